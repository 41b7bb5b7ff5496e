// SPDX-License-Identifier: BSD-3-Clause
#include "error_verdict.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace brink::bench {
namespace {

constexpr double least_error = 0x1p-53;

double error_of(const ErrorPoint& point) { return std::max(point.p50, least_error); }

/// brink's points of one question, by tolerance.
class Curve {
public:
    explicit Curve(const ErrorPoints& points)
    {
        for (const ErrorPoint& p : points)
            if (p.is_brink() && !std::isnan(p.p50)) points_.push_back(p);
    }

    bool empty() const { return points_.empty(); }

    double crudest() const { return error_of(*std::max_element(points_.begin(), points_.end(), less_error)); }

    double time_at(double error) const
    {
        const ErrorPoint& finest = *std::min_element(points_.begin(), points_.end(), less_error);
        if (error < error_of(finest)) return finest.ns;
        double least = infinity;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (error_of(points_[i]) <= error) least = std::min(least, points_[i].ns);
            if (i > 0) least = std::min(least, between(points_[i - 1], points_[i], error));
        }
        return least;
    }

private:
    static bool less_error(const ErrorPoint& a, const ErrorPoint& b) { return error_of(a) < error_of(b); }

    /// On the straight line between the two in the logarithms; infinity beyond its ends.
    static double between(const ErrorPoint& a, const ErrorPoint& b, double error)
    {
        const double from = std::log(error_of(a));
        const double to = std::log(error_of(b));
        const double x = std::log(error);
        if (from == to || (x - from) * (x - to) > 0) return infinity;
        return a.ns * std::pow(b.ns / a.ns, (x - from) / (to - from));
    }

    ErrorPoints points_;
};

Mark mark(const Curve& curve, const ErrorPoint& rival)
{
    const double error = error_of(rival);
    Mark out{rival, rival.ns / curve.time_at(error)};
    if (out.factor < 1) out.place = error > curve.crudest() ? Place::cruder : Place::better;
    return out;
}

std::string counts(const ErrorPoint& p)
{
    return fmt::format("{} missed, {} false, {} late of {} + {}", p.missed, p.false_hits, p.late, p.hits,
                       p.queries - p.hits);
}

std::string line(const Mark& m)
{
    return fmt::format("{:<28} {:<42} {:>8.1e} {:>9.0f} {:>6.2f}  {}\n", m.rival.question(), m.rival.name(),
                       m.rival.p50, m.rival.ns, m.factor, counts(m.rival));
}

std::string listed(std::string_view title, const std::vector<Mark>& marks)
{
    std::string text = fmt::format("\n{}\n", title);
    for (const Mark& m : marks)
        text += line(m);
    return marks.empty() ? text + "none\n" : text;
}

} // namespace

std::vector<Mark> marks(const ErrorPoints& points)
{
    const Curve curve(points);
    std::vector<Mark> out;
    if (curve.empty()) return out;
    for (const ErrorPoint& p : points)
        if (!p.is_brink() && !std::isnan(p.p50)) out.push_back(mark(curve, p));
    std::sort(out.begin(), out.end(), [](const Mark& a, const Mark& b) { return a.factor < b.factor; });
    return out;
}

std::string error_verdict(const ErrorPoints& points)
{
    std::vector<Mark> nearest;
    std::vector<Mark> better;
    std::vector<Mark> cruder;
    std::vector<std::string> alone;
    for (const ErrorPoints& question : by_question(points)) {
        const std::vector<Mark> of = marks(question);
        const auto first =
            std::find_if(of.begin(), of.end(), [](const Mark& m) { return m.place != Place::cruder; });
        if (of.empty()) alone.push_back(question.front().question());
        if (first != of.end()) nearest.push_back(*first);
        std::copy_if(of.begin(), of.end(), std::back_inserter(better),
                     [](const Mark& m) { return m.place == Place::better; });
        std::copy_if(of.begin(), of.end(), std::back_inserter(cruder),
                     [](const Mark& m) { return m.place == Place::cruder; });
    }
    std::string text = fmt::format("{:<28} {:<42} {:>8} {:>9} {:>6}\n", "question", "rival", "p50", "ns",
                                   "times brink's");
    text += listed("The nearest rival by time at equal error:", nearest);
    text += listed("Faster than brink at any tolerance, and less exact than it at any:", cruder);
    text += listed("Faster and more exact: below and left of brink's curve:", better);
    if (!alone.empty()) text += fmt::format("\nNo rival can be asked about: {}.\n", fmt::join(alone, ", "));
    return text;
}

} // namespace brink::bench
