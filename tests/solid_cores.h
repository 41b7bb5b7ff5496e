// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "draw.h"
#include "support.h"

#include <vector>

namespace brink {

/// Placed cores of all bounded shapes, biased to the nasty: needles, discs, flat hulls, points on a grid,
/// parallel axes.
class SolidCores {
public:
    explicit SolidCores(std::uint64_t seed) : random(seed) {}
    support::Random random;

    double size()
    {
        const int kind = random.index(8);
        if (kind == 0) return 0;
        if (kind == 1) return random.log_between(1e-6, 1);
        return random.between(0.1, 1.5);
    }

    /// `kind`: cylinder, cone, ellipsoid, hull, large hull, box, triangle, segment.
    Core local(int kind)
    {
        const double x = size(), y = size(), z = size();
        const V3 p = load(random.in_cube(1)), q = load(random.in_cube(1)), r = load(random.in_cube(1));
        if (kind == 0) return core(Cylinder{x, y});
        if (kind == 1) return core(Cone{x, y});
        if (kind == 2) return core(Ellipsoid{{x, y, z}});
        if (kind == 5) return core(Box{{x, y, z}});
        if (kind == 6) return core(Triangle{store(p), store(q), store(r)});
        if (kind == 7) return core(Capsule{store(p), store(q), 0});
        return core(hull(kind == 3 ? 4 + random.index(20) : 200));
    }

    struct Pair {
        Core a, b;
    };

    Pair pair(int kind_a, int kind_b)
    {
        const Core a = local(kind_a), b = local(kind_b);
        const Quat turned = random.rotation(), other = random.rotation();
        const V3 at = random.between(0, 1.5) * load(random.in_cube(1));
        const bool parallel = random.chance(0.3), upright = random.chance(0.3);
        const Quat first = upright ? Quat(1, 0, 0, 0) : turned;
        return {placed(a, rotation(first), {}), placed(b, rotation(parallel ? first : other), at)};
    }

    /// Lives as long as the cores do.
    const Hull& hull(int count)
    {
        const bool flat = random.chance(0.1), on_sphere = random.chance(0.5), grid = random.chance(0.2);
        std::vector<Vec3> points;
        for (int i = 0; i < count; ++i) {
            Vec3 p = on_sphere ? random.unit() : random.in_cube(1);
            if (grid) p = support::draw_integers(random, 4);
            if (flat) p.z() = 0.25;
            points.push_back(p);
        }
        hulls_.push_back(std::make_unique<Hull>(Hull::from_points(points)));
        return *hulls_.back();
    }

private:
    std::vector<std::unique_ptr<Hull>> hulls_;
};

} // namespace brink
