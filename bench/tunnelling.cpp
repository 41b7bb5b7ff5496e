// SPDX-License-Identifier: BSD-3-Clause
#include "tunnelling.h"

#include "machine.h"
#include "method.h"
#include "tunnelling_report.h"

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

} // namespace

int run_tunnelling(const Output& output, const TunnellingOptions& options)
{
    const int each = (options.crossings + speeds - 1) / speeds;
    const std::vector<Row> rows = sweep(each, options.seed);
    output.write("tunnelling.csv", tunnelling_csv(rows));
    fmt::print("{}\n{}\n", machine(), tunnelling_table(rows));
    fmt::print("{}\n", output.draw("tunnelling", tunnelling_plot(rows)));
    fmt::print("Figures: {}\n", output.path_of("tunnelling.csv"));
    int missed = 0;
    for (const Scene& scene : scenes)
        missed += total(rows, scene, methods.back()).missed;
    return missed;
}

} // namespace brink::bench
