// SPDX-License-Identifier: BSD-3-Clause
#include "persist.h"

#include "depth.h"
#include "support.h"

#include <algorithm>

namespace brink {

namespace {

constexpr int bisections = 48;

/// The last h at which a concave function, which is not negative at 0, is not negative either.
template <class Function> double last(const Function& f, double horizon)
{
    if (!(f(0) >= 0)) return 0;
    if (f(horizon) >= 0) return horizon;
    double good = 0, bad = horizon;
    for (int i = 0; i < bisections; ++i) {
        const double h = 0.5 * (good + bad);
        (f(h) >= 0 ? good : bad) = h;
    }
    return good;
}

/// A point of one body, seen from the frame of another that turns: its velocity, and a bound of its
/// acceleration.
struct Drift {
    V3 velocity;
    double acceleration;
};

template <class Of, class From>
Drift drift(const Posed<Of>& of, const Posed<From>& from, V3 velocity, V3 point, double farthest)
{
    const V3 arm = point - of.pivot, seen = cross(of.rate, arm) + velocity;
    const double speed = of.angle * norm(arm) + norm(velocity);
    return {seen - cross(from.rate, point - from.pivot),
            of.angle * of.angle * norm(arm) + 2 * from.angle * speed + from.angle * from.angle * farthest};
}

/// As long as a point of the one body stays inside the core of the other.
double inside(const Posed<Core>& of, const Posed<Core>& solid, V3 velocity, V3 point, double horizon)
{
    const Drift d = drift(of, solid, velocity, point, solid.reach);
    return last(
        [&](double h) { return depth(solid.part, point + h * d.velocity) - 0.5 * d.acceleration * h * h; },
        horizon);
}

/// As long as a point of A and one of B stay within reach of each other.
double within(const Facing<Core>& f, V3 a, V3 b, double reach, double horizon)
{
    const V3 arm = b - f.b.pivot;
    const V3 velocity = f.velocity + cross(f.b.rate, arm) - cross(f.a.rate, a);
    const double acceleration = f.a.angle * f.a.angle * norm(a) + f.b.angle * f.b.angle * norm(arm);
    return last([&](double h) { return reach - norm((b - a) + h * velocity) - 0.5 * acceleration * h * h; },
                horizon);
}

/// As long as the balls about both pivots that lie inside the cores stay within reach of each other, however
/// the bodies turn. Not of hulls, whose depth has other last bits where the hull is scaled.
double balls(const Facing<Core>& f, double reach, double horizon)
{
    if (f.a.part.kind == Core::Kind::hull || f.b.part.kind == Core::Kind::hull) return 0;
    const double inside_a = depth(f.a.part, f.a.pivot), inside_b = depth(f.b.part, f.b.pivot);
    if (!(inside_a >= 0 && inside_b >= 0)) return 0;
    const double radii = inside_a + inside_b + reach;
    return last([&](double h) { return radii - norm(f.b.pivot - f.a.pivot + h * f.velocity); }, horizon);
}

} // namespace

double contact_step(const Facing<Core>& f, const Separation& contact, double reach, double horizon)
{
    const V3 a = contact.point_a - f.a.part.radius * contact.normal;
    const V3 b = contact.point_b + f.b.part.radius * contact.normal;
    const double pair = within(f, a, b, reach, horizon);
    const double in_b = inside(f.a, f.b, -f.velocity, a, horizon);
    return std::max({pair, in_b, inside(f.b, f.a, f.velocity, b, horizon), balls(f, reach, horizon)});
}

double contact_step(const Facing<Border>& f, const Separation&, double reach, double horizon)
{
    const Border& border = f.b.part;
    const auto stays = [&](V3 outward) { // a point on this side or at most `reach` beyond
        const V3 p = farthest(f.a.part, -outward).point;
        const double speed = f.a.angle * norm(p) + norm(f.velocity);
        const Drift d = drift(f.a, f.b, -f.velocity, p, norm(p - f.b.pivot) + speed * horizon);
        const double offset = dot(outward, border.normal) < 0 ? -border.offset : border.offset;
        const double above = dot(outward, p) - offset, rate = dot(outward, d.velocity);
        return last([&](double h) { return reach - above - h * rate - 0.5 * d.acceleration * h * h; },
                    horizon);
    };
    const double below = stays(border.normal);
    return border.solid ? below : std::min(below, stays(-border.normal));
}

} // namespace brink
