// SPDX-License-Identifier: BSD-3-Clause
#include "referee.h"

#include "referee_encounter.h"

#include <algorithm>
#include <cmath>

namespace brink::support {
namespace {

/// Rounding of what was computed, times the scale; and the part of the step (at the scale's speed) by which
/// an exact tangency must lie before t_max.
const Digits rounding{"1e-105"};
const Digits moment{"1e-40"};

/// The touch that comes first, if the pair is apart at t = 0, and whether any one is certain to be in
/// [0, t_max].
struct Touches {
    std::optional<FirstTouch> first;
    bool certain = false;
};

void keep(Touches& touches, const std::optional<FirstTouch>& touch, const Encounter& e, const Digits& t_max)
{
    if (!touch) return;
    const Digits margin = moment * e.scale / norm(e.ray.by);
    if (touch->certain && touch->t + margin <= t_max) touches.certain = true;
    if (!touches.first || touch->t < touches.first->t) touches.first = touch;
}

Touches touches(const Encounter& e, const Digits& t_max)
{
    Touches out;
    for (const Feature& f : e.features)
        keep(out, first_touch(f, e.ray, e.radius, e.scale), e, t_max);
    return out;
}

/// Over ground, from whichever side the core starts on.
Touches touches_ground(const Encounter& e, const Ground& ground, const Digits& t_max)
{
    const Watch watch;
    const auto [low, high] = heights(ground, e.ray.from);
    const Digits climb = dot(ground.normal, e.ray.by);
    const Digits weight = dot(ground.normal, ground.normal);
    const bool above = low > 0;
    const Digits reach = e.radius == 0 ? e.radius : Digits(e.radius * sqrt(weight));
    const Digits apart = (above ? low : Digits(-high)) - reach;
    const Digits closing = above ? Digits(-climb) : climb;
    Touches out;
    if (closing <= 0 || apart <= 0) return out;
    const Digits t = apart / closing;
    const bool exact = watch.exact() && e.ray.exact;
    const Digits speed = closing / sqrt(weight);
    const bool certain = exact || speed >= doubt * norm(e.ray.by);
    keep(out, FirstTouch{.t = t, .closing_speed = speed, .exact = exact, .certain = certain}, e, t_max);
    return out;
}

/// When the gap may be least besides the ends: a convex function of time that is piecewise one feature's.
Digits least_gap(const Encounter& e, const Digits& t_max)
{
    Digits least = std::min(standing(e, 0).gap, standing(e, t_max).gap);
    for (const Feature& f : e.features) {
        const std::optional<Digits> t = nearest_time(f, e.ray);
        if (!t || *t <= 0 || *t >= t_max) continue;
        const Digits3 p = e.ray.at(*t);
        if (!f.foot_inside(p, border * e.scale)) continue;
        least = std::min(least, Digits(sqrt(f.squared_distance(p)) - e.radius));
    }
    if (!e.ground || !e.ground->two_sided) return least;
    const auto [low, high] = heights(*e.ground, e.ray.from);
    const Digits climb = dot(e.ground->normal, e.ray.by);
    const Digits middle = climb == 0 ? Digits(0) : Digits(-(low + high) / (2 * climb));
    return middle > 0 && middle < t_max ? std::min(least, standing(e, middle).gap) : least;
}

bool finite(const Vec3& v) { return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z()); }
bool size(double s) { return s >= 0 && std::isfinite(s); }
bool unit(const Digits& square) { return abs(square - 1) <= Digits("1e-6"); }

bool valid(const Sphere& s) { return size(s.radius); }
bool valid(const Capsule& s) { return finite(s.a) && finite(s.b) && size(s.radius); }
bool valid(const Box& s) { return finite(s.half_extents) && s.half_extents.minCoeff() >= 0; }
bool valid(const Triangle& s) { return finite(s.a) && finite(s.b) && finite(s.c); }
bool valid_border(const Vec3& normal, double offset)
{
    return finite(normal) && std::isfinite(offset) && unit(dot(digits3(normal), digits3(normal)));
}
bool valid(const Plane& s) { return valid_border(s.normal, s.offset); }
bool valid(const HalfSpace& s) { return valid_border(s.normal, s.offset); }
/// Not among the judged shapes.
template <class Unjudged> bool valid(const Unjudged&) { return false; }

bool valid(const Quat& q)
{
    return q.coeffs().allFinite() && unit(Digits(q.w()) * q.w() + Digits(q.x()) * q.x() +
                                          Digits(q.y()) * q.y() + Digits(q.z()) * q.z());
}

bool valid(const Options& o)
{
    return o.t_max >= 0 && o.t_max <= 1 && size(o.target_gap) && size(o.tolerance) && o.max_iterations >= 1 &&
           o.start_contact <= StartContact::ignore && o.detail <= Detail::time_only;
}

/// Valid, and not turning in a way that shows.
bool translates(const Shape& shape, const Motion& m)
{
    if (shape.valueless_by_exception() || !std::visit([](const auto& s) { return valid(s); }, shape))
        return false;
    if (!finite(m.start.position) || !finite(m.translation) || !finite(m.pivot) || !finite(m.rotation))
        return false;
    const bool on_centre = std::holds_alternative<Sphere>(shape) && m.pivot == Vec3(0, 0, 0);
    if (on_centre) return dot(digits3(m.rotation), digits3(m.rotation)) <= Digits(0x1p40);
    return m.rotation == Vec3(0, 0, 0) && valid(m.start.orientation);
}

} // namespace

bool refereed(const Query& q)
{
    const Pair pair{std::min(q.a.index(), q.b.index()), std::max(q.a.index(), q.b.index())};
    return pair.closed_form() && valid(q.options) && translates(q.a, q.motion_a) &&
           translates(q.b, q.motion_b);
}

Truth truth(const Query& q)
{
    const Encounter e = encounter(q);
    const Digits t_max = q.options.t_max;
    const Digits slack = doubt * e.scale;
    const Standing start = standing(e, 0);
    const Standing end = standing(e, t_max);
    Truth out;
    out.scale = e.scale;
    out.started = start.contact;
    out.in_doubt = !start.exact && abs(start.gap) <= slack;
    out.least_gap = least_gap(e, t_max);
    if (out.started) {
        out.meets = true;
        out.t = 0;
        return out;
    }
    const Touches found = e.ground ? touches_ground(e, *e.ground, t_max) : touches(e, t_max);
    out.meets = end.contact || (found.first && found.first->t <= t_max);
    const bool meets_for_sure = found.certain || (end.contact && end.exact) || out.least_gap < -slack;
    out.in_doubt = out.in_doubt || (!meets_for_sure && out.least_gap <= slack);
    if (found.first) {
        out.t = found.first->t;
        out.closing_speed = found.first->closing_speed;
        const Digits speed = std::max(out.closing_speed, Digits(doubt * norm(e.ray.by)));
        if (!found.first->exact) out.blur = rounding * e.scale / speed;
    } else if (out.meets) {
        out.t = t_max; // rounding alone let it slip
        out.in_doubt = true;
    }
    return out;
}

Digits gap_minus_target(const Query& q, const Digits& t) { return standing(encounter(q), t).gap; }

} // namespace brink::support
