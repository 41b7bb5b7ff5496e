// SPDX-License-Identifier: BSD-3-Clause
#include "pair_sample.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <stdexcept>

namespace brink::bench {
namespace {

using support::Random;

constexpr std::uint16_t half = 1024; // bodies on either side
constexpr double least_gap = 0.2;    // at the start, metres
constexpr double most_gap = 5;
constexpr std::uint64_t seed = 262144;

Shape draw_sphere(Random& random) { return Sphere{random.between(0.1, 1)}; }

Shape draw_capsule(Random& random)
{
    const double radius = random.between(0.1, 0.4);
    const double end = random.between(0.1, 0.6);
    const Vec3 axis = end * random.unit();
    return Capsule{-axis, axis, radius};
}

Shape draw_box(Random& random)
{
    const double x = random.between(0.1, 1);
    const double y = random.between(0.1, 1);
    const double z = random.between(0.1, 1);
    return Box{{x, y, z}};
}

Shape draw_triangle(Random& random)
{
    const double size = random.between(0.3, 1);
    const Vec3 a = random.unit();
    const Vec3 b = random.unit();
    const Vec3 c = random.unit();
    return Triangle{size * a, size * b, size * c};
}

Shape draw_plane(Random& random) { return Plane{random.unit(), 0}; }

Shape draw_half_space(Random& random) { return HalfSpace{random.unit(), 0}; }

Shape draw_cylinder(Random& random)
{
    const double half_length = random.between(0.1, 1);
    const double radius = random.between(0.1, 0.8);
    return Cylinder{half_length, radius};
}

Shape draw_cone(Random& random)
{
    const double half_length = random.between(0.1, 1);
    const double radius = random.between(0.1, 0.8);
    return Cone{half_length, radius};
}

Vec3 draw_radii(Random& random)
{
    const double x = random.between(0.1, 1);
    const double y = random.between(0.1, 1);
    const double z = random.between(0.1, 1);
    return {x, y, z};
}

Shape draw_ellipsoid(Random& random) { return Ellipsoid{draw_radii(random)}; }

/// 24 points on an ellipsoid.
Shape draw_hull(Random& random)
{
    const Vec3 radii = draw_radii(random);
    std::vector<Vec3> points;
    for (int i = 0; i < 24; ++i)
        points.emplace_back(radii.cwiseProduct(random.unit()));
    return Hull::from_points(points);
}

/// In the order of the Shape variant.
constexpr std::array<DrawShape, std::variant_size_v<Shape>> draws{
    draw_sphere,     draw_capsule,  draw_box,  draw_triangle,  draw_plane,
    draw_half_space, draw_cylinder, draw_cone, draw_ellipsoid, draw_hull};

constexpr std::array not_turning{
    PairKind{"sphere-sphere", draw_sphere, draw_sphere},
    PairKind{"sphere-capsule", draw_sphere, draw_capsule},
    PairKind{"sphere-box", draw_sphere, draw_box},
    PairKind{"sphere-triangle", draw_sphere, draw_triangle},
    PairKind{"sphere-plane", draw_sphere, draw_plane},
    PairKind{"sphere-half_space", draw_sphere, draw_half_space},
    PairKind{"capsule-capsule", draw_capsule, draw_capsule},
    PairKind{"capsule-box", draw_capsule, draw_box},
    PairKind{"capsule-triangle", draw_capsule, draw_triangle},
    PairKind{"capsule-plane", draw_capsule, draw_plane},
    PairKind{"capsule-half_space", draw_capsule, draw_half_space},
    PairKind{"box-box", draw_box, draw_box},
    PairKind{"box-triangle", draw_box, draw_triangle},
    PairKind{"triangle-triangle", draw_triangle, draw_triangle},
    PairKind{"hull-hull", draw_hull, draw_hull},
};

constexpr std::array turning_to_60_degrees{
    PairKind{"sphere-box", draw_sphere, draw_box},
    PairKind{"capsule-capsule", draw_capsule, draw_capsule},
    PairKind{"capsule-box", draw_capsule, draw_box},
    PairKind{"box-box", draw_box, draw_box},
    PairKind{"hull-hull", draw_hull, draw_hull},
    PairKind{"box-plane", draw_box, draw_plane},
    PairKind{"sphere-hull", draw_sphere, draw_hull},
    PairKind{"cylinder-box", draw_cylinder, draw_box},
    PairKind{"cone-capsule", draw_cone, draw_capsule},
    PairKind{"ellipsoid-ellipsoid", draw_ellipsoid, draw_ellipsoid},
};

constexpr std::array turning_to_300_degrees{
    PairKind{"capsule-box", draw_capsule, draw_box},
    PairKind{"box-box", draw_box, draw_box},
    PairKind{"hull-hull", draw_hull, draw_hull},
};

double widest_turn(Turning turning)
{
    constexpr double half_turn = 3.14159265358979324;
    return (turning == Turning::to_60_degrees ? 60.0 : 300.0) / 180 * half_turn;
}

/// Starts some 1.7 m behind the middle and for the most part moves ahead across it: one in five goes
/// anywhere.
Motion draw_motion(Random& random, const Vec3& ahead, Turning turning)
{
    Motion motion;
    const Vec3 scatter = random.in_cube(0.6);
    const double reach = random.between(0.2, 3.6);
    const Vec3 drift = random.in_cube(0.5);
    motion.start.position = -1.7 * ahead + scatter;
    motion.start.orientation = random.rotation();
    motion.translation = random.chance(0.2) ? Vec3(reach * random.unit()) : Vec3(reach * ahead + drift);
    if (turning == Turning::none) return motion;
    const double angle = random.between(0, widest_turn(turning));
    motion.rotation = angle * random.unit();
    return motion;
}

/// An unbounded body looks towards the others, so that they begin outside.
void face(Body& body, const Vec3& ahead)
{
    const auto turn_to_front = [&](auto& flat) {
        if ((body.motion.start.orientation * flat.normal).dot(ahead) < 0) flat.normal = -flat.normal;
    };
    if (auto* plane = std::get_if<Plane>(&body.shape)) turn_to_front(*plane);
    if (auto* half_space = std::get_if<HalfSpace>(&body.shape)) turn_to_front(*half_space);
}

std::vector<Body> draw_bodies(Random& random, const PairKind& kind, Turning turning)
{
    std::vector<Body> bodies;
    bodies.reserve(2 * half);
    const Vec3 ahead = random.unit();
    for (int i = 0; i < 2 * half; ++i) {
        const Vec3 way = i < half ? ahead : Vec3(-ahead);
        const Shape shape = i < half ? kind.draw_a(random) : kind.draw_b(random);
        bodies.push_back({shape, draw_motion(random, way, turning)});
        face(bodies.back(), way);
    }
    return bodies;
}

template <class T> void shuffle(std::vector<T>& items, Random& random)
{
    for (std::size_t left = items.size(); left > 1; --left)
        std::swap(items[left - 1], items[static_cast<std::size_t>(random.index(static_cast<int>(left)))]);
}

std::vector<Pair> all_pairs(Random& random)
{
    std::vector<Pair> pairs;
    pairs.reserve(std::size_t{half} * half);
    for (std::uint16_t a = 0; a < half; ++a)
        for (std::uint16_t b = half; b < 2 * half; ++b)
            pairs.push_back({a, b});
    shuffle(pairs, random);
    return pairs;
}

} // namespace

DrawShape draw_of(std::size_t shape) { return draws.at(shape); }

std::span<const PairKind> pairs_turning(Turning turning)
{
    if (turning == Turning::none) return not_turning;
    if (turning == Turning::to_60_degrees) return turning_to_60_degrees;
    return turning_to_300_degrees;
}

std::string_view name_of(Turning turning)
{
    if (turning == Turning::none) return "none";
    return turning == Turning::to_60_degrees ? "60" : "300";
}

std::vector<std::string> pair_names()
{
    std::vector<std::string> names;
    for (const Turning turning : every_turning) {
        for (const PairKind& kind : pairs_turning(turning))
            if (std::find(names.begin(), names.end(), kind.name) == names.end())
                names.emplace_back(kind.name);
    }
    return names;
}

Sample draw_sample(const PairKind& kind, Turning turning, std::size_t pairs)
{
    Random random(seed);
    Sample sample{draw_bodies(random, kind, turning), {}, {}, {}};
    for (const Pair pair : all_pairs(random)) {
        if (sample.hits.size() == pairs && sample.misses.size() == pairs) break;
        const Body& a = sample.bodies[pair.a];
        const Body& b = sample.bodies[pair.b];
        const double gap = distance(a.shape, a.motion.start, b.shape, b.motion.start).gap;
        if (!(gap >= least_gap && gap <= most_gap)) continue;
        const Status status = time_of_impact(a.shape, a.motion, b.shape, b.motion).status;
        std::vector<Pair>& kept = status == Status::separated ? sample.misses : sample.hits;
        if (kept.size() < pairs) kept.push_back(pair);
    }
    if (sample.hits.size() < pairs || sample.misses.size() < pairs)
        throw std::logic_error(fmt::format("{}: only {} hits and {} misses among the bodies, of {} wanted",
                                           kind.name, sample.hits.size(), sample.misses.size(), pairs));
    const auto middle = static_cast<std::ptrdiff_t>(pairs / 2);
    sample.mixed.assign(sample.hits.begin(), sample.hits.begin() + middle);
    sample.mixed.insert(sample.mixed.end(), sample.misses.begin(), sample.misses.begin() + middle);
    shuffle(sample.mixed, random);
    return sample;
}

} // namespace brink::bench
