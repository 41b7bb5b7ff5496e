// SPDX-License-Identifier: BSD-3-Clause
#include "leap.h"

#include "depth.h"
#include "pursuit.h"
#include "support.h"
#include "tolerance.h"
#include "trend.h"

namespace brink {

namespace {

/// The same bodies as time runs backwards.
template <class Part> Facing<Part> backwards(const Facing<Part>& f)
{
    return {{f.a.part, f.a.pivot, f.a.reach, -f.a.rate, f.a.angle},
            {f.b.part, f.b.pivot, f.b.reach, -f.b.rate, f.b.angle},
            -f.velocity,
            f.margin};
}

/// A point of A and one of B.
struct Ends {
    V3 on_a, on_b;
};
/// The points that are extreme along the axis.
Ends extreme(const Facing<Core>& f, const Sight& sight)
{
    const V3 n = sight.axis.normal;
    return {farthest(f.a.part, n).point, farthest(f.b.part, -n).point};
}
Ends extreme(const Facing<Border>&, const Sight& sight)
{
    return {sight.point_a, sight.point_a + sight.v}; // which looks have found
}

template <class Part, class WatchOfPart> class Leaping {
public:
    Leaping(Course<Part>& course, WatchOfPart& watch, const Sight& seen, Leap& leap)
        : course_(course), watch_(watch), leap_(leap), sight_(leap.sight), start_(course.now())
    {
        sight_ = seen;
    }

    bool run()
    {
        if (sight_.axis.normal == V3{} || sight_.guessed) return false;
        return watch_.can_glance() ? by_glances() : by_features();
    }

private:
    /// Where a closed form tells the nearest points, by these: however their axis turns, the rate of their
    /// distance is the same.
    bool by_glances()
    {
        Glance glance;
        Guess last{course_.now(), nearing(sight_.normal, sight_.point_a, sight_.v)}, before = last;
        for (int i = 0; i < tolerance::most_guesses; ++i) {
            const double next = falls_to(aim(), before, last);
            if (!(last.gap.rate < 0) || !go(next) || !may_look()) return back();
            glance = watch_.glance(course_.facing());
            if (glance.normal == V3{}) return back();
            before = last;
            last = {next, nearing(glance.normal, glance.point_a, glance.v)};
            if (last.gap.now > 0 && last.gap.now <= course_.tolerance) break;
        }
        if (!(last.gap.now > 0 && last.gap.now <= course_.tolerance)) return back();
        sight_ = watch_.sight(course_.facing(), glance);
        return proven(way_back());
    }
    Trend nearing(V3 normal, V3 point_a, V3 v) const
    {
        return trend(course_.facing(), {normal, {}}, point_a, point_a + v);
    }

    /// Else by the features of the last look, until another one shows what has come nearer.
    bool by_features()
    {
        Ends ends = nearest();
        bool looked = true;
        for (int i = 0; i < tolerance::most_guesses; ++i) {
            const Pursuit way(course_.facing(), watch_.features(), ends.on_a, ends.on_b, sight_.axis.normal,
                              course_.radii, course_.now());
            const double next = way.falls_to(aim(), course_.tolerance, start_, course_.window.end);
            // Where these never meet, others among many do so first.
            const bool others = !looked && !(next < infinity) && !watch_.far_sighted();
            if (!others) {
                if (next == course_.now() || !go(next)) return back();
                sight_ = watch_.follow(course_.facing());
                if (sight_.axis.normal == V3{}) return back();
                watch_.land(course_.facing(), sight_);
                if (const Step step = way_back(); step.gap > 0) return proven(step);
                ends = extreme(course_.facing(), sight_);
                looked = false;
                if (!(dot(sight_.axis.normal, ends.on_b - ends.on_a) > course_.facing().margin)) continue;
            }
            if (!may_look()) return back();
            sight_ = watch_.look_ahead(course_.facing());
            if (sight_.axis.normal == V3{} || sight_.guessed) return back();
            if (const Step step = way_back(); step.gap > 0) return proven(step);
            ends = nearest();
            looked = true;
        }
        return back();
    }
    /// The nearest points where they are known, else those that are extreme along the axis.
    Ends nearest() const
    {
        const V3 a = sight_.point_a;
        return sight_.upper < infinity ? Ends{a, a + sight_.v} : extreme(course_.facing(), sight_);
    }

    double aim() const { return 0.125 * course_.slack; } // many roundings of a pose
    bool there() const { return sight_.upper - course_.radii <= course_.tolerance; }
    bool go(double time)
    {
        if (!(time > start_ && time < course_.window.end)) return false;
        course_.go(time);
        return true;
    }
    /// Whether the budget has an evaluation left, which is then taken.
    bool may_look()
    {
        if (course_.iterations >= course_.options.max_iterations) return false;
        ++course_.iterations;
        return true;
    }
    bool back()
    {
        if (course_.now() != start_) course_.go(start_);
        return false;
    }
    /// What the axis proves of the way from the start to here, within the tolerance of contact.
    Step way_back() const
    {
        if (!there()) return {};
        if constexpr (std::is_same_v<Part, Core>) expect_depth(course_.facing().b.part);
        const TurningAxis axis{sight_.axis.normal, -sight_.axis.spin};
        return safe_step(backwards(course_.facing()), axis, course_.now() - start_);
    }
    bool proven(const Step& step)
    {
        const double at = course_.now();
        sight_.axis_gap = step.gap + course_.facing().margin;
        const bool whole = step.length >= at - start_;
        if (!whole) course_.go(start_);
        if (!(step.length > 0)) return false;
        leap_.from = whole ? start_ : at - step.length;
        leap_.at = at;
        return true;
    }

    Course<Part>& course_;
    WatchOfPart& watch_;
    Leap& leap_;
    Sight& sight_;
    double start_;
};

} // namespace

template <class Part, class WatchOfPart>
bool leap(Course<Part>& course, WatchOfPart& watch, const Sight& seen, Leap& found)
{
    return Leaping<Part, WatchOfPart>(course, watch, seen, found).run();
}

template bool leap(Course<Core>&, Watch&, const Sight&, Leap&);
template bool leap(Course<Border>&, BorderWatch&, const Sight&, Leap&);

} // namespace brink
