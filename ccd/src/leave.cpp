// SPDX-License-Identifier: BSD-3-Clause
#include "leave.h"

#include "contact_features.h"
#include "corner_step.h"
#include "flattest_edge.h"
#include "persist.h"
#include "stride.h"
#include "support.h"
#include "tolerance.h"
#include "touching.h"

#include <algorithm>
#include <type_traits>

namespace brink {

namespace {

/// The part of an overlap by which it may grow unseen between two looks, and how far an axis may turn until
/// then (radians): its cosine is no less than 1 - unseen / 2.
constexpr double unseen = 0x1p-4, most_turned = 0x1p-2;

/// The longest time that some axis proves: at rest, glued to A, glued to B, and following the edges that
/// touch.
template <class Proves> double longest(const Facing<Core>& f, V3 normal, double horizon, const Proves& proves)
{
    double h = proves(TurningAxis{normal, {}});
    const auto better = [&](V3 spin) {
        if (!(spin == V3{}) && h < horizon) h = std::max(h, proves(TurningAxis{normal, spin}));
    };
    better(f.a.rate);
    better(f.b.rate);
    const FlatEdges of_a = edges_across(f.a.part, normal), of_b = edges_across(f.b.part, -normal);
    const bool faces = of_a.count > 1 || of_b.count > 1;
    if (faces && h > tolerance::standstill * horizon) return h;
    for (int i = 0; i < std::max(1, of_a.count); ++i)
        for (int k = 0; k < std::max(1, of_b.count); ++k)
            better(axis_between(of_a.feature[i], f.a.rate, of_b.feature[k], f.b.rate, normal, normal).spin);
    return h;
}

/// Over which the gap does not fall below what it is.
double rising(const Facing<Core>& f, V3 normal, double horizon)
{
    return longest(f, normal, horizon,
                   [&](const TurningAxis& axis) { return rising_step(f, axis, horizon); });
}
double rising(const Facing<Border>& f, V3 normal, double horizon)
{
    return rising_step(f, TurningAxis{normal, f.b.rate}, horizon);
}

/// Over which cores that overlap provably part, at hardly less than the rate of now, and are as provably not
/// much farther apart than that tells: a fall by more than the part `unseen` of the overlap would be seen.
double parting_step(const Facing<Core>& f, const Separation& now, double horizon)
{
    const V3 n = now.normal, a = now.point_a - f.a.part.radius * n, b = now.point_b + f.b.part.radius * n;
    const double overlap = -(now.gap + f.a.part.radius + f.b.part.radius);
    const double rate = dot(n, f.velocity + cross(f.b.rate, b - f.b.pivot) - cross(f.a.rate, a));
    if (!(overlap > 0 && rate > 0)) return 0;
    // Where what is left once that rate is taken off does not fall, the gap rises by it along the axis of
    // now.
    Facing<Core> slower = f;
    slower.velocity = f.velocity - ((1 - 0.5 * unseen) * rate) * n;
    const double rises = longest(slower, n, horizon, [&](const TurningAxis& axis) {
        const double turn = norm(axis.spin), aside = turn > 0 ? most_turned / turn : infinity;
        return std::min(rising_step(slower, axis, horizon), aside);
    });
    return overlap_step(f, now, {(1 - unseen) * overlap, (1 - unseen) * rate}, rises);
}
double parting_step(const Facing<Border>&, const Separation&, double) { return 0; }

/// The same point by point, at rest and glued to either.
double rising_by_corners(const Facing<Core>& f, V3 normal, double horizon)
{
    double h = corner_rise(f, TurningAxis{normal, {}}, horizon);
    for (const V3 spin : {f.a.rate, f.b.rate})
        if (!(spin == V3{})) h = std::max(h, corner_rise(f, TurningAxis{normal, spin}, horizon));
    return h;
}
double rising_by_corners(const Facing<Border>& f, V3 normal, double horizon)
{
    return corner_rise(f, TurningAxis{normal, f.b.rate}, horizon);
}

/// Over which it does not decrease at any moment.
double growing(const Facing<Core>& f, const Separation& now, double horizon)
{
    return longest(f, now.normal, horizon,
                   [&](const TurningAxis& axis) { return growing_step(f, axis, now, horizon); });
}
double growing(const Facing<Border>& f, const Separation& now, double horizon)
{
    return growing_step(f, TurningAxis{now.normal, f.b.rate}, horizon);
}

/// Whether the gap is proven not to decrease as two bodies translate: its rate is more than rounding, or zero
/// in every term.
bool parting(V3 normal, V3 velocity)
{
    const V3 terms{normal.x * velocity.x, normal.y * velocity.y, normal.z * velocity.z};
    const double rate = terms.x + terms.y + terms.z;
    return rate > tolerance::rate_slack * norm(velocity) || terms == V3{};
}

template <class Part>
using TouchingOf = std::conditional_t<std::is_same_v<Part, Core>, Touching, TouchingBorder>;

template <class Part> class Leaving {
public:
    enum class Start : unsigned char { in_contact, near_contact };
    Leaving(Course<Part>& course, const Separation& now, Start start)
        : course_(course),
          now_(now),
          highest_(now),
          apart_(start == Start::near_contact),
          start_(course.answer(reported(course) ? Status::hit : Status::touching, now)),
          blind_(course.options.start_contact == StartContact::ignore)
    {
    }
    std::optional<Toi> run();

private:
    double gap() const { return gap(now_); }
    double gap(const Separation& s) const { return s.gap - course_.options.target_gap; }
    static bool reported(const Course<Part>& c) { return c.options.start_contact == StartContact::report; }
    bool fell_back();
    bool long_watched() const;
    bool holds() const;
    bool out_of_doubt() const { return gap(highest_) > tolerance::shown * course_.rounding; }
    double step_away() const;
    double step_in_contact() const;
    double coast(double step, double t_end);
    std::optional<Toi> move(double step, double t_end);
    std::optional<Toi> beyond() const
    {
        if (course_.now() > course_.options.t_max) return course_.apart();
        return {};
    }
    Toi as_it_started()
    {
        start_.iterations = course_.iterations;
        return start_;
    }

    Course<Part>& course_;
    Separation now_;
    Separation highest_; // so far
    double highest_at_ = 0;
    bool apart_;      // has been beyond the target gap, as far as can be told
    Toi start_;       // where contact is reported it is apart: one in doubt was told before
    bool blind_;      // the way out of contact need not be proven
    int strides_ = 0; // without an evaluation
};

/// Goes on by `step`, unless that passes `t_end` or the budget is spent.
template <class Part> std::optional<Toi> Leaving<Part>::move(double step, double t_end)
{
    const double before = course_.now();
    if (course_.iterations >= tolerance::long_way && blind_ && !apart_) step = coast(step, t_end);
    const double next = course_.now() + step;
    const bool spent = course_.iterations >= course_.options.max_iterations;
    const bool ends_here = spent && apart_; // whatever t_end: within the tolerance, and apart until here
    if (next >= course_.window.end || (next > t_end && !ends_here)) return course_.apart();
    if (spent && course_.now() != before) now_ = course_.separated();
    if (spent) return course_.answer(apart_ ? Status::hit : Status::undecided, now_);
    course_.go(next);
    ++course_.iterations;
    now_ = course_.separated();
    return {};
}

/// On a long way in contact, goes on without evaluations, as often as what touches here proves to stay in
/// contact; what it proves from where that leads.
template <class Part> double Leaving<Part>::coast(double step, double t_end)
{
    TouchingOf<Part> touching(course_.facing(), now_);
    for (double last = step; strides_ < tolerance::most_strides; ++strides_) {
        const double next = course_.now() + last;
        if (next > t_end || next >= course_.window.end) return last;
        touching.go(course_.facing(), course_.later(next));
        course_.go(next);
        last = touching.step(course_.facing(), course_.radii, course_.window.end - next);
        if (!(last >= tolerance::worth_coasting * step)) return last;
    }
    return 0;
}

/// Whether the gap, which no step lets fall, has come down by the roundings of many: then that ends where it
/// was highest.
template <class Part> bool Leaving<Part>::fell_back()
{
    if (now_.gap >= highest_.gap) highest_ = now_, highest_at_ = course_.now();
    const bool fell = (apart_ || !blind_) && gap() < std::min(gap(highest_), 0.0) - course_.slack;
    if (!fell) return false;
    course_.go(highest_at_);
    now_ = highest_;
    return true;
}

/// Whether much of the budget went into watching a gap that no proof spans: that it does not fall counts as
/// unproven then, and the rest would hardly lead to the next contact.
template <class Part> bool Leaving<Part>::long_watched() const
{
    return !blind_ && !apart_ &&
           course_.iterations > tolerance::most_watched * course_.options.max_iterations;
}

/// Whether steps over which the gap does not fall below what planes prove of it now keep bodies apart that
/// are: of curved ones points may say more than is true.
template <class Part> bool Leaving<Part>::holds() const
{
    const double proven = now_.lower - course_.options.target_gap;
    return !apart_ || proven >= std::min(gap(), 0.0) - course_.slack;
}

/// A step over which the gap provably does not fall below what it is, to a border on the way out of contact
/// not at any moment, or once apart does not close: 0 if none is proven that could be told from standing
/// still. Between bodies, from deeper down, where it may fall in between, it also ends at a part of what
/// could bring the gap to the target, so that poses are looked at often enough to see that.
template <class Part> double Leaving<Part>::step_away() const
{
    const double left = course_.window.end - course_.now();
    const double least = std::min(course_.tolerance / course_.fastest, tolerance::small_part * left);
    const Facing<Part>& f = course_.facing();
    if constexpr (std::is_same_v<Part, Border>) {
        if (!blind_ && !apart_) {
            const double way = growing(f, now_, left);
            return way >= least ? way : 0;
        }
    }
    const bool held = holds();
    double way = held ? rising(f, now_.normal, left) : 0;
    if (held && (!(way >= least) || course_.iterations >= tolerance::long_way))
        way = std::max(way, rising_by_corners(f, now_.normal, left));
    if (!(way >= least) && apart_ && gap() > course_.slack) way = stride(f, now_.normal, left).step.length;
    if (!(way >= least)) return 0;
    if (!(gap() < -course_.tolerance)) return way;
    const double shallow = tolerance::watchful * -gap() / course_.fastest;
    if (way <= shallow) return way;
    return std::max({shallow, growing(f, now_, way), parting_step(f, now_, left)});
}

/// A step over which the gap provably does not exceed the target by more than the tolerance.
template <class Part> double Leaving<Part>::step_in_contact() const
{
    const double lasting =
        contact_step(course_.facing(), now_, course_.radii, course_.window.end - course_.now());
    return std::max(lasting, std::max(-gap(), course_.tolerance) / course_.fastest);
}

/// It does not look at t_max, on which `touching` must not depend.
template <class Part> std::optional<Toi> Leaving<Part>::run()
{
    const double t_max = course_.options.t_max, tolerance = course_.tolerance;
    while (gap() <= tolerance) {
        apart_ = apart_ || gap() > 0;
        const bool deep = blind_ && !apart_ && gap() < -tolerance;
        double step = fell_back() || long_watched() ? 0 : deep ? step_in_contact() : step_away();
        // On a way that ends before all does, contact might be left and met again unseen.
        if (blind_ && !apart_ && !deep && course_.now() + step < course_.window.end) step = step_in_contact();
        if (step == 0) {
            if (!blind_ && !(apart_ && out_of_doubt())) return as_it_started();
            if (apart_) return course_.now() > t_max ? course_.apart() : course_.answer(Status::hit, now_);
            step = step_in_contact();
        }
        const std::optional<Toi> end = move(step, blind_ ? t_max : 1);
        if (!end) continue;
        if (apart_ && end->t > t_max) return course_.apart();
        return end->status == Status::separated || blind_ || apart_ ? end : as_it_started();
    }
    return beyond();
}

} // namespace

template <class Part> std::optional<Toi> leave(Course<Part>& course, const Separation& now)
{
    return Leaving<Part>(course, now, Leaving<Part>::Start::near_contact).run();
}

template <class Part> std::optional<Toi> leave_contact(Course<Part>& course, const Separation& now)
{
    const StartContact wish = course.options.start_contact;
    if (wish == StartContact::report) return course.answer(Status::touching, now);
    if (!course.translates()) return Leaving<Part>(course, now, Leaving<Part>::Start::in_contact).run();
    // Convex bodies that only translate have a convex gap over time: once it does not fall it never does.
    if (wish == StartContact::ignore || parting(now.normal, course.facing().velocity)) return course.apart();
    return course.answer(Status::touching, now);
}

template std::optional<Toi> leave(Course<Core>&, const Separation&);
template std::optional<Toi> leave(Course<Border>&, const Separation&);
template std::optional<Toi> leave_contact(Course<Core>&, const Separation&);
template std::optional<Toi> leave_contact(Course<Border>&, const Separation&);

} // namespace brink
