// SPDX-License-Identifier: BSD-3-Clause
#include "point_path.h"

#include "allowance.h"
#include "falling.h"
#include "glance.h"
#include "mover.h"
#include "nearest.h"
#include "point_round.h"
#include "support.h"
#include "tolerance.h"
#include "window.h"

#include <algorithm>
#include <type_traits>

namespace brink {

namespace {

/// The nearest point of a core, from a place in its own frame.
struct Nearest {
    double distance; // negative inside of a solid
    V3 outward;      // unit, from there to the place; zero on a core without inside
};

Nearest along(V3 v)
{
    const double distance = norm(v);
    return {distance, distance > 0 ? (-1 / distance) * v : V3{}};
}

/// Cores in their own axes about their pivots. `height` is that of a supporting plane, `reach` the radius of
/// a ball about the pivot that holds the core.
class FromSegment {
public:
    FromSegment(const Capsule& c, V3 pivot) : a_(load(c.a) - pivot), b_(load(c.b) - pivot) {}
    Nearest nearest(V3 p) const { return along(to_segment(a_ - p, b_ - p)); }
    double height(V3 n) const { return std::max(dot(a_, n), dot(b_, n)); }
    double reach() const { return std::sqrt(std::max(norm_squared(a_), norm_squared(b_))); }

private:
    V3 a_, b_;
};

class FromTriangle {
public:
    FromTriangle(const Triangle& t, V3 pivot)
        : a_(load(t.a) - pivot), b_(load(t.b) - pivot), c_(load(t.c) - pivot)
    {
    }
    Nearest nearest(V3 p) const { return along(to_triangle(a_ - p, b_ - p, c_ - p)); }
    double height(V3 n) const { return std::max({dot(a_, n), dot(b_, n), dot(c_, n)}); }
    double reach() const
    {
        return std::sqrt(std::max({norm_squared(a_), norm_squared(b_), norm_squared(c_)}));
    }

private:
    V3 a_, b_, c_;
};

class FromBox {
public:
    FromBox(const Box& box, V3 pivot) : centre_(-pivot), h_(load(box.half_extents)) {}
    Nearest nearest(V3 p) const
    {
        const V3 local = p - centre_, v = to_box(local, h_);
        if (!(v == V3{})) return along(v);
        const V3 out = magnitudes(local) - h_;
        if (out.x >= out.y && out.x >= out.z) return {out.x, {local.x < 0 ? -1.0 : 1.0, 0, 0}};
        if (out.y >= out.z) return {out.y, {0, local.y < 0 ? -1.0 : 1.0, 0}};
        return {out.z, {0, 0, local.z < 0 ? -1.0 : 1.0}};
    }
    double height(V3 n) const { return dot(centre_, n) + dot(h_, magnitudes(n)); }
    double reach() const { return norm(magnitudes(centre_) + h_); }

private:
    V3 centre_, h_;
};

class FromRound {
public:
    FromRound(const auto& cylinder_or_cone, V3 pivot) : core_(core(cylinder_or_cone)), centre_(-pivot) {}
    Nearest nearest(V3 p) const
    {
        const FromPoint found = from_point(p - centre_, core_);
        return {found.gap, -found.normal};
    }
    double height(V3 n) const { return dot(centre_, n) + round_interval(core_, n).high; }
    double reach() const { return norm(centre_) + brink::reach(core_); }

private:
    Core core_;
    V3 centre_;
};

/// What is seen from the core at some time.
struct Glimpse {
    Guess at;          // the gap between the plane that supports the core and the point; margins taken off
    double bend = 0;   // the second derivative of that
    double upper = 0;  // the distance of the core itself, with its nearest point
    V3 place, outward; // of the point, about the pivot; and the unit vector there from the nearest point
    SinCos turned;     // of the angle that the core has turned by
};

template <class From> class PointPath {
public:
    PointPath(const Sphere& point, const Motion& a, const auto& shape, const Motion& b, const Options& o)
        : options_(o),
          motion_a_(a),
          start_(rotation(b.start.orientation)),
          turn_(turn(b.rotation)),
          core_(shape, load(b.pivot)),
          radius_a_(point.radius),
          radii_(point.radius + radius(shape) + o.target_gap)
    {
        const V3 way = load(a.start.position) - load(b.start.position);
        from_ = into(start_, way) - load(b.pivot);
        by_ = into(start_, load(a.translation) - load(b.translation));
        const double reach = core_.reach() * (1 + tolerance::holding_slack);
        // An angle that is off turns the point about the pivot: along the normal, as if it lay on the core.
        lengths_ = norm(way) + 2 * norm(by_) + norm(load(b.pivot)) + (1 + 2 * turn_.angle) * reach + radii_;
        allowed_ = Allowance(lengths_, o);
        window_ = meeting(from_, by_, reach + radii_ + allowed_.slack);
    }

    Toi run()
    {
        if (!(radii_ > tolerance::thin * lengths_)) return untold();
        if (window_.empty || window_.begin > options_.t_max) return apart();
        prepare();
        Glimpse here = look(window_.begin);
        if (near(here)) return here.at.time > 0 ? hit(here) : untold();
        while (looks_ < tolerance::most_passing) {
            proven_ = here.at.time + step(here, 1, window_.end - here.at.time);
            if (proven_ >= window_.end) return apart();
            if (landing_from_ == infinity && here.at.gap.rate < 0 && ++landings_ <= tolerance::most_leaps)
                land(here.at);
            if (landing_from_ <= proven_) return landing_.at.time > options_.t_max ? apart() : hit(landing_);
            if (proven_ > options_.t_max) return apart(); // and no guess would have been in time
            here = look(proven_);
            if (near(here)) return hit(here);
        }
        return untold();
    }

private:
    void prepare()
    {
        const V3 axis = into(start_, turn_.axis);
        rate_ = turn_.angle * axis;
        path_ = Turning(pair(from_, by_), {-rate_, -axis, turn_.angle});
        const V3 from = first(path_.sine), by = second(path_.sine); // as far across the axis
        const double far = std::max(norm(from + window_.begin * by), norm(from + window_.end * by));
        const double speed = norm(by), w = turn_.angle;
        curvature_ = w * (w * far + 2 * speed);
        third_ = w * w * (w * far + 3 * speed);
    }
    /// The point and how it would go on if the core stopped turning.
    struct Place {
        V3 at, by;
    };
    Place place(double time, SinCos angle) const
    {
        const XYZ<Two> turned = path_.at(angle);
        return {first(turned) + time * second(turned), second(turned)};
    }
    Glimpse look(double time)
    {
        ++looks_;
        const SinCos angle = sin_cos(time * turn_.angle);
        const auto [p, by] = place(time, angle);
        const auto [distance, n] = core_.nearest(p);
        const V3 velocity = by - cross(rate_, p);
        const double gap = (dot(n, p) - core_.height(n)) - (radii_ + allowed_.slack);
        return {{time, {gap, dot(n, velocity)}}, -dot(n, cross(rate_, by + velocity)), distance, p, n, angle};
    }
    bool near(const Glimpse& g) const { return g.upper - radii_ <= allowed_.tolerance; }

    /// The time over which the gap is proven to stay at or above zero: onwards (1) or back (-1).
    double step(const Glimpse& g, double onwards, double horizon) const
    {
        const double rate = onwards * g.at.gap.rate, gap = g.at.gap.now;
        if (!(gap > 0)) return 0;
        if (rate < 0) horizon = std::min(horizon, gap / -rate);
        const double bend = std::min(curvature_, std::max(0.0, -g.bend) + third_ * horizon);
        return std::min(horizon, falls(gap, rate, bend) * tolerance::step_shrink);
    }

    /// Guesses when the gap closes. Where it does, the way there is proven backwards.
    void land(const Guess& here)
    {
        Guess last = here, before = here;
        const double aim = 0.125 * allowed_.slack;
        while (looks_ < tolerance::most_passing) {
            const double next = falls_to(aim, before, last);
            if (!(last.gap.rate < 0 && next > here.time && next < window_.end)) return;
            landing_ = look(next);
            before = last;
            last = landing_.at;
            if (!(last.gap.now > 0 && near(landing_))) continue;
            landing_from_ = next - step(landing_, -1, next - here.time);
            return;
        }
    }

    Toi untold() const { return {.iterations = looks_}; }
    Toi apart() const { return {.status = Status::separated, .t = options_.t_max, .iterations = looks_}; }
    Toi hit(const Glimpse& g) const
    {
        Toi toi{.status = Status::hit, .t = g.at.time, .t_upper = contact_by(g), .iterations = looks_};
        if (options_.detail == Detail::time_only) return toi;
        const V3 n = turned(turn_, g.turned) * (start_ * -g.outward);
        const V3 centre = load(motion_a_.start.position) + g.at.time * load(motion_a_.translation);
        toi.normal = store(n);
        toi.point_a = store(centre + radius_a_ * n);
        toi.gap = g.upper - (radii_ - options_.target_gap);
        toi.point_b = store(centre + (radius_a_ + toi.gap) * n);
        return toi;
    }
    /// When the point has come within the radii of what was nearest, which goes with the core.
    double contact_by(const Glimpse& g) const
    {
        if (!(g.at.gap.rate < 0)) return infinity;
        const V3 nearest = g.place - g.upper * g.outward;
        const double left = std::max(0.0, g.upper - radii_), rounding = allowed_.rounding;
        for (const double deep :
             {tolerance::shallow * rounding, 2 * allowed_.tolerance + tolerance::deeper * rounding}) {
            const double later = std::min(g.at.time + 2 * (left + deep) / -g.at.gap.rate, options_.t_max);
            if (norm(place(later, sin_cos(later * turn_.angle)).at - nearest) + rounding <= radii_)
                return later;
        }
        return infinity;
    }

    const Options& options_;
    const Motion& motion_a_;
    Rotation start_;
    Turn turn_;
    From core_;
    double radius_a_, radii_, lengths_ = 0;
    Allowance allowed_;
    Window window_;
    V3 from_, by_, rate_; // in the core's axes at the start, like all that follows
    Turning path_;
    double curvature_ = 0, third_ = 0; // bounds of the point's second and third derivative
    int looks_ = 0, landings_ = 0;
    double proven_ = 0;              // apart before
    Glimpse landing_;                // within the tolerance of contact
    double landing_from_ = infinity; // and apart from here to there
};

template <class S> struct FromShape;
template <> struct FromShape<Capsule> : std::type_identity<FromSegment> {
};
template <> struct FromShape<Triangle> : std::type_identity<FromTriangle> {
};
template <> struct FromShape<Box> : std::type_identity<FromBox> {
};
template <> struct FromShape<Cylinder> : std::type_identity<FromRound> {
};
template <> struct FromShape<Cone> : std::type_identity<FromRound> {
};

} // namespace

template <class S>
Toi pass(const Sphere& sphere, const Motion& a, const S& shape, const Motion& b, const Options& o)
{
    return PointPath<typename FromShape<S>::type>(sphere, a, shape, b, o).run();
}

template Toi pass(const Sphere&, const Motion&, const Capsule&, const Motion&, const Options&);
template Toi pass(const Sphere&, const Motion&, const Triangle&, const Motion&, const Options&);
template Toi pass(const Sphere&, const Motion&, const Box&, const Motion&, const Options&);
template Toi pass(const Sphere&, const Motion&, const Cylinder&, const Motion&, const Options&);
template Toi pass(const Sphere&, const Motion&, const Cone&, const Motion&, const Options&);

} // namespace brink
