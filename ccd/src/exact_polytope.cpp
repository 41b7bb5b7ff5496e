// SPDX-License-Identifier: BSD-3-Clause
#include "exact_polytope.h"

namespace brink::exact {

namespace {

bool negative(const Number& x) { return x.sign() < 0; }
bool at_most(const Number& x, const Number& y) { return (x - y).sign() <= 0; }

/// Whether `point` lies within reach of the segment from `start` along `edge`.
[[gnu::noinline]] bool within(const Point& point, const Point& start, const Point& edge,
                              const Number& length_squared, const Number& reach_squared)
{
    const Point m = point - start;
    const Number along = dot(m, edge);
    if (along.sign() <= 0) return at_most(dot(m, m), reach_squared);
    if (at_most(length_squared, along)) {
        const Point n = m - edge;
        return at_most(dot(n, n), reach_squared);
    }
    return at_most(dot(m, m) * length_squared - along * along, reach_squared * length_squared);
}

/// Whether two segments come within reach of each other.
[[gnu::noinline]] bool within(const Point& from, const Point& d, const Point& other, const Point& e,
                              const Number& reach_squared)
{
    const Point m = from - other;
    const Number dd = dot(d, d), de = dot(d, e), ee = dot(e, e), dm = dot(d, m), em = dot(e, m);
    const Number area_squared = dd * ee - de * de;
    if (area_squared.sign() > 0) {
        const Number on_d = de * em - ee * dm, on_e = dd * em - de * dm;
        if (!negative(on_d) && !negative(on_e) && at_most(on_d, area_squared) &&
            at_most(on_e, area_squared)) {
            const Number height = dot(m, cross(d, e));
            return at_most(height * height, reach_squared * area_squared);
        }
    }
    return within(from, other, e, ee, reach_squared) || within(from + d, other, e, ee, reach_squared) ||
           within(other, from, d, dd, reach_squared) || within(other + e, from, d, dd, reach_squared);
}

struct Face {
    Point corner[4];
    /// At right angles to the edge that starts at that corner, in the plane; all out or all in.
    Point outward[4];
    Point normal;
    int count;
};

Face face_of(const Polytope& p, int i)
{
    Face out;
    out.count = p.face_corners;
    for (int k = 0; k < out.count; ++k)
        out.corner[k] = p.corner[p.face[i][k]];
    out.normal = cross(out.corner[1] - out.corner[0], out.corner[2] - out.corner[0]);
    for (int k = 0; k < out.count; ++k)
        out.outward[k] = cross(out.corner[(k + 1) % out.count] - out.corner[k], out.normal);
    return out;
}

/// Whether point / weight lies over the face. weight > 0.
bool over(const Face& face, const Point& point, const Number& weight)
{
    for (int k = 0; k < face.count; ++k)
        if (dot(face.outward[k], point - weight * face.corner[k]).sign() > 0) return false;
    return true;
}

/// Whether the segment from a to b touches the face's inside, grown by the reach on both sides, or pierces
/// it.
[[gnu::noinline]] bool touches(const Face& face, const Point& a, const Point& b, const Number& reach_squared)
{
    const Number normal_squared = dot(face.normal, face.normal);
    if (normal_squared.sign() == 0) return false; // its edges are all there is
    const Number height_a = dot(face.normal, a - face.corner[0]),
                 height_b = dot(face.normal, b - face.corner[0]);
    const Number limit = reach_squared * normal_squared, one(1);
    if (at_most(height_a * height_a, limit) && over(face, a, one)) return true;
    if (at_most(height_b * height_b, limit) && over(face, b, one)) return true;
    if (height_a.sign() * height_b.sign() >= 0) return false;
    const bool falls = height_a.sign() > 0;
    const Number weight_a = falls ? -height_b : height_b, weight_b = falls ? height_a : -height_a;
    return over(face, weight_a * a + weight_b * b, weight_a + weight_b);
}

/// Beyond which of a box's six planes a path reaches: only features on those can be nearest to it. All of
/// them for a polytope that is not a box.
class Beyond {
public:
    Beyond(const Polytope& p, const Point& a, const Point& b) : box_(p.solid)
    {
        if (!box_) return;
        const Point& half = p.corner[7];
        const auto ask = [&](int axis, const Number& from, const Number& to, const Number& h) {
            const bool above = at_most(h, from) || at_most(h, to),
                       below = at_most(from, -h) || at_most(to, -h);
            sides_[axis][0] = below;
            sides_[axis][1] = above;
        };
        ask(0, a.x, b.x, half.x);
        ask(1, a.y, b.y, half.y);
        ask(2, a.z, b.z, half.z);
    }
    /// A corner's number says on which side of each axis it lies.
    bool corner(int k) const { return on(k, 7); }
    bool edge(const Polytope& p, int i) const { return on(p.edge[i][0], 7 ^ (p.edge[i][0] ^ p.edge[i][1])); }
    bool face(const Polytope& p, int i) const { return on(p.face[i][0], 7 ^ (p.face[i][0] ^ p.face[i][2])); }

private:
    bool on(int corner, int axes) const
    {
        if (!box_) return true;
        for (int axis = 0; axis < 3; ++axis)
            if (((axes >> axis) & 1) != 0 && !sides_[axis][(corner >> axis) & 1]) return false;
        return true;
    }
    bool box_;
    bool sides_[3][2] = {};
};

bool holds(const Polytope& box, const Point& p)
{
    const Point& half = box.corner[7];
    return at_most(p.x, half.x) && at_most(-p.x, half.x) && at_most(p.y, half.y) && at_most(-p.y, half.y) &&
           at_most(p.z, half.z) && at_most(-p.z, half.z);
}

double ball_entry(const Point& centre, const Path& path)
{
    const Point m = path.from - centre;
    const Number a = dot(path.by, path.by), b = dot(path.by, m), c = dot(m, m) - path.reach_squared;
    return root(b, c, b * b - a * c, Number(1));
}

double cylinder_entry(const Point& start, const Point& edge, const Path& path)
{
    const Point m = path.from - start, outward = cross(edge, m), drift = cross(edge, path.by);
    const Number length_squared = dot(edge, edge), triple = dot(m, drift);
    const Number c = dot(outward, outward) - path.reach_squared * length_squared;
    const Number discriminant = path.reach_squared * dot(drift, drift) - triple * triple;
    return root(dot(outward, drift), c, discriminant, length_squared);
}

double slab_entry(const Face& face, const Path& path)
{
    const Number height = dot(face.normal, path.from - face.corner[0]), rate = dot(face.normal, path.by);
    return descent(height, path.reach_squared * dot(face.normal, face.normal),
                   height.sign() > 0 ? -rate : rate);
}

} // namespace

Point point(const Vec3& v, int shift)
{
    const V3 c = load(v);
    return {Number(c.x, shift), Number(c.y, shift), Number(c.z, shift)};
}

Polytope polytope(const Point& a)
{
    Polytope out;
    out.corner[out.corners++] = a;
    return out;
}

Polytope polytope(const Point& a, const Point& b)
{
    Polytope out = polytope(a);
    out.corner[out.corners++] = b;
    out.edge[out.edges][0] = 0;
    out.edge[out.edges++][1] = 1;
    return out;
}

namespace {

/// The corners in turn as one face.
Polytope polygon(std::initializer_list<const Point*> corners)
{
    Polytope out;
    out.faces = 1;
    out.edges = out.face_corners = static_cast<int>(corners.size());
    for (const Point* corner : corners) {
        const int k = out.corners++;
        out.corner[k] = *corner;
        out.face[0][k] = out.edge[k][0] = static_cast<signed char>(k);
        out.edge[k][1] = static_cast<signed char>((k + 1) % out.edges);
    }
    return out;
}

} // namespace

Polytope polytope(const Point& a, const Point& b, const Point& c) { return polygon({&a, &b, &c}); }
Polytope polytope(const Point& a, const Point& b, const Point& c, const Point& d)
{
    return polygon({&a, &b, &c, &d});
}

Polytope box(const Point& half)
{
    Polytope out;
    out.solid = true;
    for (int k = 0; k < 8; ++k) {
        const int bit[] = {k & 1, k & 2, k & 4};
        out.corner[out.corners++] = {bit[0] ? half.x : -half.x, bit[1] ? half.y : -half.y,
                                     bit[2] ? half.z : -half.z};
        for (int axis = 0; axis < 3; ++axis) {
            if (bit[axis]) continue;
            out.edge[out.edges][0] = static_cast<signed char>(k);
            out.edge[out.edges++][1] = static_cast<signed char>(k | 1 << axis);
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
        for (const int base : {0, 1 << axis}) {
            const int loop[] = {base, base | u, base | u | v, base | v};
            for (int k = 0; k < 4; ++k)
                out.face[out.faces][k] = static_cast<signed char>(loop[k]);
            ++out.faces;
        }
    }
    return out;
}

bool meets(const Polytope& p, const Path& path, const Number& time)
{
    const Point by = time * path.by, end = path.from + by;
    if (p.solid && holds(p, path.from)) return true;
    if (p.edges == 0) return within(p.corner[0], path.from, by, dot(by, by), path.reach_squared);
    const Beyond beyond(p, path.from, end);
    for (int i = 0; i < p.faces; ++i)
        if (beyond.face(p, i) && touches(face_of(p, i), path.from, end, path.reach_squared)) return true;
    for (int i = 0; i < p.edges; ++i)
        if (beyond.edge(p, i) &&
            within(path.from, by, p.corner[p.edge[i][0]], p.edge_vector(i), path.reach_squared))
            return true;
    return false;
}

EntryTimes entry_times(const Polytope& p, const Path& path)
{
    EntryTimes out;
    const Beyond beyond(p, path.from, path.from + path.by);
    const auto add = [&](double t) {
        if (t < infinity) out.t[out.count++] = t;
    };
    for (int i = 0; i < p.corners; ++i)
        if (beyond.corner(i)) add(ball_entry(p.corner[i], path));
    for (int i = 0; i < p.edges; ++i)
        if (beyond.edge(p, i)) add(cylinder_entry(p.corner[p.edge[i][0]], p.edge_vector(i), path));
    for (int i = 0; i < p.faces; ++i)
        if (beyond.face(p, i)) add(slab_entry(face_of(p, i), path));
    return out;
}

} // namespace brink::exact
