// SPDX-License-Identifier: BSD-3-Clause
#include "join.h"

#include "sweep_field.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
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

bool same(const Joined& x, const Joined& y, bool with_times)
{
    const auto equal = [&](const Candidate& a, const Candidate& b) {
        const bool t = std::bit_cast<std::uint32_t>(a.t) == std::bit_cast<std::uint32_t>(b.t);
        return a.a == b.a && a.b == b.b && (t || !with_times);
    };
    return std::equal(x.found.begin(), x.found.end(), y.found.begin(), y.found.end(), equal) &&
           x.counts.met == y.counts.met && x.counts.receding == y.counts.receding &&
           x.counts.spheres == y.counts.spheres && x.counts.late == y.counts.late;
}

/// What a list of candidates leaves out that meets in time, and says too late.
struct Faults {
    int lost = 0, late = 0;
    std::size_t meeting = 0, kept = 0;

    Faults& operator+=(const Faults& f)
    {
        lost += f.lost, late += f.late, meeting += f.meeting, kept += f.kept;
        return *this;
    }
};

Faults faults_of(const Joined& joined, const SweepField& of, const SweepField& with, const Plan& plan)
{
    const bool self = &of == &with;
    const Real grown = plan.rules.grown, until = plan.rules.until, follow = plan.rules.follow;
    const std::set<SlotPair> found = pairs_in(joined, self);
    Faults f;
    f.kept = joined.found.size();
    for (std::uint32_t i = 0; i < of.sweeps.size(); ++i) {
        for (std::uint32_t k = self ? i + 1 : 0; k < with.sweeps.size(); ++k) {
            if (of.living[i] == 0 || with.living[k] == 0) continue;
            if (!(support::first_meeting(of.sweeps[i], with.sweeps[k], grown, follow) <= until)) continue;
            ++f.meeting;
            f.lost += found.contains({i, k}) ? 0 : 1;
        }
    }
    for (const Candidate& c : joined.found)
        f.late += Real{c.t} > support::first_meeting(of.sweeps[c.a], with.sweeps[c.b], grown, follow);
    return f;
}

} // namespace

