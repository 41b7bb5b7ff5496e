// SPDX-License-Identifier: BSD-3-Clause
#include "error_verdict.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>

namespace brink::bench {
namespace {

constexpr double least_error = 0x1p-53;
constexpr double never = std::numeric_limits<double>::infinity();

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
    double finest() const { return error_of(*std::min_element(points_.begin(), points_.end(), less_error)); }

    double time_at(double error) const
    {
        const ErrorPoint& finest = *std::min_element(points_.begin(), points_.end(), less_error);
        if (error < error_of(finest)) return finest.ns;
        double least = never;
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (error_of(points_[i]) <= error) least = std::min(least, points_[i].ns);
            if (i > 0) least = std::min(least, between(points_[i - 1], points_[i], error));
        }
        return least;
    }

private:
    static bool less_error(const ErrorPoint& a, const ErrorPoint& b) { return error_of(a) < error_of(b); }

    /// On the straight line between the two in the logarithms; `never` beyond its ends.
    static double between(const ErrorPoint& a, const ErrorPoint& b, double error)
    {
        const double from = std::log(error_of(a));
        const double to = std::log(error_of(b));
        const double x = std::log(error);
        if (from == to || (x - from) * (x - to) > 0) return never;
        return a.ns * std::pow(b.ns / a.ns, (x - from) / (to - from));
    }

    ErrorPoints points_;
};

Mark mark(const Curve& curve, const ErrorPoint& rival)
{
    const double error = error_of(rival);
    Mark out{rival, Place::above, rival.ns / curve.time_at(error)};
    if (out.factor < 1)
        out.place = error > curve.crudest() ? Place::right : Place::within;
    else if (error < curve.finest())
        out.place = Place::left;
    return out;
}

/// Whether it looks at poses one after the other, and sees nothing of what is between them.
bool samples(const Mark& m) { return m.rival.who == "FCL naive" || m.rival.who == "FCL discrete"; }

std::string line(const Mark& m)
{
    const ErrorPoint& p = m.rival;
    return fmt::format("  {:<34} {:<42} {:>8.1e} {:>8.0f} {:>6.2f} | {:>5} {:>5} {:>5}\n", p.question(),
                       p.name(), p.p50, p.ns, m.factor, p.missed, p.false_hits, p.late);
}

std::string listed(std::string_view title, const std::vector<Mark>& marks)
{
    std::string text = fmt::format("\n{}:{}\n", title, marks.empty() ? " none." : "");
    if (!marks.empty())
        text += fmt::format("  {:<34} {:<42} {:>8} {:>8} {:>6} | {:>5} {:>5} {:>5}\n", "", "", "p50", "ns",
                            "times", "miss", "false", "late");
    for (const Mark& m : marks)
        text += line(m);
    return text;
}

std::vector<Mark> lying(const std::vector<Mark>& marks, Place place)
{
    std::vector<Mark> out;
    std::copy_if(marks.begin(), marks.end(), std::back_inserter(out),
                 [&](const Mark& m) { return m.place == place; });
    return out;
}

/// The nearest that brink is not outdone by in either way, and where it only samples the nearest that does
/// not.
std::vector<Mark> nearest(const std::vector<Mark>& all)
{
    std::vector<Mark> out;
    for (const Mark& m : all) {
        if (m.place == Place::right) continue;
        if (out.empty() || !samples(m)) out.push_back(m);
        if (!samples(m)) break;
    }
    return out;
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
    std::vector<Mark> near;
    std::vector<Mark> within;
    std::vector<Mark> right;
    std::vector<Mark> left;
    std::vector<std::string> alone;
    const auto append = [](std::vector<Mark>& to, const std::vector<Mark>& more) {
        to.insert(to.end(), more.begin(), more.end());
    };
    for (const ErrorPoints& question : by_question(points)) {
        const std::vector<Mark> all = marks(question);
        if (all.empty()) alone.push_back(question.front().question());
        append(near, nearest(all));
        append(within, lying(all, Place::within));
        append(right, lying(all, Place::right));
        append(left, lying(all, Place::left));
    }
    const auto sampled = static_cast<std::size_t>(std::count_if(right.begin(), right.end(), samples));
    std::erase_if(right, samples);
    std::string text = "times: a rival's time over that of brink at the same median error.\n";
    text += listed("The nearest rival", near);
    text += listed("Slower than brink, and more exact than it at any tolerance", left);
    text += listed("Faster than brink, and less exact than it at any tolerance", right);
    text += fmt::format("  and {} marks of FCL naive and discrete, which look at poses only\n", sampled);
    if (!alone.empty()) text += fmt::format("\nNo rival can be asked about: {}.\n", fmt::join(alone, ", "));
    return text + listed("Faster and more exact, below and left of brink's curve", within);
}

} // namespace brink::bench
