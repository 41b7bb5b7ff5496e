// SPDX-License-Identifier: BSD-3-Clause
#include "random.h"
#include "trig.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace brink;

namespace {

double ulps(long double truth, double value)
{
    const double size = std::fabs(static_cast<double>(truth));
    const long double ulp = std::nextafter(size, 2 * size + 1) - size;
    return static_cast<double>(std::fabs(truth - static_cast<long double>(value)) / ulp);
}

/// Angles of every size, and the doubles nearest to multiples of a quarter turn, where reduction is hardest.
double angle(support::Random& random)
{
    if (random.chance(0.3)) {
        const int turns = random.index(600'000), step = random.index(5);
        return turns * 1.5707963267948966 * (1 + (step - 2) * 0x1p-52);
    }
    if (random.chance(0.5)) return random.between(-0x1p20, 0x1p20);
    return random.log_between(1e-12, 10);
}

} // namespace

TEST_CASE("sin_cos: exact where it must be")
{
    CHECK(sin_cos(0).sin == 0);
    CHECK(sin_cos(0).cos == 1);
    CHECK(sin_cos(1e-9).sin == 1e-9);
}

TEST_CASE("sin_cos: within one ulp of long double for any angle allowed")
{
    support::Random random(3);
    double worst_sin = 0, worst_cos = 0;
    for (int i = 0; i < 1'000'000; ++i) {
        const double x = angle(random);
        const SinCos got = sin_cos(x);
        worst_sin = std::max(worst_sin, ulps(std::sin(static_cast<long double>(x)), got.sin));
        worst_cos = std::max(worst_cos, ulps(std::cos(static_cast<long double>(x)), got.cos));
    }
    CHECK(worst_sin <= 1);
    CHECK(worst_cos <= 1);
    CHECK(worst_sin > 0.5); // a measure that never sees an error measures nothing
}

TEST_CASE("sin_cos: of two angles at once, the bits of one at a time")
{
    support::Random random(5);
    int differing = 0;
    for (int i = 0; i < 100'000; ++i) {
        const double x = angle(random), y = i % 7 == 0 ? 0 : angle(random);
        const auto [first, second] = sin_cos(x, y);
        const SinCos of_x = sin_cos(x), of_y = sin_cos(y);
        if (first.sin != of_x.sin || first.cos != of_x.cos || second.sin != of_y.sin ||
            second.cos != of_y.cos)
            ++differing;
    }
    CHECK(differing == 0);
}

TEST_CASE("near_sin_cos: of two angles, within 3e-16 of long double")
{
    support::Random random(6);
    long double worst = 0;
    for (int i = 0; i < 500'000; ++i) {
        const double angles[2] = {angle(random), -angle(random)};
        const auto [sines, cosines] = near_sin_cos(Two{angles[0], angles[1]});
        for (int k = 0; k < 2; ++k) {
            const auto x = static_cast<long double>(angles[k]);
            worst = std::max({worst, std::fabs(std::sin(x) - static_cast<long double>(sines[k])),
                              std::fabs(std::cos(x) - static_cast<long double>(cosines[k]))});
        }
    }
    CHECK(worst <= 3e-16L);
    CHECK(worst > 1e-16L);
}

TEST_CASE("angle_of: the angle back from its sine and cosine")
{
    CHECK(angle_of({0, 1}) == 0);
    CHECK(angle_of({0, -1}) == 3.141592653589793);
    support::Random random(4);
    double worst = 0;
    for (int i = 0; i < 200'000; ++i) {
        const double x = random.chance(0.5) ? random.between(0, 3.1415) : random.log_between(1e-15, 1);
        const SinCos at = sin_cos(x);
        const long double truth =
            std::atan2(static_cast<long double>(at.sin), static_cast<long double>(at.cos));
        worst = std::max(worst, ulps(truth, angle_of(at)));
    }
    CHECK(worst <= 2);
}
