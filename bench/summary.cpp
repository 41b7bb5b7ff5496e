// SPDX-License-Identifier: BSD-3-Clause
#include "summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace brink::bench {
namespace {

constexpr std::string_view by_default = "brink at 1e-09"; // where tolerances are told apart

void add(std::int64_t& sum, std::int64_t more)
{
    if (more >= 0) sum = std::max<std::int64_t>(sum, 0) + more;
}

double median(std::vector<double> values)
{
    if (values.empty()) return not_measured;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

SummaryRow row_of(const Found& found, const std::string& who)
{
    SummaryRow row{.part = found.part, .who = who};
    std::vector<double> errors;
    double logs = 0, log_ns = 0;
    int timed = 0;
    for (const Figure& f : found.figures) {
        const Figure* brink = f.who == who ? brink_in(found.figures, f.question) : nullptr;
        if (brink == nullptr) continue;
        ++row.questions;
        if (std::isfinite(f.time) && brink->time > 0) {
            const double times = f.time / brink->time;
            logs += std::log(times);
            log_ns += std::log(f.time);
            row.fewest = timed == 0 ? times : std::min(row.fewest, times);
            row.most = timed == 0 ? times : std::max(row.most, times);
            ++timed;
        }
        if (std::isfinite(f.error)) errors.push_back(f.error);
        row.worst = std::fmax(row.worst, f.worst);
        add(row.cases, f.cases);
        add(row.missed, f.missed);
        add(row.false_hits, f.false_hits);
        add(row.wrong, f.wrong);
        add(row.late, f.late);
    }
    if (timed > 0) {
        row.times = std::exp(logs / timed);
        row.ns = std::exp(log_ns / timed);
    }
    row.error = median(std::move(errors));
    return row;
}

std::string number(double x, std::string_view as)
{
    return std::isfinite(x) ? fmt::format(fmt::runtime(as), x) : "-";
}

std::string share(std::int64_t n, std::int64_t of)
{
    if (n < 0) return "-";
    if (n == 0 || of <= 0) return thousands(n);
    return fmt::format("{} ({:.2g} %)", thousands(n), 100 * static_cast<double>(n) / static_cast<double>(of));
}

} // namespace

std::vector<Found> figures_in(const std::filesystem::path& folder)
{
    std::vector<Found> all;
    for (const std::unique_ptr<Part>& part : all_parts()) {
        const std::filesystem::path path = folder / part->csv();
        const std::optional<Csv> csv = read_csv(path);
        if (!csv) continue;
        try {
            all.push_back({std::string(part->name()), part->figures(*csv)});
        } catch (const std::invalid_argument& wrong) {
            throw std::invalid_argument(fmt::format("'{}': {}", path.string(), wrong.what()));
        }
    }
    return all;
}

bool is_brink(const Figure& f) { return f.who.starts_with("brink"); }

const Figure* brink_in(const std::vector<Figure>& figures, std::string_view question)
{
    const auto is = [&](const Figure& f) {
        return f.question == question && (f.who == "brink" || f.who == by_default);
    };
    const auto found = std::find_if(figures.begin(), figures.end(), is);
    return found == figures.end() ? nullptr : &*found;
}

std::vector<SummaryRow> summary(const std::vector<Found>& all)
{
    std::vector<SummaryRow> rows;
    for (const Found& found : all) {
        std::vector<std::string> names;
        const auto note = [&](const Figure& f) {
            if (std::find(names.begin(), names.end(), f.who) == names.end()) names.push_back(f.who);
        };
        for (const Figure& f : found.figures)
            if (f.who == "brink" || f.who == by_default) note(f);
        for (const Figure& f : found.figures)
            if (!f.who.starts_with("brink at")) note(f);
        for (const std::string& who : names)
            rows.push_back(row_of(found, who));
    }
    return rows;
}

const std::vector<std::string> summary_heading{"questions", "ns",         "time / brink's", "from",
                                               "to",        "error of t", "worst",          "cases",
                                               "missed",    "false",      "wrong",          "late"};

std::vector<std::string> cells(const SummaryRow& r)
{
    return {thousands(r.questions),    std::isfinite(r.ns) ? thousands(std::llround(r.ns)) : "-",
            number(r.times, "{:.3g}"), number(r.fewest, "{:.3g}"),
            number(r.most, "{:.3g}"),  number(r.error, "{:.1e}"),
            number(r.worst, "{:.1e}"), r.cases < 0 ? "-" : thousands(r.cases),
            share(r.missed, r.cases),  share(r.false_hits, r.cases),
            share(r.wrong, r.cases),   share(r.late, r.cases)};
}

std::string summary_table(const std::vector<SummaryRow>& rows)
{
    const auto line = [](std::string_view part, std::string_view who, const std::vector<std::string>& c) {
        return fmt::format(
            "{:<12} {:<38} {:>9} {:>9} {:>14} {:>8} {:>8} {:>10} {:>8} {:>10} {:>14} {:>12} {:>13} {:>13}\n",
            part, who, c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], c[9], c[10], c[11]);
    };
    std::string text = line("part", "who", summary_heading);
    std::string_view last;
    for (const SummaryRow& row : rows) {
        text += line(row.part == last ? "" : row.part, row.who, cells(row));
        last = row.part;
    }
    return text;
}

} // namespace brink::bench
