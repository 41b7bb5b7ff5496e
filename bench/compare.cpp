// SPDX-License-Identifier: BSD-3-Clause
#include "compare.h"

#include "summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace brink::bench {
namespace {

constexpr double spread_unknown = 0.1; // of a time whose repetitions were not kept
constexpr double deviations = 4;       // a change beyond so many is none of the noise, of a thousand too
constexpr double deviation_by_median = 1.4826; // of a normal distribution, over its median deviation
constexpr double least_slowdown = 1.05;        // less is not worth a word
constexpr double less_exact = 1.5;             // the same queries and the same code give the same error

/// Brink's time over the geometric mean of its rivals'.
struct Ratio {
    double log = 0;
    double variance = 0; // of log
};

double variance_of(const Figure& f)
{
    const double relative = std::isfinite(f.spread) ? f.spread / f.time : spread_unknown;
    return relative * relative;
}

const Figure* find(const std::vector<Figure>& figures, const std::string& question, const std::string& who)
{
    const auto is = [&](const Figure& f) { return f.question == question && f.who == who; };
    const auto found = std::find_if(figures.begin(), figures.end(), is);
    return found == figures.end() ? nullptr : &*found;
}

bool timed(const Figure* f) { return f != nullptr && std::isfinite(f->time) && f->time > 0; }

/// The rivals that both runs asked the same question.
std::vector<std::string> common_rivals(const Found& before, const Found& after, const std::string& question)
{
    std::vector<std::string> names;
    for (const Figure& f : after.figures)
        if (f.question == question && !is_brink(f) && timed(&f) &&
            timed(find(before.figures, question, f.who)))
            names.push_back(f.who);
    return names;
}

Ratio ratio(const Found& run, const Figure& brink, const std::vector<std::string>& rivals)
{
    Ratio r{std::log(brink.time), variance_of(brink)};
    const auto n = static_cast<double>(rivals.size());
    for (const std::string& who : rivals) {
        const Figure* rival = find(run.figures, brink.question, who);
        r.log -= std::log(rival->time) / n;
        r.variance += variance_of(*rival) / (n * n);
    }
    return r;
}

double share(std::int64_t count, std::int64_t cases)
{
    return static_cast<double>(count) / static_cast<double>(std::max<std::int64_t>(cases, 1));
}

double median(std::vector<double> values)
{
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// How one time of brink's has changed, beside its rivals'.
struct Change {
    double log = 0;
    double variance = 0; // of log, by the repetitions within the two runs
    std::string what;
};

/// What one part has become.
class Comparison {
public:
    Comparison(const Found& before, const Found& after) : before_(before), after_(after)
    {
        for (const Figure& now : after.figures) {
            const Figure* then = is_brink(now) ? find(before.figures, now.question, now.who) : nullptr;
            if (then == nullptr) continue;
            ++questions_;
            compare_times(*then, now);
            compare_answers(*then, now);
        }
        if (!changes_.empty()) judge_times();
    }

    std::string row() const
    {
        return fmt::format("{:<12} {:>9} {:>10} {:>13} {:>10} {:>10}\n", after_.part, questions_,
                           changes_.size(), changes_.empty() ? "-" : fmt::format("{:.3f}", std::exp(middle_)),
                           changes_.empty() ? "-" : fmt::format("{:.1f} %", 100 * drift_), findings.size());
    }

    std::vector<std::string> findings;

private:
    void compare_times(const Figure& then, const Figure& now)
    {
        const std::vector<std::string> rivals = common_rivals(before_, after_, now.question);
        if (rivals.empty() || !timed(&then) || !timed(&now)) return;
        const Ratio old = ratio(before_, then, rivals), fresh = ratio(after_, now, rivals);
        changes_.push_back(
            {fresh.log - old.log, old.variance + fresh.variance,
             fmt::format("{}: {}: {:.3g} -> {:.3g} ns", now.question, now.who, then.time, now.time)});
    }

    /// A machine drifts between its repetitions and between runs: by how much, the many questions that did
    /// not change tell.
    void judge_times()
    {
        std::vector<double> values;
        for (const Change& c : changes_)
            values.push_back(c.log);
        middle_ = median(values);
        for (double& value : values)
            value = std::fabs(value - middle_);
        drift_ = deviation_by_median * median(values);
        const double least = std::log(least_slowdown);
        const auto n = static_cast<double>(changes_.size());
        double variance = drift_ * drift_;
        for (const Change& c : changes_)
            variance += c.variance / n;
        if (middle_ > least + deviations * std::sqrt(variance / n))
            findings.push_back(fmt::format("all of it: slower, {:.2f} times", std::exp(middle_)));
        for (const Change& c : changes_) {
            const double spread = std::sqrt(c.variance + drift_ * drift_);
            if (c.log > least && c.log - std::max(middle_, 0.0) > deviations * spread)
                findings.push_back(fmt::format("{}: slower, {:.2f} times (spread {:.0f} %)", c.what,
                                               std::exp(c.log), 100 * spread));
        }
    }

    void compare_answers(const Figure& then, const Figure& now)
    {
        const auto worse = [&](std::string_view what, double old, double fresh) {
            if (fresh > less_exact * old && std::isfinite(old))
                findings.push_back(fmt::format("{}: {}: less exact, {}: {:.1e} -> {:.1e}", now.question,
                                               now.who, what, old, fresh));
        };
        worse("median error", then.error, now.error);
        worse("worst error", then.worst, now.worst);
        const auto more = [&](std::string_view what, std::int64_t old, std::int64_t fresh) {
            if (old >= 0 && fresh >= 0 && share(fresh, now.cases) > share(old, then.cases))
                findings.push_back(fmt::format("{}: {}: more {}: {} of {} -> {} of {}", now.question, now.who,
                                               what, old, then.cases, fresh, now.cases));
        };
        more("missed", then.missed, now.missed);
        more("false hits", then.false_hits, now.false_hits);
        more("wrong answers", then.wrong, now.wrong);
        more("late answers", then.late, now.late);
    }

    const Found &before_, &after_;
    int questions_ = 0;
    std::vector<Change> changes_;
    double middle_ = 0, drift_ = 0; // of the changes' logarithms: their median, and the deviation about it
};

std::vector<Found> something_in(const std::filesystem::path& folder)
{
    std::vector<Found> found = figures_in(folder);
    if (found.empty())
        throw std::invalid_argument(fmt::format("no CSV of brink-bench in the folder '{}'", folder.string()));
    return found;
}

} // namespace

int compare(const std::filesystem::path& before, const std::filesystem::path& after)
{
    const std::vector<Found> old = something_in(before), fresh = something_in(after);
    fmt::print("{:<12} {:>9} {:>10} {:>13} {:>10} {:>10}\n", "part", "questions", "with time",
               "time, new/old", "spread", "findings");
    std::vector<std::string> findings;
    for (const Found& now : fresh) {
        const auto then =
            std::find_if(old.begin(), old.end(), [&](const Found& f) { return f.part == now.part; });
        if (then == old.end()) continue;
        const Comparison comparison(*then, now);
        fmt::print("{}", comparison.row());
        for (const std::string& finding : comparison.findings)
            findings.push_back(fmt::format("{}: {}", now.part, finding));
    }
    fmt::print("Time: brink's over the geometric mean of its rivals' in the same run, the median over the "
               "questions; spread: of "
               "single questions about\nit. One counts as slower beyond {} deviations and {:.0f} %.\n",
               deviations, 100 * (least_slowdown - 1));
    for (const std::string& finding : findings)
        fmt::print("{}\n", finding);
    if (findings.empty()) fmt::print("Nothing got slower or less exact.\n");
    return static_cast<int>(findings.size());
}

} // namespace brink::bench
