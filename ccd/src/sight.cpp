// SPDX-License-Identifier: BSD-3-Clause
#include "sight.h"

#include "support.h"
#include "tolerance.h"

#include <algorithm>

namespace brink {

namespace {

using enum Core::Kind;

/// The corner of the difference that lies farthest against a normal: where GJK may begin.
Simplex towards(const Core& a, const Core& b, V3 normal)
{
    const SupportPoint on_a = farthest(a, normal), on_b = farthest(b, -normal);
    Simplex s;
    s.add({on_b.point - on_a.point, on_a.point, on_b.point, on_a.corner, on_b.corner, 1});
    return s;
}

/// Whether the axis between the nearest points turns smoothly as the bodies move: along an ellipsoid, against
/// anything without faces.
bool rolls(const Core& a, const Core& b)
{
    const auto faces = [](const Core& c) { return c.kind >= triangle && c.kind <= hull; };
    return (a.kind == ellipsoid && !faces(b)) || (b.kind == ellipsoid && !faces(a));
}

TurningAxis axis_of(const Facing<Core>& f, const Features& features, V3 v, V3 towards)
{
    return axis_between(features.of_a, f.a.rate, features.of_b, f.b.rate, v, towards);
}

} // namespace

Watch::Method Watch::method(const Core& a, const Core& b)
{
    const auto thin = [](const Core& c) { return c.kind == point || c.kind == segment; };
    if (thin(a) && thin(b)) return Method::segments;
    // Of a segment that comes as near as rounding the way to the box has no direction left.
    if (b.kind == box && (a.kind == point || (a.kind == segment && a.radius > 0))) return Method::thin_box;
    if (a.kind == point && (b.kind == cylinder || b.kind == cone)) return Method::point_round;
    if (a.kind == box && b.kind == box) return Method::boxes;
    return Method::any;
}

Watch::Watch(const Core& a, const Core& b, double nearby) : method_(method(a, b)), nearby_(nearby)
{
    // Separating axes see the distance of boxes only where they touch.
    if (method_ == Method::boxes && a.radius + b.radius > 0) method_ = Method::any;
}

Sight Watch::look(const Facing<Core>& f)
{
    const bool glances = can_glance();
    Sight s = glances ? sight(f, glance(f)) : look_ahead(f);
    if (!glances && s.normal == V3{}) s = look_hard(f);
    return s;
}

Sight Watch::look_ahead(const Facing<Core>& f)
{
    if (can_glance()) return sight(f, glance(f));
    if (method_ == Method::boxes) return look_at_boxes(f);
    if (!is_polytope(f.a.part) || !is_polytope(f.b.part)) return look_by_gjk(f, tolerance::near_enough);
    if (!(towards_ == V3{})) return look_by_gjk(f, 0);
    return look_by_gjk(f, tolerance::from_afar, std::max(nearby_, f.margin));
}

Sight Watch::sight(const Facing<Core>& f, const Glance& g) const
{
    const Core &a = f.a.part, &b = f.b.part;
    const V3 towards = method_ == Method::point_round ? g.normal : g.v; // the way out, where inside
    const auto [of_a, of_b] = method_ == Method::segments   ? AtSegments::features(a, b, g)
                              : method_ == Method::thin_box ? AtThinBox::features(a, b, g)
                                                            : AtPointRound::features(a, b, g);
    Sight s;
    s.axis = axis_between(of_a, f.a.rate, of_b, f.b.rate, towards, towards);
    s.normal = g.normal;
    s.upper = g.upper;
    s.point_a = g.point_a;
    s.v = g.v;
    return s;
}

Sight Watch::look_at_boxes(const Facing<Core>& f)
{
    const BoxAxis best = box_axis(f.a.part, f.b.part);
    box_index_ = best.index;
    towards_ = best.normal;
    Sight s = follow(f);
    s.normal = best.normal;
    s.apart = best.gap;
    if (best.gap > nearby_) return s;
    land(f, s);
    if (s.upper <= nearby_) return s;
    method_ = Method::any; // past the ends of both features: no separating axis shows that distance
    s = look_by_gjk(f, 0);
    return s;
}

Sight Watch::look_closely(const Facing<Core>& f)
{
    Sight s = look_by_gjk(f, 0);
    if (s.normal == V3{}) s = look_hard(f);
    return s;
}

Sight Watch::seen(const LocalTop& top)
{
    towards_ = top.axis.normal;
    corners_ = {};
    Sight s;
    s.normal = towards_;
    s.axis = {towards_, {}};
    s.apart = top.axis.gap;
    s.guessed = true;
    s.upper = norm(top.v);
    s.point_a = top.point_a;
    s.v = top.v;
    return s;
}

/// Nothing where the cores overlap; no points and no features where they are proven to be more than `apart`.
Sight Watch::look_by_gjk(const Facing<Core>& f, double relative, double apart)
{
    const Core &a = f.a.part, &b = f.b.part;
    const double scale = f.a.reach + f.b.reach + norm(f.b.pivot);
    const Simplex start = corners_.known()   ? corners_.simplex(a, b)
                          : towards_ == V3{} ? Simplex{}
                                             : towards(a, b, towards_);
    const Nearness near{tolerance::tight * scale, relative, f.margin, apart};
    if (relative > 0 && !(towards_ == V3{}) && rolls(a, b))
        if (const LocalTop top = nearly_best(a, b, towards_, near); top.top) return seen(top);
    Closest c = gjk(a, b, near, start);
    // Rounding may close a flat simplex over the origin: the last axis knows whether they are apart.
    if (c.inside && gap_along(a, b, towards_) > 0) c = gjk(a, b, near, towards(a, b, towards_));
    Sight s;
    if (c.inside || c.normal == V3{}) return s;
    s.normal = towards_ = c.normal;
    s.apart = c.lower;
    s.axis = {c.normal, {}};
    corners_ = Corners(c.simplex);
    s.guessed = !corners_.known() || c.lower > apart;
    if (c.lower > apart) return s;
    s.upper = norm(c.v);
    s.point_a = c.point_a;
    s.v = c.v;
    // The weights of a sliver put its point beside where its plane is nearest.
    s.astray = norm(c.simplex.point() - c.v);
    if (!s.guessed) {
        features_ = corners_.features(c.simplex);
        s.axis = axis_of(f, features_, c.v, towards_);
    }
    return s;
}

Sight Watch::look_hard(const Facing<Core>& f)
{
    const Separation n = separation(f.a.part, f.b.part);
    const double radius_a = f.a.part.radius, radii = radius_a + f.b.part.radius;
    Sight s;
    s.normal = n.normal;
    s.axis = {n.normal, {}};
    s.guessed = true;
    s.upper = n.gap + radii;
    s.point_a = n.point_a - radius_a * n.normal;
    s.v = s.upper * n.normal;
    return s;
}

Sight Watch::follow(const Facing<Core>& f)
{
    const Core &a = f.a.part, &b = f.b.part;
    Sight s;
    if (method_ == Method::boxes) {
        features_ = box_features(a, b, box_index_);
        s.axis = axis_of(f, features_, towards_, towards_);
    } else {
        corners_.place(followed_, a, b);
        features_ = corners_.features(followed_);
        s.axis = axis_of(f, features_, followed_.corners[0].w, towards_);
    }
    return s;
}

void Watch::land(const Facing<Core>& f, Sight& s)
{
    if (method_ == Method::boxes) {
        const BoxWitness w = box_witness(f.a.part, f.b.part, box_index_, s.axis.normal);
        s.point_a = w.point_a;
        s.v = w.v;
    } else {
        followed_.reduce();
        if (followed_.size == 4) return;
        s.point_a = followed_.on_a();
        s.v = followed_.point();
    }
    s.upper = norm(s.v);
}

bool Watch::overlap(const Facing<Core>& f, double depth) const
{
    const Core &a = f.a.part, &b = f.b.part;
    const Closest c = gjk(a, b, {}, corners_.known() ? corners_.simplex(a, b) : Simplex{});
    return c.inside && c.simplex.depth() > depth;
}

Sight BorderWatch::look(const Facing<Border>& f)
{
    const Separation n = separation(f.a.part, f.b.part);
    const double radius = f.a.part.radius;
    Sight s;
    s.normal = n.normal;
    s.axis = {n.normal, f.b.rate};
    s.upper = n.gap + radius;
    s.point_a = n.point_a - radius * n.normal;
    s.v = s.upper * n.normal;
    return s;
}

void Rolling::see(V3 normal, double time)
{
    const V3 turned = cross(normal_, normal);
    const bool known = !(normal_ == V3{});
    if (known && !(time > time_ && norm(turned) > tolerance::least_turn)) return;
    if (known) spin = (1 / (time - time_)) * turned;
    normal_ = normal;
    time_ = time;
}

TurningAxis Rolling::at(double time) const
{
    const double rate = norm(spin);
    if (!(rate > 0)) return {normal_, spin};
    return {turned(Turn{spin, (1 / rate) * spin, rate}, time - time_) * normal_, spin};
}

std::optional<Separation> shown(const Sight& sight, const Facing<Core>& f, double doubt)
{
    const Core &a = f.a.part, &b = f.b.part;
    const V3 n = sight.best_normal();
    const double apart = dot(sight.v, n);
    // An axis that was followed past the other body leads back: by that they would overlap.
    if (!(sight.upper < infinity && apart >= -doubt) || !(sight.astray <= doubt) ||
        !(norm(sight.v - apart * n) <= doubt) ||
        !(apart - (sight.axis_gap > -infinity ? sight.axis_gap : gap_along(a, b, n)) <= doubt))
        return {};
    const double gap = apart - (a.radius + b.radius);
    const V3 point_a = sight.point_a + a.radius * n;
    return Separation{gap, gap, n, point_a, point_a + gap * n};
}

} // namespace brink
