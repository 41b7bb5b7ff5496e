// SPDX-License-Identifier: BSD-3-Clause
#include "start_contact.h"

#include "exact_model.h"
#include "exact_nearest.h"
#include "tolerance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace brink {

namespace {

using exact::Number;
using exact::Point;
using exact::Turn;

/// Rounds that no pair of polytopes comes near.
constexpr int most_rounds = 128;

/// The corners of a shape's core, or of a polytope inside it, in its own frame.
class Vertices {
public:
    explicit Vertices(const Shape& shape)
    {
        std::visit([&](const auto& s) { of(s); }, shape);
        if (all.empty()) all = {few_.data(), count_};
    }
    Vertices(const Vertices&) = delete;
    Vertices& operator=(const Vertices&) = delete;

    std::span<const Vec3> all;
    double radius = 0;
    bool whole = true; // they make all of the core

private:
    void add(double x, double y, double z) { few_[count_++] = {x, y, z}; }
    void add_both(double x, double y, double z)
    {
        add(x, y, z);
        add(-x, -y, -z);
    }
    /// Sixteen of a circle about z: four on the axes and, rounded inwards, those between.
    void add_circle(double r, double z)
    {
        constexpr double at[][2] = {{1, 0},
                                    {0.92387953251, 0.38268343236},
                                    {0.70710678118, 0.70710678118},
                                    {0.38268343236, 0.92387953251}};
        const bool keeps_digits = r > tolerance::nothing;
        for (const auto& [c, s] : std::span(at).first(keeps_digits ? 4 : 1)) {
            add(r * c, r * s, z);
            add(-r * s, r * c, z);
            add(-r * c, -r * s, z);
            add(r * s, -r * c, z);
        }
    }
    void of(const Sphere& s)
    {
        add(0, 0, 0);
        radius = s.radius;
    }
    void of(const Capsule& s)
    {
        few_[count_++] = s.a;
        few_[count_++] = s.b;
        radius = s.radius;
    }
    void of(const Box& s)
    {
        const double x = s.half_extents.x(), y = s.half_extents.y(), z = s.half_extents.z();
        add_both(x, y, z);
        add_both(-x, y, z);
        add_both(x, -y, z);
        add_both(x, y, -z);
    }
    void of(const Triangle& s)
    {
        for (const Vec3& corner : {s.a, s.b, s.c})
            few_[count_++] = corner;
    }
    void of(const Cylinder& s)
    {
        add_circle(s.radius, s.half_length);
        add_circle(s.radius, -s.half_length);
        whole = false;
    }
    void of(const Cone& s)
    {
        add_circle(s.radius, -s.half_length);
        add(0, 0, s.half_length);
        whole = false;
    }
    void of(const Ellipsoid& s)
    {
        add_both(s.radii.x(), 0, 0);
        add_both(0, s.radii.y(), 0);
        add_both(0, 0, s.radii.z());
        whole = false;
    }
    void of(const Hull& s) { all = s.vertices(); }
    template <class Border> void of(const Border&) {} // it has none

    std::array<Vec3, 32> few_;
    std::size_t count_ = 0;
};

/// Rounded, all by the same power of two.
V3 rounded(const Point& p)
{
    const Scaled x = p.x.rounded(), y = p.y.rounded(), z = p.z.rounded();
    int most = -(1 << 20);
    for (const Scaled& s : {x, y, z})
        if (s.mantissa != 0) most = std::max(most, s.exponent);
    const auto near_1 = [&](const Scaled& s) {
        return std::ldexp(s.mantissa, std::max(s.exponent - most, -2000));
    };
    return {near_1(x), near_1(y), near_1(z)};
}

/// The corner that lies lowest along a direction in their own frame. Doubles tell which few can be it.
int lowest(const Vertices& c, const Point& along, int shift)
{
    const V3 d = rounded(along);
    struct Height {
        double value, doubt;
    };
    const auto height = [&](const Vec3& corner) -> Height {
        const V3 p = load(corner), terms = {d.x * p.x, d.y * p.y, d.z * p.z};
        return {terms.x + terms.y + terms.z, 0x1p-48 * sum_of_magnitudes(terms) + 0x1p-1000};
    };
    double least = infinity;
    for (const Vec3& corner : c.all)
        if (const Height h = height(corner); h.value + h.doubt < least) least = h.value + h.doubt;
    int best = -1;
    Number lowest;
    for (int k = 0; k < static_cast<int>(c.all.size()); ++k) {
        const Vec3& corner = c.all[static_cast<std::size_t>(k)];
        if (const Height h = height(corner); h.value - h.doubt > least) continue;
        const Number exactly = dot(along, exact::point(corner, shift));
        if (best < 0 || (exactly - lowest).sign() < 0) best = k, lowest = exactly;
    }
    return best;
}

/// Two shapes as they start.
class Start {
public:
    explicit Start(const Query& q)
        : a_(q.a),
          b_(q.b),
          spans_(spans(q)),
          shift_(spans_.length.shift()),
          turn_a_(orientation(q.a, q.motion_a)),
          turn_b_(orientation(q.b, q.motion_b)),
          both_(turn_a_.norm_squared * turn_b_.norm_squared),
          to_b_(exact::point(q.motion_b.start.position, shift_) -
                exact::point(q.motion_a.start.position, shift_)),
          reach_(both_ * (Number(a_.radius, shift_) + Number(b_.radius, shift_) +
                          Number(q.options.target_gap, shift_)))
    {
    }

