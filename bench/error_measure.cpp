// SPDX-License-Identifier: BSD-3-Clause
#include "error_measure.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>
#include <print.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numeric>

namespace brink::bench {
namespace {

using support::Real;

/// Late is what is later than the truth by more than this, in steps. brink promises not to be late at all;
/// the others are forgiven the rounding of floats.
constexpr Real rivals_rounding = 1e-6L;

void set_errors(ErrorPoint& point, std::vector<double> errors)
{
    if (errors.empty()) return;
    std::sort(errors.begin(), errors.end());
    const auto at = [&](double share) {
        return errors[static_cast<std::size_t>(share * static_cast<double>(errors.size() - 1))];
    };
    point.p50 = at(0.5);
    point.p99 = at(0.99);
    point.worst = errors.back();
}

/// brink's answer broke a promise: says so, and what was asked as it pastes into a test.
void accuse(const Questions& questions, const Judged& one, const Contender& contender, std::string_view of)
{
    fmt::print(stderr, "{} {}: {} at tolerance {}\n{}\n", questions.pair, name_of(questions.turning), of,
               contender.setting(), support::as_cpp(query(questions.sample, one.pair)));
}

ErrorPoint judged(const Questions& questions, Contender& contender)
{
    ErrorPoint point;
    point.pair = questions.pair;
    point.motion = questions.turning == Turning::none ? "straight" : "turning to 60";
    point.who = contender.who();
    point.setting = contender.setting();
    point.queries = static_cast<int>(questions.judged.size());
    point.left_out = questions.left_out;
    const Real forgiven = point.is_brink() ? 0 : rivals_rounding;
    std::vector<double> errors;
    for (const Judged& one : questions.judged) {
        const Answer answer = contender.ask(one.pair);
        point.calls += answer.calls / static_cast<double>(questions.judged.size());
        if (answer.undecided) ++point.undecided;
        if (one.truth.fate == Fate::apart) {
            if (!answer.contact || answer.undecided) continue;
            ++point.false_hits;
            if (point.is_brink()) accuse(questions, one, contender, "a false hit");
            continue;
        }
        ++point.hits;
        if (!answer.contact) {
            ++point.missed;
            if (point.is_brink()) accuse(questions, one, contender, "a missed hit");
            continue;
        }
        const Real after = static_cast<Real>(answer.t) - one.truth.t;
        if (after > one.truth.doubt + forgiven) {
            ++point.late;
            if (point.is_brink()) accuse(questions, one, contender, "late");
        }
        errors.push_back(static_cast<double>(std::abs(after)));
    }
    set_errors(point, std::move(errors));
    return point;
}

/// Asks the queries of a sample one after the other, from where it stopped the last time.
class Stopwatch {
public:
    Stopwatch(const std::vector<Pair>& pairs, Contender& contender) : pairs_(pairs), contender_(contender) {}

    /// How many queries take about so long; no fewer than two.
    void pace(double ns)
    {
        std::size_t count = 1;
        double taken = 0;
        while (taken < ns / 16 && count < pairs_.size()) {
            count *= 2;
            taken = static_cast<double>(count) * mean_of(count);
        }
        const double share = taken > 0 ? ns / taken : 1;
        count_ = std::clamp<std::size_t>(static_cast<std::size_t>(share * static_cast<double>(count)), 2,
                                         pairs_.size());
    }

    /// ns of processor time per query, after a quarter as many that only fetch what the others have driven
    /// out of the caches.
    double lap()
    {
        mean_of(count_ / 4);
        return mean_of(count_);
    }

private:
    double mean_of(std::size_t count)
    {
        const std::clock_t start = std::clock();
        for (std::size_t i = 0; i < count; ++i) {
            benchmark::DoNotOptimize(contender_.ask(pairs_[next_]));
            if (++next_ == pairs_.size()) next_ = 0;
        }
        const auto ticks = static_cast<double>(std::clock() - start);
        return ticks / CLOCKS_PER_SEC * 1e9 / static_cast<double>(count);
    }

    const std::vector<Pair>& pairs_;
    Contender& contender_;
    std::size_t next_ = 0;
    std::size_t count_ = 2;
};

/// Standard deviation, of two numbers or more.
double deviation(const std::vector<double>& numbers)
{
    const auto count = static_cast<double>(numbers.size());
    const double mean = std::accumulate(numbers.begin(), numbers.end(), 0.0) / count;
    double squares = 0;
    for (const double x : numbers)
        squares += (x - mean) * (x - mean);
    return std::sqrt(squares / (count - 1));
}

} // namespace

ErrorPoints measure(const Questions& questions, const Contenders& contenders, const Patience& patience)
{
    ErrorPoints points;
    std::vector<Stopwatch> watches;
    for (const auto& contender : contenders) {
        points.push_back(judged(questions, *contender));
        watches.emplace_back(questions.sample.mixed, *contender).pace(patience.ns);
    }
    std::vector<std::vector<double>> laps(points.size());
    for (int i = 0; i < patience.repetitions; ++i)
        for (std::size_t k = 0; k < points.size(); ++k)
            laps[k].push_back(watches[k].lap());
    for (std::size_t k = 0; k < points.size(); ++k) {
        std::sort(laps[k].begin(), laps[k].end());
        points[k].ns = laps[k][laps[k].size() / 2];
        points[k].deviation = deviation(laps[k]);
    }
    return points;
}

} // namespace brink::bench
