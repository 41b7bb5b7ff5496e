// SPDX-License-Identifier: BSD-3-Clause
#include "random.h"
#include "scenes.h"

#include <brink/ccd.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <stdexcept>
#include <string>

using namespace brink;
using support::draw_scene;
using support::SceneSample;

namespace {

bool still(const Body& body) { return body.immovable || body.asleep; }

bool meet(const Aabb& a, const Aabb& b)
{
    return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

/// Pairs whose swept boxes meet and of which one moves.
std::size_t overlaps(const SceneSample& sample)
{
    std::vector<Aabb> boxes;
    for (const Body& body : sample.bodies)
        boxes.push_back(swept_bounds(body.shape, body.motion));
    std::vector<std::size_t> order(boxes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return boxes[a].min.x() < boxes[b].min.x(); });
    std::size_t count = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            const std::size_t a = order[i], b = order[j];
            if (boxes[b].min.x() > boxes[a].max.x()) break;
            count += !(still(sample.bodies[a]) && still(sample.bodies[b])) && meet(boxes[a], boxes[b]);
        }
    return count;
}

double per_body(const SceneSample& sample)
{
    return static_cast<double>(overlaps(sample)) / static_cast<double>(sample.bodies.size());
}

/// The sample with every mover in another step.
SceneSample at_step(SceneSample sample, int step)
{
    const std::vector<BodyId> ids = support::movers(sample);
    const std::vector<Motion> motions = support::motions_at(sample, ids, step);
    for (std::size_t i = 0; i < ids.size(); ++i)
        sample.bodies[ids[i]].motion = motions[i];
    return sample;
}

/// Of every bit but those of the shapes' sizes, which their swept bounds stand for.
class Hash {
public:
    std::uint64_t value = 0;

    void add(std::uint64_t word) { value = support::Random(value ^ word).bits(); }
    void add(const Vec3& v)
    {
        for (int axis = 0; axis < 3; ++axis)
            add(std::bit_cast<std::uint64_t>(v[axis]));
    }
    void add(const Motion& m)
    {
        add(m.start.position);
        add(m.start.orientation.vec());
        add(std::bit_cast<std::uint64_t>(m.start.orientation.w()));
        add(m.translation);
        add(m.rotation);
        add(m.pivot);
    }
};

std::uint64_t fingerprint(const SceneSample& sample)
{
    Hash hash;
    for (std::size_t i = 0; i < sample.bodies.size(); ++i) {
        const Body& body = sample.bodies[i];
        const Aabb box = swept_bounds(body.shape, body.motion);
        hash.add(body.shape.index());
        hash.add(box.min);
        hash.add(box.max);
        hash.add(body.motion);
        hash.add(sample.aside[i]);
        hash.add((body.immovable ? 1U : 0U) + (body.asleep ? 2U : 0U));
    }
    return hash.value;
}

} // namespace

TEST_CASE("scenes: as many bodies as asked for, all of them valid in every step")
{
    for (const std::string_view name : support::scene_names)
        for (const std::size_t n : {1U, 2U, 11U, 150U, 1000U}) {
            CAPTURE(name);
            CAPTURE(n);
            const SceneSample sample = draw_scene(name, n, 1);
            CHECK(sample.bodies.size() == n);
            CHECK(sample.aside.size() == n);
            for (int step = 0; step < 4; ++step)
                for (const Body& body : at_step(sample, step).bodies) {
                    const Toi far =
                        time_of_impact(body.shape, body.motion, Sphere{1}, Motion::still({Vec3(0, 0, 1e9)}));
                    REQUIRE(far.status != Status::invalid);
                    const bool moves = body.motion.translation != Vec3(0, 0, 0);
                    CHECK(!(moves && still(body)));
                }
        }
    CHECK_THROWS_AS(draw_scene("gass", 10, 1), std::invalid_argument);
    CHECK_THROWS_AS(draw_scene("gas", 0, 1), std::invalid_argument);
}

