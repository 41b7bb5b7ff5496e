// SPDX-License-Identifier: BSD-3-Clause
#include "stability_score.h"

#include <algorithm>
#include <cmath>

namespace brink::bench {

void Score::add(const Score& more)
{
    cases += more.cases;
    meets += more.meets;
    wrong += more.wrong;
    late += more.late;
    undecided += more.undecided;
    conservative += more.conservative;
    broken += more.broken;
    backward = std::max(backward, more.backward);
    backward_centres = std::max(backward_centres, more.backward_centres);
    bracket = std::max(bracket, more.bracket);
    unsettled += more.unsettled;
    stuck += more.stuck;
    ulps.insert(ulps.end(), more.ulps.begin(), more.ulps.end());
    steps.insert(steps.end(), more.steps.begin(), more.steps.end());
    used.insert(used.end(), more.used.begin(), more.used.end());
}

double Score::at_share(std::vector<double> values, double share)
{
    if (values.empty()) return 0;
    const auto rank = static_cast<std::ptrdiff_t>(std::ceil(share * static_cast<double>(values.size()))) - 1;
    std::nth_element(values.begin(), values.begin() + rank, values.end());
    return values[static_cast<std::size_t>(rank)];
}

bool Complaint::precedes(const Complaint& other) const
{
    if (wrong != other.wrong) return wrong;
    return std::pair(spot, index) < std::pair(other.spot, other.index);
}

void Scores::complain(Complaint complaint)
{
    const auto same = std::find_if(complaints.begin(), complaints.end(), [&](const Complaint& c) {
        return c.spot.pair == complaint.spot.pair && c.spot.kind == complaint.spot.kind;
    });
    if (same == complaints.end())
        complaints.push_back(std::move(complaint));
    else if (complaint.precedes(*same))
        *same = std::move(complaint);
}

void Scores::add(const Scores& more)
{
    for (const auto& [spot, scores] : more.at)
        for (std::size_t i = 0; i < scores.size(); ++i)
            at[spot][i].add(scores[i]);
    for (const Complaint& complaint : more.complaints)
        complain(complaint);
}

Score Scores::total(std::size_t pair, std::size_t kind, Solver solver) const
{
    Score sum;
    for (const auto& [spot, scores] : at)
        if (spot.pair == pair && spot.kind == kind) sum.add(scores[static_cast<std::size_t>(solver)]);
    return sum;
}

} // namespace brink::bench