    /// By the algorithm of Gilbert, Johnson and Keerthi (gjk.h). Here nothing is rounded: each round comes
    /// nearer, so that it ends, with the nearest feature.
    std::optional<bool> cores_meet() const
    {
        // The largest of its numbers are products of three squares of areas and lengths (numerics.md).
        if (!exact::Degrees{10, 40, 0, 0}.fit(spans_, {})) return {};
        const exact::Square reach{reach_ * reach_, Number(1)};
        exact::Nearest nearest;
        Point way = to_b_;
        for (int round = 0; round < most_rounds; ++round) {
            if (way.x.sign() == 0 && way.y.sign() == 0 && way.z.sign() == 0) way.x = Number(1);
            Point& corner = nearest.corner[nearest.count];
            corner = both_ * to_b_ + turn_a_.norm_squared * lowest_of_b(way) -
                     turn_b_.norm_squared * lowest_of_a(-way);
            if (nearest.count > 0 && dot(way, corner - nearest.corner[0]).sign() >= 0) return known(false);
            ++nearest.count;
            if (nearest.take_in() || !exact::less(reach, nearest.distance)) return true;
            way = nearest.way();
        }
        return {};
    }
    /// Of A's core and a plane or half-space.
    std::optional<bool> meets(const Vec3& normal, double offset, bool solid) const
    {
        if (!exact::Degrees{2, 8, 0, 2}.fit(spans_, {})) return {};
        const Point n = exact::point(normal, 0), up = turn_b_ * n;
        const Number middle = -(turn_a_.norm_squared * dot(up, to_b_)) - both_ * Number(offset, shift_);
        const Number reach_squared = reach_ * reach_ * dot(n, n);
        const auto beyond = [&](const Point& down, int side) {
            const Number h = middle + dot(up, lowest_of_a(down));
            return h.sign() * side > 0 && (h * h - reach_squared).sign() > 0;
        };
        return known(!beyond(up, 1) && (solid || !beyond(-up, -1)));
    }

private:
    /// A sphere's was never looked at, and may be anything.
    static Quat orientation(const Shape& shape, const Motion& motion)
    {
        return std::holds_alternative<Sphere>(shape) ? Quat(1, 0, 0, 0) : motion.start.orientation;
    }
    exact::Spans spans(const Query& q) const
    {
        exact::Spans out;
        for (const Vertices* side : {&a_, &b_}) {
            out.length.add(side->radius);
            for (const Vec3& corner : side->all)
                out.add(corner);
        }
        if (const Plane* plane = std::get_if<Plane>(&q.b)) out.add(*plane);
        if (const HalfSpace* half_space = std::get_if<HalfSpace>(&q.b)) out.add(*half_space);
        out.length.add(q.options.target_gap);
        out.add(q.motion_a.start.position);
        out.add(q.motion_b.start.position);
        out.add(orientation(q.a, q.motion_a));
        out.add(orientation(q.b, q.motion_b));
        return out;
    }
    std::optional<bool> known(bool contact) const
    {
        if (!contact && !(a_.whole && b_.whole)) return {};
        return contact;
    }
    Point lowest_of_a(const Point& along) const { return lowest(a_, turn_a_, along); }
    Point lowest_of_b(const Point& along) const { return lowest(b_, turn_b_, along); }
    /// Times |q|^2, about the shape's origin.
    [[gnu::noinline]] Point lowest(const Vertices& corners, const Turn& turn, const Point& along) const
    {
        const int k = brink::lowest(corners, turn.into(along), shift_);
        return turn * exact::point(corners.all[static_cast<std::size_t>(k)], shift_);
    }

    Vertices a_, b_;
    exact::Spans spans_;
    int shift_;
    Turn turn_a_, turn_b_;
    Number both_;
    Point to_b_;
    Number reach_;
};

} // namespace

std::optional<bool> in_contact_at_start(const Query& q)
{
    const Start start(q);
    if (const Plane* plane = std::get_if<Plane>(&q.b))
        return start.meets(plane->normal, plane->offset, false);
    if (const HalfSpace* solid = std::get_if<HalfSpace>(&q.b))
        return start.meets(solid->normal, solid->offset, true);
    return start.cores_meet();
}

} // namespace brink
