// SPDX-License-Identifier: BSD-3-Clause
#include "quick_body.h"

#include <algorithm>

namespace brink::support {
namespace {

struct SineCosine {
    double sine, cosine;
};

/// Within 2 ulp of 1, for angles up to 2^20, and the same bits everywhere.
SineCosine sine_cosine(double angle)
{
    // pi/2 in parts of 33 bits: their products with the count of quarter turns are exact.
    const double quarters = std::floor(angle * 0.63661977236758134 + 0.5);
    double r = angle - quarters * 0x1.921fb544p+0;
    r -= quarters * 0x1.0b4611a6p-34;
    r -= quarters * 0x1.3198a2ep-69;
    const double x = r * r;
    double s = 0, c = 0; // Taylor's, the last term first
    for (const double k : {17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0}) {
        s = (1 + s) * -x / (k * (k - 1));
        c = (1 + c) * -x / ((k + 1) * k);
    }
    const double sine = r + r * s;
    const double cosine = 1 - x / 2 * (1 + c);
    switch (static_cast<long long>(quarters) & 3) {
    case 0:
        return {sine, cosine};
    case 1:
        return {cosine, -sine};
    case 2:
        return {-sine, -cosine};
    default:
        return {-cosine, sine};
    }
}

Matrix<double> turned(const Quick3& rotation, double rate, double t)
{
    const Quick3 axis = (1 / rate) * rotation;
    const double s = sine_cosine(t * rate).sine;
    const double h = sine_cosine(t * rate / 2).sine;
    const auto column = [&](const Quick3& v) {
        const Quick3 av = cross(axis, v);
        return v + s * av + 2 * h * h * cross(axis, av);
    };
    return {column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1})};
}

Quick3 quick(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

/// The cores as they are drawn in the local frame; what they reach is found from the points of a box where
/// they have none.
struct Describe {
    QuickBody& out;
    std::vector<Quick3>& box;

    void around(const Quick3& half) const
    {
        for (unsigned i = 0; i < 8; ++i)
            box.push_back({(i & 1U) != 0 ? half.x : -half.x, (i & 2U) != 0 ? half.y : -half.y,
                           (i & 4U) != 0 ? half.z : -half.z});
    }
    void round(QuickBody::Kind kind, double half_length, double girth) const
    {
        out.kind = kind;
        out.half_length = half_length;
        out.girth = girth;
        around({girth, girth, half_length});
    }
    void ground(const Vec3& normal, double offset) const
    {
        out.kind = QuickBody::Kind::ground;
        const double length = norm(quick(normal));
        out.normal = (1 / length) * quick(normal);
        out.offset = offset / length;
    }
    void operator()(const Sphere& s) const
    {
        out.radius = s.radius;
        out.points = {{}};
    }
    void operator()(const Capsule& s) const
    {
        out.radius = s.radius;
        out.points = {quick(s.a), quick(s.b)};
    }
    void operator()(const Triangle& s) const { out.points = {quick(s.a), quick(s.b), quick(s.c)}; }
    void operator()(const Box& s) const
    {
        around(quick(s.half_extents));
        out.points.swap(box);
    }
    void operator()(const Hull& s) const
    {
        for (const Vec3& p : s.vertices())
            out.points.push_back(quick(p));
    }
    void operator()(const Cylinder& s) const { round(QuickBody::Kind::cylinder, s.half_length, s.radius); }
    void operator()(const Cone& s) const { round(QuickBody::Kind::cone, s.half_length, s.radius); }
    void operator()(const Ellipsoid& s) const
    {
        out.kind = QuickBody::Kind::ellipsoid;
        out.radii = quick(s.radii);
        around(out.radii);
    }
    void operator()(const Plane& s) const
    {
        ground(s.normal, s.offset);
        out.two_sided = true;
    }
    void operator()(const HalfSpace& s) const { ground(s.normal, s.offset); }
};

/// On the rim of a disc about z, or at its centre, where d is least.
Quick3 on_disc(double girth, double z, const Quick3& d)
{
    const double across = std::sqrt(d.x * d.x + d.y * d.y);
    if (across == 0) return {0, 0, z};
    const double s = -girth / across;
    return {s * d.x, s * d.y, z};
}

Quick3 least_on(const QuickBody& body, std::size_t part, const Quick3& d)
{
    if (body.kind == QuickBody::Kind::ellipsoid) {
        const Quick3& r = body.radii;
        const Quick3 grown{r.x * d.x, r.y * d.y, r.z * d.z};
        const double length = norm(grown);
        if (length == 0) return {};
        const double s = -1 / length;
        return {s * r.x * grown.x, s * r.y * grown.y, s * r.z * grown.z};
    }
    const bool top = part == 1;
    if (top && body.kind == QuickBody::Kind::cone) return {0, 0, body.half_length};
    return on_disc(body.girth, top ? body.half_length : -body.half_length, d);
}

Quick3 least_of(const QuickBody& body, const Quick3& d)
{
    if (body.kind == QuickBody::Kind::ellipsoid) return least_on(body, 0, d);
    if (body.kind == QuickBody::Kind::cylinder) return least_on(body, d.z < 0 ? 1 : 0, d);
    const Quick3 rim = least_on(body, 0, d);
    const Quick3 apex = least_on(body, 1, d);
    return dot(d, apex) <= dot(d, rim) ? apex : rim;
}

/// How far the parts of a curved core reach, of the corners of a box around it.
std::vector<double> of_parts(const QuickBody& body, const std::vector<double>& corners, double apex)
{
    const auto most = [&](std::size_t from, std::size_t to) {
        return *std::max_element(corners.begin() + static_cast<std::ptrdiff_t>(from),
                                 corners.begin() + static_cast<std::ptrdiff_t>(to));
    };
    if (body.kind == QuickBody::Kind::ellipsoid) return {most(0, 8)};
    return {most(0, 4), body.kind == QuickBody::Kind::cone ? apex : most(4, 8)};
}

} // namespace

