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

/// From the point on A to the point on B.
[[gnu::always_inline]] inline Pursuit::Moving Pursuit::way(double h, const NearSinCos& by) const
{
    const XYZ<Two> points = points_.at(by), growing = angles_ * points_.rate(by);
    return {pivots_ + h * velocity_ + (second(points) - first(points)),
            velocity_ + (second(growing) - first(growing))};
}

Pursuit::Height Pursuit::over_face(double time) const
{
    const double h = time - now_;
    const NearSinCos by = turned(h);
    const XYZ<Two> both_now = points_.at(by), both_rate = angles_ * points_.rate(by);
    const V3 n = second(both_now), way = pivots_ + h * velocity_ + side_ * first(both_now);
    const V3 growing = velocity_ + side_ * first(both_rate);
    return {{time, {dot(n, way), dot(n, growing) + dot(second(both_rate), way)}}};
}

Pursuit::Height Pursuit::between_edges(double time) const
{
    const double h = time - now_;
    const NearSinCos by = turned(h);
    const Moving r = way(h, by);
    const XYZ<Two> along = along_.at(by), turning = angles_ * along_.rate(by);
    const V3 e = first(along), g = second(along), m = cross(e, g);
    const V3 m_rate = cross(first(turning), g) + cross(e, second(turning));
    return {{time, {side_ * dot(m, r.now), side_ * (dot(m_rate, r.now) + dot(m, r.rate))}},
            norm(m),
            dot(m, m_rate)};
}

Pursuit::Height Pursuit::between_others(double time) const
{
    const double h = time - now_;
    const NearSinCos by = turned(h);
    const Moving r = way(h, by);
    if (between_ == Between::planes) return {{time, {dot(normal_, r.now), dot(normal_, r.rate)}}};
    Moving e;
    if (between_ != Between::points) {
        const XYZ<Two> along = along_.at(by), turning = angles_ * along_.rate(by);
        const bool of_a = between_ == Between::edge_of_a;
        e = of_a ? Moving{first(along), first(turning)} : Moving{second(along), second(turning)};
    }
    const double on_edge = dot(e.now, r.now), gap = norm(r.now - on_edge * e.now);
    const double slip = dot(e.rate, r.now) + dot(e.now, r.rate);
    return {{time, {gap, (dot(r.now, r.rate) - on_edge * slip) / gap}}};
}

/// Does what is to be done with the one of them that tells the gap.
template <class Do> auto Pursuit::with_height(Do go) const
{
    const bool face = between_ == Between::face_of_a || between_ == Between::face_of_b;
    if (face) return go([this](double t) { return over_face(t); });
    if (between_ == Between::edges) return go([this](double t) { return between_edges(t); });
    return go([this](double t) { return between_others(t); });
}

Pursuit::Height Pursuit::at(double time) const
{
    return with_height([&](auto height) { return height(time); });
}

double Pursuit::falls_to(double aim, double near, double from, double until) const
{
    const double goal = margin_ + aim;
    return with_height([&](auto height) {
        // How far above the goal, times the length. A goal of next to nothing may be told by the length
        // before: then nobody has to wait for the root.
        const auto above = [&](Height at, double length_before) {
            at.seen.gap.now -= goal * (goal <= near ? length_before : at.length);
            if (!(goal <= near)) at.seen.gap.rate -= goal * (at.growing / at.length);
            return at;
        };
        Height last = height(now_);
        last = above(last, last.length);
        Guess before = last.seen;
        for (int i = 0; i < tolerance::most_guesses; ++i) {
            const double next = brink::falls_to(0, before, last.seen), enough = near * last.length;
            if (!(last.seen.gap.rate < 0 && next > from && next < until)) return infinity;
            const double rest = std::fabs(last.seen.gap.now), rest_before = std::fabs(before.gap.now);
            // What is left falls at least with the square: the next guess is near enough unseen.
            if (rest <= enough || rest * rest < enough * rest_before) return next;
            before = last.seen;
            last = above(height(next), last.length);
        }
        return infinity;
    });
}

} // namespace brink
