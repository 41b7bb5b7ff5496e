// SPDX-License-Identifier: BSD-3-Clause
#include "referee_motion.h"

#include <algorithm>

namespace brink::support {
namespace {

/// Of the scale. In long double a bound of the gap errs by a few dozen roundings of 5.4e-20; in 100 digits by
/// as many of 1e-100.
template <class T> struct Grain;
template <> struct Grain<long double> {
    static long double enough() { return 1e-18L; }
    static long double blur() { return 1e-16L; }
};
template <> struct Grain<Hundred> {
    static Hundred enough() { return Hundred("1e-42"); }
    static Hundred blur() { return Hundred("1e-90"); }
};

template <class T> T extent_of(const Solid<T>& s)
{
    using std::abs;
    using std::sqrt;
    if (s.unbounded()) return abs(s.offset);
    if (s.core == Core::ellipsoid) return std::max({s.radii.x, s.radii.y, s.radii.z});
    if (s.core == Core::cylinder || s.core == Core::cone)
        return sqrt(T(s.girth * s.girth + s.half_length * s.half_length));
    T most = 0;
    for (const Vector<T>& corner : s.corners)
        most = std::max(most, norm(corner));
    return most;
}

template <class T> MovingBody<T> body(const Shape& shape, const Motion& m, const Vector<T>& origin)
{
    MovingBody<T> out;
    out.solid = solid<T>(shape);
    out.start = rotation_of<T>(m.start.orientation);
    out.arm = vector_of<T>(m.pivot);
    out.pivot = (vector_of<T>(m.start.position) - origin) + out.start * out.arm;
    out.velocity = vector_of<T>(m.translation);
    out.rotation = vector_of<T>(m.rotation);
    out.rate = norm(out.rotation);
    out.extent = extent_of(out.solid);
    const Vector<T> axis = out.rate > 0 ? T(1 / out.rate) * out.rotation : Vector<T>{};
    for (const Vector<T>& corner : out.solid.corners) {
        const Vector<T> x = out.start * (corner - out.arm);
        out.reach = std::max(out.reach, norm(x));
        out.swing = std::max(out.swing, norm(cross(axis, x)));
    }
    if (!out.solid.unbounded()) out.reach = std::min(out.reach, T(out.extent + norm(out.arm)));
    out.swing = std::min(out.swing, out.reach);
    return out;
}

} // namespace

template <class T> Placement<T> MovingBody<T>::at(const T& t) const
{
    const Matrix<T> axes = rate == 0 ? start : turn_by(t * rotation) * start;
    return placed(solid, pivot + t * velocity - axes * arm, axes);
}

template <class T>
MovingPair<T>::MovingPair(const Query& q)
    : origin_(vector_of<T>(q.motion_b.start.position)),
      drift_(vector_of<T>(q.motion_b.translation)),
      target_(q.options.target_gap)
{
    a_ = body(q.a, q.motion_a, origin_);
    b_ = body(q.b, q.motion_b, origin_);
    a_.velocity = a_.velocity - b_.velocity;
    b_.velocity = {};
    const T by = norm(a_.velocity);
    const T span = std::max(norm(a_.pivot - b_.pivot), norm(a_.pivot + a_.velocity - b_.pivot));
    const auto size = [](const MovingBody<T>& x) {
        return T((1 + x.rate) * (x.extent + norm(x.arm) + x.solid.radius));
    };
    scale_ = norm(a_.pivot - a_.start * a_.arm - b_.pivot + b_.start * b_.arm) + by + size(a_) + size(b_) +
             target_;
    rush_ = by + a_.rate * a_.swing + b_.rate * b_.swing;
    bend_ = a_.rate * a_.rate * a_.swing + b_.rate * b_.rate * b_.swing;
    fastest_ = rush_;
    if (over_ground()) {
        const MovingBody<T>& ground = a_.solid.unbounded() ? a_ : b_;
        const MovingBody<T>& other = a_.solid.unbounded() ? b_ : a_;
        const T away = span + other.reach;
        scale_ += ground.rate * away;
        fastest_ += ground.rate * away;
        bend_ = ground.rate * ground.rate * away + 2 * ground.rate * rush_ +
                other.rate * other.rate * other.swing;
    }
    enough_ = Grain<T>::enough() * scale_;
    blur_ = Grain<T>::blur() * scale_;
}

template <class T> Bracket<T> MovingPair<T>::at(const T& t, const Vector<T>& hint) const
{
    const Placement<T> a = a_.at(t);
    const Placement<T> b = b_.at(t);
    return bracket(a, b, enough_, hint);
}

template <class T> Vector<T> MovingPair<T>::from_world(const Vec3& point, const T& t) const
{
    return vector_of<T>(point) - origin_ - t * drift_;
}

template <class T> T MovingPair<T>::bulge(const Vector<T>& n0, const Vector<T>& n1, const T& h) const
{
    const T turned = over_ground() ? T(0) : norm(n1 - n0);
    return 2 * turned * h * rush_ + h * h * bend_;
}

template <class T> std::optional<typename MovingPair<T>::Window> MovingPair<T>::window() const
{
    using std::sqrt;
    constexpr int always = 2; // beyond the step on either side
    if (over_ground()) return Window{T(-always), T(always)};
    const Vector<T> d = a_.pivot - b_.pivot;
    const T radii = a_.reach + b_.reach + a_.solid.radius + b_.solid.radius + target_;
    const T together =
        radii * (1 + T(0x1p-40)) + blur_ + T(0x1p-30) * norm(d); // outweighs all rounding below
    const T vv = dot(a_.velocity, a_.velocity);
    const T dv = dot(d, a_.velocity);
    const T c = dot(d, d) - together * together;
    if (vv == 0) return c <= 0 ? std::optional(Window{T(-always), T(always)}) : std::nullopt;
    const T disc = dv * dv - vv * c;
    if (disc < 0 && c > 0) return std::nullopt;
    const T root = disc > 0 ? T(sqrt(disc)) : T(0);
    const T margin = T(0x1p-40) * (1 + root / vv);
    return Window{(-dv - root) / vv - margin, (-dv + root) / vv + margin};
}

template struct MovingBody<long double>;
template struct MovingBody<Hundred>;
template class MovingPair<long double>;
template class MovingPair<Hundred>;

} // namespace brink::support
