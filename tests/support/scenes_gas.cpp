// SPDX-License-Identifier: BSD-3-Clause
#include "scenes_draft.h"

#include <algorithm>
#include <cmath>

namespace brink::support {
namespace {

constexpr double gas_width = 1.17; // the edge of the mean swept box of a gas body, measured
constexpr double gas_pairs = 3;    // a body

Shape gas_shape(Random& random, double size)
{
    const int kind = random.index(3);
    if (kind == 0) return Sphere{size * random.between(0.35, 0.5)};
    if (kind == 1) {
        const double half_length = size * random.between(0.1, 0.25);
        const double radius = size * random.between(0.25, 0.35);
        return Capsule{{0, 0, -half_length}, {0, 0, half_length}, radius};
    }
    const Vec3 half_extents = in_box(random, Vec3(0.25, 0.25, 0.25), Vec3(0.45, 0.45, 0.45));
    return Box{size * half_extents};
}

void add_gas(SceneSample& sample, Random& random, std::size_t n, const Vec3& corner, double size,
             double pairs)
{
    const double edge = size * edge_for(n, gas_width, pairs);
    for (std::size_t i = 0; i < n; ++i) {
        Body body;
        body.shape = gas_shape(random, size);
        body.motion.start.position = in_box(random, corner, corner + Vec3(edge, edge, edge));
        body.motion.start.orientation = random.rotation();
        const Vec3 direction = random.unit();
        const double speed = size * random.between(0.3, 0.8);
        const Vec3 aside = random.unit();
        body.motion.translation = speed * direction;
        add(sample, body, speed * aside);
    }
}

} // namespace

double cube_root(double x)
{
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    double y = std::ldexp(mantissa, (exponent + 3000) / 3 - 1000);
    for (int i = 0; i < 12; ++i)
        y = (2 * y + x / (y * y)) / 3;
    return y;
}

double edge_for(std::size_t n, double width, double pairs)
{
    const double meet = std::min(cube_root(2 * pairs / static_cast<double>(n)), 0.75);
    return width / (1 - std::sqrt(1 - meet));
}

Vec3 in_box(Random& random, const Vec3& min, const Vec3& max)
{
    const double x = random.between(min.x(), max.x());
    const double y = random.between(min.y(), max.y());
    const double z = random.between(min.z(), max.z());
    return {x, y, z};
}

void add(SceneSample& sample, const Body& body, const Vec3& aside)
{
    sample.bodies.push_back(body);
    sample.aside.push_back(aside);
}

SceneSample gas(Random& random, std::size_t n)
{
    SceneSample sample;
    add_gas(sample, random, n, Vec3(0, 0, 0), 1, gas_pairs);
    return sample;
}

SceneSample asleep(Random& random, std::size_t n)
{
    SceneSample sample = gas(random, n);
    for (std::size_t i = 0; i < n; ++i) {
        if (i % 100 == 0) continue;
        Body& body = sample.bodies[i];
        body.motion = Motion::still(body.motion.start);
        body.asleep = true;
        sample.aside[i].setZero();
    }
    return sample;
}

SceneSample clustered(Random& random, std::size_t n)
{
    constexpr std::size_t together = 64;
    constexpr double cluster_pairs = 2.3; // a body; where clusters overlap there are more
    constexpr double filled = 0.5;        // of the world by clusters, if none of them met
    std::vector<double> sizes;            // of the clusters' bodies, each binade as often
    double volume = 0;
    for (std::size_t first = 0; first < n; first += together) {
        const int binade = static_cast<int>(first / together % 10) - 5;
        sizes.push_back(std::ldexp(random.between(1, 2), binade));
        const double edge = sizes.back() * edge_for(together, gas_width, cluster_pairs);
        volume += edge * edge * edge;
    }
    const double world = cube_root(volume / filled);
    SceneSample sample;
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        const double room = std::max(world - sizes[i] * edge_for(together, gas_width, cluster_pairs), 0.0);
        const Vec3 corner = in_box(random, Vec3(0, 0, 0), Vec3(room, room, room));
        add_gas(sample, random, std::min(together, n - i * together), corner, sizes[i], cluster_pairs);
    }
    return sample;
}

} // namespace brink::support