TEST_CASE("join: the widest and the plain one find the same in the same order, whatever the rules")
{
    std::size_t found = 0, dropped = 0;
    for (const std::size_t n : {1U, 17U, 100U, 2000U}) {
        const SweepField field = support::draw_field(n, 1, 20261122 + n);
        const SweepField other = support::draw_field(n, 1, 77 + n);
        for (unsigned bits = 0; bits < 32; ++bits) {
            if (n > 100 && (bits & 1U) == 0) continue;
            for (const float until : {1.0F, 0.3F, 0.0F}) {
                Plan plan = plan_of(bits, until < 1 ? 0.05F : 0, until);
                CAPTURE(n);
                CAPTURE(bits);
                CAPTURE(until);
                const Joined wide = support::join_all(widest_join(), field, field, plan, plenty);
                const Joined narrow = support::join_all(plain_join(), field, field, plan, plenty);
                CHECK(same(wide, narrow, plan.rules.balls));
                found += wide.found.size();
                dropped += wide.counts.met - wide.found.size();
                plan.rules.follow = 0;
                if (n > 100) continue;
                CHECK(same(support::join_all(widest_join(), field, other, plan, plenty),
                           support::join_all(plain_join(), field, other, plan, plenty), plan.rules.balls));
            }
        }
    }
    CHECK(found > 1'000'000);
    CHECK(dropped > 100'000);
}

TEST_CASE("join: by boxes, each overlapping pair of living bodies once and no other")
{
    for (const std::size_t n : {1U, 16U, 17U, 300U, 5000U}) {
        const SweepField field = support::draw_field(n, 1, 5 + n);
        std::set<SlotPair> all;
        for (std::uint32_t i = 0; i < n; ++i) {
            for (std::uint32_t k = i + 1; k < n; ++k) {
                const bool lives = field.living[i] != 0 && field.living[k] != 0;
                if (lives && overlap(field.sweeps[i].box, field.sweeps[k].box)) all.insert({i, k});
            }
        }
        CAPTURE(n);
        const Joined joined = support::join_all(widest_join(), field, field, plan_of(1, 0, 1), plenty);
        CHECK(pairs_in(joined, true) == all);
        CHECK(joined.counts.met == all.size());
        CHECK(all.size() >= (n > 16 ? n : 0));
        const Joined uncut = support::join_all(widest_join(), field, field, plan_of(0, 0, 1), plenty);
        const auto living = static_cast<std::size_t>(std::count(field.living.begin(), field.living.end(), 1));
        if (n < 5000) CHECK(pairs_in(uncut, true).size() == living * (living - 1) / 2);
    }
}

TEST_CASE("join: what balls drop is proven apart, and no time is late, at every scale")
{
    std::size_t meeting = 0, dropped = 0;
    for (const double size :
         {1e-36, 1e-20, 1e-15, 1e-13, 1e-12, 1e-9, 1e-4, 1.0, 1e4, 1e9, 1e15, 1e18, 1e20, 1e25, 1e30, 1e34}) {
        const auto grown = static_cast<float>(0.03 * size);
        const SweepField field = support::draw_field(299, size, 20261122);
        const SweepField other = support::draw_field(180, size, 1122);
        for (const float until : {1.0F, 0.4F, 0.0F}) {
            for (const unsigned bits : {7U, 11U, 19U, 31U}) {
                Plan plan = plan_of(bits, until == 0.4F ? grown : 0, until);
                CAPTURE(size);
                CAPTURE(until);
                CAPTURE(bits);
                const Joined own = support::join_all(widest_join(), field, field, plan, plenty);
                const Faults f = faults_of(own, field, field, plan);
                CHECK(f.lost == 0);
                CHECK(f.late == 0);
                plan.rules.follow = 0;
                const Faults cast = faults_of(support::join_all(widest_join(), field, other, plan, plenty),
                                              field, other, plan);
                CHECK(cast.lost == 0);
                CHECK(cast.late == 0);
                meeting += f.meeting + cast.meeting;
                dropped += own.counts.met - f.kept;
                if (bits == 31 && std::fabs(std::log10(size)) < 10) CHECK(f.kept < 2 * f.meeting);
            }
        }
    }
    CHECK(meeting > 100'000);
    CHECK(dropped > 30'000);
}

TEST_CASE("join: small balls from far away are not told to meet too late")
{
    Faults all;
    for (std::uint64_t i = 0; i < 600; ++i) {
        Random random(14, i);
        SweepField one, many;
        const double r = random.log_between(1e-4, 1), other = r * random.between(0, 1);
        const Vec3 at = random.in_cube(r), by = random.in_cube(r);
        one.sweeps.push_back(support::sweep_of_ball(at, by, r));
        for (int k = 0; k < 15; ++k) {
            const double far = r * random.log_between(4, 1e6), over = random.between(1, 3);
            const Vec3 from = at + far * random.unit(), aside = random.in_cube(r);
            const Vec3 to = over * (at + aside - from) + by;
            many.sweeps.push_back(support::sweep_of_ball(from, to, other));
        }
        one.plant(0, 1);
        many.plant(0, 1);
        const Plan plan = plan_of(31, 0, 1);
        all += faults_of(support::join_all(widest_join(), one, many, plan, plenty), one, many, plan);
    }
    CHECK(all.lost == 0);
    CHECK(all.late == 0);
    CHECK(all.meeting > 5'000);
}

TEST_CASE("join: a long path meets what it grazes at a side of its box")
{
    Faults all;
    for (std::uint64_t i = 0; i < 300; ++i) {
        Random random(15, i);
        SweepField still, fast;
        const auto grown = static_cast<float>(random.chance(0.5) ? 0 : random.log_between(1e-4, 0.1));
        while (still.sweeps.size() < 180) {
            const Vec3 at = random.in_cube(6);
            still.sweeps.push_back(support::sweep_of_ball(at, Vec3(0, 0, 0), random.log_between(0.01, 0.3)));
        }
        while (fast.sweeps.size() < 15) {
            const Sweep& target = still.sweeps[fast.sweeps.size() * 7];
            const double radius = random.log_between(0.001, 0.1), angle = random.between(0, 6.3),
                         reach = (radius + static_cast<double>(target.radius + grown)) *
                                 (1 - random.log_between(1e-5, 1e-2));
            const int side = random.index(3);
            Vec3 along(0, 0, 0), off(0, 0, 0);
            along[(side + 1) % 3] = std::cos(angle);
            along[(side + 2) % 3] = std::sin(angle);
            off[side] = random.chance(0.5) ? reach : -reach;
            const Vec3 middle = Vec3(target.from[0], target.from[1], target.from[2]) + off;
            const Vec3 from = middle - random.between(1, 8) * along, by = random.between(9, 16) * along;
            fast.sweeps.push_back(support::sweep_of_ball(from, by, radius));
        }
        fast.plant(0, 1);
        still.plant(0, 1);
        still.tree.still = true;
        const Plan plan = plan_of(31, grown, 1);
        all += faults_of(support::join_all(widest_join(), fast, still, plan, plenty), fast, still, plan);
    }
    CHECK(all.lost == 0);
    CHECK(all.late == 0);
    CHECK(all.meeting > 4'500);
    CHECK(2 * all.kept < 3 * all.meeting);
}

TEST_CASE("join: what recedes is not nearing")
{
    constexpr std::uint32_t n = 4'000;
    const SweepField field = support::draw_field(n, 1, 21);
    const Plan plan = plan_of(7, 0, 1);
    const std::set<SlotPair> found =
        pairs_in(support::join_all(widest_join(), field, field, plan, plenty), true);
    // The path of what travels far may be apart from a box that it nears.
    std::vector<bool> travels_far;
    for (const Sweep& sweep : field.sweeps)
        travels_far.push_back(packet_of(sweep, plan).far != 0);
    int receding = 0, nearing = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
        for (std::uint32_t k = i + 1; k < n; ++k) {
            const Sweep &a = field.sweeps[i], &b = field.sweeps[k];
            if (travels_far[i] || travels_far[k]) continue;
            const bool dropped = field.living[i] != 0 && field.living[k] != 0 && overlap(a.box, b.box) &&
                                 !found.contains({i, k});
            Real rate = 0;
            for (int axis = 0; axis < 3; ++axis)
                rate += (Real{b.from[axis]} - a.from[axis]) * (Real{b.by[axis]} - a.by[axis]);
            receding += dropped;
            nearing += dropped && rate < -0.05L; // of up to 1e4
        }
    }
    CHECK(receding > 50);
    CHECK(nearing == 0);
}

TEST_CASE("join: a buffer without room is gone on with where it was left")
{
    for (const std::size_t n : {100U, 300U, 1500U}) {
        const SweepField field = support::draw_field(n, 0.7, 9 + n);
        for (const unsigned bits : {1U, 3U, 31U}) {
            const Plan plan = plan_of(bits, 0, 1);
            const Joined at_once = support::join_all(widest_join(), field, field, plan, 1U << 20U);
            for (const std::size_t room : {272U, 273U, 400U, 1000U}) {
                CAPTURE(n);
                CAPTURE(room);
                CHECK(same(at_once, support::join_all(widest_join(), field, field, plan, room), bits != 1));
                CHECK(same(at_once, support::join_all(plain_join(), field, field, plan, room), bits != 1));
            }
            CHECK(at_once.found.size() > n / 2);
        }
    }
}
