// SPDX-License-Identifier: BSD-3-Clause
#include "print.h"

#include <fmt/format.h>

namespace brink::support {
namespace {

std::string hex(double x)
{
    if (std::isnan(x)) return "std::numeric_limits<double>::quiet_NaN()";
    if (std::isinf(x)) return x > 0 ? "infinity" : "-infinity";
    if (x == std::floor(x) && std::abs(x) < 1000 && !(x == 0 && std::signbit(x))) return fmt::format("{}", x);
    return fmt::format("{:a}", x);
}

std::string hex(const Vec3& v) { return fmt::format("Vec3({}, {}, {})", hex(v.x()), hex(v.y()), hex(v.z())); }

std::string hex(const Quat& q)
{
    return fmt::format("Quat({}, {}, {}, {})", hex(q.w()), hex(q.x()), hex(q.y()), hex(q.z()));
}

std::string hex(const Motion& m)
{
    return fmt::format("Motion{{Pose{{{}, {}}}, {}, {}, {}}}", hex(m.start.position),
                       hex(m.start.orientation), hex(m.translation), hex(m.rotation), hex(m.pivot));
}

std::string hex(const Sphere& s) { return fmt::format("Sphere{{{}}}", hex(s.radius)); }

std::string hex(const Capsule& s)
{
    return fmt::format("Capsule{{{}, {}, {}}}", hex(s.a), hex(s.b), hex(s.radius));
}

std::string hex(const Box& s) { return fmt::format("Box{{{}}}", hex(s.half_extents)); }

std::string hex(const Triangle& s)
{
    return fmt::format("Triangle{{{}, {}, {}}}", hex(s.a), hex(s.b), hex(s.c));
}

std::string hex(const Plane& s) { return fmt::format("Plane{{{}, {}}}", hex(s.normal), hex(s.offset)); }

std::string hex(const HalfSpace& s)
{
    return fmt::format("HalfSpace{{{}, {}}}", hex(s.normal), hex(s.offset));
}

std::string hex(const Cylinder& s)
{
    return fmt::format("Cylinder{{{}, {}}}", hex(s.half_length), hex(s.radius));
}

std::string hex(const Cone& s) { return fmt::format("Cone{{{}, {}}}", hex(s.half_length), hex(s.radius)); }

std::string hex(const Ellipsoid& s) { return fmt::format("Ellipsoid{{{}}}", hex(s.radii)); }

std::string hex(const Hull& s)
{
    std::string points;
    for (const Vec3& p : s.vertices())
        points += (points.empty() ? "" : ", ") + hex(p);
    return fmt::format("Hull::from_points(std::vector<Vec3>{{{}}})", points);
}

std::string hex(const Shape& shape)
{
    return std::visit([](const auto& s) { return hex(s); }, shape);
}

std::string_view name(StartContact start)
{
    if (start == StartContact::ignore) return "StartContact::ignore";
    if (start == StartContact::ignore_if_separating) return "StartContact::ignore_if_separating";
    return "StartContact::report";
}

std::string hex(const Options& o)
{
    const std::string_view detail = o.detail == Detail::contact ? "Detail::contact" : "Detail::time_only";
    return fmt::format("Options{{{}, {}, {}, {}, {}, {}}}", hex(o.t_max), hex(o.target_gap), hex(o.tolerance),
                       name(o.start_contact), detail, o.max_iterations);
}

} // namespace

std::string_view name(Status status)
{
    constexpr std::array<std::string_view, 5> names{"invalid", "separated", "touching", "hit", "undecided"};
    const auto index = static_cast<std::size_t>(status);
    return index < names.size() ? names[index] : "no status at all";
}

std::string in_words(const Toi& toi)
{
    return fmt::format(
        "{} t={:.17g} t_upper={:.17g} gap={:.6g} normal=({:.9g}, {:.9g}, {:.9g}) iterations={}",
        name(toi.status), toi.t, toi.t_upper, toi.gap, toi.normal.x(), toi.normal.y(), toi.normal.z(),
        toi.iterations);
}

std::string as_cpp(const Query& q, std::string_view note)
{
    const std::string comment = note.empty() ? "" : fmt::format("    // {}\n", note);
    return fmt::format(
        "{}    check(Query{{{},\n                {},\n                {},\n                {},\n"
        "                {}}});\n",
        comment, hex(q.a), hex(q.motion_a), hex(q.b), hex(q.motion_b), hex(q.options));
}

} // namespace brink::support
