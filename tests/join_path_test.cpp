// SPDX-License-Identifier: BSD-3-Clause
// Of the join: paths that are long for what travels on them, and pairs that no longer matter.
#include "sweep_field.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

using namespace brink;
using support::Joined;
using support::overlap;
using support::pairs_in;
using support::plan_of;
using support::Random;
using support::Real;
using support::SlotPair;
using support::SweepField;

namespace {

constexpr std::size_t plenty = 2048;

/// Whether a segment meets a box grown by r, in long double.
bool pierces(const Sweep& path, const Box3f& box, Real r)
{
    Real begin = 0, end = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const Real from = path.from[axis], by = path.by[axis];
        const Real low = box.min[axis] - r - from, high = box.max[axis] + r - from;
        if (by == 0) {
            if (low > 0 || high < 0) return false;
            continue;
        }
        begin = std::max(begin, std::min(low / by, high / by));
        end = std::min(end, std::max(low / by, high / by));
    }
    return begin <= end;
}

/// Those of a leaf near each other; where most are erased a leaf is about as large as its body.
SweepField draw_targets(double size, double erased, std::uint64_t seed)
{
    constexpr std::size_t n = 1600;
    Random random(seed);
    SweepField field;
    field.sweeps.resize(n);
    Vec3 centre = Vec3(0, 0, 0);
    for (std::size_t place = 0; place < n; ++place) {
        if (place % lanes == 0) centre = random.in_cube(60 * size);
        const Vec3 at = centre + random.in_cube(3 * size), by = random.in_cube(size);
        const double radius = random.chance(0.2) ? 0 : size * random.between(0, 1);
        field.sweeps[(7 * place + 3) % n] = support::sweep_of_ball(at, by, radius);
    }
    field.sweeps[17] = support::everywhere();
    field.plant(erased, seed);
    return field;
}

/// Long thin paths, most of them past a corner of a target, some along the axes.
SweepField draw_bullets(double size, const SweepField& targets, std::uint64_t seed)
{
    Random random(seed);
    SweepField field;
    for (int i = 0; i < 400; ++i) {
        Vec3 from = random.in_cube(60 * size), by = random.in_cube(120 * size);
        auto aim = static_cast<std::size_t>(random.index(1600));
        while (targets.living[aim] == 0)
            aim = (aim + 1) % 1600;
        const Box3f& box = targets.sweeps[aim].box;
        const double beyond = random.between(1, 2), off = random.log_between(1e-6, 1);
        const Vec3 miss = random.in_cube(size * off);
        for (int axis = 0; axis < 3; ++axis) {
            const int side = random.index(2);
            const auto corner = static_cast<double>(side == 0 ? box.min[axis] : box.max[axis]);
            if (i % 4 != 0 && std::isfinite(corner)) by[axis] = beyond * (corner + miss[axis] - from[axis]);
        }
        const int flat = random.index(12);
        if (flat < 3) by[flat] = 0;
        if (flat == 4) by[0] = by[1] = 0;
        const double radius = random.chance(0.3) ? 0 : size * random.between(0, 0.2);
        field.sweeps.push_back(support::sweep_of_ball(from, by, radius));
    }
    field.plant(0.05, seed);
    return field;
}

} // namespace

TEST_CASE("join: a long thin path loses nothing that it passes through")
{
    std::size_t hits = 0, kept = 0;
    int met = 0;
    for (const double size : {1e-20, 1e-12, 1.0, 1e6, 1e15, 1e25, 1e33, 2.0, 2e6, 2e15}) {
        const bool alone = size == 2 || size == 2e6 || size == 2e15;
        const SweepField targets = draw_targets(size, alone ? 0.93 : 0, 4);
        const SweepField bullets = draw_bullets(size, targets, 3);
        const Plan plan = plan_of(3, 0, 1);
        const Joined joined = support::join_all(widest_join(), bullets, targets, plan, plenty);
        const std::set<SlotPair> found = pairs_in(joined, false);
        int lost = 0, boxes_met = 0;
        for (std::uint32_t i = 0; i < bullets.sweeps.size(); ++i) {
            const Sweep& path = bullets.sweeps[i];
            if (bullets.living[i] == 0) continue;
            for (std::uint32_t k = 0; k < targets.sweeps.size(); ++k) {
                if (targets.living[k] == 0) continue;
                boxes_met += overlap(path.box, targets.sweeps[k].box);
                // A cube of this half edge lies within the ball.
                if (!pierces(path, targets.sweeps[k].box, Real{path.radius} * 0.577L)) continue;
                ++hits;
                lost += found.contains({i, k}) ? 0 : 1;
            }
        }
        CAPTURE(size);
        CHECK(lost == 0);
        if (size != 1) continue;
        kept += joined.found.size();
        met += boxes_met;
    }
    CHECK(hits > 3'000);
    CHECK(2 * kept < static_cast<std::size_t>(met)); // most of what their boxes overlap they pass by
}

TEST_CASE("join: pairs of which neither id is low enough may be left out, no others")
{
    const SweepField field = support::draw_field(1500, 1, 12);
    Plan plan = plan_of(3, 0, 1);
    const Joined whole = support::join_all(widest_join(), field, field, plan, plenty);
    for (const BodyId below : {0U, 5U, 200U}) {
        plan.rules.below = below;
        const Joined low = support::join_all(widest_join(), field, field, plan, plenty);
        const std::set<SlotPair> found = pairs_in(low, true);
        int lost = 0;
        for (const auto& [a, b] : pairs_in(whole, true)) {
            const bool matters = std::min(field.ids[a], field.ids[b]) <= below;
            lost += matters && !found.contains({a, b});
        }
        CHECK(lost == 0);
        CHECK(low.found.size() < whole.found.size());
    }
}
