// SPDX-License-Identifier: BSD-3-Clause
#include "body_store.h"

#include "support/draw.h"
#include "support/moving.h"
#include "support/random.h"
#include "valid_motion.h"

#include <brink/scene.h>

#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

using namespace brink;
using support::Random;

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// What is thrown, and nothing but std::invalid_argument.
template <class Act> std::string refusal(const Act& act)
{
    try {
        act();
    } catch (const std::invalid_argument& e) {
        return e.what();
    }
    return "";
}

std::string refusal(const Body& body)
{
    return refusal([&] { check(body, 3); });
}
std::string refusal_of(const Shape& shape) { return refusal(Body{shape}); }
std::string refusal_of(const Motion& motion) { return refusal(Body{Box{{1, 1, 1}}, motion}); }

void expect_size(const std::string& text, const char* field, const char* value)
{
    CHECK(text == std::string("brink::Scene: body 3: shape.") + field + " is " + value +
                      ": it must be finite and not negative");
}
void expect_finite(const std::string& text, const char* field, const char* value)
{
    CHECK(text == std::string("brink::Scene: body 3: ") + field + " is " + value + ": it must be finite");
}

} // namespace

TEST_CASE("scene checks: each field of each shape is named, with its value and the id")
{
    expect_size(refusal_of(Sphere{-1}), "radius", "-1");
    expect_size(refusal_of(Sphere{not_a_number}), "radius", "nan");
    expect_size(refusal_of(Sphere{infinity}), "radius", "inf");
    expect_size(refusal_of(Capsule{{0, 0, 0}, {0, 0, 0}, -0.5}), "radius", "-0.5");
    expect_finite(refusal_of(Capsule{{0, infinity, 0}, {0, 0, 0}, 1}), "shape.a", "(0, inf, 0)");
    expect_finite(refusal_of(Capsule{{0, 0, 0}, {0, 0, -infinity}, 1}), "shape.b", "(0, 0, -inf)");
    expect_size(refusal_of(Box{{1, 2, -3}}), "half_extents", "(1, 2, -3)");
    expect_finite(refusal_of(Triangle{{infinity, 0, 0}, {0, 0, 0}, {0, 0, 0}}), "shape.a", "(inf, 0, 0)");
    expect_finite(refusal_of(Triangle{{0, 0, 0}, {0, infinity, 0}, {0, 0, 0}}), "shape.b", "(0, inf, 0)");
    expect_finite(refusal_of(Triangle{{0, 0, 0}, {0, 0, 0}, {1, 2, infinity}}), "shape.c", "(1, 2, inf)");
    const std::string unit = ": it must be a unit vector", body = "brink::Scene: body 3: ";
    CHECK(refusal_of(Plane{{0, 0, 2}, 0}) == body + "shape.normal is (0, 0, 2)" + unit);
    CHECK(refusal_of(HalfSpace{{0, 0, 0}, 0}) == body + "shape.normal is (0, 0, 0)" + unit);
    expect_finite(refusal_of(Plane{{0, 0, 1}, infinity}), "shape.offset", "inf");
    expect_finite(refusal_of(HalfSpace{{0, 0, 1}, not_a_number}), "shape.offset", "nan");
    expect_size(refusal_of(Cylinder{-1, 1}), "half_length", "-1");
    expect_size(refusal_of(Cylinder{1, -0.25}), "radius", "-0.25");
    expect_size(refusal_of(Cone{infinity, 1}), "half_length", "inf");
    expect_size(refusal_of(Cone{1, -1e22}), "radius", "-1e+22"); // of seventeen digits, as many as it takes
    expect_size(refusal_of(Cone{1, -0.1}), "radius", "-0.10000000000000001");
    expect_size(refusal_of(Ellipsoid{{1, -1, 1}}), "radii", "(1, -1, 1)");
    CHECK(refusal_of(Hull{}).empty());
    CHECK(refusal_of(Sphere{0}).empty());
}

