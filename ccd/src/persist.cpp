// SPDX-License-Identifier: BSD-3-Clause
#include "persist.h"

#include "falling.h"
#include "gjk.h"
#include "piercing.h"
#include "spindle.h"
#include "support.h"
#include "tolerance.h"

#include <algorithm>

namespace brink {

namespace {

constexpr int narrowings = 4;

/// The part of the way out, as far as its rate tells, beyond which nobody looks for a longer step.
constexpr double nearly_out = 0.9;

/// As long as a point of A and one of B stay within reach of each other.
double within(const Facing<Core>& f, V3 a, V3 b, double reach, double horizon)
{
    const V3 arm = b - f.b.pivot;
    const V3 velocity = f.velocity + cross(f.b.rate, arm) - cross(f.a.rate, a);
    const double acceleration = f.a.angle * f.a.angle * norm(a) + f.b.angle * f.b.angle * norm(arm);
    return last_kept([&](double h) { return reach - norm((b - a) + h * velocity); }, acceleration, horizon);
}

/// The way from a point of A to one of B as they move: how fast it changes, and bounds of that and of its
/// second derivative.
struct Way {
    V3 now, rate;
    double speed = 0, bend = 0;
};

Way way_between(const Facing<Core>& f, V3 a, V3 b)
{
    const V3 of_a = cross(f.a.rate, a), of_b = cross(f.b.rate, b - f.b.pivot);
    return {b - a, f.velocity + of_b - of_a, norm(f.velocity) + norm(of_b) + norm(of_a),
            f.b.angle * norm(of_b) + f.a.angle * norm(of_a)};
}

/// As long as the volume that three ways span, times `side`, stays positive, and the origin as far inside the
/// plane through their ends as is to be kept.
double spanned(const Way& p, const Way& q, const Way& r, double side, const Kept& kept, double horizon)
{
    const V3 by_q = cross(q.now, r.now);
    const double volume = side * dot(p.now, by_q);
    const double rate =
        side * (dot(p.rate, by_q) + dot(q.rate, cross(r.now, p.now)) + dot(r.rate, cross(p.now, q.now)));
    const auto longest = [&](const Way& w) { return norm(w.now) + horizon * w.speed; };
    const double at_p = longest(p), at_q = longest(q), at_r = longest(r);
    const double bend = p.bend * at_q * at_r + q.bend * at_r * at_p + r.bend * at_p * at_q +
                        2 * (p.speed * q.speed * at_r + q.speed * r.speed * at_p + r.speed * p.speed * at_q);
    const double spare = volume - tolerance::tight * at_p * at_q * at_r;
    if (!(spare > 0)) return 0;
    const double closes = std::min(horizon, falls(spare, rate, bend));
    if (kept.depth == 0) return closes;
    // The distance from the plane through the ends, times twice the area between them.
    const double to_q = norm(q.rate - p.rate) + horizon * (q.bend + p.bend),
                 to_r = norm(r.rate - p.rate) + horizon * (r.bend + p.bend);
    const double area = norm(cross(q.now - p.now, r.now - p.now));
    const double grows =
        to_q * (norm(r.now - p.now) + horizon * to_r) + to_r * (norm(q.now - p.now) + horizon * to_q);
    const double left = spare - kept.depth * area, gained = kept.rate * area - kept.depth * grows;
    return left >= 0 ? std::min(closes, falls(left, rate + gained, bend)) : 0;
}

/// As long as four ways close over the origin, as their volumes on all sides keep one sign: the origin is a
/// mean of them, and the same means of both ends are one point of both cores.
double closed(const Way (&w)[4], const Kept& kept, double horizon)
{
    const double side =
        dot(w[0].now - w[3].now, cross(w[1].now - w[3].now, w[2].now - w[3].now)) > 0 ? 1 : -1;
    double best = 0;
    for (int i = 0; i < narrowings && horizon > best; ++i) { // bends are bounded better over less time
        const auto by = [&](int p, int q, int r) { return spanned(w[p], w[q], w[r], side, kept, horizon); };
        const double h = std::min({by(0, 1, 2), by(0, 2, 3), by(0, 3, 1), by(1, 3, 2)});
        best = std::max(best, h);
        horizon = std::min(horizon, 4 * h);
    }
    return best;
}

} // namespace

double overlap_step(const Facing<Core>& f, const Separation& contact, const Kept& kept, double horizon)
{
    const Core &a = f.a.part, &b = f.b.part;
    const V3 n = contact.normal;
    const double depth = -(contact.gap + a.radius + b.radius);
    if (!(depth > 0) || n == V3{}) return 0;
    Way w[4];
    w[3] = way_between(f, farthest(a, -n).point, farthest(b, n).point);
    // The corners next to the way out are those that come nearest where one core is moved out along it.
    const V3 out = 1.25 * depth * n;
    const Closest c = gjk(a, placed(b, {}, out), {tolerance::tight * norm(w[3].now), 0, 0});
    double best = 0;
    if (!c.inside && c.simplex.size == 3) {
        for (int k = 0; k < 3; ++k)
            w[k] = way_between(f, c.simplex.corners[k].on_a, c.simplex.corners[k].on_b - out);
        best = closed(w, kept, horizon);
    }
    // Round ones: where the surface has fallen by a part of the depth.
    const double fine = kept.depth > 0 ? 0.25 : 1; // cut off less of it
    const double least = fine * std::sqrt(depth / norm(w[3].now)), half_root_three = 0.8660254037844386;
    for (const double tilt : {0.5 * least, least, 2 * least, 4 * least}) {
        const V3 x = tilt * any_perpendicular(n), y = cross(n, x);
        const V3 around[] = {x, half_root_three * y - 0.5 * x, -half_root_three * y - 0.5 * x};
        for (int k = 0; k < 3; ++k)
            w[k] = way_between(f, farthest(a, n + around[k]).point, farthest(b, -n - around[k]).point);
        best = std::max(best, closed(w, kept, horizon));
    }
    return best;
}

double contact_step(const Facing<Core>& f, const Separation& contact, double reach, double horizon)
{
    const double radius_a = f.a.part.radius, radius_b = f.b.part.radius;
    const V3 n = contact.normal, a = contact.point_a - radius_a * n, b = contact.point_b + radius_b * n;
    const double overlap = -(contact.gap + radius_a + radius_b);
    double lasting = within(f, a, b, reach, horizon);
    const auto attempt = [&](const auto& witness) {
        if (lasting < horizon) lasting = std::max(lasting, witness());
    };
    attempt([&] { return piercing_step({f.a, f.b, -f.velocity, -n, overlap, horizon}, a); });
    attempt([&] { return piercing_step({f.b, f.a, f.velocity, n, overlap, horizon}, b); });
    const double opening = dot(n, f.velocity + cross(f.b.rate, b - f.b.pivot) - cross(f.a.rate, a));
    if (lasting >= nearly_out * falls(reach + overlap, -opening, 0)) return lasting;
    attempt([&] { return overlap_step(f, contact, {}, horizon); });
    attempt([&] { return spindle_step(f, reach, horizon); });
    return lasting;
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
        return last_kept([&](double h) { return reach - above - h * rate; }, d.acceleration, horizon);
    };
    const double below = stays(border.normal);
    const double lasting = border.solid ? below : std::min(below, stays(-border.normal));
    return lasting < horizon ? std::max(lasting, spindle_step(f, reach, horizon)) : lasting;
}

} // namespace brink
