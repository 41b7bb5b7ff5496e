// SPDX-License-Identifier: BSD-3-Clause
#include "support/print.h"
#include "support/query_text.h"
#include "support/verdict.h"

#if BRINK_HAVE_REFEREE
#include "support/referee_turning.h"
#endif

#include <doctest/doctest.h>

#include <array>

namespace brink::tests {
namespace {

using namespace support;

const std::vector<KeptQuery>& rubble()
{
    static const std::vector<KeptQuery> queries =
        read_queries(std::filesystem::path(BRINK_SOURCE_DIR "/bench/workloads/rubble.txt"));
    return queries;
}

} // namespace

TEST_CASE("workload: the rubble's queries come out as they were recorded")
{
    struct Kind {
        std::string_view note;
        Status status;
        int seen;
    };
    std::array<Kind, 4> kinds{{{"touching at the start", Status::touching, 0},
                               {"meets", Status::hit, 0},
                               {"near miss", Status::separated, 0},
                               {"clear miss", Status::separated, 0}}};
    for (const KeptQuery& kept : rubble()) {
        CAPTURE(kept.line);
        for (Kind& kind : kinds) {
            if (!kept.note.starts_with(kind.note)) continue;
            ++kind.seen;
            CHECK(name(answer(kept.query).status) == name(kind.status));
        }
    }
    CHECK(kinds[0].seen == 500);
    CHECK(kinds[1].seen == 1600);
    CHECK(kinds[2].seen == 900);
    CHECK(kinds[3].seen == 1000);
}

TEST_CASE("workload: the rubble's answers keep every promise")
{
    std::size_t asked = 0;
    for (std::size_t i = 0; i < rubble().size(); i += 8) {
        const KeptQuery& kept = rubble()[i];
        CAPTURE(kept.line);
        Trial trial(kept.query);
        ++asked;
        for (const Finding& finding : judge_alone(trial))
            FAIL_CHECK(finding.check, ": ", finding.detail, "\n", as_cpp(kept.query, kept.note));
#if BRINK_HAVE_REFEREE
        for (const Finding& finding : rule(kept.query, trial.toi()).findings)
            FAIL_CHECK("referee: ", finding.check, ": ", finding.detail, "\n", as_cpp(kept.query, kept.note));
#endif
    }
    CHECK(asked == 500);
}

} // namespace brink::tests
