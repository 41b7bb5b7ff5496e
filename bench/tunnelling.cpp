// SPDX-License-Identifier: BSD-3-Clause
#include "machine.h"
#include "method.h"
#include "part.h"
#include "tunnelling_picture.h"
#include "tunnelling_report.h"
#include "tunnelling_strip.h"

#include <CLI/CLI.hpp>
#include <print.h>

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>
#include <ctime>
#include <fmt/format.h>

namespace brink::bench {
namespace {

constexpr int speeds = 17;             // from 0.1 to 1000 wall thicknesses a step, four a decade
constexpr double lateness = 1e-3;      // of the step: an answer later than that counts as late
constexpr int quick_crossings = 3'400; // see Part::run
constexpr double least_seconds = 4e-3; // that one figure of ns per query rests on

double speed(int k) { return std::pow(10, -1 + 0.25 * k); }

void count(Tally& tally, double contact, const std::optional<double>& answer)
{
    ++tally.crossings;
    if (!answer) {
        ++tally.missed;
        return;
    }
    tally.late += *answer > contact + lateness ? 1 : 0;
    tally.latest = std::max(tally.latest, *answer - contact);
    tally.earliest = std::max(tally.earliest, contact - *answer);
}

/// Processor time, so that what else the machine does is not counted.
double ns_per_query(const Method& method, const std::vector<Question>& questions)
{
    std::size_t asked = 0;
    const std::clock_t begin = std::clock();
    double seconds = 0;
    while (seconds < least_seconds) {
        for (const Question& q : questions)
            benchmark::DoNotOptimize(method.ask(q));
        asked += questions.size();
        seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
    }
    return 1e9 * seconds / static_cast<double>(asked);
}

std::vector<Question> draw(const Scene& scene, int k, int crossings, std::uint64_t seed)
{
    support::Random random(seed, static_cast<std::uint64_t>(k));
    std::vector<Question> questions;
    questions.reserve(static_cast<std::size_t>(crossings));
    for (int i = 0; i < crossings; ++i)
        questions.emplace_back(scene.draw(random, speed(k)));
    return questions;
}

/// A crossing that brink missed is a bug: the first of each scene and speed prints itself as a test.
void print_miss(const Crossing& c)
{
    fmt::print("brink missed a crossing whose contact is at t = {}:\n{}\n", c.contact,
               support::as_cpp({c.a, c.motion_a, c.b, c.motion_b, {}}, "from brink-bench tunnelling"));
}

Row measure(const Scene& scene, const Method& method, double at, const std::vector<Question>& questions)
{
    Row row{&scene, &method, at, {}};
    for (const Question& q : questions) {
        const std::optional<double> answer = method.ask(q);
        if (!answer && &method == &methods.back() && row.tally.missed == 0) print_miss(q.crossing);
        count(row.tally, q.crossing.contact, answer);
    }
    row.tally.ns = ns_per_query(method, questions);
    return row;
}

/// Rows of one scene and method stand together, so that each is one line of the picture.
std::vector<Row> sweep(int each, std::uint64_t seed)
{
    Progress progress("tunnelling", static_cast<int>(scenes.size()) * speeds);
    std::vector<Row> rows;
    for (const Scene& scene : scenes) {
        for (int k = 0; k < speeds; ++k, progress.step()) {
            const std::vector<Question> questions = draw(scene, k, each, seed);
            for (const Method& method : methods)
                rows.push_back(measure(scene, method, speed(k), questions));
        }
    }
    std::stable_sort(rows.begin(), rows.end(), [](const Row& left, const Row& right) {
        return std::pair(left.scene, left.method) < std::pair(right.scene, right.method);
    });
    return rows;
}

/// Sweeps speed over wall thickness for every scene and method: the share of true crossings missed, late
/// answers, and time per query.
class Tunnelling final : public Part {
public:
    std::string_view name() const override { return "tunnelling"; }
    std::string_view about() const override
    {
        return "bodies that fly or turn through thin walls: discrete checks, FCL and brink; which are lost";
    }
    std::string_view csv() const override { return "tunnelling.csv"; }
    void describe(CLI::App&) override;
    std::uint64_t run(const Output&, Effort) override;
    std::vector<Figure> figures(const Csv&) const override;
    std::vector<Picture> pictures() const override;

private:
    int crossings_ = 34'000;
    std::uint64_t seed_ = 20261122;
};

void Tunnelling::describe(CLI::App& command)
{
    command.add_option("--crossings", crossings_, "true crossings in each scene, over all speeds")
        ->check(CLI::Range(speeds, 10'000'000))
        ->capture_default_str();
    command.add_option("--seed", seed_, "of the random crossings")->capture_default_str();
}

std::uint64_t Tunnelling::run(const Output& output, Effort effort)
{
    const int wanted = effort == Effort::quick ? std::min(crossings_, quick_crossings) : crossings_;
    const int each = (wanted + speeds - 1) / speeds;
    const std::vector<Row> rows = sweep(each, seed_);
    output.write(csv(), tunnelling_csv(rows));
    fmt::print("{}\n{}\n", machine(), tunnelling_table(rows));
    fmt::print("{}\n", output.draw("tunnelling", tunnelling_plot(rows)));
    if (const std::optional<StripCase> strip = strip_case(seed_))
        fmt::print("{}\n", output.draw("tunnelling_strip", strip_plot(*strip)));
    fmt::print("Figures: {}\n", output.path_of(csv()));
    std::uint64_t missed = 0;
    for (const Scene& scene : scenes)
        missed += static_cast<std::uint64_t>(total(rows, scene, methods.back()).missed);
    return missed;
}

/// All speeds of a scene and method together.
std::vector<Figure> Tunnelling::figures(const Csv& csv) const
{
    std::vector<Figure> figures;
    for (std::size_t i = 0; i < csv.rows(); ++i) {
        const std::string& scene = csv.text(i, "scene");
        const std::string& method = csv.text(i, "method");
        if (figures.empty() || figures.back().question != scene || figures.back().who != method) {
            figures.push_back(
                {.question = scene, .who = method, .time = 0, .cases = 0, .missed = 0, .late = 0});
        }
        Figure& f = figures.back();
        f.time += csv.number(i, "ns_per_query") / speeds;
        f.cases += csv.count(i, "crossings");
        f.missed += csv.count(i, "missed");
        f.late += csv.count(i, "late");
    }
    return figures;
}

std::vector<Picture> Tunnelling::pictures() const
{
    return {{"tunnelling", "A discrete check loses the fast ones, and the more the faster they are; brink's "
                           "line lies on zero."},
            {"tunnelling_strip", "Ten checks see the box on either side of the wall and never in it; brink "
                                 "gives the pose of contact."}};
}

} // namespace

std::unique_ptr<Part> tunnelling_part() { return std::make_unique<Tunnelling>(); }

} // namespace brink::bench
