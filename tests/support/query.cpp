// SPDX-License-Identifier: BSD-3-Clause
#include "query.h"

#include "draw.h"
#include "path.h"

namespace brink::support {
namespace {

/// What makes a query nasty.
enum class Twist : unsigned char { plain, head_on, grazing, parallel, start, far, thin, exact };

Twist draw_twist(Random& random)
{
    constexpr std::array<Twist, 16> weights{Twist::plain,   Twist::plain,    Twist::plain,    Twist::plain,
                                            Twist::plain,   Twist::plain,    Twist::head_on,  Twist::grazing,
                                            Twist::grazing, Twist::parallel, Twist::parallel, Twist::start,
                                            Twist::start,   Twist::far,      Twist::thin,     Twist::exact};
    return weights[static_cast<std::size_t>(random.index(static_cast<int>(weights.size())))];
}

ShapeStyle style(Twist twist)
{
    if (twist == Twist::parallel) return ShapeStyle::aligned;
    return twist == Twist::exact ? ShapeStyle::integer : ShapeStyle::any;
}

Path draw_path(Random& random, Twist twist)
{
    if (twist == Twist::exact) {
        const Vec3 from = draw_integers(random, 24);
        const Vec3 by = draw_integers(random, 24);
        return {from, by};
    }
    const double distance = twist == Twist::thin ? random.between(1, 20) : random.between(1.2, 6);
    Vec3 from = distance * random.unit();
    if (twist == Twist::start && random.chance(0.4)) from = random.in_cube(0.4);
    Vec3 aim = random.in_cube(twist == Twist::thin ? 0.8 : 1.2);
    if (twist == Twist::head_on) aim = Vec3(0, 0, 0);
    const double arrival = random.between(0.1, 1.2);
    Vec3 by = (aim - from) / arrival;
    if (twist == Twist::start && random.chance(0.5)) by = random.in_cube(3);
    return {from, by};
}

/// Up to 60 degrees, up to 300, several turns; seldom next to nothing.
Vec3 draw_rotation(Random& random)
{
    constexpr double degree = 0.017453292519943295;
    const int kind = random.index(20);
    const Vec3 axis = random.chance(0.2) ? Vec3(0, 0, 1) : random.unit();
    if (kind == 0) return random.log_between(1e-12, 1e-3) * axis;
    if (kind < 11) return random.between(0, 60) * degree * axis;
    if (kind < 17) return random.between(60, 300) * degree * axis;
    return random.between(300, 1500) * degree * axis;
}

Motion draw_turning(Random& random, Motion motion)
{
    motion.rotation = draw_rotation(random);
    if (random.chance(0.6)) motion.pivot = random.in_cube(random.chance(0.8) ? 0.6 : 3);
    return motion;
}

Options draw_options(Random& random, Twist twist)
{
    Options options;
    if (random.chance(0.12)) options.t_max = random.chance(0.1) ? 0 : random.between(0, 1);
    if (random.chance(0.15)) options.target_gap = random.log_between(1e-6, 0.5);
    if (twist == Twist::exact) options.target_gap = random.chance(0.2) ? 0.25 : 0;
    constexpr std::array<double, 4> tolerances{1e-6, 1e-12, 1e-3, 0};
    const int pick = random.index(40);
    if (pick < 4) options.tolerance = tolerances[static_cast<std::size_t>(pick)];
    const int start = random.index(twist == Twist::start ? 3 : 12);
    options.start_contact = static_cast<StartContact>(start < 3 ? start : 0);
    return options;
}

/// The whole query but for the fine tuning of grazing and touching.
Query draw_query(Random& random, const Pair& pair, bool rotates, Twist twist)
{
    Query q{draw_shape(random, pair.first, style(twist)),
            {},
            draw_shape(random, pair.second, style(twist)),
            {},
            {}};
    if (twist == Twist::thin) q.a = small_shape(random, pair.first);
    if (twist == Twist::thin && std::holds_alternative<Box>(q.b)) q.b = thin_wall(random);
    Quat turned_b = twist == Twist::exact ? Quat(1, 0, 0, 0) : draw_orientation(random);
    Quat turned_a = twist == Twist::exact ? turned_b : draw_orientation(random);
    if (twist == Twist::parallel) turned_a = nearly(random, turned_b);
    Path path = draw_path(random, twist);
    if (unbounded(q.b) && twist != Twist::exact) path = above_ground(random, path, q.b, turned_b);
    const double share = random.chance(0.4) ? 1 : random.between(0, 1);
    const Vec3 common = random.chance(0.5) ? random.in_cube(2) : Vec3(0, 0, 0);
    Vec3 base = random.chance(0.5) ? random.in_cube(1) : Vec3(0, 0, 0);
    if (twist == Twist::far) base = random.in_cube(random.chance(0.5) ? 1e6 : 1e3);
    if (twist == Twist::exact) base = draw_integers(random, 8);
    const bool whole = twist == Twist::exact;
    q.motion_a.start = {base + path.from, turned_a};
    q.motion_a.translation = whole ? path.by : Vec3(common + share * path.by);
    q.motion_b.start = {base, turned_b};
    if (!whole) q.motion_b.translation = common - (1 - share) * path.by;
    const int who = random.index(3);
    if (rotates && who != 1) q.motion_a = draw_turning(random, q.motion_a);
    if (rotates && who != 0) q.motion_b = draw_turning(random, q.motion_b);
    q.options = draw_options(random, twist);
    if (random.chance(0.01)) q.motion_a.translation = q.motion_b.translation;
    return q;
}

} // namespace

Toi answer(const Query& q) { return time_of_impact(q.a, q.motion_a, q.b, q.motion_b, q.options); }

bool curved(const Shape& shape)
{
    return std::holds_alternative<Cylinder>(shape) || std::holds_alternative<Cone>(shape) ||
           std::holds_alternative<Ellipsoid>(shape);
}

std::string Pair::name() const
{
    return std::string(shape_names[first]) + "-" + std::string(shape_names[second]);
}

namespace {

bool is_border(std::size_t shape) { return shape == 4 || shape == 5; }

} // namespace

bool Pair::unbounded() const { return is_border(first) && is_border(second); }

bool Pair::has_reference() const { return second < 6 && !unbounded(); }

bool Pair::closed_form() const
{
    return (first == 0 && second < 6) || (first == 1 && (second == 1 || is_border(second)));
}

std::vector<Pair> all_pairs()
{
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < shape_names.size(); ++i)
        for (std::size_t j = i; j < shape_names.size(); ++j)
            pairs.push_back({i, j});
    return pairs;
}

