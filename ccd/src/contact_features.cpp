// SPDX-License-Identifier: BSD-3-Clause
#include "contact_features.h"

#include "nearest.h"
#include "support.h"
#include "tolerance.h"

namespace brink {

namespace {

using enum Feature::Kind;

/// Of unit length and in the sense of v; zero where n is.
V3 facing(V3 n, V3 v)
{
    const double length = norm(n);
    if (!(length > 0)) return {};
    return (dot(n, v) < 0 ? -1 / length : 1 / length) * n;
}

V3 in_sense(V3 n, V3 v) { return dot(n, v) < 0 ? -n : n; }

/// The common normal of two edges of bodies that turn with w_a and w_b: a normal at right angles to an edge e
/// that turns with w changes by eta with eta . e = -n . (w x e).
TurningAxis between_edges(V3 e, V3 rate_a, V3 g, V3 rate_b, V3 v, V3 towards)
{
    const double cosine = dot(e, g), rest = 1 - cosine * cosine;
    if (rest < tolerance::nearly_parallel) return {facing(across(v, e), v), rate_a};
    const V3 n = facing(cross(e, g), towards);
    const double along_e = -dot(n, cross(rate_a, e)), along_g = -dot(n, cross(rate_b, g));
    const V3 eta = ((along_e - cosine * along_g) / rest) * e + ((along_g - cosine * along_e) / rest) * g;
    return {n, cross(n, eta)};
}

TurningAxis over_edge(V3 e, V3 rate, V3 v)
{
    const V3 n = facing(across(v, e), v);
    return {n, -dot(n, cross(rate, e)) * cross(n, e)};
}

Feature edge_between(V3 p, V3 q)
{
    const V3 e = q - p;
    const double length = norm(e);
    if (!(length > 0)) return {};
    return {edge, (1 / length) * e};
}

/// The feature that one to four corners make; of a flat four, three will do.
Feature feature(int count, V3 p, V3 q, V3 r)
{
    if (count == 1) return {};
    if (count >= 3) {
        const V3 n = face_normal(p, q, r);
        if (!(n == V3{})) return {face, (1 / norm(n)) * n};
    }
    return edge_between(p, q);
}

} // namespace

TurningAxis axis_between(const Feature& a, V3 rate_a, const Feature& b, V3 rate_b, V3 v, V3 towards)
{
    if (a.kind == face) return {in_sense(a.along, towards), rate_a};
    if (b.kind == face) return {in_sense(b.along, towards), rate_b};
    if (a.kind == edge && b.kind == edge) return between_edges(a.along, rate_a, b.along, rate_b, v, towards);
    if (a.kind == edge) return over_edge(a.along, rate_a, v);
    if (b.kind == edge) return over_edge(b.along, rate_b, v);
    return {facing(v, v), {}};
}

void Corners::Some::add(const int* corners, int k)
{
    int seen = 0;
    for (int i = 0; i < k; ++i)
        seen |= static_cast<int>(corners[i] == corners[k]);
    place[count] = k;
    count += 1 - seen;
}

Corners::Corners(const Simplex& s)
{
    for (int k = 0; k < s.size; ++k)
        if (s.corners[k].in_a < 0 || s.corners[k].in_b < 0) return;
    count_ = s.size;
    for (int k = 0; k < count_; ++k) {
        in_a_[k] = s.corners[k].in_a;
        in_b_[k] = s.corners[k].in_b;
        of_a_.add(in_a_, k);
        of_b_.add(in_b_, k);
    }
}

Features Corners::features(const Simplex& now) const
{
    const auto on_a = [&](int i) { return now.corners[of_a_.place[i]].on_a; };
    const auto on_b = [&](int i) { return now.corners[of_b_.place[i]].on_b; };
    return {feature(of_a_.count, on_a(0), on_a(1), on_a(2)), feature(of_b_.count, on_b(0), on_b(1), on_b(2))};
}

void Corners::place(Simplex& s, const Core& a, const Core& b) const
{
    s.size = count_;
    for (int k = 0; k < count_; ++k) {
        Simplex::Corner& c = s.corners[k];
        c.on_a = corner(a, in_a_[k]);
        c.on_b = corner(b, in_b_[k]);
        c.w = c.on_b - c.on_a;
        c.in_a = in_a_[k];
        c.in_b = in_b_[k];
        c.weight = 0;
    }
}

} // namespace brink
