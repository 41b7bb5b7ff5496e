// SPDX-License-Identifier: BSD-3-Clause
#include "exact.h"
#include "random.h"

#include <doctest/doctest.h>

using namespace brink;

namespace {

__extension__ using Quad =
    __float128; // 113 bits: sums and products of two doubles of like size are exact in it

double of_any_size(support::Random& random)
{
    const double sign = random.chance(0.5) ? 1 : -1;
    const double size = random.log_between(1e-12, 1e12);
    return sign * size;
}

} // namespace

TEST_CASE("two_sum: what rounding takes off the sum is the second part, exactly")
{
    CHECK(two_sum(1, 0x1p-60).hi == 1);
    CHECK(two_sum(1, 0x1p-60).lo == 0x1p-60);
    support::Random random(1);
    int inexact = 0;
    for (int i = 0; i < 100'000; ++i) {
        const double a = of_any_size(random), b = of_any_size(random);
        const Pair sum = two_sum(a, b), difference = two_difference(a, b);
        CHECK(Quad(sum.hi) + Quad(sum.lo) == Quad(a) + Quad(b));
        CHECK(Quad(difference.hi) + Quad(difference.lo) == Quad(a) - Quad(b));
        CHECK(sum.hi == a + b);
        inexact += sum.lo != 0;
    }
    CHECK(inexact > 50'000);
}

TEST_CASE("two_product: what rounding takes off the product is the second part, exactly")
{
    CHECK(two_product(1 + 0x1p-30, 1 - 0x1p-30).hi == 1);
    CHECK(two_product(1 + 0x1p-30, 1 - 0x1p-30).lo == -0x1p-60);
    support::Random random(2);
    int inexact = 0;
    for (int i = 0; i < 100'000; ++i) {
        const double a = of_any_size(random), b = of_any_size(random);
        const Pair product = two_product(a, b);
        CHECK(Quad(product.hi) + Quad(product.lo) == Quad(a) * Quad(b));
        CHECK(product.hi == a * b);
        inexact += product.lo != 0;
    }
    CHECK(inexact > 50'000);
}
