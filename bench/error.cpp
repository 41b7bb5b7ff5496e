// SPDX-License-Identifier: BSD-3-Clause
#include "error_contender.h"
#include "error_measure.h"
#include "error_picture.h"
#include "error_verdict.h"
#include "machine.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace brink::bench {
namespace {

constexpr std::array motions{Turning::none, Turning::to_60_degrees};
constexpr int timed_queries = 4096; // half hits; more than a branch predictor learns in a repetition
constexpr Patience usual{9, 10e6};
constexpr Patience quick{3, 1.5e6};
constexpr int quick_queries = 48; // see Part::run
constexpr std::string_view large = "box-box turning to 60";

std::vector<std::string> pairs()
{
    std::vector<std::string> names;
    for (const support::Pair& pair : support::all_pairs())
        if (!pair.unbounded() && has_truth(pair)) names.push_back(pair.name());
    return names;
}

Contenders everyone(const Questions& questions)
{
    Contenders out = brink_contenders(questions);
    const auto join = [&](Contenders more) { std::move(more.begin(), more.end(), std::back_inserter(out)); };
    join(fcl_contenders(questions));
    join(bullet_contenders(questions));
    return out;
}

ErrorPoints of_motion(const ErrorPoints& points, std::string_view motion)
{
    ErrorPoints out;
    std::copy_if(points.begin(), points.end(), std::back_inserter(out),
                 [&](const ErrorPoint& p) { return p.motion == motion; });
    return out;
}

/// Time per query and error of t, of every pair of shapes and either kind of motion: brink as a curve over
/// its tolerance, rivals as marks.
class Error final : public Part {
public:
    std::string_view name() const override { return "error"; }
    std::string_view about() const override
    {
        return "time per query against error of t, every pair of shapes, straight and turning: brink at "
               "tolerances 1e-3 to 1e-14, FCL and Bullet";
    }
    std::string_view csv() const override { return "error.csv"; }
    void describe(CLI::App&) override;
    std::uint64_t run(const Output&, Effort) override;
    std::vector<Figure> figures(const Csv& csv) const override { return error_figures(error_points(csv)); }
    std::vector<Picture> pictures() const override;
    std::string verdict(const Csv& csv) const override { return error_verdict(error_points(csv)); }

private:
    int queries_ = 400;
    std::vector<std::string> pairs_{"all"};
};

void Error::describe(CLI::App& command)
{
    command.add_option("--queries", queries_, "of each pair and motion that are judged, half of them hits")
        ->check(CLI::Range(20, timed_queries / 2))
        ->capture_default_str();
    add_choice(command, "--pairs", pairs_, pairs());
}

void draw(const Output& output, const ErrorPoints& points)
{
    const auto page = [&](std::string_view motion, std::string_view stem, std::string_view headline) {
        const ErrorPoints of = of_motion(points, motion);
        if (!of.empty()) fmt::print("{}\n", output.draw(stem, error_page(of, stem, headline)));
    };
    page("straight", "error_straight", "Bodies that move straight: time per query over error of t");
    page("turning to 60", "error_turning",
         "Bodies that move and turn by up to 60 degrees: time per query over error of t");
    for (const ErrorPoints& question : by_question(points))
        if (question.front().question() == large)
            fmt::print("{}\n", output.draw("error_box_box",
                                           error_sheet(question, "error_box_box",
                                                       "Two boxes that move and turn by up to 60 degrees")));
}

std::uint64_t Error::run(const Output& output, Effort effort)
{
    const bool hurried = effort == Effort::quick;
    const Wanted wanted{hurried ? std::min(queries_, quick_queries) : queries_, timed_queries};
    const std::vector<std::string> names = chosen(pairs_, pairs());
    ErrorPoints points;
    Progress progress("error", static_cast<int>(names.size() * motions.size()));
    for (const Turning motion : motions)
        for (const std::string& pair : names) {
            const Questions questions = draw_questions(*support::pair_named(pair), motion, wanted);
            const ErrorPoints more = measure(questions, everyone(questions), hurried ? quick : usual);
            points.insert(points.end(), more.begin(), more.end());
            progress.step();
        }
    output.write(csv(), error_csv(points));
    fmt::print("{}\nTruth by {}.\n\n{}\n{}\n", machine(), truth_teller(), error_table(points),
               error_verdict(points));
    draw(output, points);
    fmt::print("Figures: {}\n", output.path_of(csv()));
    std::uint64_t broken = 0;
    for (const ErrorPoint& p : points)
        if (p.is_brink()) broken += static_cast<std::uint64_t>(p.missed + p.false_hits + p.late);
    return broken;
}

std::vector<Picture> Error::pictures() const
{
    constexpr std::string_view see = "Left is more exact, lower is faster: a mark below and left of brink's "
                                     "curve would be a rival that is "
                                     "both.";
    return {{"error_box_box", see}, {"error_straight", see}, {"error_turning", see}};
}

} // namespace

std::unique_ptr<Part> error_part() { return std::make_unique<Error>(); }

} // namespace brink::bench