QuickBody quick_body(const Shape& shape, const Motion& m, const Vec3& origin)
{
    QuickBody out;
    std::vector<Quick3> box;
    std::visit(Describe{out, box}, shape);
    const Quick3 arm = quick(m.pivot);
    const std::vector<Quick3> own = out.points.empty() ? box : out.points;
    for (const Quick3& p : own)
        out.extent = std::max(out.extent, norm(p));
    out.extent += norm(arm) + out.radius + std::abs(out.offset);
    out.start = rotation_of<double>(m.start.orientation);
    out.pivot = (quick(m.start.position) - quick(origin)) + out.start * arm;
    out.velocity = quick(m.translation);
    out.rotation = quick(m.rotation);
    out.rate = norm(out.rotation);
    out.centre = -arm;
    out.offset -= dot(out.normal, arm);
    const Quick3 axis = out.rate > 0 ? (1 / out.rate) * out.rotation : Quick3{};
    const auto reach = [&](const Quick3& p) { return norm(p - arm) * (1 + 0x1p-40); };
    const auto swing = [&](const Quick3& p) {
        return norm(cross(axis, out.start * (p - arm))) + 0x1p-40 * norm(p - arm); // outweighs the rounding
    };
    for (const Quick3& p : own) {
        out.reach.push_back(reach(p));
        out.swing.push_back(swing(p));
    }
    if (out.points.empty() && !own.empty()) {
        const Quick3 apex{0, 0, out.half_length};
        out.reach = of_parts(out, out.reach, reach(apex));
        out.swing = of_parts(out, out.swing, swing(apex));
    }
    for (Quick3& p : out.points)
        p = p - arm;
    return out;
}

QuickPlace::QuickPlace(const QuickBody& of, double t)
    : body(&of),
      pivot(of.pivot + t * of.velocity),
      axes(of.rate == 0 ? of.start : turned(of.rotation, of.rate, t) * of.start)
{
    points.reserve(of.points.size());
    for (const Quick3& p : of.points)
        points.push_back(axes * p);
    centre = axes * of.centre;
    normal = axes * of.normal;
}

Quick3 QuickPlace::least_of_part(std::size_t part, const Quick3& d) const
{
    return centre + axes * least_on(*body, part, transposed_times(axes, d));
}

QuickPlace::Least QuickPlace::least(const Quick3& d) const
{
    if (points.empty()) return {centre + axes * least_of(*body, transposed_times(axes, d)), 0};
    std::size_t best = 0;
    double lowest = dot(d, points[0]);
    for (std::size_t i = 1; i < points.size(); ++i) {
        const double here = dot(d, points[i]);
        if (here >= lowest) continue;
        lowest = here;
        best = i;
    }
    return {points[best], best};
}

} // namespace brink::support
