// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector.h"

namespace brink {

/// A quaternion's rotation times its squared norm, and that norm: sums of products of its components, without
/// a division. T is a number more exact than double, made from one by T{x}.
template <class T> struct WholeTurn {
    XYZ<T> x, y, z; // the images of the local axes
    T norm_squared;

    explicit WholeTurn(const Quat& q)
    {
        const double* c = q.coeffs().data();
        const T i{c[0]}, j{c[1]}, k{c[2]}, w{c[3]};
        const T ii = i * i, jj = j * j, kk = k * k, ww = w * w;
        const T ij = i * j, ik = i * k, jk = j * k, wi = w * i, wj = w * j, wk = w * k;
        const auto twice = [](const T& a) { return a + a; };
        x = {(ww - kk) + (ii - jj), twice(ij + wk), twice(ik - wj)};
        y = {twice(ij - wk), (ww - kk) - (ii - jj), twice(jk + wi)};
        z = {twice(ik + wj), twice(jk - wi), (ww + kk) - (ii + jj)};
        norm_squared = (ww + kk) + (ii + jj);
    }

    XYZ<T> operator*(const XYZ<T>& p) const { return p.x * x + p.y * y + p.z * z; }
    XYZ<T> into(const XYZ<T>& p) const { return {dot(x, p), dot(y, p), dot(z, p)}; }
};

} // namespace brink