std::optional<Pair> pair_named(std::string_view name)
{
    for (const Pair& pair : all_pairs())
        if (pair.name() == name) return pair;
    return std::nullopt;
}

Query query(const Pair& pair, Family family, std::uint64_t seed, std::uint64_t index, Aim aim)
{
    const std::uint64_t later =
        pair.second < 6 ? 0 : std::uint64_t{1} << 40U; // other streams than those of seeds
    Random random(seed * 64 + pair.first * 8 + pair.second + later, index);
    const bool turning = random.chance(pair.closed_form() ? 0.1 : 0.5);
    const bool rotates = family == Family::rotation || (family == Family::any && turning);
    const Twist twist = draw_twist(random);
    Query q = draw_query(random, pair, rotates, twist);
    const bool tune = twist == Twist::grazing || (twist == Twist::start && random.chance(0.6));
    if (!tune || pair.unbounded()) return q;
    const double sign = random.chance(0.5) ? 1 : -1;
    const double beyond =
        random.chance(0.1) ? 0 : sign * random.log_between(twist == Twist::start ? 1e-16 : 1e-12, 1e-3);
    const GapAt gap = gap_at(q, aim);
    return tuned(q, twist == Twist::start ? gap(0) : least_gap(gap, q.options.t_max), beyond);
}

} // namespace brink::support
