// SPDX-License-Identifier: BSD-3-Clause
#include "machine.h"
#include "pair_sample.h"
#include "part.h"

#include <CLI/CLI.hpp>
#include <approach_with.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace brink::bench {
namespace {

using support::Ending;
using support::Ingredient;
using support::Way;

constexpr std::array<std::string_view, 6> pairs{"sphere-box", "capsule-capsule", "capsule-box",
                                                "box-box",    "hull-hull",       "cylinder-box"};
constexpr std::array ingredients{Ingredient::length_bound, Ingredient::directional, Ingredient::second_order,
                                 Ingredient::features_axis, Ingredient::following};
constexpr std::size_t shown = 4; // of these in the table; for the last one the library speaks itself
constexpr std::array<std::string_view, shown> names{"length_bound", "directional_bound", "second_order",
                                                    "features_axis"};
constexpr double tolerance = 1e-9;
constexpr int quick_queries = 2'000; // see Part::run
constexpr double same_time = 1e-6;   // of t, in steps

struct Tally {
    std::int64_t sum = 0;
    int most = 0;

    void add(int n)
    {
        sum += n;
        most = std::max(most, n);
    }
    double mean(int hits) const { return static_cast<double>(sum) / hits; }
};

/// All hits of a pair with one ingredient and those before it.
struct With {
    Tally calls, steps;
    int capped = 0;
    int others = 0;   // answers that are not the library's
    double apart = 0; // the largest difference of t
};

struct PairCounts {
    std::string_view pair;
    int hits = 0;
    int left_out = 0; // not hits at this tolerance
    int unlike = 0;   // hits for which `following` and the library look a different number of times
    std::array<With, ingredients.size()> with;
    Tally library;
};

void count_way(With& with, const Way& way, const Toi& library)
{
    with.calls.add(way.evaluations);
    with.steps.add(way.steps);
    if (way.ending == Ending::capped) {
        ++with.capped;
        return;
    }
    const double apart = std::fabs(way.t - library.t);
    with.apart = std::max(with.apart, apart);
    if (way.ending != Ending::hit || !(apart <= same_time)) ++with.others;
}

PairCounts count(const PairKind& kind, int queries, Progress& progress)
{
    PairCounts counts{kind.name, 0, 0, 0, {}, {}};
    const Sample sample = draw_sample(kind, Turning::to_60_degrees, static_cast<std::size_t>(queries / 2));
    for (const Pair& pair : sample.hits) {
        const Body& a = sample.bodies[pair.a];
        const Body& b = sample.bodies[pair.b];
        support::Query query{a.shape, a.motion, b.shape, b.motion, {}};
        query.options.tolerance = tolerance;
        const Toi library = answer(query);
        progress.step();
        if (library.status != Status::hit) {
            ++counts.left_out;
            continue;
        }
        ++counts.hits;
        counts.library.add(library.iterations);
        for (std::size_t i = 0; i < ingredients.size(); ++i) {
            const Way way = approach_with(ingredients[i], query);
            count_way(counts.with[i], way, library);
            if (ingredients[i] == Ingredient::following && way.evaluations != library.iterations)
                ++counts.unlike;
        }
    }
    return counts;
}

constexpr std::string_view legend = R"(
Mean / max per hit. First four: evaluations of the distance with this ingredient and those before it. length: gap over the
fastest motion of any point. directional: over the fastest approach along the normal. 2nd order: a certificate for the
normal at rest. features: for the axis that the nearest features ask for, which turns with them. library: what
time_of_impact spends; it tries the normal at rest first, which makes misses cheap, and follows features between
evaluations where those are corners, edges and faces. axis steps: its steps, with an evaluation or without.
)";

std::string cell(const Tally& tally, int hits)
{
    return fmt::format("{:.2f} / {}", tally.mean(hits), tally.most);
}

