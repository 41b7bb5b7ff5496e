// SPDX-License-Identifier: BSD-3-Clause
#include "error_point.h"
#include "machine.h"
#include "pair_sample.h"
#include "part.h"

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
constexpr int quick_queries = 600; // see Part::run

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
void judge(ErrorPoint& point, const Hits& of, const std::vector<std::optional<double>>& answers)
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

ErrorPoint brink_point(const Hits& of, double tolerance)
{
    ErrorPoint point;
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

ErrorPoint fcl_point(const Hits& of)
{
    ErrorPoint point;
    point.who = "FCL";
    std::vector<std::optional<double>> answers;
    for (const Hit& hit : of.hits)
        answers.push_back(ask_fcl(of, hit.pair));
    judge(point, of, answers);
    return point;
}

/// ns of processor time per hit, for all of them in turn.
double time_hits(const Hits& of, const ErrorPoint& point)
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
std::vector<ErrorPoint> measure(const Hits& of, std::string_view pair)
{
    std::vector<ErrorPoint> points;
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

/// Run time and error of t of pairs that turn by up to 60 degrees, at tolerances from 1e-3 to 1e-12, against
/// long double and brute force, with FCL's conservative advancement beside it.
class Error final : public Part {
public:
    std::string_view name() const override { return "error"; }
    std::string_view about() const override
    {
        return "run time against error of t where both bodies turn, at tolerances 1e-3 to 1e-12; FCL beside "
               "it";
    }
    std::string_view csv() const override { return "error.csv"; }
    void describe(CLI::App&) override;
    std::uint64_t run(const Output&, Effort) override;
    std::vector<Figure> figures(const Csv&) const override;
    std::vector<Picture> pictures() const override;

private:
    int queries_ = 4000;
    std::vector<std::string> pairs_{"all"};
};

void Error::describe(CLI::App& command)
{
    command.add_option("--queries", queries_, "of each pair, half of them hits in brink's eyes")
        ->check(CLI::Range(100, 100'000))
        ->capture_default_str();
    add_choice(command, "--pairs", pairs_, {pairs.begin(), pairs.end()});
}

std::uint64_t Error::run(const Output& output, Effort effort)
{
    const int queries = effort == Effort::quick ? std::min(queries_, quick_queries) : queries_;
    const std::vector<std::string> names = chosen(pairs_, {pairs.begin(), pairs.end()});
    std::vector<ErrorPoint> points;
    Progress progress("error", static_cast<int>(names.size()) * queries);
    for (const PairKind& kind : pairs_turning(Turning::to_60_degrees)) {
        if (std::find(names.begin(), names.end(), kind.name) == names.end()) continue;
        const Hits hits = draw_hits(kind, queries, progress);
        const std::vector<ErrorPoint> more = measure(hits, kind.name);
        points.insert(points.end(), more.begin(), more.end());
    }
    output.write(csv(), error_csv(points));
    fmt::print("{}\n\n{}\n", machine(), error_table(points));
    fmt::print("{}\n", output.draw("error", error_plot(points)));
    fmt::print("Figures: {}\n", output.path_of(csv()));
    std::uint64_t broken = 0;
    for (const ErrorPoint& point : points)
        if (point.who == "brink") broken += static_cast<std::uint64_t>(point.missed + point.late);
    return broken;
}

std::vector<Figure> Error::figures(const Csv& csv) const
{
    std::vector<Figure> figures;
    for (std::size_t i = 0; i < csv.rows(); ++i) {
        const bool brink = csv.text(i, "who") == "brink";
        figures.push_back({.question = csv.text(i, "pair"),
                           .who = brink ? "brink at " + csv.text(i, "tolerance") : csv.text(i, "who"),
                           .time = csv.number(i, "ns_per_hit"),
                           .spread = csv.number(i, "standard_deviation_ns"),
                           .error = csv.number(i, "p50_error"),
                           .worst = csv.number(i, "max_error"),
                           .cases = csv.count(i, "hits"),
                           .missed = csv.count(i, "missed"),
                           .late = csv.count(i, "late")});
    }
    return figures;
}

std::vector<Picture> Error::pictures() const
{
    return {{"error", "Left is more exact, lower is faster: brink's curve lies below and left of FCL's point "
                      "in each pair."}};
}

} // namespace

std::unique_ptr<Part> error_part() { return std::make_unique<Error>(); }

} // namespace brink::bench
