// SPDX-License-Identifier: BSD-3-Clause
#include "keep.h"

#include <fmt/format.h>

#include <stdexcept>

namespace brink::fuzz {

std::vector<support::KeptQuery> queries_of(const std::vector<Pair>& pairs, const std::vector<Tally>& tallies)
{
    std::vector<support::KeptQuery> out;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        for (const Complaint& c : tallies[i].complaints)
            out.push_back(
                {c.asked, fmt::format("{} {}: {}: {}", pairs[i].name(), c.index, c.check, c.detail)});
    return out;
}

Keep::Keep(std::string file) : file_(std::move(file))
{
    if (file_.empty()) return;
    out_.open(file_);
    if (!out_) throw std::runtime_error(fmt::format("cannot write to '{}' (--keep)", file_));
}

void Keep::write(const std::vector<support::KeptQuery>& queries)
{
    if (file_.empty()) return;
    write_queries(out_, queries);
    out_.close();
    if (!out_) throw std::runtime_error(fmt::format("cannot write to '{}' (--keep)", file_));
}

} // namespace brink::fuzz
