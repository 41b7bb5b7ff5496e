// SPDX-License-Identifier: BSD-3-Clause
#include "leap.h"

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

template <class Part, class WatchOfPart> class Leaping {
public:
    Leaping(Course<Part>& course, WatchOfPart& watch, const Sight& seen)
        : course_(course), watch_(watch), sight_(seen), start_(course.now())
    {
    }

    std::optional<Leap> run()
    {
        if (sight_.axis.normal == V3{} || sight_.guessed) return {};
        const double aim = 0.125 * course_.slack; // many roundings of a pose
        Guess last = guess(), before = last;
        for (int i = 0; i < tolerance::most_guesses; ++i) {
            const double next = falls_to(aim, before, last);
            if (!(last.gap.rate < 0 && next > start_ && next < course_.window.end)) return back();
            course_.go(next);
            const std::optional<Guess> seen = watch_.can_glance() ? glance() : see();
            if (!seen) return back();
            before = last;
            last = *seen;
            if (!(last.gap.now > 0 && last.gap.now <= course_.tolerance)) continue;
            if (glanced_) sight_ = watch_.sight(course_.facing(), glance_);
            if (!fresh_) watch_.land(course_.facing(), sight_);
            if (there()) return proven();
            if (fresh_ || !look()) return back();
            if (there()) return proven();
            before = last = guess();
        }
        return back();
    }

private:
    /// By the points seen, where they are the last look's; else by those that are extreme along the axis.
    Guess guess() const
    {
        const Facing<Part>& f = course_.facing();
        if (!fresh_ || !(sight_.upper < infinity)) return {course_.now(), trend(f, sight_.axis)};
        const V3 a = sight_.point_a;
        return {course_.now(), trend(f, sight_.axis, a, a + sight_.v)};
    }
    bool there() const { return sight_.upper - course_.radii <= course_.tolerance; }
    bool look()
    {
        if (course_.iterations >= course_.options.max_iterations) return false;
        ++course_.iterations;
        sight_ = watch_.look(course_.facing());
        fresh_ = true;
        return !(sight_.axis.normal == V3{});
    }
    /// A guess by the nearest points: however their axis turns, the rate of their distance is the same.
    std::optional<Guess> glance()
    {
        if (course_.iterations >= course_.options.max_iterations) return {};
        ++course_.iterations;
        glance_ = watch_.glance(course_.facing());
        glanced_ = true;
        if (glance_.normal == V3{}) return {};
        const V3 a = glance_.point_a;
        return Guess{course_.now(), trend(course_.facing(), {glance_.normal, {}}, a, a + glance_.v)};
    }
    /// One by the features followed, or else by another look.
    std::optional<Guess> see()
    {
        if (watch_.can_follow()) {
            sight_ = watch_.follow(course_.facing());
            fresh_ = false;
        } else if (!look()) {
            return {};
        }
        if (sight_.axis.normal == V3{}) return {};
        return guess();
    }
    std::optional<Leap> back()
    {
        if (course_.now() != start_) course_.go(start_);
        return {};
    }
    std::optional<Leap> proven()
    {
        const TurningAxis axis{sight_.axis.normal, -sight_.axis.spin};
        const double at = course_.now(), way = at - start_;
        const Step step = safe_step(backwards(course_.facing()), axis, way);
        if (step.length >= way) return Leap{start_, at, sight_};
        course_.go(start_);
        if (!(step.length > 0)) return {};
        return Leap{at - step.length, at, sight_};
    }

    Course<Part>& course_;
    WatchOfPart& watch_;
    Sight sight_;
    double start_;
    bool fresh_ = true;    // whether the sight is that of a look
    bool glanced_ = false; // whether it is still to be made of
    Glance glance_;
};

} // namespace

template <class Part, class WatchOfPart>
std::optional<Leap> leap(Course<Part>& course, WatchOfPart& watch, const Sight& seen)
{
    return Leaping<Part, WatchOfPart>(course, watch, seen).run();
}

template std::optional<Leap> leap(Course<Core>&, Watch&, const Sight&);
template std::optional<Leap> leap(Course<Border>&, BorderWatch&, const Sight&);

} // namespace brink
