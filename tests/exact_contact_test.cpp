// SPDX-License-Identifier: BSD-3-Clause
#include "exact_contact.h"

#include "support/moving.h"
#include "support/query.h"

#if BRINK_HAVE_REFEREE
#include "support/referee.h"
#endif

#include <doctest/doctest.h>

#include <cmath>

using namespace brink;
using support::moving;
using support::resting;

namespace {

Verdict ask(const Shape& a, const Motion& motion_a, const Shape& b, const Motion& motion_b, double t_max = 1)
{
    Options options;
    options.t_max = t_max;
    return exact_contact(brink::Query{a, motion_a, b, motion_b, options});
}
Verdict ask(const support::Query& q)
{
    return exact_contact(brink::Query{q.a, q.motion_a, q.b, q.motion_b, q.options});
}

const Box box{Vec3(1, 2, 3)};
const Triangle triangle{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

} // namespace

TEST_CASE("exact_contact: tangency of two spheres is contact, one place more is not")
{
    const Motion by = moving(Vec3(-3, 2, 0), Vec3(6, 0, 0));
    const Verdict touch = ask(Sphere{1}, by, Sphere{1}, resting());
    CHECK(touch.status == Status::hit);
    CHECK(touch.t <= 0.5);
    CHECK(touch.t_upper >= 0.5);
    CHECK(touch.t_upper - touch.t <= 0x1p-48);
    CHECK(ask(Sphere{1}, by, Sphere{1 - 0x1p-53}, resting()).status == Status::separated);
    CHECK(ask(Sphere{1}, by, Sphere{1}, resting(), 0.5).status == Status::hit);
    CHECK(ask(Sphere{1}, by, Sphere{1}, resting(), std::nextafter(0.5, 0)).status == Status::separated);
}

TEST_CASE("exact_contact: the end of the step to the last place")
{
    const Motion down = moving(Vec3(0, 0, 3), Vec3(0, 0, -4)); // a unit sphere reaches z = 0 at t = 1/2
    for (const Shape& floor : {Shape(Plane{Vec3(0, 0, 1), 0}), Shape(HalfSpace{Vec3(0, 0, 1), 0}), Shape(box),
                               Shape(triangle), Shape(Capsule{Vec3(-1, 0, 0), Vec3(1, 0, 0), 0})}) {
        const Motion at = std::holds_alternative<Box>(floor) ? resting(Vec3(0, 0, -3)) : resting();
        CHECK(ask(Sphere{1}, down, floor, at, 0.5).status == Status::hit);
        CHECK(ask(Sphere{1}, down, floor, at, std::nextafter(0.5, 0)).status == Status::separated);
    }
}

TEST_CASE("exact_contact: points and segments without radius meet")
{
    const Capsule along_x{Vec3(-1, 0, 0), Vec3(1, 0, 0), 0}, along_y{Vec3(0, -1, 0), Vec3(0, 1, 0), 0};
    const Motion down = moving(Vec3(0, 0, 1), Vec3(0, 0, -2));
    CHECK(ask(along_x, down, along_y, resting()).status == Status::hit);
    CHECK(ask(along_x, down, along_x, resting()).status == Status::hit); // parallel: a flat parallelogram
    CHECK(ask(along_x, moving(Vec3(2, 0, 1), Vec3(0, 0, -2)), along_x, resting()).status ==
          Status::hit); // end on end
    CHECK(ask(along_x, moving(Vec3(2 + 0x1p-50, 0, 1), Vec3(0, 0, -2)), along_x, resting()).status ==
          Status::separated);
    CHECK(ask(Sphere{0}, down, Sphere{0}, resting()).status == Status::hit);
    CHECK(ask(Sphere{0}, resting(), Sphere{0}, resting()).status == Status::touching);
}

TEST_CASE("exact_contact: a point through a triangle's inside, edge, corner, and past them")
{
    const auto drop = [](double x, double y) {
        return ask(Sphere{0}, moving(Vec3(x, y, 1), Vec3(0, 0, -2)), triangle, resting()).status;
    };
    CHECK(drop(1, 1) == Status::hit);
    CHECK(drop(2, 2) == Status::hit); // on the long edge
    CHECK(drop(2, 2 + 0x1p-50) == Status::separated);
    CHECK(drop(0, 4) == Status::hit);
    CHECK(drop(0, std::nextafter(4, 5)) == Status::separated);
    CHECK(drop(0, -0x1p-1074) == Status::separated);
}

TEST_CASE("exact_contact: inside a box, on its face, edge and corner")
{
    CHECK(ask(Sphere{0}, resting(), box, resting()).status == Status::touching);
    CHECK(ask(Sphere{0}, resting(Vec3(1, 2, 3)), box, resting()).status == Status::touching);
    CHECK(ask(Sphere{5}, resting(Vec3(4, 6, 0)), box, resting()).status ==
          Status::touching); // 3-4-5 off an edge
    CHECK(ask(Sphere{5}, resting(Vec3(std::nextafter(4, 5), 6, 0)), box, resting()).status ==
          Status::separated);
    CHECK(ask(Sphere{7}, resting(Vec3(3, 5, 9)), box, resting()).status == Status::touching); // 2-3-6-7
}

TEST_CASE("exact_contact: a quaternion off unit turns as if it were unit")
{
    // A quarter turn about z by (1, 0, 0, 1) / |.|: only its direction counts, and no digit of sqrt(2) is
    // needed.
    Motion turned = resting();
    turned.start.orientation = Quat(1 + 0x1p-22, 0, 0, 1 + 0x1p-22);
    const Capsule along_x{Vec3(0, 0, 0), Vec3(3, 0, 0), 1};
    CHECK(ask(Sphere{1}, resting(Vec3(2, 1, 0)), along_x, turned).status == Status::touching);
    CHECK(ask(Sphere{1}, resting(Vec3(std::nextafter(2, 3), 1, 0)), along_x, turned).status ==
          Status::separated);
}

TEST_CASE(
    "exact_contact: over all of double's range for spheres, undecided where numbers reach too far for others")
{
    const Motion far = moving(Vec3(0x1p1000, 0x1p-1000, 0), Vec3(-0x1p1001, 0, 0));
    CHECK(ask(Sphere{0x1p-1001}, far, Sphere{0x1p-1001}, resting()).status == Status::hit); // tangent
    CHECK(ask(Sphere{0x1p-1001}, far, Sphere{0x1.fffffffffffffp-1002}, resting()).status ==
          Status::separated);
    CHECK(ask(Capsule{Vec3(0, 0, 0), Vec3(0x1p-1000, 0, 0), 0}, far, Capsule{}, resting()).status ==
          Status::undecided);
}

#if BRINK_HAVE_REFEREE
TEST_CASE("exact_contact: as in 200 digits, on random queries and those exact in small integers")
{
    for (const support::Pair& pair : support::all_pairs()) {
        if (!pair.closed_form()) continue;
        CAPTURE(pair.name());
        int hits = 0, starts = 0;
        for (std::uint64_t i = 0; i < 400; ++i) {
            const support::Query q = support::query(pair, support::Family::translation, 31, i);
            if (!support::refereed(q)) continue;
            CAPTURE(i);
            const support::Truth truth = support::truth(q);
            if (truth.in_doubt) continue;
            const Verdict verdict = ask(q);
            CHECK((verdict.status == Status::touching) == truth.started);
            CHECK((verdict.status == Status::hit) == (truth.meets && !truth.started));
            starts += truth.started ? 1 : 0;
            if (verdict.status != Status::hit) continue;
            const bool bracketed =
                verdict.t <= truth.t + truth.blur && truth.t <= verdict.t_upper + truth.blur;
            CHECK(bracketed);
            CHECK(verdict.t_upper - verdict.t <= 20 * 0x1p-52 * verdict.t_upper);
            ++hits;
        }
        CHECK(hits > 80);
        CHECK(starts > 10);
    }
}
#endif
