// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/pose.h>

#include <boost/multiprecision/mpfr.hpp>

/// The referee's arithmetic: 200 decimal digits (MPFR), so that 100 are left after every cancellation that
/// doubles can bring about. A double converts exactly; exponents do not overflow.
namespace brink::support {

using Digits = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<200, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

/// Says whether everything computed in this thread since its construction (or a later one's) was exact.
class Watch {
public:
    Watch() { mpfr_clear_inexflag(); }
    bool exact() const { return mpfr_inexflag_p() == 0; }
};

struct Digits3 {
    Digits x = 0, y = 0, z = 0;
};

inline Digits3 digits3(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
inline Digits3 operator+(const Digits3& a, const Digits3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Digits3 operator-(const Digits3& a, const Digits3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Digits3 operator-(const Digits3& a) { return {-a.x, -a.y, -a.z}; }
inline Digits3 operator*(const Digits& s, const Digits3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Digits dot(const Digits3& a, const Digits3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Digits3 cross(const Digits3& a, const Digits3& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Digits norm(const Digits3& a) { return sqrt(dot(a, a)); }

/// Columns of a 3 x 3 matrix.
struct Digits33 {
    Digits3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
};

inline Digits3 operator*(const Digits33& m, const Digits3& v) { return v.x * m.x + v.y * m.y + v.z * m.z; }
inline Digits3 transposed_times(const Digits33& m, const Digits3& v)
{
    return {dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}

/// The rotation M(q) / |q|^2 that a quaternion stands for.
inline Digits33 rotation_in_digits(const Quat& q)
{
    const Digits w = q.w();
    const Digits x = q.x();
    const Digits y = q.y();
    const Digits z = q.z();
    const Digits s = w * w + x * x + y * y + z * z;
    const auto part = [&](const Digits& numerator) { return Digits(numerator / s); };
    return {{part(w * w + x * x - y * y - z * z), part(2 * (x * y + w * z)), part(2 * (x * z - w * y))},
            {part(2 * (x * y - w * z)), part(w * w - x * x + y * y - z * z), part(2 * (y * z + w * x))},
            {part(2 * (x * z + w * y)), part(2 * (y * z - w * x)), part(w * w - x * x - y * y + z * z)}};
}

} // namespace brink::support
