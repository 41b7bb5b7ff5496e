// SPDX-License-Identifier: BSD-3-Clause
#include "random.h"
#include "validity.h"

#include <doctest/doctest.h>

using namespace brink;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double largest = std::numeric_limits<double>::max();
constexpr double bad_numbers[] = {not_a_number, infinity, -infinity};

/// A variant that lost its value to an exception while it was assigned.
Shape valueless()
{
    struct Thrower {
        operator Box() const { throw 1; } // NOLINT(google-explicit-constructor)
    };
    Shape shape = Sphere{1};
    try {
        shape.emplace<Box>(Thrower{});
    } catch (int) {
    }
    return shape;
}

} // namespace

TEST_CASE("validity: defaults, zero sizes and the largest numbers are valid")
{
    CHECK(valid(Sphere{}));
    CHECK(valid(Capsule{}));
    CHECK(valid(Box{}));
    CHECK(valid(Triangle{}));
    CHECK(valid(Plane{}));
    CHECK(valid(HalfSpace{}));
    CHECK(valid(Pose{}));
    CHECK(valid(Sphere{largest}));
    CHECK(valid(Box{{largest, largest, largest}}));
    CHECK(valid(Capsule{{largest, -largest, largest}, {-largest, largest, 0}, largest}));
    CHECK(valid(Plane{{0, 0, 1}, -largest}));
}

TEST_CASE("validity: any number that is not finite, in any place")
{
    for (const double bad : bad_numbers) {
        CHECK(!valid(Sphere{bad}));
        CHECK(!valid(Capsule{{0, 0, 0}, {1, 1, 1}, bad}));
        CHECK(!valid(Plane{{0, 0, 1}, bad}));
        CHECK(!valid(HalfSpace{{0, 0, 1}, bad}));
        for (int k = 0; k < 3; ++k) {
            Vec3 v(0, 0, 0);
            v[k] = bad;
            CHECK(!valid(Capsule{v, {1, 1, 1}, 1}));
            CHECK(!valid(Capsule{{1, 1, 1}, v, 1}));
            CHECK(!valid(Box{v}));
            CHECK(!valid(Triangle{v, {1, 0, 0}, {0, 1, 0}}));
            CHECK(!valid(Triangle{{1, 0, 0}, v, {0, 1, 0}}));
            CHECK(!valid(Triangle{{1, 0, 0}, {0, 1, 0}, v}));
            CHECK(!valid(Plane{v, 0}));
            CHECK(!valid(HalfSpace{v, 0}));
            CHECK(!valid(Pose{v, Quat(1, 0, 0, 0)}));
            CHECK(!valid(Shape{Sphere{1}}, Pose{v, Quat(1, 0, 0, 0)}));
        }
        for (int k = 0; k < 4; ++k) {
            Quat q(1, 0, 0, 0);
            q.coeffs()[k] = bad;
            CHECK(!valid(Pose{{0, 0, 0}, q}));
        }
    }
}

TEST_CASE("validity: negative sizes")
{
    CHECK(!valid(Sphere{-1e-300}));
    CHECK(!valid(Capsule{{0, 0, 0}, {1, 1, 1}, -1}));
    CHECK(!valid(Box{{-1, 1, 1}}));
    CHECK(!valid(Box{{1, -1, 1}}));
    CHECK(!valid(Box{{1, 1, -1}}));
    CHECK(valid(Sphere{-0.0}));
}

TEST_CASE("validity: a normal or quaternion may be off unit by a millionth in its square")
{
    for (const double off : {-0.9e-6, 0.9e-6}) {
        CHECK(valid(Plane{{0, 0, std::sqrt(1 + off)}, 0}));
        CHECK(valid(HalfSpace{{0, std::sqrt(1 + off), 0}, 0}));
        CHECK(valid(Pose{{0, 0, 0}, Quat(0, 0, std::sqrt(1 + off), 0)}));
    }
    for (const double off : {-1.1e-6, 1.1e-6, -1.0}) {
        CHECK(!valid(Plane{{0, 0, std::sqrt(1 + off)}, 0}));
        CHECK(!valid(HalfSpace{{0, std::sqrt(1 + off), 0}, 0}));
        CHECK(!valid(Pose{{0, 0, 0}, Quat(0, 0, std::sqrt(1 + off), 0)}));
    }
}

TEST_CASE("validity: what float engines pass is accepted")
{
    support::Random random(6);
    for (int i = 0; i < 10'000; ++i) {
        const Quat q = random.rotation();
        const Vec3 n = random.unit();
        CHECK(valid(Pose{{0, 0, 0}, q.cast<float>().cast<double>()}));
        CHECK(valid(Plane{n.cast<float>().cast<double>(), 0}));
    }
}

TEST_CASE("validity: a shape at a pose")
{
    const Pose garbled{{0, 0, 0}, Quat(not_a_number, 3, 0, 0)};
    CHECK(valid(Shape{Sphere{1}}, garbled)); // its orientation cannot matter
    CHECK(!valid(Shape{Box{{1, 1, 1}}}, garbled));
    CHECK(!valid(Shape{Plane{}}, garbled));
    CHECK(!valid(Shape{Sphere{-1}}, Pose{}));
    CHECK(valueless().valueless_by_exception());
    CHECK(!valid(valueless(), Pose{}));
}
