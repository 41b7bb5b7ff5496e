// SPDX-License-Identifier: BSD-3-Clause
#include "scene_cells.h"

#include "output.h"

#include <algorithm>
#include <fmt/format.h>

namespace brink::bench {

std::string count(std::size_t n) { return thousands(static_cast<std::int64_t>(n)); }

std::string ms(double value)
{
    if (value <= 0) return "-";
    const int decimals = value < 0.095 ? 4 : value < 0.95 ? 3 : value < 9.5 ? 2 : value < 95 ? 1 : 0;
    return fmt::format("{:.{}f}", value, decimals);
}

std::string times(double theirs, double ours)
{
    if (theirs <= 0 || ours <= 0) return "-";
    return fmt::format("{:.{}f} x", theirs / ours, theirs / ours < 9.95 ? 1 : 0);
}

double step_of(const SceneFigures* f) { return f != nullptr ? f->step_ms : 0; }

std::vector<Heading> headings(const SceneResults& results)
{
    std::vector<Heading> all;
    for (const SceneFigures& f : results.figures)
        if (const Heading h{f.scene, f.order}; std::find(all.begin(), all.end(), h) == all.end())
            all.push_back(h);
    return all;
}

} // namespace brink::bench
