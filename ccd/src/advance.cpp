// SPDX-License-Identifier: BSD-3-Clause
#include "advance.h"

#include "certificate.h"
#include "tolerance.h"
#include "window.h"

#include <algorithm>
#include <optional>
#include <type_traits>

namespace brink {

namespace {

double size(const Core& core) { return core.radius; }
double size(const Border& border) { return std::fabs(border.offset); }

/// The lengths of one body that roundings are relative to.
template <class Part> double extent(const Mover<Part>& m)
{
    return norm(m.arm) + (1 + m.turn.angle) * m.reach + size(m.part);
}

Turning turning(const Core& part, const Mover<Core>& m, V3) { return {&part, 0, m.reach, m.turn.rate}; }
Turning turning(const Border& part, const Mover<Border>& m, V3 axis)
{
    return {nullptr, dot(axis, part.normal) < 0 ? -part.offset : part.offset, 0, m.turn.rate};
}

/// One query: the two bodies, seen from A's pivot, on their way through the step.
template <class Part> class Advance {
public:
    Advance(const Mover<Core>& a, const Mover<Part>& b, const Options& options);
    Toi run();
    Toi from_contact();
    std::optional<Toi> from_proven_contact();
    void describe(Toi& toi);

private:
    struct Pose {
        Core a;    // turned about its pivot, which is the origin
        Part b;    // likewise
        V3 offset; // from A's pivot to B's
        Separation separation;
        double gap = 0; // above target_gap
    };

    Pose pose();
    Facing facing() const;
    Toi answer(Status status) const;
    Toi separated() const
    {
        return {.status = Status::separated, .t = options_.t_max, .iterations = iterations_};
    }
    Toi translate_away() const;
    std::optional<Toi> leave();
    Toi leave_contact();
    Toi go_on();
    Toi approach();
    std::optional<Toi> move(double step, double t_end);
    double step_away() const;

    const Mover<Core>& a_;
    const Mover<Part>& b_;
    const Options& options_;
    V3 from_, velocity_; // of B's pivot, relative to A's
    double rounding_;    // of a gap, at most
    double slack_;       // what rounding can take off a bound
    double tolerance_;   // how near counts as there
    double fastest_;     // no gap changes faster
    Window window_;
    double t_ = 0;
    int iterations_ = 0;
    Pose now_;
};

template <class Part>
Advance<Part>::Advance(const Mover<Core>& a, const Mover<Part>& b, const Options& options)
    : a_(a),
      b_(b),
      options_(options),
      from_((b.position - a.position) + (b.arm - a.arm)),
      velocity_(b.translation - a.translation)
{
    const double distance = norm(b.position - a.position), travel = norm(velocity_);
    const double swing = std::is_same_v<Part, Border> ? norm(from_) + travel + a.reach : b.reach;
    const double lengths =
        distance + 2 * travel + extent(a) + extent(b) + b.turn.angle * swing + options.target_gap;
    tolerance_ = std::max(options.tolerance, 2 * tolerance::least_slack * lengths);
    rounding_ = tolerance::certificate_slack * lengths;
    slack_ = std::min(rounding_, 0.5 * tolerance_);
    fastest_ = travel + a.turn.angle * a.reach + b.turn.angle * swing;
    window_ = meeting(a, b, from_, velocity_, options.target_gap + slack_);
}

template <class Part> typename Advance<Part>::Pose Advance<Part>::pose()
{
    ++iterations_;
    const V3 offset = from_ + t_ * velocity_;
    Pose p{a_.turned_to(t_), b_.turned_to(t_), offset, {}, 0};
    p.separation = separation(p.a, placed(p.b, {}, offset));
    p.gap = p.separation.gap - options_.target_gap;
    return p;
}

template <class Part> Facing Advance<Part>::facing() const
{
    const V3 axis = now_.separation.normal;
    const double proven = now_.separation.lower - options_.target_gap - slack_;
    return {turning(now_.a, a_, axis), turning(now_.b, b_, axis), axis, now_.offset, velocity_, proven};
}

template <class Part> Toi Advance<Part>::answer(Status status) const
{
    Toi toi{.status = status, .t = t_, .iterations = iterations_};
    if (status == Status::touching) toi.t_upper = 0;
    if (options_.detail == Detail::time_only) return toi;
    const V3 origin = a_.pivot(t_);
    toi.normal = store(now_.separation.normal);
    toi.point_a = store(origin + now_.separation.point_a);
    toi.point_b = store(origin + now_.separation.point_b);
    toi.gap = now_.separation.gap;
    return toi;
}

/// Goes on by `step`, unless that passes `t_end` or the budget is spent.
template <class Part> std::optional<Toi> Advance<Part>::move(double step, double t_end)
{
    if (t_ + step > t_end || t_ + step >= window_.end) return separated();
    if (iterations_ >= options_.max_iterations) return answer(Status::undecided);
    t_ += step;
    now_ = pose();
    return {};
}

/// Whether the gap is proven not to decrease as two bodies translate: its rate is more than rounding, or zero
/// in every term.
bool parting(V3 normal, V3 velocity)
{
    const V3 terms{normal.x * velocity.x, normal.y * velocity.y, normal.z * velocity.z};
    const double rate = terms.x + terms.y + terms.z;
    return rate > tolerance::rate_slack * norm(velocity) || terms == V3{};
}

/// Convex bodies that only translate have a convex gap over time: once it does not fall it never falls again.
template <class Part> Toi Advance<Part>::translate_away() const
{
    const bool may_part = options_.start_contact == StartContact::ignore;
    return may_part || parting(now_.separation.normal, velocity_) ? separated() : answer(Status::touching);
}

/// A step from a pose within the tolerance of contact, over which the gap provably does not fall below what
/// it is: 0 if none is proven that could be told from standing still. From deeper down it also ends before
/// the gap can reach the target, lest it pass over a time of separation and the contact after it; where it
/// must not fall at all, at a quarter of that, so that poses are looked at often enough to see it fall again.
template <class Part> double Advance<Part>::step_away() const
{
    const double share = options_.start_contact == StartContact::ignore ? 1 : 0.25;
    const double least = tolerance_ / fastest_, shallow = share * -now_.gap / fastest_;
    const double rising = rising_step(facing(), window_.end - t_);
    if (!(rising >= least)) return 0;
    return now_.gap < -tolerance_ ? std::min(rising, shallow) : rising;
}

/// From a start in contact, or within the tolerance of it, to where the gap exceeds the tolerance: by steps
/// over which it does not fall, or else (`ignore` only) cannot exceed the target by more than the tolerance.
/// Returns an answer where that ends the query. It does not look at t_max, on which `touching` must not
/// depend.
template <class Part> std::optional<Toi> Advance<Part>::leave()
{
    const auto touching = [this, start = *this] {
        Toi toi = start.answer(Status::touching);
        toi.iterations = iterations_;
        return toi;
    };
    const bool blind = options_.start_contact == StartContact::ignore;
    bool apart = false;
    while (now_.gap <= tolerance_) {
        apart = apart || now_.gap > 0;
        double step = step_away();
        if (step == 0) {
            if (apart) return t_ > options_.t_max ? separated() : answer(Status::hit);
            if (!blind) return touching();
            step = std::max(-now_.gap, tolerance_) / fastest_;
        }
        const std::optional<Toi> end = move(step, blind ? options_.t_max : 1);
        if (!end) continue;
        if (apart && end->t > options_.t_max) return separated();
        return end->status == Status::separated || blind || apart ? end : touching();
    }
    if (t_ > options_.t_max) return separated();
    return {};
}

template <class Part> Toi Advance<Part>::approach()
{
    for (;;) {
        if (now_.gap <= tolerance_) return answer(Status::hit);
        const Facing f = facing();
        if (!(f.gap > 0)) return answer(Status::undecided);
        if (const std::optional<Toi> end = move(safe_step(f, window_.end - t_), options_.t_max)) return *end;
    }
}

/// In contact at the start.
template <class Part> Toi Advance<Part>::leave_contact()
{
    if (options_.start_contact == StartContact::report) return answer(Status::touching);
    if (a_.turn.angle == 0 && b_.turn.angle == 0) return translate_away();
    return go_on();
}

template <class Part> Toi Advance<Part>::go_on()
{
    if (t_ == 0 && now_.gap <= tolerance_) {
        if (const std::optional<Toi> end = leave()) return *end;
    }
    return approach();
}

template <class Part> Toi Advance<Part>::run()
{
    if (window_.empty || window_.begin > options_.t_max) return separated();
    t_ = window_.begin;
    now_ = pose();
    return t_ == 0 && now_.gap <= 0 ? leave_contact() : go_on();
}

template <class Part> Toi Advance<Part>::from_contact()
{
    now_ = pose();
    return leave_contact();
}

template <class Part> std::optional<Toi> Advance<Part>::from_proven_contact()
{
    now_ = pose();
    if (!(now_.gap < -rounding_)) return {};
    return leave_contact();
}

template <class Part> void Advance<Part>::describe(Toi& toi)
{
    t_ = toi.t;
    now_ = pose();
    const Toi described = answer(toi.status);
    toi.normal = described.normal;
    toi.point_a = described.point_a;
    toi.point_b = described.point_b;
    toi.gap = described.gap;
}

} // namespace

template <class Part>
Toi certified_advancement(const Mover<Core>& a, const Mover<Part>& b, const Options& options)
{
    return Advance<Part>(a, b, options).run();
}

template <class Part> Toi from_contact(const Mover<Core>& a, const Mover<Part>& b, const Options& options)
{
    return Advance<Part>(a, b, options).from_contact();
}

template <class Part>
std::optional<Toi> from_proven_contact(const Mover<Core>& a, const Mover<Part>& b, const Options& options)
{
    return Advance<Part>(a, b, options).from_proven_contact();
}

template <class Part>
void describe_contact(Toi& toi, const Mover<Core>& a, const Mover<Part>& b, const Options& options)
{
    Advance<Part>(a, b, options).describe(toi);
}

template Toi certified_advancement(const Mover<Core>&, const Mover<Core>&, const Options&);
template Toi certified_advancement(const Mover<Core>&, const Mover<Border>&, const Options&);
template Toi from_contact(const Mover<Core>&, const Mover<Core>&, const Options&);
template Toi from_contact(const Mover<Core>&, const Mover<Border>&, const Options&);
template std::optional<Toi> from_proven_contact(const Mover<Core>&, const Mover<Core>&, const Options&);
template std::optional<Toi> from_proven_contact(const Mover<Core>&, const Mover<Border>&, const Options&);
template void describe_contact(Toi&, const Mover<Core>&, const Mover<Core>&, const Options&);
template void describe_contact(Toi&, const Mover<Core>&, const Mover<Border>&, const Options&);

} // namespace brink
