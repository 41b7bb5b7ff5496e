// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include "machine.h"
#include "report_page.h"
#include "scene_rivals.h"

#include <chrono>
#include <fmt/chrono.h>
#include <fmt/format.h>

namespace brink::bench {
namespace {

std::string measured_on(Effort effort)
{
    const std::string bullet = bullet_version();
    return fmt::format(
        "{}, {}\n{:%Y-%m-%d}, brink-bench{}\n", machine(), bullet.empty() ? "no Bullet" : "Bullet " + bullet,
        fmt::gmtime(std::chrono::system_clock::now()), effort == Effort::quick ? " --quick" : "");
}

/// 1 where the part could not be asked at all.
std::uint64_t run_one(Part& part, const Output& output, Effort effort)
{
    fmt::print("\n== {}: {}\n\n", part.name(), part.about());
    std::fflush(stdout);
    try {
        return run_part(part, output, effort);
    } catch (const std::exception& error) {
        fmt::print(stderr, "brink-bench {}: {}\n", part.name(), error.what());
        return 1;
    }
}

} // namespace

std::uint64_t run_part(Part& part, const Output& output, Effort effort)
{
    output.write(machine_file, measured_on(effort));
    return part.run(output, effort);
}

std::uint64_t run_all(const Output& output, Effort effort, Parts which)
{
    std::uint64_t broken = 0;
    const std::filesystem::path folder = output.path_of("");
    for (const std::unique_ptr<Part>& part : all_parts()) {
        if (which == Parts::missing && std::filesystem::exists(folder / part->csv())) continue;
        broken += run_one(*part, output, effort);
        output.write("report.html", report_page(folder, figures_in(folder)));
    }
    const std::vector<Found> found = figures_in(folder);
    output.write("report.html", report_page(folder, found));
    fmt::print("\n{}\nReport: {}\n", summary_table(summary(found)), output.path_of("report.html"));
    if (broken > 0) fmt::print("BROKEN: {} of brink's answers or parts, see above\n", broken);
    return broken;
}

} // namespace brink::bench
