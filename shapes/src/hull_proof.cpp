// SPDX-License-Identifier: BSD-3-Clause
#include "hull_proof.h"

#include "dyadic.h"
#include "tolerance.h"

#include <algorithm>
#include <tuple>

namespace brink {

namespace {

/// The same as side(), where rounding must not decide.
int exact_side(V3 a, V3 b, V3 c, V3 p)
{
    using Exact = Dyadic<64>; // coordinates reach over 17 limbs, a product of three differences over 54
    const auto from_a = [a](V3 q) {
        return XYZ<Exact>{Exact(q.x) - Exact(a.x), Exact(q.y) - Exact(a.y), Exact(q.z) - Exact(a.z)};
    };
    const XYZ<Exact> u = from_a(b), v = from_a(c), w = from_a(p);
    return (w.x * (u.y * v.z - u.z * v.y) + w.y * (u.z * v.x - u.x * v.z) + w.z * (u.x * v.y - u.y * v.x))
        .sign();
}

} // namespace

int side(V3 a, V3 b, V3 c, V3 p)
{
    const V3 u = b - a, v = c - a, w = p - a;
    const double yz = u.y * v.z, zy = u.z * v.y, zx = u.z * v.x, xz = u.x * v.z, xy = u.x * v.y,
                 yx = u.y * v.x;
    const double determinant = w.x * (yz - zy) + w.y * (zx - xz) + w.z * (xy - yx);
    const double terms = std::fabs(w.x) * (std::fabs(yz) + std::fabs(zy)) +
                         std::fabs(w.y) * (std::fabs(zx) + std::fabs(xz)) +
                         std::fabs(w.z) * (std::fabs(xy) + std::fabs(yx));
    const double error = tolerance::side * terms;
    const bool keeps_digits = terms > tolerance::least_square;
    if (keeps_digits && determinant > error) return 1;
    if (keeps_digits && determinant < -error) return -1;
    return exact_side(a, b, c, p);
}

Surface::Surface(const std::vector<V3>& points, std::vector<Facet> faces)
    : points_(points), faces_(std::move(faces))
{
    if (!faces_.empty() && turn_outwards() && pair_edges()) return;
    faces_.clear();
}

bool Surface::turn_outwards()
{
    for (const Facet& f : faces_)
        for (const int k : f)
            middle_ = middle_ + (1.0 / 3 / static_cast<double>(faces_.size())) * at(k);
    inner_ = infinity;
    for (Facet& f : faces_) {
        const int below = side(at(f[0]), at(f[1]), at(f[2]), middle_);
        if (below == 0) return false;
        if (below > 0) std::swap(f[1], f[2]);
        const V3 a = at(f[0]), n = cross(at(f[1]) - a, at(f[2]) - a);
        planes_.push_back({n, dot(n, a)});
        const double depth = std::max(0.0, dot(n, a - middle_) - tolerance::plane);
        inner_ = std::min(inner_, tolerance::inner * (depth * depth / norm_squared(n)));
    }
    return true;
}

bool Surface::pair_edges()
{
    for (std::size_t i = 0; i < faces_.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            edges_.push_back(
                {faces_[i][k], faces_[i][(k + 1) % 3], static_cast<int>(i), faces_[i][(k + 2) % 3]});
    const auto ends = [](const Edge& e) { return std::tuple(e.from, e.to); };
    std::sort(edges_.begin(), edges_.end(), [&](const Edge& e, const Edge& f) { return ends(e) < ends(f); });
    for (std::size_t i = 0; i + 1 < edges_.size(); ++i)
        if (ends(edges_[i]) == ends(edges_[i + 1])) return false;
    return std::all_of(edges_.begin(), edges_.end(), [&](const Edge& e) {
        const Edge back = opposite(e);
        return back.from == e.to && back.to == e.from;
    });
}

Surface::Edge Surface::opposite(const Edge& e) const
{
    const auto before = [](const Edge& f, const Edge& g) {
        return std::tuple(f.from, f.to) < std::tuple(g.from, g.to);
    };
    const auto found = std::lower_bound(edges_.begin(), edges_.end(), Edge{e.to, e.from, 0, 0}, before);
    return found == edges_.end() ? edges_.front() : *found;
}

bool Surface::holds(V3 point) const
{
    if (norm_squared(point - middle_) < inner_) return true;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
        if (dot(planes_[i].normal, point) - planes_[i].offset < -tolerance::plane) continue;
        const Facet& f = faces_[i];
        if (side(at(f[0]), at(f[1]), at(f[2]), point) > 0) return false;
    }
    return true;
}

/// Whether a line from the middle, which no face hides from itself, meets one face only: the surface is then
/// seen from there as a sphere is, and where none of its edges is bent inwards, it is convex. (K. Mehlhorn
/// and others, Checking Geometric Programs or Verification of Geometric Structures, 1999.)
bool Surface::goes_round_once() const
{
    const V3 o = middle_, a = at(faces_[0][0]), b = at(faces_[0][1]), c = at(faces_[0][2]);
    const V3 target = 0.5 * a + 0.3 * b + 0.2 * c;
    int met = 0;
    for (const Facet& f : faces_) {
        int least = 1;
        for (std::size_t k = 0; k < 3; ++k)
            least = std::min(least, side(o, at(f[k]), at(f[(k + 1) % 3]), target));
        if (least == 0) return false; // through an edge, perhaps
        met += least > 0 ? 1 : 0;
    }
    return met == 1;
}

/// A corner all of whose faces lie in one plane.
bool Surface::has_flat_corner() const
{
    std::vector<bool> sharp(points_.size(), false);
    for (const Edge& e : edges_) {
        const Facet& f = faces_[static_cast<std::size_t>(e.face)];
        if (side(at(f[0]), at(f[1]), at(f[2]), at(opposite(e).apex)) == 0) continue;
        sharp[static_cast<std::size_t>(e.from)] = sharp[static_cast<std::size_t>(e.to)] = true;
    }
    return std::any_of(edges_.begin(), edges_.end(),
                       [&](const Edge& e) { return !sharp[static_cast<std::size_t>(e.from)]; });
}

bool Surface::convex() const
{
    const auto bent_inwards = [&](const Edge& e) {
        const Facet& f = faces_[static_cast<std::size_t>(e.face)];
        return side(at(f[0]), at(f[1]), at(f[2]), at(opposite(e).apex)) > 0;
    };
    return !empty() && std::none_of(edges_.begin(), edges_.end(), bent_inwards) && !has_flat_corner() &&
           goes_round_once();
}

} // namespace brink
