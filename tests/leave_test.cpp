// SPDX-License-Identifier: BSD-3-Clause
#include "two_bodies.h"

#include <brink/ccd.h>

#include <doctest/doctest.h>

#include <algorithm>

using namespace brink;
using support::Random;

namespace {

/// What the gap does from the start on, until it first exceeds the target: by how much it falls.
double fallen(const TwoBodies<Core>& scene, double target)
{
    const auto over = [&](double t) { return scene.at(t).gap - target; };
    double left = 1;
    for (int zoom = 0; zoom < 2; ++zoom) {
        int k = 1;
        while (k < 64 && over(left * k / 64) <= 0)
            ++k;
        left *= k / 64.0;
    }
    double highest = -infinity, most = 0;
    for (int k = 0; k <= 256 && highest <= 0; ++k) {
        const double here = over(left * k / 256);
        most = std::max(most, highest - here);
        highest = std::max(highest, here);
    }
    return most;
}

} // namespace

TEST_CASE("leave: out of contact in a few looks, however fast the bodies turn, while the gap grows")
{
    // The pivot is far off, so that nearly all of what the body turns by goes along the surface.
    Random random(271);
    int left = 0, looks = 0;
    for (int i = 0; i < 2'000; ++i) {
        const double radius = random.between(0.05, 0.3), depth = random.log_between(1e-6, 0.1);
        const double away = random.between(0.5, 5), turn = random.between(5, 20), far = random.between(1, 5);
        const double half_length = random.between(0.3, 1), tolerance = random.chance(0.5) ? 1e-9 : 0;
        const Cylinder a{half_length, random.between(0.3, 1)};
        const Sphere b{radius};
        Motion motion_a, motion_b;
        motion_a.rotation = Vec3(0, 0, turn);
        motion_a.pivot = Vec3(random.between(-0.1, 0.1), 0, far);
        motion_b.start.position = Vec3(0, 0.1, half_length + radius - depth);
        motion_b.translation = Vec3(0, 0, away);
        Options options{.tolerance = tolerance, .start_contact = StartContact::ignore_if_separating};
        const Toi toi = time_of_impact(a, motion_a, b, motion_b, options);
        CAPTURE(i);
        CHECK(toi.status == Status::separated);
        CHECK(toi.iterations < 100);
        ++left;
        looks += toi.iterations;
    }
    CHECK(looks < 20 * left);
}

TEST_CASE("leave: out of an overlap that is ignored in a few looks, however fast the bodies turn")
{
    Random random(273);
    int left = 0, looks = 0, most = 0;
    for (int i = 0; i < 4'000; ++i) {
        const Shape a = random_shape(random, i % 8), b = random_shape(random, i / 8 % 8);
        Motion motion_a = random_motion(random, 0.7), motion_b = random_motion(random, 0.7);
        motion_a.rotation *= 4;
        motion_b.rotation *= 4;
        const TwoBodies<Core> scene{moving_core(a, motion_a), moving_core(b, motion_b)};
        if (!(scene.at(0).gap < -1e-6)) continue;
        CAPTURE(i);
        const Toi toi = time_of_impact(a, motion_a, b, motion_b, {.start_contact = StartContact::ignore});
        CHECK(toi.status != Status::undecided);
        ++left;
        looks += toi.iterations;
        most = std::max(most, toi.iterations);
    }
    CHECK(left > 500);
    CHECK(looks < 20 * left);
    CHECK(most < 100);
}

TEST_CASE("leave: what does not prove to separate is touching")
{
    Random random(272);
    int left = 0, touching = 0;
    for (int i = 0; i < 4'000; ++i) {
        const Shape a = random_shape(random, i % 8), b = random_shape(random, i / 8 % 8);
        const Motion motion_a = random_motion(random, 0.7), motion_b = random_motion(random, 0.7);
        const TwoBodies<Core> scene{moving_core(a, motion_a), moving_core(b, motion_b)};
        const double room = random.between(0, 0.6);
        Options options{.target_gap = i % 2 == 0 ? 0 : room,
                        .start_contact = StartContact::ignore_if_separating};
        if (!(scene.at(0).gap < options.target_gap - 1e-6)) continue;
        CAPTURE(i);
        const Toi toi = time_of_impact(a, motion_a, b, motion_b, options);
        ++(toi.status == Status::touching ? touching : left);
        if (toi.status != Status::touching) CHECK(fallen(scene, options.target_gap) < 1e-11);
    }
    CHECK(left > 500);
    CHECK(touching > 500);
}

TEST_CASE("leave: cores that overlap a little and part are let go in a few looks")
{
    // More than half were `touching`, after half of the budget.
    Random random(274);
    int parting = 0, held = 0, looks = 0;
    for (int i = 0; i < 2'000; ++i) {
        const Shape a = random_shape(random, i % 2 == 0 ? 4 : 1), b = random_shape(random, 4);
        Motion motion_a = random_motion(random, 0.7), motion_b = random_motion(random, 0.7);
        for (Motion* motion : {&motion_a, &motion_b}) {
            motion->translation *= 0.05;
            motion->rotation *= 0.05;
        }
        const double overlap = random.log_between(1e-5, 1e-2);
        for (int k = 0; k < 4; ++k) {
            const Separation s = TwoBodies<Core>{moving_core(a, motion_a), moving_core(b, motion_b)}.at(0);
            motion_b.start.position -= (overlap + s.gap) * store(s.normal);
        }
        const TwoBodies<Core> scene{moving_core(a, motion_a), moving_core(b, motion_b)};
        if (!(std::fabs(scene.at(0).gap + overlap) < 0.1 * overlap)) continue;
        const Toi toi =
            time_of_impact(a, motion_a, b, motion_b, {.start_contact = StartContact::ignore_if_separating});
        CAPTURE(i);
        const double most = fallen(scene, 0);
        if (toi.status != Status::touching) CHECK(most < 1e-11);
        if (most > 0) continue;
        ++parting;
        held += toi.status == Status::touching;
        looks += toi.iterations;
    }
    CAPTURE(held);
    CHECK(parting > 500);
    CHECK(held < parting / 10);
    CHECK(looks < 25 * parting);
}
