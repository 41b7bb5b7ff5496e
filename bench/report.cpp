// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include "machine.h"
#include "report_page.h"
#include "scene_rivals.h"

#include <chrono>
#include <fmt/chrono.h>
#include <fmt/format.h>
#include <fstream>

namespace brink::bench {
namespace {

/// Adds, or puts in the place of what an earlier run said of the part, by which command it was measured.
void note_run(const Output& output, const Part& part, const Order& order)
{
    const std::string bullet = bullet_version();
    std::string text = fmt::format("{}, {}\n", machine(), bullet.empty() ? "no Bullet" : "Bullet " + bullet);
    const std::string of_part = fmt::format("{}: ", part.name());
    std::ifstream before(output.path_of(machine_file));
    for (std::string line; std::getline(before, line);)
        for (const std::unique_ptr<Part>& other : all_parts())
            if (line.starts_with(fmt::format("{}: ", other->name())) && !line.starts_with(of_part))
                text += line + "\n";
    text += fmt::format("{}{:%Y-%m-%d}, {}\n", of_part, fmt::gmtime(std::chrono::system_clock::now()),
                        order.command);
    output.write(machine_file, text);
}

/// 1 where the part could not be asked at all.
std::uint64_t run_one(Part& part, const Output& output, const Order& order)
{
    fmt::print("\n== {}: {}\n\n", part.name(), part.about());
    std::fflush(stdout);
    try {
        return run_part(part, output, order);
    } catch (const std::exception& error) {
        fmt::print(stderr, "brink-bench {}: {}\n", part.name(), error.what());
        return 1;
    }
}

} // namespace

std::uint64_t run_part(Part& part, const Output& output, const Order& order)
{
    note_run(output, part, order);
    return part.run(output, order.effort);
}

std::uint64_t run_all(const Output& output, const Order& order, Parts which)
{
    std::uint64_t broken = 0;
    const std::filesystem::path folder = output.path_of("");
    for (const std::unique_ptr<Part>& part : all_parts()) {
        if (which == Parts::missing && std::filesystem::exists(folder / part->csv())) continue;
        broken += run_one(*part, output, order);
        output.write("report.html", report_page(folder, figures_in(folder)));
    }
    const std::vector<Found> found = figures_in(folder);
    output.write("report.html", report_page(folder, found));
    fmt::print("\n{}\nReport: {}\n", summary_table(summary(found)), output.path_of("report.html"));
    if (broken > 0) fmt::print("BROKEN: {} of brink's answers or parts, see above\n", broken);
    return broken;
}

} // namespace brink::bench
