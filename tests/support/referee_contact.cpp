// SPDX-License-Identifier: BSD-3-Clause
#include "referee_question.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brink::support {
namespace {

using Real = long double;

constexpr Real eps = 0x1p-52L;

double shown(Real x) { return static_cast<double>(x); }

/// A single point, to measure the distance of.
Solid<Real> dot_solid()
{
    Solid<Real> out;
    out.corners = {{}};
    out.edges = {{0, 0}};
    return out;
}

/// Distance of a point from a solid; negative inside.
Real off(const Placement<Real>& shape, const Vector<Real>& point, Real enough)
{
    static const Solid<Real> speck = dot_solid();
    const Placement<Real> there = placed(speck, point, Matrix<Real>{});
    if (shape.solid->unbounded()) {
        const Real height = dot(shape.normal, point) - shape.offset;
        return shape.solid->core == Core::plane ? std::abs(height) : height;
    }
    return bracket(shape, there, Effort<Real>{enough}).lower;
}

/// A body's height above ground against `up`, which must be the ground's normal or, for a plane, its
/// opposite; -infinity otherwise.
Real height(const Placement<Real>& body, const Placement<Real>& ground, const Vector<Real>& up)
{
    constexpr Real parallel = 1e-6L;
    const GroundHeights<Real> h = heights_over(body, ground);
    if (norm(up - ground.normal) < parallel) return h.above;
    const bool under = ground.solid->core == Core::plane && norm(up + ground.normal) < parallel;
    return under ? h.below : -std::numeric_limits<Real>::infinity();
}

Real along(const Placement<Real>& a, const Placement<Real>& b, const Vector<Real>& n)
{
    if (b.solid->unbounded()) return height(a, b, -n);
    if (a.solid->unbounded()) return height(b, a, n);
    return separation(a, b, n);
}

} // namespace

Findings judge_contact(const Query& q, const Toi& toi, const Question& question)
{
    const MovingPair<Real>& pair = question.coarse();
    const Placement<Real> a = pair.a().at(toi.t);
    const Placement<Real> b = pair.b().at(toi.t);
    const Bracket<Real> truth = bracket(a, b, Effort<Real>{pair.enough()});
    const Real exact = 4 * 16 * eps * pair.scale();
    // What toi.h promises of curved shapes.
    const bool round = curved(q.a) || curved(q.b);
    const Real told = static_cast<Real>(q.options.tolerance) / 32;
    const auto up_to = [&](Real part) { return round ? std::max(told, part * pair.scale()) + exact : exact; };
    const Real close = up_to(0x1p-30L), near = up_to(0x1p-20L);
    const Real radii = a.solid->radius + b.solid->radius;
    Findings out;
    const bool high = toi.gap > truth.upper + close;
    const bool low = truth.depth_known && toi.gap < truth.lower - close;
    if (!std::isfinite(toi.gap) || high || low)
        out.push_back({"gap", fmt::format("says {:.17g}, is {:.17g}", toi.gap, shown(truth.upper))});
    const Vector<Real> n = vector_of<Real>(toi.normal);
    const bool directed = norm(n) > 0.5L;
    if (!directed && truth.lower + radii > close) out.push_back({"normal", "zero, though one is defined"});
    const Real loose = std::max<Real>(q.options.tolerance, 1e-6L * pair.scale());
    const Real claimed = truth.depth_known ? truth.lower : static_cast<Real>(toi.gap);
    if (directed && along(a, b, n) < claimed - loose)
        out.push_back({"normal", fmt::format("the separation along it is {:.3g}, the gap {:.3g}",
                                             shown(along(a, b, n)), shown(claimed))});
    const Vector<Real> point_a = pair.from_world(toi.point_a, toi.t);
    const Vector<Real> point_b = pair.from_world(toi.point_b, toi.t);
    const Real world = static_cast<Real>(toi.point_a.norm() + toi.point_b.norm());
    const Real most = std::max(off(a, point_a, pair.enough()), off(b, point_b, pair.enough()));
    if (!(most <= near + 32 * eps * world))
        out.push_back({"points", fmt::format("off the shapes by {:.3g}", shown(most))});
    const Real apart = norm(point_b - point_a - static_cast<Real>(toi.gap) * n);
    if (directed && !(apart <= exact + 32 * eps * world))
        out.push_back(
            {"points", fmt::format("point_b - point_a is off gap * normal by {:.3g}", shown(apart))});
    return out;
}

} // namespace brink::support
