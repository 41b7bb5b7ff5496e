// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "packet.h"
#include "sweep.h"

#include "support/random.h"
#include "support/real.h"

#include <doctest/doctest.h>

#include <cmath>
#include <set>
#include <utility>
#include <vector>

/// Random sweeps in a tree, and what a join says of them.
namespace brink::support {

inline Sweep sweep_of_ball(const Vec3& from, const Vec3& by, double radius)
{
    Sweep s;
    s.radius = static_cast<float>(radius);
    for (int axis = 0; axis < 3; ++axis) {
        s.from[axis] = static_cast<float>(from[axis]);
        s.by[axis] = static_cast<float>(by[axis]);
        const auto f = static_cast<double>(s.from[axis]), b = static_cast<double>(s.by[axis]),
                   r = static_cast<double>(s.radius);
        s.box.min[axis] = round_down(std::min(f, f + b) - r);
        s.box.max[axis] = round_up(std::max(f, f + b) + r);
    }
    return s;
}

inline Sweep everywhere()
{
    constexpr float inf = std::numeric_limits<float>::infinity();
    return {{{-inf, -inf, -inf}, {inf, inf, inf}}, {0, 0, 0}, {0, 0, 0}, inf};
}

/// Balls of about one size at random: some are points, some share their velocity, some are within rounding of
/// touching another, some travel far, and some are everywhere.
class SweepDraw {
public:
    SweepDraw(std::size_t count, double size, std::uint64_t seed)
        : random_(seed),
          size_(size),
          edge_(1.5 * size * std::cbrt(static_cast<double>(count))),
          wind_(random_.in_cube(3 * size))
    {
    }
    Sweep next(const std::vector<Sweep>& before)
    {
        const double radius = random_.chance(0.2) ? 0 : size_ * random_.between(0, 1);
        const int travel = random_.index(20);
        Vec3 at = random_.in_cube(edge_), by = random_.in_cube(4 * size_);
        if (travel < 6) by = wind_;
        if (travel == 6 || travel == 7) by = Vec3(0, 0, 0);
        if (travel == 8) by *= 25;
        if (random_.chance(0.01)) return everywhere();
        if (!before.empty() && random_.chance(0.25)) {
            const Sweep& near = before[static_cast<std::size_t>(random_.index(int(before.size())))];
            const int axis_of = random_.index(6);
            Vec3 away = random_.unit();
            if (axis_of < 3) away = (away[0] < 0 ? -1 : 1) * Vec3::Unit(axis_of);
            const double off = random_.between(-4, 4) * std::ldexp(1, -4 - random_.index(22));
            const double gap = (radius + static_cast<double>(near.radius)) * (1 + off);
            for (int axis = 0; axis < 3 && std::isfinite(near.radius); ++axis) {
                at[axis] = static_cast<double>(near.from[axis]) + gap * away[axis];
                if (travel % 2 == 0) by[axis] = static_cast<double>(near.by[axis]);
            }
        }
        return sweep_of_ball(at, by, radius);
    }

private:
    Random random_;
    double size_, edge_;
    Vec3 wind_;
};

/// Bodies by slot, in a tree in an order of their own, with gaps.
struct SweepField {
    std::vector<Sweep> sweeps;
    std::vector<char> living;
    std::vector<BodyId> ids; // by slot
    BlockTree tree;

    void plant(double erased, std::uint64_t seed)
    {
        Random random(seed);
        const std::size_t n = sweeps.size();
        living.assign(n, 1);
        tree.resize(n);
        tree.count = n;
        for (std::size_t place = 0; place < n; ++place) {
            const auto slot = static_cast<std::uint32_t>((place * 7 + 3) % n);
            ids.push_back(static_cast<BodyId>((place * 11 + 5) % n));
            tree.set(place, slot, sweeps[slot]);
        }
        for (std::size_t place = 0; place < n; ++place) {
            if (!random.chance(erased)) continue;
            living[tree.slots[place]] = 0;
            tree.erase(place);
        }
        tree.bound(ids);
    }
};

/// n: coprime to 7.
inline SweepField draw_field(std::size_t n, double size, std::uint64_t seed, double erased = 0.1)
{
    SweepField field;
    SweepDraw draw(n, size, seed);
    while (field.sweeps.size() < n)
        field.sweeps.push_back(draw.next(field.sweeps));
    field.plant(erased, seed + 1);
    return field;
}

struct Joined {
    std::vector<Candidate> found;
    JoinCounts counts;
};

/// All packets of one field against the tree of another, or of the field itself (`of` and `with` the same:
/// each pair once). room: for candidates, at a time.
inline Joined join_all(Join join, const SweepField& of, const SweepField& with, const Plan& plan,
                       std::size_t room)
{
    Joined all;
    Candidates to;
    for (std::uint32_t leaf = 0; leaf < of.tree.leaves(); ++leaf) {
        Packet p;
        make_packet(p, of.tree, leaf, plan);
        const bool self = &of == &with;
        std::uint32_t next = self ? leaf : 0;
        while (next != no_leaf) {
            to.make_room(room);
            next = join(p, with.tree, self ? leaf : no_leaf, next, plan.rules, to, all.counts);
            for (std::size_t i = 0; i < to.count; ++i)
                all.found.push_back(to[i]);
        }
    }
    return all;
}

inline Plan plan_of(unsigned bits, float grown, float until)
{
    Plan plan;
    JoinRules& r = plan.rules;
    r.boxes = (bits & 1U) != 0;
    r.balls = (bits & 2U) != 0;
    r.receding = (bits & 4U) != 0;
    r.spheres = (bits & 8U) != 0;
    r.late = (bits & 16U) != 0;
    r.until = r.late ? until : 1;
    r.grown = grown;
    plan.grown = static_cast<double>(grown);
    return plan;
}

using SlotPair = std::pair<std::uint32_t, std::uint32_t>;

/// The pairs found, each of which must be there once; of one field against itself in either order.
inline std::set<SlotPair> pairs_in(const Joined& joined, bool self)
{
    std::set<SlotPair> pairs;
    int twice = 0, own = 0;
    for (const Candidate& c : joined.found) {
        own += self && c.a == c.b;
        const bool swap = self && c.b < c.a;
        twice += pairs.insert(swap ? SlotPair{c.b, c.a} : SlotPair{c.a, c.b}).second ? 0 : 1;
    }
    CHECK(twice == 0);
    CHECK(own == 0);
    return pairs;
}

inline bool overlap(const Box3f& a, const Box3f& b)
{
    bool yes = true;
    for (int axis = 0; axis < 3; ++axis)
        yes = yes && a.min[axis] <= b.max[axis] && a.max[axis] >= b.min[axis];
    return yes;
}

/// When the balls first come within `grown` of each other, in long double; infinity if never.
inline Real first_meeting(const Sweep& a, const Sweep& b, Real grown, Real follow)
{
    const Real r = Real{a.radius} + Real{b.radius} + grown;
    if (std::isinf(r)) return 0;
    Real3 d{Real{b.from[0]} - a.from[0], Real{b.from[1]} - a.from[1], Real{b.from[2]} - a.from[2]};
    Real3 v{follow * b.by[0] - a.by[0], follow * b.by[1] - a.by[1], follow * b.by[2] - a.by[2]};
    const Real c = dot(d, d) - r * r, nearing = -dot(d, v);
    if (c <= 0) return 0;
    const Real disc = nearing * nearing - dot(v, v) * c;
    if (!(nearing > 0) || disc < 0) return INFINITY;
    return c / (nearing + std::sqrt(disc));
}

} // namespace brink::support
