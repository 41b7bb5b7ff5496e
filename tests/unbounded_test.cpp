// SPDX-License-Identifier: BSD-3-Clause
#include "unbounded.h"

#include "packet.h"
#include "support/draw.h"
#include "support/moving.h"
#include "support/random.h"
#include "support/real.h"

#include <doctest/doctest.h>

#include <set>

using namespace brink;
using support::Random;
using support::Real;
using support::Real3;

namespace {

struct World {
    BodyStore store;
    BroadPhase broad;
};

Body draw_border(Random& random, double far, double size)
{
    Body body{support::draw_shape(random, random.chance(0.5) ? 4 : 5, support::ShapeStyle::any)};
    const Vec3 at = random.in_cube(5 * size);
    body.motion = support::resting(far * Vec3(1, -1, 0.5) + at);
    body.motion.start.orientation = support::draw_orientation(random);
    const int kind = random.index(8);
    if (kind == 0) body.motion.translation = random.in_cube(size);
    if (kind == 1) body.motion.rotation = random.in_cube(1);
    body.immovable = kind > 5;
    return body;
}

World draw_world(Random& random, double far, double size)
{
    World w;
    for (int i = 0; i < 60; ++i)
        w.store.add(draw_border(random, far, size));
    for (int i = 0; i < 200; ++i) {
        const Vec3 at = random.in_cube(6 * size), by = random.in_cube(3 * size);
        const double radius = random.chance(0.2) ? 0 : size * random.between(0, 1);
        w.store.add({Sphere{radius}, support::moving(far * Vec3(1, -1, 0.5) + at, by)});
    }
    w.store.add({Sphere{1e300}});
    for (std::uint32_t slot = 0; slot < w.store.bodies.size(); ++slot)
        w.broad.add(slot, w.store);
    w.broad.update(w.store);
    return w;
}

/// Turned by M(q) / |q|^2.
Real3 turned(const Quat& q, const Real3& v)
{
    const Real3 u{q.x(), q.y(), q.z()};
    const Real w = q.w(), square = w * w + dot(u, u);
    const Real3 t = Real{2} * cross(u, v);
    return (1 / square) * (square * v + w * t + cross(u, t));
}

/// The plane or half-space of a body that stands still, as a point's height above it.
class Height {
public:
    Height(const Body& body, V3 origin)
    {
        const auto* plane = std::get_if<Plane>(&body.shape);
        const auto* half = std::get_if<HalfSpace>(&body.shape);
        const Real3 n = support::real3(plane ? plane->normal : half->normal);
        solid = half != nullptr;
        normal_ = turned(body.motion.start.orientation, (1 / norm(n)) * n);
        const Real3 at = support::real3(body.motion.start.position) - Real3{origin.x, origin.y, origin.z};
        offset_ = Real{plane ? plane->offset : half->offset} / norm(n) + dot(normal_, at);
    }
    Real operator()(const Real3& p) const { return dot(normal_, p) - offset_; }
    bool solid = false;

private:
    Real3 normal_;
    Real offset_ = 0;
};

bool stands(const Body& body)
{
    return body.motion.translation == Vec3(0, 0, 0) && body.motion.rotation == Vec3(0, 0, 0);
}

/// Whether a moving ball is on one side all the time until then.
bool passes(const Packet& p, int lane, const Height& height, const JoinRules& rules)
{
    const Real3 from{p.balls.from[0][lane], p.balls.from[1][lane], p.balls.from[2][lane]};
    const Real3 by{p.balls.by[0][lane], p.balls.by[1][lane], p.balls.by[2][lane]};
    const Real r = Real{p.balls.radius[lane]} + Real{rules.grown};
    const Real begin = height(from), end = height(from + Real{rules.until} * by);
    return (begin > r && end > r) || (!height.solid && begin < -r && end < -r);
}

struct Asked {
    int wrongly_dropped = 0, wrongly_kept = 0, dropped = 0, twice = 0;
    std::vector<Candidate> found;
};

/// All movers against all borders, with so much room at a time.
Asked ask(const World& w, const Plan& plan, std::size_t room)
{
    Asked asked;
    Candidates to;
    for (std::uint32_t leaf = 0; leaf < w.broad.movers.leaves(); ++leaf) {
        Packet p;
        make_packet(p, w.broad.movers, leaf, plan);
        Item item{Group::movers, Group::unbounded, leaf, 0};
        std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
        JoinCounts counts;
        while (item.next != no_leaf) {
            to.make_room(room);
            item.next = unbounded_candidates(p, item, w.store, w.broad, plan, to, counts);
            for (std::size_t i = 0; i < to.count; ++i) {
                asked.twice += pairs.insert({to[i].a, to[i].b}).second ? 0 : 1;
                asked.found.push_back(to[i]);
            }
        }
        CHECK(counts.met == pairs.size());
        for (const std::uint32_t slot : w.broad.unbounded) {
            const Body& body = w.store.bodies[slot];
            for (int lane = 0; lane < lanes; ++lane) {
                if ((p.held >> lane & 1U) == 0) continue;
                const bool kept = pairs.contains({p.slots[lane], slot});
                const bool apart =
                    plan.rules.boxes && stands(body) && passes(p, lane, {body, w.broad.origin}, plan.rules);
                asked.dropped += !kept;
                asked.wrongly_dropped += !kept && !apart;
                asked.wrongly_kept += kept && apart;
            }
        }
    }
    return asked;
}

} // namespace

