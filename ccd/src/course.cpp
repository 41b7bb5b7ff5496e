// SPDX-License-Identifier: BSD-3-Clause
#include "course.h"

#include "support.h"
#include "tolerance.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace brink {

namespace {

double radius(const Core& core) { return core.radius; }
double radius(const Border&) { return 0; }
double size(const Core& core) { return core.radius; }
double size(const Border& border) { return std::fabs(border.offset); }

/// The lengths of one body that roundings are relative to, where it starts
template <class Part> double extent_at_start(const Mover<Part>& m)
{
    return sum_of_magnitudes(m.arm) + m.reach + size(m.part);
}
/// and on its way.
template <class Part> double extent(const Mover<Part>& m)
{
    return sum_of_magnitudes(m.arm) + (1 + m.turn.angle) * m.reach + size(m.part);
}

} // namespace

template <class Part>
Course<Part>::Course(const Mover<Core>& a, const Mover<Part>& b, const Options& o)
    : options(o),
      radii(a.part.radius + radius(b.part) + o.target_gap),
      a_(a),
      b_(b),
      from_((b.position - a.position) + (b.arm - a.arm)),
      part_a_(a.part),
      part_b_(b.part),
      facing_{{part_a_, {}, a.reach, a.turn.rate, a.turn.angle},
              {part_b_, from_, b.reach, b.turn.rate, b.turn.angle},
              b.translation - a.translation,
              0}
{
    const V3 velocity = facing_.velocity;
    const double distance = sum_of_magnitudes(b.position - a.position), travel = norm(velocity);
    const double swing = std::is_same_v<Part, Border> ? norm(from_) + travel + a.reach : b.reach;
    const double lengths =
        distance + 2 * travel + extent(a) + extent(b) + b.turn.angle * swing + o.target_gap;
    static_cast<Allowance&>(*this) = {lengths, o};
    fastest = travel + a.turn.angle * a.reach + b.turn.angle * swing;
    facing_.margin = radii + slack;
    window = meeting(a, b, from_, velocity, o.target_gap + slack);
}

template <class Part> void Course<Part>::go(double time)
{
    t_ = time;
    facing_.b.pivot = from_ + t_ * facing_.velocity;
    const auto [a, b] = turns(t_);
    a_.place(part_a_, a, {});
    b_.place(part_b_, b, facing_.b.pivot);
}

template <class Part> Separation Course<Part>::separated(V3 axis) const
{
    Separation s = separated();
    if constexpr (std::is_same_v<Part, Core>)
        s.lower = std::max(s.lower, gap_along(part_a_, part_b_, axis) - (part_a_.radius + part_b_.radius));
    return s;
}

template <class Part> double Course<Part>::rounding_at_start() const
{
    const double distance = sum_of_magnitudes(b_.position - a_.position);
    return tolerance::certificate_slack *
           (distance + extent_at_start(a_) + extent_at_start(b_) + options.target_gap);
}

template <class Part> void Course<Part>::begin_lap(double gap)
{
    const Facing<Part>& f = facing_;
    const double left = window.end - t_, lap = tolerance::whole_turn / std::max(f.a.angle, f.b.angle);
    const double travel = norm(f.velocity), arc_a = f.a.angle * f.a.reach;
    const double drift = f.a.angle == f.b.angle  ? travel
                         : f.a.angle > f.b.angle ? fastest - arc_a
                                                 : travel + arc_a;
    const double kept = drift * left + slack;
    if (lap_end_ < infinity || !(2 * lap < left) || !(kept < tolerance::spared * gap)) return;
    lap_end_ = t_ + lap;
    facing_.margin = radii + slack + kept;
}

template <class Part> bool Course<Part>::give_up_lap()
{
    facing_.margin = radii + slack;
    return std::exchange(lap_end_, infinity) < infinity;
}

template <class Part> double Course<Part>::allowed() const
{
    const double lengths = norm(b_.position - a_.position) + norm(facing_.velocity) + radii +
                           (1 + a_.turn.angle) * a_.reach + (1 + b_.turn.angle) * b_.reach;
    return std::max(tolerance, tolerance::promised * lengths);
}

template <class Part> Toi Course<Part>::answer(Status status, const Separation& s) const
{
    Toi toi{.status = status, .t = t_, .iterations = iterations};
    if (status == Status::touching) toi.t_upper = 0;
    if (options.detail == Detail::time_only) return toi;
    const V3 origin = a_.pivot(t_);
    toi.normal = store(s.normal);
    toi.point_a = store(origin + s.point_a);
    toi.point_b = store(origin + s.point_b);
    toi.gap = s.gap;
    return toi;
}

template class Course<Core>;
template class Course<Border>;

} // namespace brink