TEST_CASE("scene checks: each field of a motion is named, with its value and the id")
{
    const Vec3 bad(0, 0, infinity);
    Motion m;
    m.start.position = bad;
    expect_finite(refusal_of(m), "motion.start.position", "(0, 0, inf)");
    m = {};
    m.translation = bad;
    expect_finite(refusal_of(m), "motion.translation", "(0, 0, inf)");
    m = {};
    m.pivot = bad;
    expect_finite(refusal_of(m), "motion.pivot", "(0, 0, inf)");
    m = {};
    m.start.orientation = Quat(0.5, 0, 0, 0);
    CHECK(refusal_of(m) ==
          "brink::Scene: body 3: motion.start.orientation is (0.5, 0, 0, 0): it must be a unit quaternion");
    CHECK(refusal(Body{Sphere{1}, m}).empty()); // about its centre it has none
    m.pivot = Vec3(1, 0, 0);
    CHECK(!refusal(Body{Sphere{1}, m}).empty());
    m = {};
    m.rotation = Vec3(0x1p21, 0, 0);
    CHECK(refusal_of(m) ==
          "brink::Scene: body 3: motion.rotation is (2097152, 0, 0): it must be at most 2^20 radians");
    m.rotation = Vec3(0, not_a_number, 0);
    CHECK(refusal_of(m).find("motion.rotation is (0, nan, 0)") != std::string::npos);
}

TEST_CASE("scene checks: what rests must stand still, and a body must be in a group")
{
    Body body{Box{{1, 1, 1}}, support::moving({0, 0, 0}, {1, 0, 0})};
    CHECK(refusal(body).empty());
    body.immovable = true;
    CHECK(refusal(body) == "brink::Scene: body 3: motion.translation is (1, 0, 0): it must be zero, because "
                           "the body is immovable");
    body.immovable = false;
    body.asleep = true;
    body.motion.translation = Vec3(0, 0, 0);
    body.motion.rotation = Vec3(0, 0, 1);
    CHECK(refusal(body) == "brink::Scene: body 3: motion.rotation is (0, 0, 1): it must be zero, because the "
                           "body is asleep (wake it first)");
    CHECK(refusal({.category = 0}) == "brink::Scene: body 3: category is 0: it must have a bit set");
    CHECK(refusal({.mask = 0}).empty());
}

TEST_CASE("scene checks: each option is named, with its value")
{
    const auto of = [](const Options& pair) { return refusal([&] { check(SceneOptions{.pair = pair}); }); };
    const std::string pair = "brink::Scene: options.pair.", size = ": it must be finite and not negative";
    CHECK(of({.t_max = 1.5}) == pair + "t_max is 1.5: it must be in [0, 1]");
    CHECK(of({.t_max = not_a_number}) == pair + "t_max is nan: it must be in [0, 1]");
    CHECK(of({.target_gap = -1}) == pair + "target_gap is -1" + size);
    CHECK(of({.tolerance = infinity}) == pair + "tolerance is inf" + size);
    CHECK(of({.max_iterations = 0}) == pair + "max_iterations is 0: it must be at least 1");
    CHECK(of({.start_contact = static_cast<StartContact>(9)}) ==
          pair + "start_contact is 9: it must be one of StartContact");
    CHECK(of({.detail = static_cast<Detail>(7)}) == pair + "detail is 7: it must be one of Detail");
    CHECK(of({}).empty());
    CHECK(refusal([] { check(SceneOptions{.category = 0}); }) ==
          "brink::Scene: options.category is 0: it must have a bit set");
    CHECK(refusal([] { check(SceneOptions{.mask = 0}); }).empty());
    Scene scene;
    CHECK_THROWS_AS(scene.cast(Sphere{1}, {}, {.category = 0}), std::invalid_argument);
}

TEST_CASE("scene checks: casts and rays")
{
    CHECK(refusal([] { check_cast(Sphere{-2}, {}); }) ==
          "brink::Scene: cast: shape.radius is -2: it must be finite and not negative");
    CHECK(refusal([] {
              check_cast(Sphere{1}, support::moving({0, 0, 0}, {0, infinity, 0}));
          }) == "brink::Scene: cast: motion.translation is (0, inf, 0): it must be finite");
    CHECK(refusal([] {
              check_ray({infinity, 0, 0}, {1, 0, 0}, 1);
          }) == "brink::Scene: ray: origin is (inf, 0, 0): it must be finite");
    CHECK(refusal([] {
              check_ray({0, 0, 0}, {0, not_a_number, 0}, 1);
          }) == "brink::Scene: ray: direction is (0, nan, 0): it must be finite");
    CHECK(refusal([] {
              check_ray({0, 0, 0}, {1, 0, 0}, -1);
          }) == "brink::Scene: ray: t_max is -1: it must not be negative");
    CHECK(refusal([] {
              check_ray({0, 0, 0}, {1, 0, 0}, not_a_number);
          }) == "brink::Scene: ray: t_max is nan: it must not be negative");
    CHECK(refusal([] { check_ray({0, 0, 0}, {0, 0, 0}, infinity); }).empty());
}

