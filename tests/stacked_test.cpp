// SPDX-License-Identifier: BSD-3-Clause
#include "support/print.h"
#include "support/random.h"
#include "support/verdict.h"

#if BRINK_HAVE_REFEREE
#include "support/referee_turning.h"
#endif

#include <doctest/doctest.h>

#include <cmath>
#include <vector>

using namespace brink;
using support::Random;

namespace {

/// In halves, so that every coordinate and sum of them is exact.
double half(Random& random, int low, int high) { return 0.5 * (low + random.index(high - low + 1)); }

Vec3 halves(Random& random, int low, int high)
{
    const double x = half(random, low, high), y = half(random, low, high), z = half(random, low, high);
    return {x, y, z};
}

Shape draw_shape(Random& random, int kind)
{
    const Vec3 p = halves(random, -3, 3), q = halves(random, -3, 3), r = halves(random, -3, 3);
    const Vec3 size = halves(random, 1, 4);
    switch (kind) {
    case 0:
        return Sphere{size.x()};
    case 1:
        return Capsule{p, q, size.x()};
    case 2:
        return Box{size};
    case 3:
        return Triangle{p, q, r};
    case 4:
        return Plane{Vec3(0, 0, 1), p.x()};
    case 5:
        return HalfSpace{Vec3(0, 0, 1), p.x()};
    case 6:
        return Cylinder{size.x(), size.y()};
    case 7:
        return Cone{size.x(), size.y()};
    case 8:
        return Ellipsoid{size};
    default:
        return Hull::from_points(std::vector<Vec3>{p, q, r, halves(random, -3, 3), size, -size});
    }
}

double top(const Shape& shape)
{
    if (const auto* plane = std::get_if<Plane>(&shape)) return plane->offset;
    if (const auto* solid = std::get_if<HalfSpace>(&shape)) return solid->offset;
    return std::round(4 * bounds(shape, {}).max.z()) / 4; // bounds are rounded outwards
}

/// One on the other, beside it, or, by the target gap, over it; what is on top moves.
support::Query draw_stacked(Random& random)
{
    support::Query q;
    do {
        q.a = draw_shape(random, random.index(10));
        q.b = draw_shape(random, random.index(10));
    } while (q.a.index() > q.b.index() || q.a.index() == 4 || q.a.index() == 5);
    Motion& a = q.motion_a;
    if (random.chance(0.3)) a.start.orientation = random.chance(0.5) ? Quat(0, 1, 0, 0) : Quat(0, 0, 0, 1);
    const double lowest = std::round(4 * bounds(q.a, a.start).min.z()) / 4;
    const double x = half(random, -2, 2), y = half(random, -2, 2);
    q.options.target_gap = random.chance(0.2) ? half(random, 1, 2) : 0;
    a.start.position = Vec3(x, y, top(q.b) - lowest + q.options.target_gap);
    a.translation = halves(random, -2, 2);
    if (random.chance(0.4)) a.rotation = random.in_cube(1);
    if (random.chance(0.2)) q.motion_b.rotation = random.in_cube(1);
    q.options.start_contact = static_cast<StartContact>(random.index(3));
    return q;
}

} // namespace

TEST_CASE("stacked: bodies that touch to the bit, as on a grid, and move on")
{
    int touching = 0, passed_over = 0;
    for (std::uint64_t i = 0; i < 300; ++i) {
        Random random(77, i);
        const support::Query q = draw_stacked(random);
        support::Trial trial(q);
        CAPTURE(i);
        for (const support::Finding& finding : judge_alone(trial))
            FAIL_CHECK(finding.check, ": ", finding.detail, "\n", as_cpp(q));
        const Toi& toi = trial.toi();
        CHECK(toi.status != Status::undecided);
#if BRINK_HAVE_REFEREE
        for (const support::Finding& finding : rule(q, toi).findings)
            FAIL_CHECK("referee: ", finding.check, ": ", finding.detail, "\n", as_cpp(q));
#endif
        touching += toi.status == Status::touching ? 1 : 0;
        passed_over +=
            q.options.start_contact == StartContact::ignore && toi.status == Status::separated ? 1 : 0;
    }
    CHECK(touching > 30);
    CHECK(passed_over > 30);
}