TEST_CASE("unbounded_candidates: a plane or half-space is dropped where it is proven apart, and only there")
{
    int dropped = 0;
    std::size_t kept = 0;
    for (const double far : {0.0, 1e3, 1e8}) {
        for (const double size : {1e-3, 1.0, 1e3}) {
            Random random(20261122, static_cast<std::uint64_t>(far + size));
            const World w = draw_world(random, far, size);
            for (const float until : {1.0F, 0.3F, 0.0F}) {
                Plan plan;
                plan.rules.until = until;
                plan.rules.grown = until < 1 ? static_cast<float>(0.1 * size) : 0;
                const Asked asked = ask(w, plan, 2048);
                CAPTURE(far);
                CAPTURE(size);
                CAPTURE(until);
                CHECK(asked.wrongly_dropped == 0);
                CHECK(asked.wrongly_kept <= 5); // within rounding
                CHECK(asked.twice == 0);
                CHECK(ask(w, plan, lanes * (lanes + 1)).found.size() == asked.found.size());
                dropped += asked.dropped;
                kept += asked.found.size();
                plan.rules.boxes = false;
                CHECK(ask(w, plan, 2048).dropped == 0);
            }
        }
    }
    CHECK(dropped > 100'000);
    CHECK(kept > 50'000);
}

TEST_CASE("unbounded_candidates: a half-space whose offset is far from it is known to its rounding only")
{
    Random random(12);
    int touching = 0, dropped = 0, wrong = 0;
    for (int i = 0; i < 4'000; ++i) {
        const Vec3 n = random.unit(), at = random.in_cube(1);
        const double offset = random.between(-1e8, 1e8), radius = random.log_between(1e-11, 1e-8);
        World w;
        w.store.add({HalfSpace{n, offset}, support::resting(at - offset * n)});
        w.store.add({Sphere{radius}, support::resting(at)});
        w.broad.add(0, w.store);
        w.broad.add(1, w.store);
        w.broad.update(w.store);
        const bool found = !ask(w, {}, 1000).found.empty();
        const Height height(w.store.bodies[0], load(at));
        const bool meets = height({}) <= Real{radius};
        touching += meets;
        dropped += !found;
        wrong += meets && !found;
    }
    CHECK(touching > 1'000);
    CHECK(dropped == 0); // all lie within what the layer cannot tell
    CHECK(wrong == 0);
}

TEST_CASE("unbounded_candidates: what rests is not asked against a resting plane unless all are")
{
    World w;
    w.store.add({Plane{}});
    w.store.add({.shape = Plane{}, .immovable = true});
    w.store.add({.shape = Sphere{1}, .asleep = true});
    for (std::uint32_t slot = 0; slot < 3; ++slot)
        w.broad.add(slot, w.store);
    w.broad.update(w.store);
    Packet p;
    Plan plan;
    make_packet(p, w.broad.arrived.count == 1 ? w.broad.arrived : w.broad.resting, 0, plan);
    Candidates to;
    JoinCounts counts;
    const Item item{Group::arrived, Group::unbounded, 0, 0};
    to.make_room(1000);
    CHECK(unbounded_candidates(p, item, w.store, w.broad, plan, to, counts) == no_leaf);
    CHECK(to.count == 1);
    CHECK(to[0].b == 0);
    plan.rest_pairs = true;
    to.make_room(1000);
    CHECK(unbounded_candidates(p, item, w.store, w.broad, plan, to, counts) == no_leaf);
    CHECK(to.count == 2);
}
