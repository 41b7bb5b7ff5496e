// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/pose.h>

#include <cmath>

/// Vectors of any number type: the referee does the same sums in long double, where that is enough to prove
/// something, and in 100 digits.
namespace brink::support {

template <class T> struct Vector {
    T x = 0, y = 0, z = 0;
};

template <class T> Vector<T> vector_of(const Vec3& v) { return {T(v.x()), T(v.y()), T(v.z())}; }
template <class T> Vector<T> operator+(const Vector<T>& a, const Vector<T>& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T> Vector<T> operator-(const Vector<T>& a, const Vector<T>& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T> Vector<T> operator-(const Vector<T>& a) { return {-a.x, -a.y, -a.z}; }
template <class T> Vector<T> operator*(const T& s, const Vector<T>& a) { return {s * a.x, s * a.y, s * a.z}; }
template <class T> T dot(const Vector<T>& a, const Vector<T>& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <class T> Vector<T> cross(const Vector<T>& a, const Vector<T>& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T> T norm(const Vector<T>& a)
{
    using std::sqrt;
    return sqrt(dot(a, a));
}

/// Columns of a 3 x 3 matrix.
template <class T> struct Matrix {
    Vector<T> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
};

template <class T> Vector<T> operator*(const Matrix<T>& m, const Vector<T>& v)
{
    return v.x * m.x + v.y * m.y + v.z * m.z;
}
template <class T> Matrix<T> operator*(const Matrix<T>& a, const Matrix<T>& b)
{
    return {a * b.x, a * b.y, a * b.z};
}
template <class T> Vector<T> transposed_times(const Matrix<T>& m, const Vector<T>& v)
{
    return {dot(m.x, v), dot(m.y, v), dot(m.z, v)};
}

/// The rotation M(q) / |q|^2 that a quaternion stands for.
template <class T> Matrix<T> rotation_of(const Quat& q)
{
    const T w = q.w(), x = q.x(), y = q.y(), z = q.z();
    const T s = 1 / T(w * w + x * x + y * y + z * z);
    const auto part = [&](const T& numerator) { return T(s * numerator); };
    return {{part(w * w + x * x - y * y - z * z), part(2 * (x * y + w * z)), part(2 * (x * z - w * y))},
            {part(2 * (x * y - w * z)), part(w * w - x * x + y * y - z * z), part(2 * (y * z + w * x))},
            {part(2 * (x * z + w * y)), part(2 * (y * z - w * x)), part(w * w - x * x - y * y + z * z)}};
}

/// exp([w]x): Rodrigues' formula, 1 - cos as 2 sin^2 of the half.
template <class T> Matrix<T> turn_by(const Vector<T>& w)
{
    using std::sin;
    const T angle = norm(w);
    if (angle == 0) return {};
    const Vector<T> axis = T(1 / angle) * w;
    const T s = sin(angle);
    const T h = sin(T(angle / 2));
    const auto column = [&](const Vector<T>& v) {
        const Vector<T> av = cross(axis, v);
        return v + s * av + T(2 * h * h) * cross(axis, av);
    };
    return {column({1, 0, 0}), column({0, 1, 0}), column({0, 0, 1})};
}

} // namespace brink::support
