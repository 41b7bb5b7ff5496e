// SPDX-License-Identifier: BSD-3-Clause
#include "report.h"

#include <fmt/format.h>

namespace brink::bench {

std::uint64_t run_all(const Output& output, Effort effort, Parts which)
{
    std::uint64_t broken = 0;
    for (const std::unique_ptr<Part>& part : all_parts()) {
        if (which == Parts::missing && read_csv(output.path_of(part->csv()))) continue;
        broken += part->run(output, effort);
    }
    return broken;
}

} // namespace brink::bench