TEST_CASE("scenes: a body has as many pairs at any n, in every step")
{
    struct Range {
        std::string_view name;
        double least, most; // pairs a body
    };
    // A bullet is one body in a hundred.
    for (const Range& range :
         {Range{"gas", 2.7, 3.2}, Range{"clustered", 2.3, 3.6}, Range{"bullets", 0.8, 1.3},
          Range{"asleep", 0.03, 0.06}, Range{"stacks", 0.9, 2}, Range{"rain", 1.3, 1.7}})
        for (const std::size_t n : {4'000U, 40'000U}) {
            const SceneSample sample = draw_scene(range.name, n, 7);
            for (const int step : {0, 1, 2}) {
                if (range.name == "stacks" && n > 4'000) continue; // all have the floor's x
                const double pairs = per_body(at_step(sample, step));
                CAPTURE(range.name);
                CAPTURE(n);
                CAPTURE(step);
                CHECK(pairs > range.least);
                CHECK(pairs < range.most);
            }
        }
}

TEST_CASE("scenes: the same bits for a seed, with every compiler, and others for another")
{
    for (const std::string_view name : support::scene_names) {
        CAPTURE(name);
        const SceneSample sample = draw_scene(name, 500, 3);
        CHECK(fingerprint(sample) == fingerprint(draw_scene(name, 500, 3)));
        CHECK(fingerprint(sample) != fingerprint(draw_scene(name, 500, 4)));
        CHECK(fingerprint(sample) != fingerprint(draw_scene(name, 501, 3)));
        CHECK(fingerprint(sample) != fingerprint(support::in_spatial_order(sample)));
    }
    Hash all;
    for (const std::string_view name : support::scene_names)
        for (int step = 0; step < 4; ++step)
            all.add(fingerprint(at_step(support::in_spatial_order(draw_scene(name, 500, 3)), step)));
    CHECK(all.value == 16443767788789071672U);
}

TEST_CASE("scenes: each is what its name says")
{
    const auto count = [](const SceneSample& sample, auto&& of) {
        return std::count_if(sample.bodies.begin(), sample.bodies.end(), of);
    };
    const auto immovable = [](const Body& body) { return body.immovable; };
    const auto asleep = [](const Body& body) { return body.asleep; };
    CHECK(support::movers(draw_scene("gas", 1000, 1)).size() == 1000);
    CHECK(support::movers(draw_scene("bullets", 1000, 1)).size() == 10);
    CHECK(count(draw_scene("bullets", 1000, 1), immovable) == 990);
    CHECK(count(draw_scene("asleep", 1000, 1), asleep) == 990);
    CHECK(count(draw_scene("stacks", 1000, 1), immovable) == 1);

    const SceneSample rain = draw_scene("rain", 1000, 1);
    std::array<int, 10> kinds{};
    int off_centre = 0;
    for (const Body& body : rain.bodies) {
        ++kinds.at(body.shape.index());
        off_centre += body.motion.pivot != Vec3(0, 0, 0);
    }
    for (const std::size_t kind : {0U, 1U, 2U, 3U, 6U, 7U, 8U, 9U}) // all but planes and half-spaces
        CHECK(kinds.at(kind) > 80);
    CHECK(off_centre > 150);

    double least = 1e9, most = 0;
    for (const Body& body : draw_scene("clustered", 1000, 1).bodies) {
        const double size = (bounds(body.shape, body.motion.start).max - body.motion.start.position).norm();
        least = std::min(least, size);
        most = std::max(most, size);
    }
    CHECK(most > 400 * least);
}

TEST_CASE("scenes: stacked boxes touch, and bullets start clear of everything")
{
    const SceneSample stacks = draw_scene("stacks", 201, 1);
    int touching = 0;
    for (std::size_t i = 0; i < stacks.bodies.size(); ++i)
        for (std::size_t j = i + 1; j < stacks.bodies.size(); ++j) {
            const Body &a = stacks.bodies[i], &b = stacks.bodies[j];
            const Distance d = distance(a.shape, a.motion.start, b.shape, b.motion.start);
            CHECK(d.gap >= 0);
            touching += d.gap == 0;
        }
    CHECK(touching == 200); // each has the floor or a box below it

    const SceneSample bullets = draw_scene("bullets", 2000, 1);
    int hits = 0;
    for (int step = 0; step < 4; ++step) {
        const SceneSample now = at_step(bullets, step);
        for (const BodyId id : support::movers(now))
            for (std::size_t j = 0; j < now.bodies.size(); ++j) {
                if (j == id) continue;
                const Body &a = now.bodies[id], &b = now.bodies[j];
                const Toi toi = time_of_impact(a.shape, a.motion, b.shape, b.motion);
                CHECK(toi.status != Status::touching);
                hits += toi.status == Status::hit;
            }
    }
    CHECK(hits > 40);
}

TEST_CASE("scenes: spatial order keeps the bodies, and puts neighbours side by side")
{
    const SceneSample sample = draw_scene("gas", 5000, 1);
    const SceneSample sorted = support::in_spatial_order(sample);
    const auto way = [](const SceneSample& s) {
        double sum = 0;
        for (std::size_t i = 1; i < s.bodies.size(); ++i)
            sum += (s.bodies[i].motion.start.position - s.bodies[i - 1].motion.start.position).norm();
        return sum;
    };
    CHECK(way(sorted) < 0.15 * way(sample));
    const auto positions = [](const SceneSample& s) {
        std::vector<double> all;
        for (std::size_t i = 0; i < s.bodies.size(); ++i)
            all.push_back(s.bodies[i].motion.start.position.x() + 1e3 * s.aside[i].y());
        std::sort(all.begin(), all.end());
        return all;
    };
    CHECK(positions(sorted) == positions(sample));
    CHECK(overlaps(sorted) == overlaps(sample));
}

TEST_CASE("scenes: after four steps a scene is where it was, and no two steps sweep the same")
{
    const SceneSample sample = draw_scene("rain", 300, 1);
    CHECK(fingerprint(at_step(sample, 4)) == fingerprint(sample));
    double drift = 0;
    const SceneSample last = at_step(sample, 3), first = sample;
    for (std::size_t i = 0; i < sample.bodies.size(); ++i) {
        const Vec3 end = last.bodies[i].motion.at(1).position;
        drift = std::max(drift, (end - first.bodies[i].motion.start.position).norm());
    }
    CHECK(drift < 1e-12);
    for (int step = 0; step < 4; ++step)
        CHECK(fingerprint(at_step(sample, step)) != fingerprint(at_step(sample, step + 1)));
}
