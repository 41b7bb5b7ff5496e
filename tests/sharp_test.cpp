// SPDX-License-Identifier: BSD-3-Clause
#include "sharp.h"

#include "dyadic.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace brink;
using support::Random;

namespace {

using Number = Dyadic<256>;
using Numbers = XYZ<Number>;

Numbers numbers(V3 v) { return {Number(v.x), Number(v.y), Number(v.z)}; }
double value(const Number& x)
{
    const Scaled s = x.rounded();
    return std::ldexp(s.mantissa, s.exponent);
}
/// a - b
double off(Pair a, const Number& b) { return value(Number(a.hi) + Number(a.lo) - b); }

constexpr double u = tolerance::unit_roundoff;

} // namespace

TEST_CASE("Pair: sums, products and roots within 4 u^2 of their terms, held against exact numbers")
{
    Random random(4);
    for (int i = 0; i < 50'000; ++i) {
        const double x = random.between(-1, 1), y = random.between(-1, 1);
        const double x_low = random.between(-u, u), y_low = random.between(-u, u);
        const Pair a{x, x_low}, b{y, y_low};
        const Number p = Number(x) + Number(x_low), q = Number(y) + Number(y_low);
        CHECK(std::fabs(off(a + b, p + q)) <= 4 * u * u * (std::fabs(x) + std::fabs(y)));
        CHECK(std::fabs(off(a * b, p * q)) <= 4 * u * u);
        const Pair square = a * a, root = square_root(square);
        const Pair back = root * root - square;
        CHECK(std::fabs(rounded(back)) <= 16 * u * u * x * x);
    }
    CHECK(rounded(square_root(Pair{})) == 0);
}

TEST_CASE("sharp::height: a sphere against a box, a triangle and a capsule within pair_slack")
{
    Random random(5);
    const Motion still;
    double most = 0;
    for (int i = 0; i < 2'000; ++i) {
        Motion motion_b, motion_a;
        motion_b.start.orientation = random.rotation();
        motion_b.start.position = random.in_cube(3);
        motion_a.start.position = random.in_cube(3);
        motion_a.translation = random.in_cube(5);
        const Vec3 a = random.in_cube(2), b = random.in_cube(2), c = random.in_cube(2), axis = random.unit();
        const V3 n = load(axis);
        const Approach m{load(motion_a.start.position) - load(motion_b.start.position),
                         load(motion_a.translation),
                         0,
                         1,
                         motion_a,
                         motion_b};
        const sharp::Height h = sharp::height(Sphere{}, Triangle{a, b, c}, m, n, {0});
        const WholeTurn<Number> turn(motion_b.start.orientation);
        const Numbers local = turn.into(numbers(n));
        Number most_of_b = dot(local, numbers(load(a)));
        for (const Vec3& corner : {b, c}) {
            const Number reach = dot(local, numbers(load(corner)));
            if ((reach - most_of_b).sign() > 0) most_of_b = reach;
        }
        const Numbers from = numbers(load(motion_a.start.position)) - numbers(load(motion_b.start.position));
        const Number exact = turn.norm_squared * dot(numbers(n), from) - most_of_b;
        most = std::fmax(most, std::fabs(off(h.above, exact)));
        const Number falls = -(turn.norm_squared * dot(numbers(n), numbers(load(motion_a.translation))));
        CHECK(std::fabs(off(h.rate, falls)) <= tolerance::pair_slack * 5);
        const sharp::Height edge = sharp::height(Sphere{}, Capsule{a, b, 0}, m, n, {0});
        CHECK(rounded(edge.above) >= rounded(h.above) - 1e-15); // fewer points reach less far
        const sharp::Height ball = sharp::height(Sphere{}, Box{Vec3(0, 0, 0)}, m, n, {0.5});
        CHECK(rounded(ball.above) == doctest::Approx(dot(n, m.from) - 0.5).epsilon(1e-14));
    }
    CHECK(most > 0);
    CHECK(most <= tolerance::pair_slack * 6); // lengths add up to 6 or more
}

TEST_CASE("sharp::fall: rounded down and up, and never for what rises")
{
    const sharp::Fall f = sharp::fall({1}, {3}, 0);
    CHECK(f.t < f.t_upper);
    CHECK((Number(f.t) * Number(3) - Number(1)).sign() < 0);
    CHECK((Number(f.t_upper) * Number(3) - Number(1)).sign() > 0);
    CHECK(f.t_upper - f.t <= 6 * 0x1p-54);
    CHECK(sharp::fall({1}, {-3}, 0).t == 0);
    CHECK(sharp::fall({1}, {0}, 0).t == 0);
}
