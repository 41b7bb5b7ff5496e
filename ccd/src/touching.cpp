// SPDX-License-Identifier: BSD-3-Clause
#include "touching.h"

#include "persist.h"

#include <algorithm>

namespace brink {

Touching::Touching(const Facing<Core>& f, const Separation& contact)
    : on_a_(contact.point_a - f.a.part.radius * contact.normal),
      on_b_(contact.point_b + f.b.part.radius * contact.normal)
{
    if (!has_edges(f.a.part) || !has_edges(f.b.part)) return;
    edge_a_ = flattest_edge(f.a.part, contact.normal);
    edge_b_ = flattest_edge(f.b.part, -contact.normal);
}

void Touching::go(const Facing<Core>& from, const Course<Core>::Later& to)
{
    const auto with_b = [&](V3 p) { return to.turn_b * (p - from.b.pivot) + to.pivot_b; };
    on_a_ = to.turn_a * on_a_;
    on_b_ = with_b(on_b_);
    edge_a_.top = to.turn_a * edge_a_.top;
    edge_b_.top = with_b(edge_b_.top);
    edge_a_.along = to.turn_a * edge_a_.along;
    edge_b_.along = to.turn_b * edge_b_.along;
}

double Touching::step(const Facing<Core>& f, double reach, double horizon) const
{
    const auto lasting = [&](V3 on_a, V3 on_b) {
        return contact_step(f, {0, 0, {}, on_a, on_b}, reach, horizon);
    };
    const double carried = lasting(on_a_, on_b_);
    if (!(norm(cross(edge_a_.along, edge_b_.along)) > tolerance::skew)) return carried;
    const auto [s, t] = nearest_places(edge_a_, edge_b_);
    if (!(s >= 0 && s <= edge_a_.length && t >= 0 && t <= edge_b_.length)) return carried;
    return std::max(carried, lasting(edge_a_.top + s * edge_a_.along, edge_b_.top + t * edge_b_.along));
}

double TouchingBorder::step(const Facing<Border>& f, double reach, double horizon)
{
    return contact_step(f, {}, reach, horizon);
}

} // namespace brink
