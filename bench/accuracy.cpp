// SPDX-License-Identifier: BSD-3-Clause
#include "accuracy.h"

#include "accuracy_point.h"
#include "machine.h"
#include "pair_sample.h"

#include <benchmark/benchmark.h>
#include <fcl.h>
#include <fmt/format.h>
#include <reference.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <optional>

namespace brink::bench {
namespace {

constexpr std::array<std::string_view, 3> pairs{"capsule-capsule", "box-box", "hull-hull"};
constexpr std::array tolerances{1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12};
constexpr int repetitions = 15;

/// A query with a contact that does not graze.
struct Hit {
    Pair pair;
    support::Real t;     // of first contact, by long double and brute force
    support::Real doubt; // t is within this
};

/// The queries of one pair that count, and FCL's geometries of the bodies.
struct Hits {
    Sample sample;
    std::vector<support::FclBody> fcl;
    std::vector<Hit> hits;
};

/// Empty for a query that does not count.
std::optional<Hit> judged(const Sample& sample, const Pair& pair)
{
    const Body& a = sample.bodies[pair.a];
    const Body& b = sample.bodies[pair.b];
    const support::Query query{a.shape, a.motion, b.shape, b.motion, {}};
    const support::GapOverTime motion(query);
    const support::Reference known = support::reference(query, motion);
    if (known.gave_up || !known.contact || known.grazing) return std::nullopt;
    return Hit{pair, known.t, support::blur(motion) / known.closing_speed};
}

Hits draw_hits(const PairKind& kind, int queries, Progress& progress)
{
    Hits out{draw_sample(kind, Turning::to_60_degrees, static_cast<std::size_t>(queries)), {}, {}};
    for (const Body& body : out.sample.bodies)
        out.fcl.emplace_back(body.shape);
    for (const Pair& pair : out.sample.mixed) {
        if (const std::optional<Hit> hit = judged(out.sample, pair)) out.hits.push_back(*hit);
        progress.step();
    }
    return out;
}

Toi ask_brink(const Hits& of, const Pair& pair, double tolerance)
{
    const Body& a = of.sample.bodies[pair.a];
    const Body& b = of.sample.bodies[pair.b];
    Options options;
    options.tolerance = tolerance;
    return time_of_impact(a.shape, a.motion, b.shape, b.motion, options);
}

std::optional<double> ask_fcl(const Hits& of, const Pair& pair)
{
    return fcl_continuous(support::FclQuestion::conservative_advancement, of.fcl[pair.a],
                          of.sample.bodies[pair.a].motion, of.fcl[pair.b], of.sample.bodies[pair.b].motion);
}

/// The errors of t, from the answers: empty for a hit that was missed.
void judge(AccuracyPoint& point, const Hits& of, const std::vector<std::optional<double>>& answers)
{
    std::vector<double> errors;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const Hit& hit = of.hits[i];
        if (!answers[i]) {
            ++point.missed;
            continue;
        }
        const support::Real after = *answers[i] - hit.t;
        if (after > hit.doubt + 0x1p-53L) ++point.late;
        errors.push_back(static_cast<double>(std::abs(after)));
    }
    if (errors.empty()) return;
    std::sort(errors.begin(), errors.end());
    const auto at = [&](double share) {
        return errors[static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1))];
    };
    point.p50 = at(0.5);
    point.p99 = at(0.99);
    point.most = errors.back();
}

AccuracyPoint brink_point(const Hits& of, double tolerance)
{
    AccuracyPoint point;
    point.who = "brink";
    point.tolerance = tolerance;
    std::vector<std::optional<double>> answers;
    for (const Hit& hit : of.hits) {
        const Toi toi = ask_brink(of, hit.pair, tolerance);
        point.calls += toi.iterations / static_cast<double>(of.hits.size());
        if (toi.status == Status::undecided) ++point.undecided;
        answers.push_back(toi.status == Status::separated ? std::nullopt : std::optional(toi.t));
    }
    judge(point, of, answers);
    return point;
}

AccuracyPoint fcl_point(const Hits& of)
{
    AccuracyPoint point;
    point.who = "FCL";
    std::vector<std::optional<double>> answers;
    for (const Hit& hit : of.hits)
        answers.push_back(ask_fcl(of, hit.pair));
    judge(point, of, answers);
    return point;
}

/// ns of processor time per hit, for all of them in turn.
double time_hits(const Hits& of, const AccuracyPoint& point)
{
    const std::clock_t start = std::clock();
    for (const Hit& hit : of.hits) {
        if (point.who == "FCL")
            benchmark::DoNotOptimize(ask_fcl(of, hit.pair));
        else
            benchmark::DoNotOptimize(ask_brink(of, hit.pair, point.tolerance));
    }
    const auto ticks = static_cast<double>(std::clock() - start);
    return ticks / CLOCKS_PER_SEC * 1e9 / static_cast<double>(of.hits.size());
}

/// All points of a pair; their repetitions take turns, so that all see the same machine.
std::vector<AccuracyPoint> measure(const Hits& of, std::string_view pair)
{
    std::vector<AccuracyPoint> points;
    for (const double tolerance : tolerances)
        points.push_back(brink_point(of, tolerance));
    points.push_back(fcl_point(of));
    std::vector<double> squares(points.size());
    for (int i = 0; i < repetitions; ++i)
        for (std::size_t k = 0; k < points.size(); ++k) {
            const double ns = time_hits(of, points[k]);
            points[k].ns += ns / repetitions;
            squares[k] += ns * ns / repetitions;
        }
    for (std::size_t k = 0; k < points.size(); ++k) {
        const double variance = std::max(0.0, squares[k] - points[k].ns * points[k].ns);
        points[k].deviation = std::sqrt(variance * repetitions / (repetitions - 1));
        points[k].hits = static_cast<int>(of.hits.size());
        points[k].pair = pair;
    }
    return points;
}

} // namespace

std::vector<std::string> accuracy_pairs() { return {pairs.begin(), pairs.end()}; }

int run_accuracy(const Output& output, const AccuracyOptions& options)
{
    const auto wanted = [&](std::string_view name) {
        const auto is = [&](const std::string& n) { return n == name || n == "all"; };
        return std::any_of(options.pairs.begin(), options.pairs.end(), is);
    };
    const auto count = static_cast<int>(std::count_if(pairs.begin(), pairs.end(), wanted));
    std::vector<AccuracyPoint> points;
    Progress progress("accuracy", count * options.queries);
    for (const PairKind& kind : pairs_turning(Turning::to_60_degrees)) {
        if (std::find(pairs.begin(), pairs.end(), kind.name) == pairs.end() || !wanted(kind.name)) continue;
        const Hits hits = draw_hits(kind, options.queries, progress);
        const std::vector<AccuracyPoint> more = measure(hits, kind.name);
        points.insert(points.end(), more.begin(), more.end());
    }
    output.write("accuracy.csv", accuracy_csv(points));
    fmt::print("{}\n\n{}\n", machine(), accuracy_table(points));
    fmt::print("{}\n", output.draw("accuracy", accuracy_plot(points)));
    fmt::print("Figures: {}\n", output.path_of("accuracy.csv"));
    int broken = 0;
    for (const AccuracyPoint& point : points)
        if (point.who == "brink") broken += point.missed + point.late;
    return broken;
}

} // namespace brink::bench
