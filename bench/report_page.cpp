// SPDX-License-Identifier: BSD-3-Clause
#include "report_page.h"

#include "machine.h"

#include <cmath>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

namespace brink::bench {
namespace {

constexpr std::string_view style = R"(
:root { color-scheme: light dark; --line: #8884; --soft: #8882; --strong: #0a62c9; }
@media (prefers-color-scheme: dark) { :root { --strong: #6db3ff; } }
body { font: 16px/1.5 system-ui, sans-serif; margin: 0 auto; padding: 1rem; max-width: 75rem; }
h1 { line-height: 1.15; } h2 { margin-top: 2.5rem; border-top: 1px solid var(--line); padding-top: 1rem; }
pre { white-space: pre-wrap; background: var(--soft); padding: .6rem .8rem; border-radius: .4rem; font-size: .85rem; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .85rem; font-variant-numeric: tabular-nums; }
th, td { padding: .2rem .6rem; text-align: right; white-space: nowrap; border-bottom: 1px solid var(--soft); }
th { vertical-align: bottom; border-bottom: 1px solid var(--line); }
th:nth-child(1), td:nth-child(1), th:nth-child(2), td:nth-child(2) { text-align: left; }
tr.brink td { font-weight: 600; color: var(--strong); }
figure { margin: 1rem 0 2rem; } figcaption { margin-bottom: .5rem; }
img { width: 100%; height: auto; background: #fff; border-radius: .4rem; }
details { margin: 1rem 0; } summary { cursor: pointer; }
)";

constexpr std::string_view columns = R"(
<p>ns: of a query, or of a body in a step of a scene, the geometric mean over the questions. time / brink's: how many times as long as brink, the geometric mean over the questions that both were asked, and the
least and the most of one question. error of t: in fractions of the step, the median of the questions' medians, and the
worst of all. missed: a contact not said. false: a contact said where there is none. wrong: either, where a part does not
tell them apart. late: a contact said after it happened. -: not counted or not measured there.</p>
)";

std::string escaped(std::string_view text)
{
    std::string out;
    for (const char c : text)
        out += c == '&'   ? "&amp;"
               : c == '<' ? "&lt;"
               : c == '>' ? "&gt;"
               : c == '"' ? "&quot;"
                          : std::string(1, c);
    return out;
}

/// A picture within the page: of an SVG what a URL cannot hold is written as %xx.
std::string data_url(std::string_view svg)
{
    std::string out = "data:image/svg+xml,";
    for (const char c : svg) {
        const bool plain = std::string_view("%#\"<>&'\n\r\t").find(c) == std::string_view::npos;
        out += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return out;
}

std::string text_of(const std::filesystem::path& path)
{
    std::ifstream file(path);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string row(const std::vector<std::string>& cells, std::string_view tag, std::string_view kind)
{
    std::string out = kind.empty() ? "<tr>" : fmt::format("<tr class=\"{}\">", kind);
    for (const std::string& cell : cells)
        out += fmt::format("<{0}>{1}</{0}>", tag, escaped(cell));
    return out + "</tr>\n";
}

std::string table(std::string_view id, const std::vector<std::string>& heading, std::string_view rows)
{
    return fmt::format(
        "<div class=\"wide\"><table id=\"{}\">\n<thead>{}</thead>\n<tbody>\n{}</tbody></table></div>\n", id,
        row(heading, "th", ""), rows);
}

std::string summary_part(const std::vector<Found>& found)
{
    std::vector<std::string> heading{"part", "who"};
    heading.insert(heading.end(), summary_heading.begin(), summary_heading.end());
    std::string rows;
    for (const SummaryRow& r : summary(found)) {
        std::vector<std::string> line{r.part, r.who};
        const std::vector<std::string> more = cells(r);
        line.insert(line.end(), more.begin(), more.end());
        rows += row(line, "td", r.who.starts_with("brink") ? "brink" : "");
    }
    return fmt::format("<h2>Summary</h2>\n{}{}", table("summary", heading, rows), columns.substr(1));
}

/// As the CSV has it.
std::string as_is(double x) { return std::isfinite(x) ? fmt::format("{}", x) : "-"; }
std::string as_is(std::int64_t n) { return n < 0 ? "-" : std::to_string(n); }

std::string figures_table(const Found& found)
{
    std::string rows;
    for (const Figure& f : found.figures)
        rows += row({f.question, f.who, as_is(f.time), as_is(f.spread), as_is(f.error), as_is(f.worst),
                     as_is(f.cases), as_is(f.missed), as_is(f.false_hits), as_is(f.wrong), as_is(f.late)},
                    "td", is_brink(f) ? "brink" : "");
    return fmt::format("<details><summary>All figures</summary>\n{}</details>\n",
                       table("figures-" + found.part,
                             {"question", "who", "ns", "spread, ns", "median error of t", "worst", "cases",
                              "missed", "false", "wrong", "late"},
                             rows));
}

std::string figure(const std::filesystem::path& folder, const Picture& picture)
{
    const std::string svg = text_of(folder / fmt::format("{}.svg", picture.stem));
    const std::string see = escaped(picture.see);
    if (svg.empty())
        return fmt::format("<p>No picture {}.svg: gnuplot was not there when this was measured. ({})</p>\n",
                           picture.stem, see);
    return fmt::format("<figure><figcaption>{0}</figcaption><img alt=\"{0}\" src=\"{1}\"></figure>\n", see,
                       data_url(svg));
}

std::string section(const std::filesystem::path& folder, const Part& part, const std::vector<Found>& all)
{
    std::string text = fmt::format("<h2>{}</h2>\n<p>{}</p>\n", part.name(), escaped(part.about()));
    if (!std::filesystem::exists(folder / part.csv()))
        return text + fmt::format("<p>Not measured: there is no {} in the folder.</p>\n", part.csv());
    if (const std::string verdict = part.verdict(*read_csv(folder / part.csv())); !verdict.empty())
        text += fmt::format(
            "<details><summary>Who comes near, question by question</summary>\n<pre>{}</pre></details>\n",
            escaped(verdict));
    for (const Picture& picture : part.pictures())
        text += figure(folder, picture);
    for (const Found& found : all)
        if (found.part == part.name() && !found.figures.empty()) text += figures_table(found);
    return text + fmt::format("<p>Figures: {}</p>\n", part.csv());
}

} // namespace

std::string report_page(const std::filesystem::path& folder, const std::vector<Found>& found)
{
    const std::string measured_on = text_of(folder / machine_file);
    std::string page =
        fmt::format("<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
                    "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
                    "<title>brink: run time against error</title>\n<link rel=\"icon\" "
                    "href=\"data:,\">\n<style>{}</style></head>\n<body>\n"
                    "<h1>brink: run time against error</h1>\n"
                    "<p>When, within a time step, do two moving shapes first touch? What brink answers, how "
                    "exactly and how "
                    "fast, beside other libraries that were asked the same in the same run. Ratios hold "
                    "better than times.</p>\n"
                    "<pre>{}</pre>\n",
                    style, escaped(measured_on));
    page += summary_part(found);
    for (const std::unique_ptr<Part>& part : all_parts())
        page += section(folder, *part, found);
    return page + "</body></html>\n";
}

} // namespace brink::bench
