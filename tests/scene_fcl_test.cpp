// SPDX-License-Identifier: BSD-3-Clause
// A whole scene against FCL: its dynamic tree over the same swept boxes, and its conservative advancement of
// each pair, which proves contact where it finds some and nothing where it finds none.
#include "support/fcl.h"
#include "support/fcl_tree.h"
#include "support/print.h"
#include "support/referee.h"
#include "support/scenes.h"
#include "support/verdict.h"

#include <brink/distance.h>
#include <brink/scene.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

using namespace brink;

namespace {

using IdPair = std::pair<BodyId, BodyId>;

bool unbounded(const Body& b)
{
    return std::holds_alternative<Plane>(b.shape) || std::holds_alternative<HalfSpace>(b.shape);
}
bool rests(const Body& b) { return b.immovable || b.asleep; }

/// Those that FCL can be asked about: of bounded bodies.
std::vector<IdPair> candidates_of(Scene& scene)
{
    std::vector<IdPair> pairs;
    for (const BodyPair& p : scene.candidates())
        if (!unbounded(scene.body(p.a)) && !unbounded(scene.body(p.b))) pairs.emplace_back(p.a, p.b);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

/// The pairs whose boxes overlap by FCL, but for those that a scene is not asked about.
template <class BoxOf> std::vector<IdPair> fcl_pairs(const Scene& scene, BoxOf box_of)
{
    std::vector<Aabb> boxes;
    std::vector<BodyId> ids;
    for (BodyId id = 0; id < scene.size(); ++id) {
        if (unbounded(scene.body(id))) continue;
        boxes.push_back(box_of(id));
        ids.push_back(id);
    }
    std::vector<IdPair> pairs;
    for (const auto& [a, b] : support::fcl_overlapping(boxes))
        if (!(rests(scene.body(ids[a])) && rests(scene.body(ids[b])))) pairs.emplace_back(ids[a], ids[b]);
    return pairs;
}

/// What is wrong with the answer, by the referee where it knows the pair and by the dense reference.
support::Findings findings(const support::Query& query, const Toi& toi)
{
    support::Trial trial(query, toi);
    support::Findings all = support::judge_by_reference(trial);
    if (!support::refereed(query)) return all;
    const support::Findings more = support::verify(query, toi);
    all.insert(all.end(), more.begin(), more.end());
    return all;
}

} // namespace

TEST_CASE("Scene and FCL: a thousand bodies of every scene, every difference judged")
{
    constexpr double much = 1e-3; // FCL's own tolerance, in time, and in the length of a body
    int hits = 0, missed = 0, differ = 0, refereed = 0;
    std::size_t all_pairs = 0, all_impacts = 0;
    for (const std::string_view name : support::scene_names) {
        CAPTURE(name);
        Scene scene;
        for (const Body& body : support::draw_scene(name, 1000, 20261122).bodies)
            scene.add(body);
        const std::vector<IdPair> pairs = candidates_of(scene);
        REQUIRE(pairs == fcl_pairs(scene, [&](BodyId id) { return scene.swept_bounds(id); }));
        const std::vector<IdPair> least = fcl_pairs(
            scene, [&](BodyId id) { return swept_bounds(scene.body(id).shape, scene.body(id).motion); });
        CHECK(std::includes(pairs.begin(), pairs.end(), least.begin(), least.end()));
        // Floats cost next to nothing; the room for turns, which rain has, does.
        if (name != "rain") CHECK(pairs.size() <= least.size() + 3);
        all_pairs += pairs.size();

        std::map<IdPair, Toi> impacts;
        for (const Impact& impact : scene.impacts().found)
            if (!unbounded(scene.body(impact.a)) && !unbounded(scene.body(impact.b)))
                impacts[{impact.a, impact.b}] = impact.toi;
        all_impacts += impacts.size();
        for (const auto& [pair, toi] : impacts) // a pair in contact has boxes that overlap
            CHECK(std::binary_search(pairs.begin(), pairs.end(), pair));
        std::vector<support::FclBody> bodies;
        for (BodyId id = 0; id < scene.size(); ++id)
            bodies.emplace_back(scene.body(id).shape);

        for (const IdPair& pair : pairs) {
            const Body &a = scene.body(pair.first), &b = scene.body(pair.second);
            if (!support::fcl_trusts(support::FclQuestion::conservative_advancement, a.shape, b.shape))
                continue;
            const std::optional<double> fcl =
                support::fcl_continuous(support::FclQuestion::conservative_advancement, bodies[pair.first],
                                        a.motion, bodies[pair.second], b.motion);
            const auto found = impacts.find(pair);
            const bool hit = found != impacts.end();
            hits += fcl.has_value();
            missed += hit && !fcl;
            if (hit == fcl.has_value() && (!hit || std::fabs(found->second.t - *fcl) <= much)) continue;
            ++differ;
            const support::Query query{a.shape, a.motion, b.shape, b.motion, {}};
            const Toi toi = hit ? found->second : support::answer(query);
            CAPTURE(support::as_cpp(query));
            CAPTURE(support::in_words(toi));
            CAPTURE((fcl ? *fcl : infinity));
            CHECK(findings(query, toi).empty());
            refereed += support::refereed(query);
            // FCL stops short of contact, which takes long where bodies near each other slowly.
            const auto gap_then = [&] {
                return distance(a.shape, a.motion.at(*fcl), b.shape, b.motion.at(*fcl)).gap;
            };
            if (fcl) CHECK((hit && (found->second.t <= *fcl + much || std::fabs(gap_then()) <= much)));
        }
    }
    MESSAGE("FCL: ", hits, " of ", all_pairs, " pairs meet; brink: ", all_impacts, "; they differ in ",
            differ, ", of which FCL missed ", missed, "; the referee heard ", refereed);
    CHECK(hits > 3000);
}
