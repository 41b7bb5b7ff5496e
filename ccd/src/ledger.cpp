// SPDX-License-Identifier: BSD-3-Clause
#include <brink/ledger.h>

#include <iomanip>
#include <ostream>

namespace brink {

namespace {

constexpr const char* names[layer_count] = {"neither can move",      "asleep",     "bounds apart",
                                            "balls apart, receding", "balls pass", "too late",
                                            "category and mask",     "filter"};

} // namespace

std::ostream& operator<<(std::ostream& out, const Ledger& ledger)
{
    const auto count = [&](const char* name, std::uint64_t n) {
        const double share =
            ledger.pairs > 0 ? 100.0 * static_cast<double>(n) / static_cast<double>(ledger.pairs) : 0;
        out << "  " << std::left << std::setw(24) << name << std::right << std::setw(16) << n << std::setw(12)
            << std::fixed << std::setprecision(4) << share << " %\n";
    };
    const auto time = [&](const char* name, double seconds) {
        out << "  " << std::left << std::setw(24) << name << std::right << std::setw(13) << std::fixed
            << std::setprecision(3) << 1e3 * seconds << " ms\n";
    };
    const auto flags = out.flags();
    const auto precision = out.precision();
    count("pairs", ledger.pairs);
    for (int i = 0; i < layer_count; ++i)
        count(names[i], ledger.removed[static_cast<unsigned>(i)]);
    count("asked exactly", ledger.exact);
    count("left open", ledger.left);
    if (ledger.again > 0) count("asked again", ledger.again);
    time("bounds", ledger.update_seconds);
    time("search", ledger.search_seconds);
    time("exact", ledger.exact_seconds);
    time("order", ledger.order_seconds);
    out.flags(flags);
    out.precision(precision);
    return out;
}

} // namespace brink
