// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/pose.h>

#include <cmath>
#include <type_traits>

/// brink's own arithmetic. Eigen only stores and passes: its products use fused multiply-adds where the flags
/// allow, and its inline functions may be linked from a user's object file, so answers never pass through
/// them. Everything has internal linkage and a fixed order of operations.
namespace brink {

/// Three coordinates. T is double, or several doubles side by side.
template <class T> struct XYZ {
    T x{}, y{}, z{};
};
using V3 = XYZ<double>;

static inline V3 load(const Vec3& v) { return {v.data()[0], v.data()[1], v.data()[2]}; }
static inline Vec3 store(V3 v) { return {v.x, v.y, v.z}; }

template <class T> static inline XYZ<T> operator+(XYZ<T> a, XYZ<T> b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T> static inline XYZ<T> operator-(XYZ<T> a, XYZ<T> b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T> static inline XYZ<T> operator-(XYZ<T> a) { return {-a.x, -a.y, -a.z}; }
template <class T> static inline XYZ<T> operator*(std::type_identity_t<T> s, XYZ<T> a)
{
    return {s * a.x, s * a.y, s * a.z};
}
static inline bool operator==(V3 a, V3 b) { return a.x == b.x && a.y == b.y && a.z == b.z; }

template <class T> static inline T dot(XYZ<T> a, XYZ<T> b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <class T> static inline XYZ<T> cross(XYZ<T> a, XYZ<T> b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T> static inline T norm_squared(XYZ<T> a) { return dot(a, a); }
static inline double norm(V3 a) { return std::sqrt(dot(a, a)); }
static inline V3 magnitudes(V3 v) { return {std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)}; }
static inline double sum_of_magnitudes(V3 a) { return std::fabs(a.x) + std::fabs(a.y) + std::fabs(a.z); }

/// Zero times every coordinate: zero when all are finite, NaN otherwise. Sums of these test many numbers at
/// once.
static inline double finite_probe(V3 a) { return a.x * 0 + a.y * 0 + a.z * 0; }

/// The rotation M(q) / |q|^2, by columns: the images of the local axes.
struct Rotation {
    V3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
};

static inline V3 operator*(const Rotation& r, V3 v) { return v.x * r.x + v.y * r.y + v.z * r.z; }
/// The inverse rotation of v.
static inline V3 into(const Rotation& r, V3 v) { return {dot(r.x, v), dot(r.y, v), dot(r.z, v)}; }
static inline Rotation operator*(const Rotation& r, const Rotation& s) { return {r * s.x, r * s.y, r * s.z}; }

static inline Rotation rotation(const Quat& q)
{
    const double* c = q.coeffs().data(); // x, y, z, w
    const double x = c[0], y = c[1], z = c[2], w = c[3];
    const double s = 2 / (x * x + y * y + z * z + w * w);
    const double xx = s * x * x, yy = s * y * y, zz = s * z * z;
    const double xy = s * x * y, xz = s * x * z, yz = s * y * z;
    const double wx = s * w * x, wy = s * w * y, wz = s * w * z;
    return {{1 - (yy + zz), xy + wz, xz - wy},
            {xy - wz, 1 - (xx + zz), yz + wx},
            {xz + wy, yz - wx, 1 - (xx + yy)}};
}

/// Some unit vector at right angles to v (any unit vector when v is zero). v finite.
static inline V3 any_perpendicular(V3 v)
{
    const double ax = std::fabs(v.x), ay = std::fabs(v.y), az = std::fabs(v.z);
    const V3 p = ax <= ay && ax <= az ? V3{0, -v.z, v.y} : ay <= az ? V3{v.z, 0, -v.x} : V3{-v.y, v.x, 0};
    const double largest = std::fmax(std::fabs(p.x), std::fmax(std::fabs(p.y), std::fabs(p.z)));
    if (!(largest > 0)) return {1, 0, 0};
    const V3 scaled{p.x / largest, p.y / largest, p.z / largest};
    return (1 / norm(scaled)) * scaled;
}

} // namespace brink
