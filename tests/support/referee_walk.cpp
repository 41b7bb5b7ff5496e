// SPDX-License-Identifier: BSD-3-Clause
#include "referee_walk.h"

#include <algorithm>

namespace brink::support {
namespace {

/// Whether (1 - x) g0 + x g1 - bulge x (1 - x) / 2 > 0 for all x in [0, 1].
template <class T> bool chord_clears(const T& g0, const T& g1, const T& bulge)
{
    if (g0 <= 0 || g1 <= 0) return false;
    const T half = bulge / 2;
    const T lean = g0 - g1 + half;
    if (lean <= 0 || lean >= 2 * half) return true; // least at an end
    return 4 * half * g0 > lean * lean;
}

/// The walk's guesses, which no proof rests on: how far to try next.
template <class T> class Pace {
public:
    explicit Pace(const MovingPair<T>& pair)
        : pair_(pair), curvature_(bent(std::max(pair.a().rate, pair.b().rate)))
    {
    }

    /// The root of g - c h - curvature h^2 / 2, so that a step stays short of contact.
    T step(const T& g, const T& closing, const T& most) const
    {
        using std::sqrt;
        const T under = closing * closing + 2 * curvature_ / (boost_ * boost_) * g;
        const T below = closing + T(sqrt(under));
        return below * most <= 2 * g ? most : T(2 * g / below);
    }

    void accepted(const T& turned, const T& h)
    {
        boost_ = std::min(T(4), T(boost_ * T(1.5)));
        curvature_ = bent(turned / h);
    }

    void refused(const T& turned, const T& h)
    {
        boost_ = std::max(T(1), T(boost_ / 2));
        curvature_ = std::max(curvature_, bent(turned / h));
    }

private:
    T bent(const T& turning) const { return pair_.bulge({0, 0, 0}, {turning, 0, 0}, T(1)); }

    const MovingPair<T>& pair_;
    T curvature_;
    T boost_ = 2;
};

/// A time rounded to what long double can say, where that moves it by little.
template <class T> T plain(const T& t, const T& step)
{
    const auto rounded = T(static_cast<long double>(t));
    using std::abs;
    return abs(rounded - t) <= step / 1024 ? rounded : t;
}

template <class T> class Walker {
public:
    Walker(const MovingPair<T>& pair, const T& from, const T& to, const Limits<T>& limits)
        : pair_(pair), to_(to), level_(pair.target()), limits_(limits), pace_(pair)
    {
        stand(from, look(from));
        out_.least = out_.gap.upper;
        out_.least_at = from;
    }

    Walk<T> go()
    {
        const auto window = pair_.window();
        while (out_.clear < to_) {
            if (over(out_.gap) <= limits_.near) return end(Halt::near);
            if (!window || out_.clear >= window->to) return jump(to_), end(Halt::done);
            if (out_.clear < window->from) {
                jump(std::min(to_, window->from));
                continue;
            }
            if (limits_.far >= 0 && over(out_.gap) >= limits_.far) return end(Halt::far);
            if (out_.evaluations >= limits_.budget) return end(Halt::spent);
            if (!advance()) return end(Halt::near);
        }
        return end(over(out_.gap) <= 0 ? Halt::near : Halt::done);
    }

private:
    /// As near as a step takes.
    Bracket<T> look(const T& t) const { return pair_.roughly(t, out_.gap.normal, level_, T(1e-8)); }

    T over(const Bracket<T>& gap) const { return gap.lower - pair_.blur() - level_; }

    void stand(const T& t, const Bracket<T>& gap)
    {
        out_.clear = t;
        out_.gap = gap;
        out_.closing_speed = closing_speed(pair_, t, gap);
        ++out_.evaluations;
    }

    void jump(const T& t) { stand(t, look(t)); }

    Walk<T> end(Halt halt)
    {
        out_.halt = halt;
        return out_;
    }

    bool proven(const Bracket<T>& next, const T& h) const
    {
        const T g0 = over(out_.gap);
        const T g1 = over(next);
        if (g1 <= 0) return false;
        if (g0 + g1 > pair_.fastest() * h) return true;
        if (pair_.over_ground() && dot(out_.gap.normal, next.normal) <= 0) return false; // of another side
        return chord_clears(g0, g1, pair_.bulge(out_.gap.normal, next.normal, h));
    }

    void see(const T& t, const Bracket<T>& gap)
    {
        ++out_.evaluations;
        if (gap.upper < out_.least) {
            out_.least = gap.upper;
            out_.least_at = t;
        }
        const bool first = !out_.touched || t < *out_.touched;
        if (gap.upper + pair_.blur() <= level_ && first) out_.touched = t;
    }

    /// Whether a bracket is too wide to step by.
    bool loose(const Bracket<T>& gap) const
    {
        return gap.upper - gap.lower > std::max(over(out_.gap), over(gap)) / 4;
    }

    /// How far along a step that ended in contact the line between the two gaps meets the level, and less.
    T share_of(const Bracket<T>& gap) const
    {
        const T g0 = over(out_.gap);
        return T(0.9) * g0 / (g0 + level_ - gap.upper);
    }

    /// One step, however short. False where time or the gap itself is too coarse.
    bool advance()
    {
        T most = to_ - out_.clear;
        for (const MovingBody<T>* body : {&pair_.a(), &pair_.b()})
            if (body->solid.unbounded() && body->rate * most > 1) most = 1 / body->rate; // keeps to one side
        T h = pace_.step(over(out_.gap), out_.closing_speed, most);
        for (;;) {
            const T aim = out_.clear + h;
            const T next = aim >= to_ ? to_ : plain(aim, h);
            if (!(next > out_.clear)) return false;
            h = next - out_.clear;
            const Bracket<T> gap = look(next);
            see(next, gap);
            const T turned = norm(gap.normal - out_.gap.normal);
            if (proven(gap, h)) {
                pace_.accepted(turned, h);
                stand(next, gap);
                --out_.evaluations; // seen already
                return true;
            }
            pace_.refused(turned, h);
            if (out_.evaluations >= limits_.budget) return true;
            if (gap.upper > level_ && loose(gap)) return false;
            h = gap.upper < level_ && gap.depth_known ? std::min(T(h / 2), T(h * share_of(gap))) : T(h / 2);
        }
    }

    const MovingPair<T>& pair_;
    T to_, level_;
    Limits<T> limits_;
    Pace<T> pace_;
    Walk<T> out_;
};

template <class T> Vector<T> velocity(const MovingBody<T>& body, const T& t, const Vector<T>& point)
{
    return body.velocity + cross(body.rotation, point - body.pivot - t * body.velocity);
}

} // namespace

template <class T>
Walk<T> walk(const MovingPair<T>& pair, const T& from, const T& to, const Limits<T>& limits)
{
    return Walker<T>(pair, from, to, limits).go();
}

template <class T> T closing_speed(const MovingPair<T>& pair, const T& t, const Bracket<T>& gap)
{
    const Vector<T> relative = velocity(pair.b(), t, gap.point_b) - velocity(pair.a(), t, gap.point_a);
    return gap.points_known ? T(-dot(gap.normal, relative)) : T(0);
}

template Walk<long double> walk(const MovingPair<long double>&, const long double&, const long double&,
                                const Limits<long double>&);
template Walk<Hundred> walk(const MovingPair<Hundred>&, const Hundred&, const Hundred&,
                            const Limits<Hundred>&);
template long double closing_speed(const MovingPair<long double>&, const long double&,
                                   const Bracket<long double>&);
template Hundred closing_speed(const MovingPair<Hundred>&, const Hundred&, const Bracket<Hundred>&);

} // namespace brink::support
