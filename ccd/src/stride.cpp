// SPDX-License-Identifier: BSD-3-Clause
#include "stride.h"

#include "contact_features.h"
#include "corner_step.h"
#include "edge_step.h"
#include "flattest_edge.h"
#include "mover.h"
#include "support.h"
#include "tolerance.h"

#include <algorithm>

namespace brink {

namespace {

V3 turned_by(V3 v, V3 rate, double time)
{
    const double angle = norm(rate);
    if (!(angle > 0)) return v;
    return turned(Turn{rate, (1 / angle) * rate, angle}, time) * v;
}

/// The axes near one that are left to choose from: a convex polygon in the plane at right angles to it, from
/// which half-planes are cut off.
class Choice {
public:
    explicit Choice(V3 normal) : normal_(normal), x_(any_perpendicular(normal)), y_(cross(normal, x_))
    {
        constexpr double w = tolerance::widest_tilt;
        size_ = 4;
        at_[0] = {-w, -w}, at_[1] = {w, -w}, at_[2] = {w, w}, at_[3] = {-w, w};
    }
    /// The one in the midst, not of unit length.
    V3 midst() const { return normal_ + midst_.x * x_ + midst_.y * y_; }
    /// Leaves those on the side of it that `towards` shows, or, where `beyond` is negative, farther along.
    /// Whether there are any.
    bool cut(V3 towards, double beyond)
    {
        const double p = dot(towards, x_), q = dot(towards, y_);
        const double rest = std::min(beyond, 0.0) - p * midst_.x - q * midst_.y;
        const auto side = [&](Place z) { return rest + p * z.x + q * z.y; };
        Place left[tolerance::most_tilts + 4];
        int count = 0;
        for (int i = 0; i < size_; ++i) {
            const Place a = at_[i], b = at_[i + 1 < size_ ? i + 1 : 0];
            const double on_a = side(a), on_b = side(b);
            if (on_a >= 0) left[count++] = a;
            if ((on_a >= 0) == (on_b >= 0)) continue;
            const double s = on_a / (on_a - on_b);
            left[count++] = {a.x + s * (b.x - a.x), a.y + s * (b.y - a.y)};
        }
        size_ = count;
        std::copy(left, left + count, at_);
        centre();
        return size_ > 2;
    }

private:
    struct Place {
        double x = 0, y = 0;
    };
    void centre()
    {
        double area = 0;
        Place sum;
        for (int i = 2; i < size_; ++i) {
            const Place u{at_[i - 1].x - at_[0].x, at_[i - 1].y - at_[0].y};
            const Place v{at_[i].x - at_[0].x, at_[i].y - at_[0].y};
            const double part = std::fabs(u.x * v.y - u.y * v.x);
            area += part;
            sum.x += part * (u.x + v.x);
            sum.y += part * (u.y + v.y);
        }
        midst_ = at_[0];
        if (!(area > 0)) return;
        midst_.x += sum.x / (3 * area);
        midst_.y += sum.y / (3 * area);
    }

    V3 normal_, x_, y_;
    int size_ = 0;
    Place at_[tolerance::most_tilts + 4], midst_;
};

/// The way between two points when time has gone on, as an axis that turns sees it.
V3 way_between(const Facing<Core>& f, const Blocked& b, V3 spin)
{
    const double h = b.step.length;
    const V3 on_a = f.a.pivot + turned_by(b.on_a - f.a.pivot, f.a.rate, h);
    const V3 on_b = f.b.pivot + h * f.velocity + turned_by(b.on_b - f.b.pivot, f.b.rate, h);
    return turned_by(on_b - on_a, -spin, h);
}

class Striding {
public:
    Striding(const Facing<Core>& f, double horizon) : f_(f), horizon_(horizon)
    {
        if (is_polytope(f.a.part) && is_polytope(f.b.part)) patience_ = tolerance::idle_tilts;
    }
    void tilt(V3 normal, V3 spin)
    {
        Choice choice(normal);
        double longest = 0;
        int idle = 0; // tilts that have not led farther
        for (int i = 0; i < tolerance::most_tilts && idle < patience_ && !done(); ++i, ++idle) {
            const V3 n = choice.midst();
            const double length = norm(n);
            const TurningAxis axis{(1 / length) * n, spin};
            const Blocked b = blocked_step(f_, axis, horizon_);
            if (b.step.length > tolerance::farther * longest) {
                longest = b.step.length;
                idle = 0;
            }
            take(axis, b.step);
            const V3 way = way_between(f_, b, spin);
            if (!choice.cut(way - f_.margin * axis.normal, dot(n, way) - f_.margin * length)) return;
        }
    }
    /// Axes that stay at right angles to a line of either body or of both.
    void lines(V3 normal)
    {
        const FlatLines of_a = flat_lines(f_.a.part, normal), of_b = flat_lines(f_.b.part, -normal);
        const auto feature = [](const FlatLines& lines, int k) -> Feature {
            if (k == lines.count) return {};
            return {Feature::Kind::edge, lines.line[k].along};
        };
        for (int i = 0; i <= of_a.count; ++i)
            for (int k = 0; k <= of_b.count; ++k) {
                if (done() || (i == of_a.count && k == of_b.count)) return;
                const TurningAxis axis =
                    axis_between(feature(of_a, i), f_.a.rate, feature(of_b, k), f_.b.rate, normal, normal);
                if (!(axis.normal == V3{})) tilt(axis.normal, axis.spin);
            }
    }
    void edges(V3 normal) { take({normal, {}}, edge_step(f_, normal, horizon_)); }
    void whirl(V3 normal) { take({normal, {}}, whirl_step(f_, normal, horizon_)); }
    bool done() const { return best_.step.length >= horizon_; }
    const Stride& best() const { return best_; }

private:
    void take(const TurningAxis& axis, const Step& step)
    {
        if (step.length > best_.step.length) best_ = {axis, step};
    }

    const Facing<Core>& f_;
    double horizon_;
    int patience_ = tolerance::most_tilts;
    Stride best_;
};

} // namespace

Stride stride(const Facing<Core>& facing, V3 normal, double horizon)
{
    const Facing<Core> f = about_one_pivot(facing);
    Striding s(f, horizon);
    s.edges(normal);
    s.tilt(normal, {});
    for (const V3 spin : {f.a.rate, f.b.rate})
        if (!(spin == V3{})) s.tilt(normal, spin);
    if (!is_polytope(f.a.part) || !is_polytope(f.b.part)) s.lines(normal);
    if (!s.done() && s.best().step.length > 0) s.whirl(s.best().axis.normal);
    if (!s.done()) s.whirl(normal);
    return s.best();
}

Stride stride(const Facing<Border>& f, V3 normal, double horizon)
{
    const TurningAxis axis{normal, f.b.rate};
    return {axis, corner_step(f, axis, horizon)};
}

} // namespace brink
