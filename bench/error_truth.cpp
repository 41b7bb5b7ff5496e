// SPDX-License-Identifier: BSD-3-Clause
#include "error_truth.h"

#include <referee_turning.h>

namespace brink::bench {

using support::Meeting;
using support::Real;

bool has_truth(const support::Pair&) { return true; }

Truth truth(const support::Query& query)
{
    support::Query wider = query;
    wider.options.target_gap = clearance;
    const Meeting near = meeting(wider);
    if (near.in_doubt || near.started) return {};
    if (!near.meets) return {Fate::apart};
    const Meeting met = meeting(query);
    if (met.in_doubt || !met.meets || met.grazing) return {};
    return {Fate::contact, static_cast<Real>(met.by), static_cast<Real>(met.by - met.apart)};
}

std::string_view truth_teller() { return "the referee, to 40 digits"; }

} // namespace brink::bench
