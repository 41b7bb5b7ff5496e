// SPDX-License-Identifier: BSD-3-Clause
#include "error_truth.h"

#include <reference.h>

namespace brink::bench {

using support::GapOverTime;
using support::Reference;

bool has_truth(const support::Pair& pair) { return pair.has_reference(); }

Truth truth(const support::Query& query)
{
    const GapOverTime motion(query);
    const Reference known = reference(query, motion);
    if (known.gave_up || known.started) return {};
    if (known.contact) {
        if (known.grazing) return {};
        return {Fate::contact, known.t, blur(motion) / known.closing_speed};
    }
    support::Query wider = query;
    wider.options.target_gap = clearance;
    const Reference near = reference(wider, GapOverTime(wider));
    return near.contact || near.gave_up ? Truth{} : Truth{Fate::apart};
}

std::string_view truth_teller()
{
    return "long double and brute force, there being no referee in this build";
}

} // namespace brink::bench
