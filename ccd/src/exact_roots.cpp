// SPDX-License-Identifier: BSD-3-Clause
#include "exact_polytope.h"

#include <utility>

namespace brink::exact {

namespace {

Scaled scaled(double mantissa, int exponent)
{
    int e = 0;
    const double m = std::frexp(mantissa, &e);
    return {m, exponent + e};
}
Scaled operator*(Scaled a, Scaled b) { return scaled(a.mantissa * b.mantissa, a.exponent + b.exponent); }
Scaled operator/(Scaled a, Scaled b) { return scaled(a.mantissa / b.mantissa, a.exponent - b.exponent); }
Scaled operator+(Scaled a, Scaled b)
{
    if (a.mantissa == 0) return b;
    if (b.mantissa == 0) return a;
    if (a.exponent < b.exponent) std::swap(a, b);
    return scaled(a.mantissa + std::ldexp(b.mantissa, b.exponent - a.exponent), a.exponent);
}
Scaled square_root(Scaled a)
{
    const int odd = a.exponent & 1;
    return scaled(std::sqrt(std::ldexp(a.mantissa, odd)), (a.exponent - odd) / 2);
}
Scaled magnitude(const Number& x)
{
    const Scaled s = x.rounded();
    return {std::fabs(s.mantissa), s.exponent};
}
double plain(Scaled a) { return std::ldexp(a.mantissa, a.exponent); }

} // namespace

double root(const Number& b, const Number& c, const Number& disc, const Number& factor)
{
    if (b.sign() >= 0 || c.sign() <= 0 || disc.sign() < 0) return infinity;
    return plain(magnitude(c) /
                 (square_root(magnitude(disc)) * square_root(magnitude(factor)) + magnitude(b)));
}

double descent(const Number& height, const Number& reach_squared, const Number& rate)
{
    const Number above = height * height - reach_squared;
    if (above.sign() <= 0 || rate.sign() <= 0) return infinity;
    return plain(magnitude(above) /
                 ((magnitude(height) + square_root(magnitude(reach_squared))) * magnitude(rate)));
}

} // namespace brink::exact
