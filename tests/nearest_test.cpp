// SPDX-License-Identifier: BSD-3-Clause
#include "nearest.h"
#include "random.h"

#include <doctest/doctest.h>

using namespace brink;
using support::Random;

namespace {

double distance_at(V3 p, V3 d, V3 h, double t) { return norm(to_box(p + t * d, h)); }

/// The least distance along a segment, to a few digits more than doubles hold of t: it is convex.
double least_distance(V3 p, V3 d, V3 h)
{
    double low = 0, high = 1;
    for (int i = 0; i < 200; ++i) {
        const double s = low + (high - low) / 3, t = high - (high - low) / 3;
        (distance_at(p, d, h, s) < distance_at(p, d, h, t) ? high : low) =
            distance_at(p, d, h, s) < distance_at(p, d, h, t) ? t : s;
    }
    return distance_at(p, d, h, 0.5 * (low + high));
}

/// Zero now and then, so that segments lie along axes and boxes are flat.
double some(Random& random, double most) { return random.chance(0.2) ? 0 : random.between(-most, most); }

} // namespace

TEST_CASE("nearest_to_box: no place of the segment is nearer")
{
    Random random(162);
    int inside = 0, ends = 0, through = 0;
    for (int i = 0; i < 50'000; ++i) {
        const double px = some(random, 2), py = some(random, 2), pz = some(random, 2);
        const double dx = some(random, 3), dy = some(random, 3), dz = some(random, 3);
        const double hx = some(random, 1), hy = some(random, 1), hz = some(random, 1);
        const V3 p{px, py, pz}, d{dx, dy, dz}, h{std::fabs(hx), std::fabs(hy), std::fabs(hz)};
        CAPTURE(i);
        const double t = nearest_to_box(p, d, h), distance = distance_at(p, d, h, t);
        REQUIRE(t >= 0);
        REQUIRE(t <= 1);
        CHECK(distance <= least_distance(p, d, h) + 1e-13);
        ends += t == 0 || t == 1;
        inside += t > 0 && t < 1 && distance > 0;
        through += distance == 0;
    }
    CHECK(inside > 5'000);
    CHECK(ends > 5'000);
    CHECK(through > 500);
}
