// SPDX-License-Identifier: BSD-3-Clause
#include "support/approach_with.h"

#include "best_step.h"
#include "course.h"
#include "sight.h"
#include "support.h"

#include <type_traits>

namespace brink::support {
namespace {

/// One query on its way.
class Approaching {
public:
    Approaching(const Mover<Core>& a, const Mover<Core>& b, const Options& options)
        : course_(a, b, options), watch_(a.part, b.part, course_.radii + course_.tolerance)
    {
        course_.go(course_.window.begin);
    }
    Way by_bounds(Ingredient);
    Way by_axes(bool following);

private:
    double horizon() const { return course_.window.end - course_.now(); }
    bool there() const { return sight_.upper - course_.radii <= course_.tolerance; }
    bool spent() const { return way_.evaluations >= most_evaluations; }
    Way ended(Ending);
    /// Whether the bodies may still meet after a step.
    bool go(double length);
    double bounded_step(Ingredient, const Separation&) const;
    void look();
    void follow(const Step&);
    Step best_step() const { return brink::best_step(course_.facing(), sight_, rolling_.spin, horizon()); }

    Course<Core> course_;
    Watch watch_;
    Sight sight_;
    Rolling rolling_;
    Trail trail_;
    Way way_;
};

Way Approaching::ended(Ending ending)
{
    way_.ending = ending;
    way_.t = course_.now();
    return way_;
}

bool Approaching::go(double length)
{
    const double next = course_.now() + length;
    if (next > course_.options.t_max || next >= course_.window.end) return false;
    course_.go(next);
    ++way_.steps;
    return true;
}

double Approaching::bounded_step(Ingredient ingredient, const Separation& s) const
{
    if (ingredient == Ingredient::length_bound) return s.gap / course_.fastest;
    const Facing<Core>& f = course_.facing();
    if (ingredient == Ingredient::second_order)
        return safe_step(f, TurningAxis{s.normal, {}}, horizon()).length;
    const double gap = gap_along(f.a.part, f.b.part, s.normal) - f.margin;
    const double rate = closing_rate(f, s.normal);
    return rate > 0 ? gap / rate : infinity;
}

Way Approaching::by_bounds(Ingredient ingredient)
{
    for (;;) {
        if (spent()) return ended(Ending::capped);
        ++way_.evaluations;
        const Separation s = course_.separated();
        if (s.gap - course_.options.target_gap <= course_.tolerance) return ended(Ending::hit);
        const double length = bounded_step(ingredient, s);
        if (!(length > 0)) return ended(Ending::stuck);
        if (!go(length)) return ended(Ending::apart);
    }
}

void Approaching::look()
{
    ++way_.evaluations;
    sight_ = watch_.look(course_.facing());
    trail_.followed = 0;
    if (sight_.guessed) rolling_.see(sight_.normal, course_.now());
}

void Approaching::follow(const Step& step)
{
    ++trail_.followed;
    sight_ = watch_.follow(course_.facing());
    if (step.residual <= 0.5 * course_.tolerance) watch_.land(course_.facing(), sight_);
}

/// As Advance::approach, but for leaps, and for axes at hand where the way is long.
Way Approaching::by_axes(bool following)
{
    look();
    for (;;) {
        if (there()) return ended(Ending::hit);
        const bool first = following && way_.steps == 0;
        if (first && passes(course_.facing(), sight_, horizon())) return ended(Ending::apart);
        Step step = first ? first_step(course_.facing(), sight_, horizon()) : best_step();
        const bool lost = trail_.lost(step, course_.facing(), watch_, sight_, course_.radii);
        if (there()) return ended(Ending::hit);
        if (spent()) return ended(Ending::capped);
        if (lost) {
            look();
            continue;
        }
        if (!(step.gap > 0)) {
            ++way_.evaluations;
            sight_ = Watch::look_hard(course_.facing());
            if (there()) return ended(Ending::hit);
            step = best_step();
        }
        if (!(step.gap > 0)) return ended(Ending::stuck);
        if (trail_.followed == 0) trail_.seen_gap = step.gap;
        if (!go(step.length)) return ended(Ending::apart);
        trail_.last_gap = step.gap;
        if (following && watch_.can_follow())
            follow(step);
        else
            look();
    }
}

Way approach_with(Ingredient ingredient, const Mover<Core>& a, const Mover<Core>& b, const Options& options)
{
    Approaching approaching(a, b, options);
    if (ingredient < Ingredient::features_axis) return approaching.by_bounds(ingredient);
    return approaching.by_axes(ingredient == Ingredient::following);
}

template <class S> constexpr bool bounded = std::is_same_v<decltype(part(std::declval<S>())), Core>;

} // namespace

Way approach_with(Ingredient ingredient, const Query& q)
{
    // In the order of the library's table.
    if (q.b.index() < q.a.index())
        return approach_with(ingredient, Query{q.b, q.motion_b, q.a, q.motion_a, q.options});
    return std::visit(
        [&](const auto& a, const auto& b) -> Way {
            if constexpr (bounded<decltype(a)> && bounded<decltype(b)>)
                return approach_with(ingredient, mover(a, q.motion_a), mover(b, q.motion_b), q.options);
            return {};
        },
        q.a, q.b);
}

} // namespace brink::support
