// SPDX-License-Identifier: BSD-3-Clause
#include "error_questions.h"

#include <algorithm>

namespace brink::bench {
namespace {

double as_float(double x) { return static_cast<double>(static_cast<float>(x)); }
Vec3 as_floats(const Vec3& v) { return {as_float(v.x()), as_float(v.y()), as_float(v.z())}; }

Shape rounded(const Sphere& s) { return Sphere{as_float(s.radius)}; }
Shape rounded(const Capsule& s) { return Capsule{as_floats(s.a), as_floats(s.b), as_float(s.radius)}; }
Shape rounded(const Box& s) { return Box{as_floats(s.half_extents)}; }
Shape rounded(const Triangle& s) { return Triangle{as_floats(s.a), as_floats(s.b), as_floats(s.c)}; }
Shape rounded(const Plane& s) { return Plane{as_floats(s.normal), as_float(s.offset)}; }
Shape rounded(const HalfSpace& s) { return HalfSpace{as_floats(s.normal), as_float(s.offset)}; }
Shape rounded(const Cylinder& s) { return Cylinder{as_float(s.half_length), as_float(s.radius)}; }
Shape rounded(const Cone& s) { return Cone{as_float(s.half_length), as_float(s.radius)}; }
Shape rounded(const Ellipsoid& s) { return Ellipsoid{as_floats(s.radii)}; }

Shape rounded(const Hull& s)
{
    std::vector<Vec3> points;
    for (const Vec3& point : s.vertices())
        points.push_back(as_floats(point));
    return Hull::from_points(points);
}

Motion rounded(const Motion& m)
{
    const Quat& q = m.start.orientation;
    const Quat turn{as_float(q.w()), as_float(q.x()), as_float(q.y()), as_float(q.z())};
    return {{as_floats(m.start.position), turn},
            as_floats(m.translation),
            as_floats(m.rotation),
            as_floats(m.pivot)};
}

Body rounded(const Body& body)
{
    const Shape shape = std::visit([](const auto& s) { return rounded(s); }, body.shape);
    return {shape, rounded(body.motion)};
}

} // namespace

support::Query query(const Sample& sample, const Pair& pair)
{
    const Body& a = sample.bodies[pair.a];
    const Body& b = sample.bodies[pair.b];
    return {a.shape, a.motion, b.shape, b.motion, {}};
}

Questions draw_questions(const support::Pair& shapes, Turning turning, const Wanted& wanted)
{
    const std::string name = shapes.name();
    const PairKind kind{name, draw_of(shapes.first), draw_of(shapes.second)};
    Questions out{name, turning, draw_sample(kind, turning, static_cast<std::size_t>(wanted.timed)), {}};
    for (Body& body : out.sample.bodies)
        body = rounded(body);
    int hits = wanted.judged / 2;
    int misses = wanted.judged / 2;
    for (const Pair& pair : out.sample.mixed) {
        if (hits == 0 && misses == 0) break;
        const Truth known = truth(query(out.sample, pair));
        if (known.fate == Fate::left_out) {
            ++out.left_out;
            continue;
        }
        int& left = known.fate == Fate::contact ? hits : misses;
        if (left == 0) continue;
        --left;
        out.judged.push_back({pair, known});
    }
    return out;
}

} // namespace brink::bench
