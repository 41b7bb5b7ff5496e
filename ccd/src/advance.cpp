// SPDX-License-Identifier: BSD-3-Clause
#include "advance.h"

#include "best_step.h"
#include "contact_by.h"
#include "leap.h"
#include "leave.h"
#include "sight.h"
#include "stride.h"
#include "tolerance.h"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace brink {

namespace {

template <class Part> using WatchOf = std::conditional_t<std::is_same_v<Part, Core>, Watch, BorderWatch>;

/// One query on its way to first contact.
template <class Part> class Advance {
public:
    Advance(const Mover<Core>& a, const Mover<Part>& b, const Options& options)
        : course_(a, b, options), watch_(a.part, b.part, course_.radii + course_.tolerance)
    {
    }
    Toi run(const StartOracle&, int spent);
    Toi from_contact();
    std::optional<Toi> from_proven_contact();
    void describe(Toi& toi);

private:
    bool nearly() const { return sight_.upper - course_.radii <= course_.allowed(); }
    bool there() const { return sight_.upper - course_.radii <= course_.tolerance; }
    double horizon() const { return course_.end() - course_.now(); }
    bool leads_on(const Step& step) const
    {
        return step.gap > 0 && course_.now() + step.length > course_.now();
    }
    bool spent() const { return course_.iterations >= course_.options.max_iterations; }
    Separation measured();
    Separation contact() { return contact_at(course_, watch_, sight_); }
    void look();
    void go_on(const Step&);
    Step best_step() const;
    bool coast(const Step&);
    bool can_leap();
    Toi land();
    Toi hit();
    Toi arrived();
    Toi in_doubt();
    bool begins_in_contact(const Separation& start, const StartOracle&) const;
    Toi approach();
    Toi approach_anew();

    Course<Part> course_;
    WatchOf<Part> watch_;
    Sight sight_;
    Rolling rolling_;
    Trail trail_;
    bool first_ = true;
    bool misled_ = false;                 // the features of the last look do not lead to contact
    int strides_ = 0;                     // without a look
    Leap leap_;                           // where steps lead to its start, what follows is proven
    const StartOracle* untold_ = nullptr; // of a start that no look has shown to be within the tolerance
};

template <class Part> void Advance<Part>::look()
{
    ++course_.iterations;
    sight_ = watch_.look(course_.facing());
    trail_.followed = 0;
    misled_ = false;
    if (sight_.guessed || course_.iterations >= tolerance::quick_way)
        rolling_.see(sight_.normal, course_.now());
    if (course_.iterations >= tolerance::long_way && leap_.from == infinity)
        course_.begin_lap((sight_.upper < infinity ? sight_.upper : sight_.apart) - course_.radii);
}

template <class Part> Step Advance<Part>::best_step() const
{
    const Step best = brink::best_step(course_.facing(), sight_, rolling_.spin, horizon());
    if (course_.iterations < tolerance::long_way) return best;
    const Step wide = stride(course_.facing(), sight_.best_normal(), horizon()).step;
    return wide.length > best.length ? wide : best;
}

template <class Part> Separation Advance<Part>::measured()
{
    ++course_.iterations;
    return course_.separated();
}

/// Goes on as far as axes at hand lead in steps like this one, without looks; whether that is beyond t_max.
template <class Part> bool Advance<Part>::coast(const Step& step)
{
    AtHand axis{sight_.best_normal(), step.length};
    for (int i = 0; i < tolerance::most_coasted && strides_ < tolerance::most_strides; ++i, ++strides_) {
        const Facing<Part>& f = course_.facing();
        const TurningAxis followed = watch_.can_follow() ? watch_.follow(f).axis : rolling_.at(course_.now());
        axis = step_at_hand(f, axis, followed, horizon());
        if (!(axis.length >= tolerance::worth_coasting * step.length)) break;
        const double next = course_.now() + axis.length;
        if (next > course_.options.t_max || next >= course_.end()) return true;
        course_.go(next);
    }
    return false;
}

/// Sees where a step has led, which left `step.residual` of the gap.
template <class Part> void Advance<Part>::go_on(const Step& step)
{
    trail_.last_gap = step.gap;
    const Facing<Part>& f = course_.facing();
    const bool stale = misled_ && (f.a.angle + f.b.angle) * step.length > tolerance::far_turned;
    if (!watch_.can_follow() || stale || (first_ && !watch_.far_sighted())) return look();
    ++trail_.followed;
    sight_ = watch_.follow(f);
    if (step.residual <= 0.5 * course_.tolerance) watch_.land(f, sight_);
}

/// Whether what was just looked at shows a leap ahead that leaves no step to take before.
template <class Part> bool Advance<Part>::can_leap()
{
    const bool blind = trail_.followed > 0 || (first_ && !watch_.far_sighted());
    if (blind || leap_.from < infinity || course_.iterations > tolerance::most_leaps || spent()) return false;
    misled_ = !brink::leap(course_, watch_, sight_, leap_);
    return !misled_ && course_.now() == leap_.at;
}

/// Where no step leads on: contact if the bodies are near enough all over, though looks have not shown it.
template <class Part> Toi Advance<Part>::in_doubt()
{
    sight_ = watch_.look_hard(course_.facing());
    return nearly() ? arrived() : course_.answer(Status::undecided, contact());
}

template <class Part> Toi Advance<Part>::land()
{
    if (leap_.at > course_.options.t_max) return course_.apart();
    if (course_.now() != leap_.at) course_.go(leap_.at);
    sight_ = leap_.sight;
    return arrived();
}

template <class Part> Toi Advance<Part>::approach()
{
    for (;;) {
        if (there()) return arrived();
        if (first_ && passes(course_.facing(), sight_, horizon())) return course_.apart();
        if (can_leap()) return land();
        Step step = first_ ? first_step(course_.facing(), sight_, horizon()) : best_step();
        if (trail_.lost(step, course_.facing(), watch_, sight_, course_.radii)) {
            if (spent()) return in_doubt();
            look();
            continue;
        }
        if (there()) return arrived();
        if ((!leads_on(step) || step.gap <= course_.tolerance) && course_.give_up_lap()) continue;
        if (!leads_on(step)) {
            sight_ = watch_.look_hard(course_.facing());
            if (there()) return arrived();
            step = best_step();
        }
        if (!leads_on(step)) return in_doubt();
        if (trail_.followed == 0) trail_.seen_gap = step.gap;
        const double next = course_.now() + step.length;
        if (next >= leap_.from) return land();
        if (next > course_.options.t_max || next >= course_.end()) return course_.apart();
        if (spent()) return in_doubt();
        course_.go(next);
        if (course_.iterations >= tolerance::long_way && coast(step)) return course_.apart();
        go_on(step);
        first_ = false;
    }
}

template <class Part> Toi Advance<Part>::approach_anew()
{
    if (spent()) return course_.answer(Status::undecided, course_.separated());
    look();
    return approach();
}

template <class Part> Toi Advance<Part>::hit()
{
    const bool told = course_.options.detail == Detail::contact;
    Toi toi = course_.answer(Status::hit, told ? contact() : Separation{});
    toi.t_upper = contact_by(course_, watch_, sight_);
    toi.iterations = course_.iterations;
    return toi;
}

template <class Part> Toi Advance<Part>::run(const StartOracle& oracle, int spent)
{
    course_.iterations = spent;
    if (course_.window.empty || course_.window.begin > course_.options.t_max) return course_.apart();
    course_.go(course_.window.begin);
    look();
    untold_ = &oracle;
    return approach();
}

/// Within the tolerance of contact: at the start, whichever look shows that, the question is whether in it.
template <class Part> Toi Advance<Part>::arrived()
{
    course_.give_up_lap();
    const StartOracle* oracle = std::exchange(untold_, nullptr);
    if (oracle == nullptr || course_.now() > 0) return hit();
    const Separation start = course_.separated(sight_.best_normal());
    if (begins_in_contact(start, *oracle)) return from_contact();
    if (start.gap - course_.options.target_gap > course_.tolerance) return approach();
    if (const std::optional<Toi> end = leave(course_, start)) return *end;
    return approach_anew();
}

/// In doubt it is contact where contact is to be reported, and else a near miss, which approaching makes a
/// hit: late is worse than early.
template <class Part>
bool Advance<Part>::begins_in_contact(const Separation& start, const StartOracle& oracle) const
{
    const double target = course_.options.target_gap, gap = start.gap - target;
    const double doubt = tolerance::shown * course_.rounding_at_start();
    if (oracle.in_contact != nullptr && std::fabs(gap) <= course_.rounding)
        if (const std::optional<bool> known = oracle.in_contact(oracle.query)) return *known;
    const bool reported = course_.options.start_contact == StartContact::report;
    return reported ? start.lower - target <= doubt : gap <= -doubt;
}

template <class Part> Toi Advance<Part>::from_contact()
{
    course_.go(0);
    const Separation start = measured();
    if (const std::optional<Toi> end = leave_contact(course_, start)) return *end;
    return approach_anew();
}

template <class Part> std::optional<Toi> Advance<Part>::from_proven_contact()
{
    course_.go(0);
    const Separation start = measured();
    if (!(start.gap - course_.options.target_gap < -course_.rounding)) return {};
    if (const std::optional<Toi> end = leave_contact(course_, start)) return *end;
    return approach_anew();
}

template <class Part> void Advance<Part>::describe(Toi& toi)
{
    course_.go(toi.t);
    const Toi described = course_.answer(toi.status, measured());
    toi.normal = described.normal;
    toi.point_a = described.point_a;
    toi.point_b = described.point_b;
    toi.gap = described.gap;
}

} // namespace

template <class Part>
Toi certified_advancement(const Mover<Core>& a, const Mover<Part>& b, const Options& options,
                          const StartOracle& oracle, int spent)
{
    return Advance<Part>(a, b, options).run(oracle, spent);
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

template Toi certified_advancement(const Mover<Core>&, const Mover<Core>&, const Options&, const StartOracle&,
                                   int);
template Toi certified_advancement(const Mover<Core>&, const Mover<Border>&, const Options&,
                                   const StartOracle&, int);
template Toi from_contact(const Mover<Core>&, const Mover<Core>&, const Options&);
template Toi from_contact(const Mover<Core>&, const Mover<Border>&, const Options&);
template std::optional<Toi> from_proven_contact(const Mover<Core>&, const Mover<Core>&, const Options&);
template std::optional<Toi> from_proven_contact(const Mover<Core>&, const Mover<Border>&, const Options&);
template void describe_contact(Toi&, const Mover<Core>&, const Mover<Core>&, const Options&);
template void describe_contact(Toi&, const Mover<Core>&, const Mover<Border>&, const Options&);

} // namespace brink
