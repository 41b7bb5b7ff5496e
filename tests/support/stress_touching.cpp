// SPDX-License-Identifier: BSD-3-Clause
#include "stress_touching.h"

#include <algorithm>

namespace brink::support {
namespace {

Vec3 integers(Random& random, int n)
{
    const int x = random.index(2 * n + 1) - n;
    const int y = random.index(2 * n + 1) - n;
    const int z = random.index(2 * n + 1) - n;
    return {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
}

/// Of whole length: along an axis, or a permutation of x^2 + y^2 + z^2 = n^2, any signs.
struct Whole {
    Vec3 v;
    double length;
};

Whole draw_whole(Random& random)
{
    constexpr std::array<std::array<int, 4>, 8> quadruples{{{0, 0, 1, 1},
                                                            {0, 3, 4, 5},
                                                            {1, 2, 2, 3},
                                                            {2, 3, 6, 7},
                                                            {1, 4, 8, 9},
                                                            {4, 4, 7, 9},
                                                            {2, 6, 9, 11},
                                                            {6, 6, 7, 11}}};
    const auto& [x, y, z, n] = quadruples[static_cast<std::size_t>(random.index(8))];
    Vec3 v(x, y, z);
    for (int i = 2; i > 0; --i)
        std::swap(v[i], v[random.index(i + 1)]);
    for (int i = 0; i < 3; ++i)
        v[i] = random.chance(0.5) ? v[i] : -v[i];
    return {v, static_cast<double>(n)};
}

/// A shape with nothing beyond the plane through `foot` (a point of its core) with normal n, and a radius of
/// at most `most`.
struct Below {
    Shape shape;
    Vec3 foot;
    double radius = 0;
};

/// m, or -m where that points up.
Vec3 downwards(const Vec3& m, const Vec3& n) { return m.dot(n) > 0 ? Vec3(-m) : m; }

Below draw_below(Random& random, std::size_t kind, const Vec3& n, double most)
{
    const Vec3 foot = integers(random, 4);
    const Vec3 down = downwards(integers(random, 5), n);
    const Vec3 down_too = downwards(integers(random, 5), n);
    const double radius = random.index(static_cast<int>(most) + 1);
    if (kind == 1) return {Capsule{foot, foot + down, radius}, foot, radius};
    if (kind == 3) return {Triangle{foot, foot + down, foot + down_too}, foot};
    if (kind != 2) return {Sphere{radius}, Vec3(0, 0, 0), radius};
    const Vec3 half = foot.cwiseAbs();
    Vec3 corner = half;
    for (int i = 0; i < 3; ++i)
        corner[i] = n[i] > 0 || (n[i] == 0 && foot[i] > 0) ? half[i] : -half[i];
    return {Box{half}, corner};
}

/// Ground under the origin, at a whole height, with its normal along an axis.
Below draw_ground(Random& random, std::size_t kind, const Vec3& n)
{
    const int height = random.index(9) - 4;
    const Vec3 foot = height * n;
    if (kind == 4) return {Plane{n, static_cast<double>(height)}, foot};
    return {HalfSpace{n, static_cast<double>(height)}, foot};
}

} // namespace

Query exactly_touching(Random& random, const Pair& pair)
{
    Whole apart = draw_whole(random);
    if (pair.second >= 4) { // a normal must be a unit vector
        const int axis = random.index(3);
        const double sign = random.chance(0.5) ? 1 : -1;
        apart = {sign * (1 + random.index(9)) * Vec3::Unit(axis), 0};
        apart.length = apart.v.norm();
    }
    const Vec3 up = apart.v / apart.length; // exact for ground, unused for others
    const Below b = pair.second >= 4 ? draw_ground(random, pair.second, up)
                                     : draw_below(random, pair.second, apart.v, apart.length);
    // A is drawn as seen from its own side: nothing beyond the plane through its foot, facing B.
    const Below a = draw_below(random, pair.first, -apart.v, 0);
    Shape shape = a.shape;
    const double radius = apart.length - b.radius;
    if (auto* sphere = std::get_if<Sphere>(&shape)) sphere->radius = radius;
    if (auto* capsule = std::get_if<Capsule>(&shape)) capsule->radius = radius;
    const Vec3 base = integers(random, 8);
    Query q{shape, {}, b.shape, {}, {}};
    q.motion_a.start.position = base + b.foot + apart.v - a.foot;
    q.motion_a.translation = integers(random, 8);
    q.motion_b.start.position = base;
    if (random.chance(0.5)) q.motion_b.translation = integers(random, 8);
    return q;
}

} // namespace brink::support