namespace {

/// Any of a motion's or a box's numbers made something else.
void spoil(Random& random, Body& body)
{
    const double with[] = {not_a_number, infinity, -infinity, -1, 1e308, 1e200, 0x1p20, 5e-324};
    const double x = with[random.index(8)];
    auto& box = std::get<Box>(body.shape);
    Motion& m = body.motion;
    const int what = random.index(19), axis = what % 3;
    if (what < 3) box.half_extents[axis] = x;
    if (what >= 3 && what < 6) m.start.position[axis] = x;
    if (what >= 6 && what < 9) m.translation[axis] = x;
    if (what >= 9 && what < 12) m.rotation[axis] = x;
    if (what >= 12 && what < 15) m.pivot[axis] = x;
    if (what >= 15) m.start.orientation.coeffs()[what - 15] = x;
}

} // namespace

TEST_CASE("scene checks: what time_of_impact calls invalid is refused and nothing else is, and then nothing "
          "changes")
{
    Random random(5);
    int refused = 0, taken = 0;
    for (int i = 0; i < 5'000; ++i) {
        Body body{Box{{1, 2, 3}}, support::moving({0, 0, 0}, {1, 0, 0})};
        for (int k = random.index(3); k >= 0; --k)
            spoil(random, body);
        CAPTURE(i);
        const Toi toi = time_of_impact(body.shape, body.motion, Sphere{1}, support::resting());
        const bool bad = !refusal(body).empty();
        CHECK(bad == (toi.status == Status::invalid));
        CHECK(bad == !valid(body.shape, body.motion));
        ++(bad ? refused : taken);
    }
    CHECK(refused > 2'000);
    CHECK(taken > 500);
}

TEST_CASE("Scene: a change that is refused leaves it as it was")
{
    Scene scene;
    const BodyId a = scene.add({Sphere{1}}), b = scene.add({Sphere{2}, support::resting({9, 0, 0})});
    const BodyId gone = scene.add({Sphere{3}});
    scene.remove(gone);
    const Motion good = support::moving({1, 1, 1}, {1, 0, 0}),
                 bad = support::moving({0, 0, 0}, {infinity, 0, 0});
    const BodyId both[] = {a, b}, with_gone[] = {a, gone};
    const Motion one_bad[] = {good, bad}, two[] = {good, good};
    CHECK(refusal([&] { scene.set_motions(both, one_bad); }).find("body 1: motion.translation") !=
          std::string::npos);
    CHECK(refusal([&] { scene.set_motions(with_gone, two); }) ==
          "brink::Scene: there is no body 2: it was removed");
    CHECK(refusal([&] {
              scene.set_motions(both, {&good, 1});
          }) == "brink::Scene: 2 bodies and 1 motions: set_motions takes one for each");
    CHECK(refusal([&] { scene.replace(a, {Sphere{-1}}); }).find("body 0: shape.radius") != std::string::npos);
    CHECK(refusal([&] { scene.add({Sphere{-1}}); }).find("body 3: shape.radius") != std::string::npos);
    for (const BodyId id : {gone, BodyId{8}, no_body}) {
        CHECK(!refusal([&] { scene.remove(id); }).empty());
        CHECK(!refusal([&] { scene.sleep(id); }).empty());
        CHECK(!refusal([&] { scene.wake(id); }).empty());
        CHECK(!refusal([&] { static_cast<void>(scene.body(id)); }).empty());
        CHECK(!refusal([&] { static_cast<void>(scene.swept_bounds(id)); }).empty());
    }
    CHECK(scene.size() == 2);
    CHECK(scene.body(a).motion.translation == Vec3(0, 0, 0));
    CHECK(std::get<Sphere>(scene.body(a).shape).radius == 1);
    CHECK(scene.add({Sphere{1}}) == 3);
}
