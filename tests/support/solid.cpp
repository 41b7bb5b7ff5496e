// SPDX-License-Identifier: BSD-3-Clause
#include "solid.h"
#if BRINK_HAVE_REFEREE
#include "hundred.h"
#endif

namespace brink::support {
namespace {

/// The corners of a box: bit k of the index is the side along axis k.
template <class T> std::vector<Vector<T>> box_corners(const Vector<T>& half)
{
    std::vector<Vector<T>> out;
    for (unsigned i = 0; i < 8; ++i)
        out.push_back({(i & 1U) != 0 ? half.x : -half.x, (i & 2U) != 0 ? half.y : -half.y,
                       (i & 4U) != 0 ? half.z : -half.z});
    return out;
}

template <class T> Solid<T> described(const Sphere& s)
{
    Solid<T> out;
    out.radius = s.radius;
    out.corners = {{}};
    out.edges = {{0, 0}};
    return out;
}

template <class T> Solid<T> described(const Capsule& s)
{
    Solid<T> out;
    out.radius = s.radius;
    out.corners = {vector_of<T>(s.a), vector_of<T>(s.b)};
    out.edges = {{0, 1}};
    return out;
}

template <class T> Solid<T> described(const Triangle& s)
{
    Solid<T> out;
    out.corners = {vector_of<T>(s.a), vector_of<T>(s.b), vector_of<T>(s.c)};
    out.edges = {{0, 1}, {1, 2}, {2, 0}};
    out.faces = {{0, 1, 2, false}};
    return out;
}

template <class T> Solid<T> described(const Box& s)
{
    Solid<T> out;
    out.corners = box_corners(vector_of<T>(s.half_extents));
    for (std::size_t i = 0; i < 8; ++i)
        for (std::size_t axis = 1; axis < 8; axis *= 2)
            if ((i & axis) == 0) out.edges.push_back({i, i | axis});
    for (const std::size_t at : {std::size_t{0}, std::size_t{7}})
        for (std::size_t u = 1; u < 8; u *= 2)
            for (std::size_t v = 2 * u; v < 8; v *= 2)
                out.faces.push_back({at, at ^ u, at ^ v, true});
    return out;
}

template <class T> Solid<T> round(Core core, const T& half_length, const T& girth)
{
    Solid<T> out;
    out.core = core;
    out.half_length = half_length;
    out.girth = girth;
    out.corners = box_corners(Vector<T>{girth, girth, half_length});
    return out;
}

template <class T> Solid<T> described(const Cylinder& s)
{
    return round<T>(Core::cylinder, T(s.half_length), T(s.radius));
}

template <class T> Solid<T> described(const Cone& s)
{
    return round<T>(Core::cone, T(s.half_length), T(s.radius));
}

template <class T> Solid<T> described(const Ellipsoid& s)
{
    Solid<T> out;
    out.core = Core::ellipsoid;
    out.radii = vector_of<T>(s.radii);
    out.corners = box_corners(out.radii);
    return out;
}

template <class T> Solid<T> described(const Hull& s)
{
    Solid<T> out;
    out.core = Core::cloud;
    for (const Vec3& p : s.vertices())
        out.corners.push_back(vector_of<T>(p));
    return out;
}

template <class T, class Border> Solid<T> border(Core core, const Border& s)
{
    Solid<T> out;
    out.core = core;
    const Vector<T> n = vector_of<T>(s.normal);
    const T length = norm(n);
    out.normal = T(1 / length) * n;
    out.offset = s.offset / length;
    return out;
}

template <class T> Solid<T> described(const Plane& s) { return border<T>(Core::plane, s); }
template <class T> Solid<T> described(const HalfSpace& s) { return border<T>(Core::half_space, s); }

} // namespace

template <class T> Solid<T> solid(const Shape& shape)
{
    return std::visit([](const auto& s) { return described<T>(s); }, shape);
}

template <class T> Placement<T> placed(const Solid<T>& s, const Vector<T>& origin, const Matrix<T>& axes)
{
    Placement<T> out;
    out.solid = &s;
    out.origin = origin;
    out.axes = axes;
    if (s.unbounded()) {
        out.normal = axes * s.normal;
        out.offset = s.offset + dot(out.normal, origin);
    } else if (s.core == Core::polytope || s.core == Core::cloud) {
        out.corners.reserve(s.corners.size());
        for (const Vector<T>& corner : s.corners)
            out.corners.push_back(origin + axes * corner);
    }
    return out;
}

namespace {

template <class T> Vector<T> farthest(const std::vector<Vector<T>>& corners, const Vector<T>& n)
{
    std::size_t best = 0;
    T most = dot(n, corners[0]);
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const T along = dot(n, corners[i]);
        if (along <= most) continue;
        most = along;
        best = i;
    }
    return corners[best];
}

/// Of a disc about the z axis at height z; its centre where every point is as far.
template <class T> Vector<T> on_disc(const T& girth, const T& z, const Vector<T>& n)
{
    using std::sqrt;
    const T across = sqrt(T(n.x * n.x + n.y * n.y));
    if (across == 0) return {0, 0, z};
    const T s = girth / across;
    return {s * n.x, s * n.y, z};
}

template <class T> Vector<T> on_ellipsoid(const Vector<T>& radii, const Vector<T>& n)
{
    const Vector<T> grown{radii.x * n.x, radii.y * n.y, radii.z * n.z};
    const T length = norm(grown);
    if (length == 0) return {};
    const T s = 1 / length;
    return {s * radii.x * grown.x, s * radii.y * grown.y, s * radii.z * grown.z};
}

template <class T> Vector<T> local_support(const Solid<T>& s, const Vector<T>& n)
{
    if (s.core == Core::ellipsoid) return on_ellipsoid(s.radii, n);
    if (s.core == Core::cylinder) return on_disc(s.girth, n.z < 0 ? T(-s.half_length) : s.half_length, n);
    const Vector<T> apex{0, 0, s.half_length};
    const Vector<T> rim = on_disc(s.girth, T(-s.half_length), n);
    return dot(n, apex) >= dot(n, rim) ? apex : rim;
}

} // namespace

template <class T> Vector<T> Placement<T>::support(const Vector<T>& direction) const
{
    if (solid->core == Core::polytope || solid->core == Core::cloud) return farthest(corners, direction);
    return origin + axes * local_support(*solid, transposed_times(axes, direction));
}

template Solid<long double> solid(const Shape&);
template struct Placement<long double>;
template Placement<long double> placed(const Solid<long double>&, const Vector<long double>&,
                                       const Matrix<long double>&);
#if BRINK_HAVE_REFEREE
template Solid<Hundred> solid(const Shape&);
template struct Placement<Hundred>;
template Placement<Hundred> placed(const Solid<Hundred>&, const Vector<Hundred>&, const Matrix<Hundred>&);
#endif

} // namespace brink::support
