// SPDX-License-Identifier: BSD-3-Clause
#include "error_point.h"

#include <fmt/format.h>

namespace brink::bench {

std::string ErrorPoint::name() const
{
    if (setting.empty()) return who;
    return who + (is_brink() ? " at " : ", ") + setting;
}

std::string error_csv(const ErrorPoints& points)
{
    std::string text = "pair,motion,who,setting,queries,hits,ns_per_query,standard_deviation_ns,p50_error,"
                       "p99_error,max_error,calls_mean,missed,false_hits,late,undecided,left_out\n";
    for (const ErrorPoint& p : points)
        text += fmt::format("{},{},{},{},{},{},{:.2f},{:.2f},{:.3e},{:.3e},{:.3e},{:.3f},{},{},{},{},{}\n",
                            p.pair, p.motion, p.who, p.setting, p.queries, p.hits, p.ns, p.deviation, p.p50,
                            p.p99, p.worst, p.calls, p.missed, p.false_hits, p.late, p.undecided, p.left_out);
    return text;
}

ErrorPoints error_points(const Csv& csv)
{
    ErrorPoints points;
    for (std::size_t i = 0; i < csv.rows(); ++i) {
        const auto count = [&](std::string_view column) { return static_cast<int>(csv.count(i, column)); };
        points.push_back({.pair = csv.text(i, "pair"),
                          .motion = csv.text(i, "motion"),
                          .who = csv.text(i, "who"),
                          .setting = csv.text(i, "setting"),
                          .ns = csv.number(i, "ns_per_query"),
                          .deviation = csv.number(i, "standard_deviation_ns"),
                          .p50 = csv.number(i, "p50_error"),
                          .p99 = csv.number(i, "p99_error"),
                          .worst = csv.number(i, "max_error"),
                          .calls = csv.number(i, "calls_mean"),
                          .queries = count("queries"),
                          .hits = count("hits"),
                          .missed = count("missed"),
                          .false_hits = count("false_hits"),
                          .late = count("late"),
                          .undecided = count("undecided"),
                          .left_out = count("left_out")});
    }
    return points;
}

std::vector<Figure> error_figures(const ErrorPoints& points)
{
    std::vector<Figure> figures;
    for (const ErrorPoint& p : points)
        figures.push_back({.question = p.question(),
                           .who = p.name(),
                           .time = p.ns,
                           .spread = p.deviation,
                           .error = p.p50,
                           .worst = p.worst,
                           .cases = p.queries,
                           .missed = p.missed,
                           .false_hits = p.false_hits,
                           .late = p.late});
    return figures;
}

std::vector<ErrorPoints> by_question(const ErrorPoints& points)
{
    std::vector<ErrorPoints> out;
    for (const ErrorPoint& p : points) {
        if (out.empty() || out.back().front().question() != p.question()) out.emplace_back();
        out.back().push_back(p);
    }
    return out;
}

} // namespace brink::bench
