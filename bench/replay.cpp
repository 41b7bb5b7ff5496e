// SPDX-License-Identifier: BSD-3-Clause
#include "replay.h"

#include "machine.h"
#include "replay_report.h"

#include <fmt/format.h>

namespace brink::bench {

std::string recorded_workload() { return BRINK_BENCH_WORKLOAD; }

std::size_t run_replay(const Output& output, const ReplayOptions& options)
{
    const ReplayAnswers answers = ask_all(options.file);
    fmt::print("{}\n{}", machine(), replay_tables(answers));
    output.write("replay.csv", replay_csv(answers));
    fmt::print("\nCSV: {}\n{}\n", output.path_of("replay.csv"), output.draw("replay", replay_plot(answers)));
    for (const std::string& objection : answers.objections)
        fmt::print("brink: {}\n", objection);
    return answers.objections.size();
}

} // namespace brink::bench
