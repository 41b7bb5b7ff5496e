// SPDX-License-Identifier: BSD-3-Clause
#include "pursuit.h"

#include "tolerance.h"
#include "trig.h"

namespace brink {

/// A vector and how fast it changes.
struct Pursuit::Moving {
    V3 now, rate;
};

Pursuit::Between Pursuit::between(const Features& features, double radii)
{
    using enum Feature::Kind;
    const Feature::Kind a = features.of_a.kind, b = features.of_b.kind;
    if (a == face) return Between::face_of_a;
    if (b == face) return Between::face_of_b;
    if (a == edge && b == edge) {
        const double cosine = dot(features.of_a.along, features.of_b.along);
        if (1 - cosine * cosine >= tolerance::nearly_parallel) return Between::edges;
    }
    if (!(radii > 0)) return Between::planes; // such features do not meet
    if (a == edge) return Between::edge_of_a;
    return b == edge ? Between::edge_of_b : Between::points;
}

void Pursuit::set_out(const Side& a, const Side& b, const Features& features, V3 normal)
{
    const bool of_a = between_ == Between::face_of_a, of_b = between_ == Between::face_of_b;
    const Side &first = of_a ? b : a, &second = of_a ? a : b;
    angles_ = Two{first.angle, second.angle};
    const XYZ<Two> axes =
        select(angles_ > both(0), both(1) / angles_, both(0)) * pair(first.rate, second.rate);
    if (of_a || of_b) { // the height of the face itself does not change
        side_ = of_a ? 1 : -1;
        margin_ += side_ * dot(normal, second.point);
        points_ = Path(pair(first.point, normal), axes);
        return;
    }
    points_ = Path(pair(a.point, b.point), axes);
    normal_ = normal;
    if (between_ == Between::points || between_ == Between::planes) return;
    const V3 e = features.of_a.along, g = features.of_b.along;
    along_ = Path(pair(e, g), axes);
    if (dot(cross(e, g), normal) < 0) side_ = -1;
}

Trend Pursuit::over_face(const Moving& point, const Moving& normal, V3 by) const
{
    const V3 way = pivots_ + by + side_ * point.now, growing = velocity_ + side_ * point.rate;
    return {dot(normal.now, way) - margin_, dot(normal.now, growing) + dot(normal.rate, way)};
}

Trend Pursuit::between_edges(const Moving& e, const Moving& g, const Moving& way) const
{
    const V3 m = cross(e.now, g.now), turning = cross(e.rate, g.now) + cross(e.now, g.rate);
    const double square = norm_squared(m), per_length = side_ / std::sqrt(square);
    const double gap = dot(m, way.now) * per_length;
    return {gap - margin_,
            (dot(turning, way.now) + dot(m, way.rate)) * per_length - gap * (dot(m, turning) / square)};
}

Guess Pursuit::at(double time) const
{
    const double h = time - now_;
    const V3 by = h * velocity_;
    const Two angles = both(h) * angles_;
    const auto [one, other] = h == 0 ? TwoSinCos{} : sin_cos(angles[0], angles[1]);
    const Two s{one.sin, other.sin}, c{one.cos, other.cos};
    const XYZ<Two> points = points_.at(s, c), growing = angles_ * points_.rate(s, c);
    const Moving on_a{first(points), first(growing)}, on_b{second(points), second(growing)};
    if (between_ == Between::face_of_a || between_ == Between::face_of_b)
        return {time, over_face(on_a, on_b, by)};
    const Moving way{pivots_ + by + (on_b.now - on_a.now), velocity_ + (on_b.rate - on_a.rate)};
    if (between_ == Between::planes) return {time, {dot(normal_, way.now) - margin_, dot(normal_, way.rate)}};
    Moving e, g;
    if (between_ != Between::points) {
        const XYZ<Two> along = along_.at(s, c), turning = angles_ * along_.rate(s, c);
        e = {first(along), first(turning)};
        g = {second(along), second(turning)};
        if (between_ == Between::edges) return {time, between_edges(e, g, way)};
        if (between_ == Between::edge_of_b) e = g;
    }
    const double on_edge = dot(e.now, way.now), gap = norm(way.now - on_edge * e.now);
    const double slip = dot(e.rate, way.now) + dot(e.now, way.rate);
    return {time, {gap - margin_, (dot(way.now, way.rate) - on_edge * slip) / gap}};
}

double Pursuit::falls_to(double aim, double near, double from, double until) const
{
    Guess last = at(now_), before = last;
    for (int i = 0; i < tolerance::most_guesses; ++i) {
        const double next = brink::falls_to(aim, before, last);
        if (!(last.gap.rate < 0 && next > from && next < until)) return infinity;
        const double rest = std::fabs(aim - last.gap.now), rest_before = std::fabs(aim - before.gap.now);
        // What is left falls at least with the square: the next guess is near enough unseen.
        if (rest <= near || rest * rest < near * rest_before) return next;
        before = last;
        last = at(next);
    }
    return infinity;
}

} // namespace brink
