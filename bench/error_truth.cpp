// SPDX-License-Identifier: BSD-3-Clause
#include "error_truth.h"

#include <referee_turning.h>

namespace brink::bench {

using support::Meeting;
using support::Real;

bool has_truth(const support::Pair&) { return true; }

Truth truth(const support::Query& query)
{
    const Meeting met = meeting(query);
    if (met.in_doubt || met.started) return {};
    if (met.meets) {
        if (met.grazing) return {};
        return {Fate::contact, static_cast<Real>(met.by), static_cast<Real>(met.by - met.apart)};
    }
    support::Query wider = query;
    wider.options.target_gap = clearance;
    const Meeting near = meeting(wider);
    return near.meets || near.in_doubt ? Truth{} : Truth{Fate::apart};
}

std::string_view truth_teller() { return "the referee, proven to 40 digits"; }

} // namespace brink::bench
