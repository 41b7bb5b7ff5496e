// SPDX-License-Identifier: BSD-3-Clause
// What a scene refuses, and how it says so.
#include "body_store.h"
#include "glance.h"
#include "valid_motion.h"

#include <sstream>
#include <stdexcept>
#include <string>

namespace brink {

namespace {

/// One input: its name, how it reads, whether it will do and what it must be.
struct Field {
    std::string name, value;
    bool ok;
    std::string rule;
};

template <class... Part> std::string joined(const Part&... parts)
{
    std::ostringstream out;
    out.precision(17);
    (out << ... << parts);
    return out.str();
}
std::string text(double x) { return joined(x); }
std::string text(const Vec3& v) { return joined("(", v.x(), ", ", v.y(), ", ", v.z(), ")"); }
std::string text(const Quat& q) { return joined("(", q.w(), ", ", q.x(), ", ", q.y(), ", ", q.z(), ")"); }

Field size(const char* name, double x)
{
    return {name, text(x), is_size(x), "must be finite and not negative"};
}
Field point(const char* name, const Vec3& v) { return {name, text(v), is_finite(load(v)), "must be finite"}; }
Field sizes(const char* name, const Vec3& v)
{
    return {name, text(v), is_size(v.x()) && is_size(v.y()) && is_size(v.z()),
            "must be finite and not negative"};
}
Field unit(const char* name, const Vec3& v)
{
    return {name, text(v), is_unit_square(norm_squared(load(v))), "must be a unit vector"};
}
Field number(const char* name, double x) { return {name, text(x), x * 0 == 0, "must be finite"}; }

using Fields = std::vector<Field>;

Fields fields(const Sphere& s) { return {size("radius", s.radius)}; }
Fields fields(const Capsule& s) { return {point("a", s.a), point("b", s.b), size("radius", s.radius)}; }
Fields fields(const Box& s) { return {sizes("half_extents", s.half_extents)}; }
Fields fields(const Triangle& s) { return {point("a", s.a), point("b", s.b), point("c", s.c)}; }
Fields fields(const Plane& s) { return {unit("normal", s.normal), number("offset", s.offset)}; }
Fields fields(const HalfSpace& s) { return {unit("normal", s.normal), number("offset", s.offset)}; }
Fields fields(const Cylinder& s) { return {size("half_length", s.half_length), size("radius", s.radius)}; }
Fields fields(const Cone& s) { return {size("half_length", s.half_length), size("radius", s.radius)}; }
Fields fields(const Ellipsoid& s) { return {sizes("radii", s.radii)}; }
Fields fields(const Hull&) { return {}; }

Fields fields(const Motion& m)
{
    const Quat& q = m.start.orientation;
    return {point("start.position", m.start.position),
            {"start.orientation", text(q), valid(q), "must be a unit quaternion"},
            point("translation", m.translation),
            {"rotation", text(m.rotation),
             norm_squared(load(m.rotation)) <= largest_rotation * largest_rotation,
             "must be at most 2^20 radians"},
            point("pivot", m.pivot)};
}

[[noreturn]] void refuse(const std::string& whose, const Field& f)
{
    throw std::invalid_argument(joined("brink::Scene: ", whose, f.name, " is ", f.value, ": it ", f.rule));
}

/// Says which field it is; the caller knows that there is one.
void refuse_first(const std::string& whose, const Fields& all)
{
    for (const Field& f : all)
        if (!f.ok) refuse(whose, f);
}

void check_valid(const std::string& whose, const Shape& shape, const Motion& motion)
{
    if (valid(shape, motion)) return;
    if (shape.valueless_by_exception()) refuse(whose, {"shape", "valueless", false, "must hold a shape"});
    std::visit([&](const auto& s) { refuse_first(joined(whose, "shape."), fields(s)); }, shape);
    refuse_first(joined(whose, "motion."), fields(motion));
}

std::string name(BodyId id) { return joined("body ", id, ": "); }

} // namespace

bool fits(const Motion& m, const Body& of)
{
    return valid(of.shape, m) && (!at_rest(of) || (load(m.translation) == V3{} && load(m.rotation) == V3{}));
}

void check(const Motion& m, const Body& of, BodyId id)
{
    if (!valid(of.shape, m)) check_valid(name(id), of.shape, m);
    if (!at_rest(of)) return;
    const std::string rule = of.immovable ? "must be zero, because the body is immovable"
                                          : "must be zero, because the body is asleep (wake it first)";
    if (!(load(m.translation) == V3{}))
        refuse(name(id), {"motion.translation", text(m.translation), false, rule});
    if (!(load(m.rotation) == V3{})) refuse(name(id), {"motion.rotation", text(m.rotation), false, rule});
}

void check(const Body& b, BodyId id)
{
    check(b.motion, b, id);
    const auto any = [&](const char* field, std::uint32_t bits) {
        if (bits == 0) refuse(name(id), {field, "0", false, "must have a bit set"});
    };
    any("category", b.category);
}

void check(const SceneOptions& options)
{
    if (options.category == 0) refuse("options.", {"category", "0", false, "must have a bit set"});
    const Options& o = options.pair;
    if (valid(o)) return;
    refuse_first(
        "options.pair.",
        {{"t_max", text(o.t_max), o.t_max >= 0 && o.t_max <= 1, "must be in [0, 1]"},
         size("target_gap", o.target_gap),
         size("tolerance", o.tolerance),
         {"max_iterations", std::to_string(o.max_iterations), o.max_iterations >= 1, "must be at least 1"},
         {"start_contact", std::to_string(static_cast<int>(o.start_contact)),
          o.start_contact <= StartContact::ignore, "must be one of StartContact"},
         {"detail", std::to_string(static_cast<int>(o.detail)), o.detail <= Detail::time_only,
          "must be one of Detail"}});
}

void check_cast(const Shape& shape, const Motion& motion) { check_valid("cast: ", shape, motion); }

void check_ray(const Vec3& origin, const Vec3& direction, double t_max)
{
    if (is_finite(load(origin)) && is_finite(load(direction)) && t_max >= 0) return;
    refuse_first("ray: ", {point("origin", origin),
                           point("direction", direction),
                           {"t_max", text(t_max), t_max >= 0, "must not be negative"}});
}

} // namespace brink