std::string table(const std::vector<PairCounts>& all)
{
    std::string text = fmt::format(
        "Distance evaluations, both bodies turning by up to 60 degrees, tolerance {:g}\n"
        "{:<16} {:>6} | {:>13} {:>13} {:>13} {:>13} | {:>10} | {:>10}\n",
        tolerance, "pair", "hits", "length", "directional", "2nd order", "features", "library", "axis steps");
    for (const PairCounts& c : all) {
        text += fmt::format("{:<16} {:>6} |", c.pair, c.hits);
        for (std::size_t i = 0; i < shown; ++i)
            text += fmt::format(" {:>13}", cell(c.with[i].calls, c.hits));
        text +=
            fmt::format(" | {:>10} | {:>10}\n", cell(c.library, c.hits), cell(c.with[shown].steps, c.hits));
    }
    return text + std::string(legend.substr(1));
}

std::string table_csv(const std::vector<PairCounts>& all)
{
    std::string text = "pair,hits,counted,mean,max,capped,disagreements,most_apart\n";
    const auto row = [&](const PairCounts& c, std::string_view what, const Tally& tally, const With& with) {
        text += fmt::format("{},{},{},{:.3f},{},{},{},{:.2e}\n", c.pair, c.hits, what, tally.mean(c.hits),
                            tally.most, with.capped, with.others, with.apart);
    };
    for (const PairCounts& c : all) {
        for (std::size_t i = 0; i < shown; ++i)
            row(c, names[i], c.with[i].calls, c.with[i]);
        row(c, "library", c.library, {});
        row(c, "axis_steps", c.with[shown].steps, c.with[shown]);
    }
    return text;
}

/// How far the answers can be relied on; gives how many are not the library's.
int check(const std::vector<PairCounts>& all)
{
    int others = 0, capped = 0, left_out = 0, unlike = 0;
    double apart = 0;
    for (const PairCounts& c : all) {
        left_out += c.left_out;
        unlike += c.unlike;
        for (const With& with : c.with) {
            others += with.others;
            capped += with.capped;
            apart = std::max(apart, with.apart);
        }
    }
    fmt::print(
        "Ended at {} evaluations: {}. No hit within {:g} of the library's t: {}; farthest from it: {:.1e}.\n",
        thousands(support::most_evaluations), capped, same_time, others, apart);
    if (left_out > 0) fmt::print("Left out, undecided by the library: {}.\n", left_out);
    if (unlike > 0) fmt::print("Hits whose axis steps are not quite the library's: {}.\n", unlike);
    return others;
}

/// Distance evaluations per hit of pairs that turn by up to 60 degrees, as ingredients of the certificate are
/// added one by one, and the library's own.
class Ingredients final : public Part {
public:
    std::string_view name() const override { return "ingredients"; }
    std::string_view about() const override
    {
        return "distance evaluations per hit as the ingredients of the certificate are added";
    }
    std::string_view csv() const override { return "ingredients.csv"; }
    void describe(CLI::App&) override;
    std::uint64_t run(const Output&, Effort) override;
    /// None: it counts, and times nothing.
    std::vector<Figure> figures(const Csv&) const override { return {}; }
    std::vector<Picture> pictures() const override { return {}; }

private:
    int queries_ = 10'000;
};

void Ingredients::describe(CLI::App& command)
{
    command.add_option("--queries", queries_, "of each pair, half of them hits; the hits count")
        ->check(CLI::Range(100, 100'000))
        ->capture_default_str();
}

std::uint64_t Ingredients::run(const Output& output, Effort effort)
{
    const int queries = effort == Effort::quick ? std::min(queries_, quick_queries) : queries_;
    std::vector<PairCounts> all;
    Progress progress("ingredients", static_cast<int>(pairs.size()) * (queries / 2));
    for (const PairKind& kind : pairs_turning(Turning::to_60_degrees))
        if (std::find(pairs.begin(), pairs.end(), kind.name) != pairs.end())
            all.push_back(count(kind, queries, progress));
    output.write(csv(), table_csv(all));
    fmt::print("{}\n\n{}\n", machine(), table(all));
    const int others = check(all);
    fmt::print("Figures: {}\n", output.path_of(csv()));
    return static_cast<std::uint64_t>(others);
}

} // namespace

std::unique_ptr<Part> ingredients_part() { return std::make_unique<Ingredients>(); }

} // namespace brink::bench
