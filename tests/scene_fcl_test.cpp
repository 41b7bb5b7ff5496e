// SPDX-License-Identifier: BSD-3-Clause
// A whole scene against FCL: its dynamic tree over the same swept boxes, and its conservative advancement of
// each pair, which proves contact where it finds some and nothing where it finds none.
#include "support/fcl.h"
#include "support/fcl_tree.h"
#include "support/print.h"
#include "support/referee.h"
#include "support/scenes.h"
#include "support/verdict.h"

#include <brink/scene.h>

#include <doctest/doctest.h>

#include <algorithm>
#include <map>

using namespace brink;

namespace {

using IdPair = std::pair<BodyId, BodyId>;

std::vector<IdPair> candidates_of(Scene& scene)
{
    std::vector<IdPair> pairs;
    for (const BodyPair& p : scene.candidates())
        pairs.emplace_back(p.a, p.b);
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

std::vector<Aabb> boxes_of(Scene& scene)
{
    std::vector<Aabb> boxes;
    for (BodyId id = 0; id < scene.size(); ++id)
        boxes.push_back(scene.swept_bounds(id));
    return boxes;
}

std::vector<Aabb> exact_boxes_of(const Scene& scene)
{
    std::vector<Aabb> boxes;
    for (BodyId id = 0; id < scene.size(); ++id)
        boxes.push_back(swept_bounds(scene.body(id).shape, scene.body(id).motion));
    return boxes;
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

TEST_CASE("Scene and FCL: a thousand bodies of gas, every difference judged")
{
    constexpr double much = 1e-3; // FCL's own tolerance, in time
    Scene scene;
    for (const Body& body : support::draw_scene("gas", 1000, 20261122).bodies)
        scene.add(body);
    const std::vector<IdPair> pairs = candidates_of(scene);
    REQUIRE(pairs == support::fcl_overlapping(boxes_of(scene)));
    const std::vector<IdPair> least = support::fcl_overlapping(exact_boxes_of(scene));
    CHECK(std::includes(pairs.begin(), pairs.end(), least.begin(), least.end()));
    CHECK(pairs.size() <= least.size() + 3); // floats cost next to nothing

    std::map<IdPair, Toi> impacts;
    for (const Impact& impact : scene.impacts().found)
        impacts[{impact.a, impact.b}] = impact.toi;
    std::vector<support::FclBody> bodies;
    for (BodyId id = 0; id < scene.size(); ++id)
        bodies.emplace_back(scene.body(id).shape);

    int hits = 0, missed = 0, differ = 0, refereed = 0;
    for (const IdPair& pair : pairs) {
        const Body &a = scene.body(pair.first), &b = scene.body(pair.second);
        if (!support::fcl_trusts(support::FclQuestion::conservative_advancement, a.shape, b.shape)) continue;
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
        if (fcl) CHECK((hit && found->second.t <= *fcl + much));
    }
    MESSAGE("FCL: ", hits, " of ", pairs.size(), " pairs meet; brink: ", impacts.size(), "; they differ in ",
            differ, ", of which FCL missed ", missed, "; the referee heard ", refereed);
    CHECK(hits > 400);
    for (const auto& [pair, toi] : impacts) // a pair in contact has boxes that overlap
        CHECK(std::binary_search(pairs.begin(), pairs.end(), pair));
}
