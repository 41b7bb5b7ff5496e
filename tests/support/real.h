// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/pose.h>

#include <array>
#include <cmath>

/// The reference's own arithmetic: x87 long double (64-bit mantissa), sharing nothing with brink.
namespace brink::support {

using Real = long double;

struct Real3 {
    Real x = 0, y = 0, z = 0;
};

inline Real3 real3(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
inline Vec3 rounded(const Real3& v)
{
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

inline Real3 operator+(const Real3& a, const Real3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Real3 operator-(const Real3& a, const Real3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Real3 operator-(const Real3& a) { return {-a.x, -a.y, -a.z}; }
inline Real3 operator*(Real s, const Real3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Real dot(const Real3& a, const Real3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Real3 cross(const Real3& a, const Real3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
/// Within 2^-62, for angles up to 2^20. The C library's own differ between versions, and queries are aimed
/// with it.
inline Real sine(Real angle)
{
    // pi/2 in parts of 33 bits: their products with the count of quarter turns are exact.
    const Real quarters = std::floor(angle * 0.636619772367581343075535L + 0.5L);
    Real r = angle - quarters * 0x1.921fb544p+0L;
    r = r - quarters * 0x1.0b4611a6p-34L;
    r = r - quarters * 0x1.3198a2ep-69L;
    const auto quarter = static_cast<long long>(quarters) & 3;
    const bool odd = (quarter & 1) != 0;
    Real series = 1; // Taylor's, the last term first
    for (int k = odd ? 22 : 23; k >= 2; k -= 2)
        series = 1 - r * r * series / static_cast<Real>(k * (k - 1));
    const Real value = odd ? series : r * series;
    return quarter >= 2 ? -value : value;
}
inline Real norm(const Real3& a) { return std::sqrt(dot(a, a)); }

/// Zero for a zero vector.
inline Real3 direction(const Real3& a)
{
    const Real length = norm(a);
    return length > 0 ? (1 / length) * a : Real3{};
}

/// Columns of a 3 x 3 matrix.
struct Real33 {
    Real3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
};

inline Real3 operator*(const Real33& m, const Real3& v) { return v.x * m.x + v.y * m.y + v.z * m.z; }
inline Real33 operator*(const Real33& a, const Real33& b) { return {a * b.x, a * b.y, a * b.z}; }
inline Real3 transposed_times(const Real33& m, const Real3& v)
{
    return {dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}

} // namespace brink::support
