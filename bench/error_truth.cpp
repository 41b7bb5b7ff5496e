// SPDX-License-Identifier: BSD-3-Clause
#include "error_truth.h"

#include <reference.h>

#include <algorithm>

namespace brink::bench {

using support::GapOverTime;
using support::Reference;

Truth truth(const support::Query& query)
{
    const auto [first, second] = std::minmax(query.a.index(), query.b.index());
    if (!support::Pair{first, second}.has_reference()) return refereed_truth(query);
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

} // namespace brink::bench
