// SPDX-License-Identifier: BSD-3-Clause
#include "method.h"

namespace brink::bench {
namespace {

using support::FclQuestion;

/// Stops at the first part whose end shows an overlap, as a simulator would. The step's beginning was the end
/// of the step before.
template <int parts> std::optional<double> discrete(const Question& q)
{
    for (int k = 1; k <= parts; ++k) {
        const double t = static_cast<double>(k) / parts;
        if (fcl_collide(q.fcl_a, q.crossing.motion_a.at(t), q.fcl_b, q.crossing.motion_b.at(t))) return t;
    }
    return std::nullopt;
}

template <FclQuestion solver> std::optional<double> continuous(const Question& q)
{
    return fcl_continuous(solver, q.fcl_a, q.crossing.motion_a, q.fcl_b, q.crossing.motion_b);
}

/// Strict with ourselves: `undecided` would keep the bodies apart, but it reports no contact.
std::optional<double> ask_brink(const Question& q)
{
    const Crossing& c = q.crossing;
    const Toi toi = time_of_impact(c.a, c.motion_a, c.b, c.motion_b);
    if (toi.status == Status::hit || toi.status == Status::touching) return toi.t;
    return std::nullopt;
}

} // namespace

const std::array<Method, 6> methods{{
    {"discrete_1", "discrete, 1 check a step", discrete<1>},
    {"discrete_10", "discrete, 10 checks a step", discrete<10>},
    {"discrete_100", "discrete, 100 checks a step", discrete<100>},
    {"fcl_default", "FCL continuous, default", continuous<FclQuestion::naive>},
    {"fcl_advancement", "FCL conservative advancement", continuous<FclQuestion::conservative_advancement>},
    {"brink", "brink", ask_brink},
}};

} // namespace brink::bench
