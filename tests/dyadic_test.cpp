// SPDX-License-Identifier: BSD-3-Clause
#include "dyadic.h"

#include "support/random.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

using namespace brink;
using support::Random;

namespace {

using Number = Dyadic<256>;

double value(const Number& x)
{
    const Scaled s = x.rounded();
    return std::ldexp(s.mantissa, s.exponent);
}

/// Of any magnitude a double can have, zero and subnormals among them.
double any(Random& random)
{
    if (random.chance(0.02)) return 0;
    const double sign = random.chance(0.5) ? -1 : 1;
    const double mantissa = random.between(1, 2);
    return sign * std::ldexp(mantissa, random.index(2098) - 1074);
}

} // namespace

TEST_CASE("Dyadic: every double is itself")
{
    Random random(1);
    for (const double x : {0.0, -0.0, 1.0, -1.0, 0x1p-1074, -0x1.fffffffffffffp-1023, 0x1p-1022,
                           std::numeric_limits<double>::max(), 0.1, 3.0})
        CHECK(value(Number(x)) == x);
    for (int i = 0; i < 100'000; ++i) {
        const double x = any(random);
        CHECK(value(Number(x)) == x);
        CHECK(Number(x).sign() == (x > 0) - (x < 0));
    }
    CHECK(value(Number(3, 2)) == 3 * 0x1p128);
}

TEST_CASE("Dyadic: 2^1000 + 2^-1000 - 2^1000 is 2^-1000")
{
    const Number big(0x1p1000), small(0x1p-1000);
    CHECK(value((big + small) - big) == 0x1p-1000);
    CHECK((big * small - Number(1)).sign() == 0);
    CHECK((big - big).sign() == 0);
    CHECK((small - big).sign() == -1);
    CHECK((-small).sign() == -1);
}

TEST_CASE("Dyadic: sums and products of whole numbers are those of 64-bit arithmetic")
{
    Random random(2);
    for (int i = 0; i < 100'000; ++i) {
        const auto a = static_cast<std::int64_t>(random.between(-0x1p30, 0x1p30));
        const auto b = static_cast<std::int64_t>(random.between(-0x1p30, 0x1p30));
        const Number x(static_cast<double>(a)), y(static_cast<double>(b));
        CHECK((x * y - Number(static_cast<double>(a * b / 1024)) * Number(1024) -
               Number(static_cast<double>(a * b % 1024)))
                  .sign() == 0);
        CHECK((x + y - Number(static_cast<double>(a + b))).sign() == 0);
        CHECK((x - y).sign() == (a > b) - (a < b));
    }
}

TEST_CASE("Dyadic: (a + b) (a - b) = a a - b b, and the laws of a ring, over all exponents")
{
    Random random(3);
    int near = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double x = any(random);
        const double y = random.chance(0.3) ? std::nextafter(x, 0) : any(random);
        const double z = any(random);
        const Number a(x), b(y), c(z);
        CHECK(((a + b) * (a - b) - (a * a - b * b)).sign() == 0);
        CHECK(((a + b) + c - (a + (b + c))).sign() == 0);
        CHECK((a * (b + c) - (a * b + a * c)).sign() == 0);
        CHECK(((a * b) * c - a * (b * c)).sign() == 0);
        CHECK((a - b).sign() == (x > y) - (x < y));
        near += x != 0 && std::fabs(x - y) < 0x1p-50 * std::fabs(x) ? 1 : 0;
    }
    CHECK(near > 4'000);
}

TEST_CASE("Dyadic: rounding drops less than 2 u")
{
    const Scaled s = (Number(1) + Number(0x1.8p-52) + Number(0x1p-300)).rounded();
    CHECK(s.mantissa == 1 + 0x1p-52);
    CHECK(s.exponent == 0);
}

TEST_CASE("Span: limbs reached over, and the shift that brings the largest near 1")
{
    Span none;
    none.add(0);
    CHECK(none.limbs() == 0);
    Span one;
    one.add(1.5);
    CHECK(one.limbs() == 2); // the last bit stands for 2^-52
    CHECK(one.shift() == 0);
    one.add(0x1p-1074);
    CHECK(one.limbs() == 18);
    one.add(0x1p1023);
    CHECK(one.limbs() == 33);
    CHECK(one.shift() == -15);
}
