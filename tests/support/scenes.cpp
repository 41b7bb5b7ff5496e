// SPDX-License-Identifier: BSD-3-Clause
#include "scenes.h"

#include "scenes_draft.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace brink::support {
namespace {

/// Of a cell of edge 1 in a lattice.
Vec3 corner_of(std::size_t i, std::size_t side)
{
    const std::size_t x = i % side, y = i / side % side, z = i / side / side;
    return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
}

/// A whole number of cells along each axis: bullets fly from one corner of the lattice, where no box is, to
/// another.
Vec3 flight(Random& random)
{
    for (;;) {
        const int x = random.index(17) - 8;
        const int y = random.index(17) - 8;
        const int z = random.index(17) - 8;
        const int square = x * x + y * y + z * z;
        if (square >= 64 && square <= 144)
            return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
    }
}

/// Where a bullet begins, and its two ways.
struct Course {
    std::size_t cell = 0;
    Vec3 out, aside;
};

/// From a cell of its own, and so that all four corners of its round are in the lattice: small ones have no
/// room for that, and let it leave.
Course draw_course(Random& random, std::size_t side, const std::vector<bool>& taken)
{
    const auto inside = [side](const Vec3& p) {
        return p.minCoeff() >= 0 && p.maxCoeff() <= static_cast<double>(side);
    };
    for (int attempt = 0;; ++attempt) {
        const std::size_t i = static_cast<std::size_t>(random.bits() % taken.size());
        const Vec3 start = corner_of(i, side);
        const Vec3 out = flight(random);
        const Vec3 aside = flight(random);
        const bool stays = inside(start + out) && inside(start + aside) && inside(start + out + aside);
        if (attempt >= 1000 || (stays && !taken[i])) return {i, out, aside};
    }
}

SceneSample bullets(Random& random, std::size_t n)
{
    const std::size_t flying = std::max<std::size_t>(n / 100, 1);
    const std::size_t boxes = n - flying;
    std::size_t side = 1; // of the lattice, in cells of edge 1
    while (side * side * side < boxes)
        ++side;
    SceneSample sample;
    for (std::size_t i = 0; i < boxes; ++i) {
        Body body;
        const Vec3 half_extents = in_box(random, Vec3(0.1, 0.1, 0.1), Vec3(0.25, 0.25, 0.25));
        body.shape = Box{half_extents};
        const Vec3 jitter = random.in_cube(0.1);
        body.motion.start.position = corner_of(i, side) + Vec3(0.5, 0.5, 0.5) + jitter;
        body.motion.start.orientation = random.rotation();
        body.immovable = true;
        add(sample, body);
    }
    std::vector<bool> taken(side * side * side);
    for (std::size_t i = 0; i < flying; ++i) {
        const Course course = draw_course(random, side, taken);
        taken[course.cell] = true;
        Body body;
        body.shape = Sphere{random.between(0.002, 0.005)};
        const Vec3 jitter = random.in_cube(0.1);
        body.motion.start.position = corner_of(course.cell, side) + jitter;
        body.motion.translation = course.out;
        add(sample, body, course.aside);
    }
    return sample;
}

SceneSample stacks(std::size_t n)
{
    constexpr std::size_t high = 10;
    const std::size_t towers = (n + high - 2) / high;
    std::size_t side = 1;
    while (side * side < towers)
        ++side;
    SceneSample sample;
    Body floor;
    floor.shape = HalfSpace{};
    floor.immovable = true;
    add(sample, floor);
    for (std::size_t i = 0; i + 1 < n; ++i) {
        const std::size_t tower = i / high;
        Body body;
        body.shape = Box{{0.5, 0.5, 0.5}};
        body.motion.start.position =
            Vec3(1.5 * static_cast<double>(tower % side), 1.5 * static_cast<double>(tower / side),
                 static_cast<double>(i % high) + 0.5);
        add(sample, body);
    }
    return sample;
}

Hull pebble(Random& random)
{
    std::vector<Vec3> points;
    for (int i = 0; i < 12; ++i) {
        const Vec3 direction = random.unit();
        points.push_back(random.between(0.4, 0.5) * direction);
    }
    return Hull::from_points(points);
}

Shape rain_shape(Random& random, const std::vector<Shape>& pebbles)
{
    const int kind = random.index(8);
    const double size = random.between(0.3, 0.5);
    const double share = random.between(0.4, 0.8);
    switch (kind) {
    case 0:
        return Sphere{size};
    case 1:
        return Capsule{{-share * size, 0, 0}, {share * size, 0, 0}, 0.5 * size};
    case 2:
        return Box{{size, share * size, 0.6 * size}};
    case 3:
        return Cylinder{share * size, 0.7 * size};
    case 4:
        return Cone{size, share * size};
    case 5:
        return Ellipsoid{{size, share * size, 0.5 * size}};
    case 6:
        return Triangle{{size, 0, 0}, {-size, share * size, 0}, {-size, -share * size, 0}};
    default:
        return pebbles[static_cast<std::size_t>(random.index(static_cast<int>(pebbles.size())))];
    }
}

Vec3 fall(Random& random)
{
    const Vec3 wind = random.in_cube(0.2);
    const double speed = random.between(0.3, 0.8);
    return {wind.x(), wind.y(), -speed};
}

SceneSample rain(Random& random, std::size_t n)
{
    constexpr double width = 0.977, pairs = 1.5; // of the mean swept box, measured; a body
    std::vector<Shape> pebbles;
    for (int i = 0; i < 16; ++i)
        pebbles.emplace_back(pebble(random));
    const double edge = edge_for(n, width, pairs);
    SceneSample sample;
    Body ground;
    ground.shape = Box{{edge, edge, 1}};
    ground.motion.start.position = Vec3(edge / 2, edge / 2, -1);
    ground.immovable = true;
    add(sample, ground);
    for (std::size_t i = 1; i < n; ++i) {
        Body body;
        body.shape = rain_shape(random, pebbles);
        body.motion.start.position = in_box(random, Vec3(0, 0, 0.75), Vec3(edge, edge, edge + 0.75));
        body.motion.start.orientation = random.rotation();
        body.motion.translation = fall(random);
        const Vec3 axis = random.unit();
        body.motion.rotation = random.between(0, 1) * axis;
        if (random.chance(0.25)) body.motion.pivot = random.in_cube(0.2);
        add(sample, body, fall(random));
    }
    return sample;
}

SceneSample drawn(std::string_view name, std::size_t n, Random& random)
{
    if (name == "gas") return gas(random, n);
    if (name == "clustered") return clustered(random, n);
    if (name == "bullets") return bullets(random, n);
    if (name == "asleep") return asleep(random, n);
    if (name == "stacks") return stacks(n);
    if (name == "rain") return rain(random, n);
    throw std::invalid_argument("no scene is called '" + std::string(name) + "'");
}

} // namespace

SceneSample draw_scene(std::string_view name, std::size_t n, std::uint64_t seed)
{
    if (n == 0) throw std::invalid_argument("a scene has at least one body");
    Random random(seed, n);
    SceneSample sample = drawn(name, n, random);
    for (std::size_t i = n; i > 1; --i) {
        const std::size_t j = static_cast<std::size_t>(random.bits() % i);
        std::swap(sample.bodies[i - 1], sample.bodies[j]);
        std::swap(sample.aside[i - 1], sample.aside[j]);
    }
    return sample;
}

} // namespace brink::support
