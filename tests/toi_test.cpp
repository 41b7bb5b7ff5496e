// SPDX-License-Identifier: BSD-3-Clause
#include "support/query.h"
#include "toi_query.h"

#include <doctest/doctest.h>

#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <sstream>

using namespace brink;

namespace {

using Ask = support::Query;
using Spoil = std::function<void(Ask&, double)>;

const double not_a_number = std::numeric_limits<double>::quiet_NaN();

Shape some(std::size_t index)
{
    const Shape shapes[] = {Sphere{1},
                            Capsule{Vec3(0, 0, -1), Vec3(0, 0, 1), 0.5},
                            Box{Vec3(1, 1, 1)},
                            Triangle{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                            Plane{},
                            HalfSpace{},
                            Cylinder{1, 0.5},
                            Cone{1, 0.5},
                            Ellipsoid{Vec3(1, 0.5, 0.75)},
                            Hull{}};
    return shapes[index];
}

Ask fine(const support::Pair& pair)
{
    Motion far;
    far.start.position = Vec3(0, 0, 9);
    far.translation = Vec3(0, 0, -9);
    far.rotation = Vec3(0.5, 0, 0);
    far.pivot = Vec3(0, 0.1, 0);
    return {some(pair.first),
            far,
            some(pair.second),
            Motion{.rotation = Vec3(0, 0.5, 0), .pivot = Vec3(0, 0, 0.1)},
            {}};
}

const Spoil spoil_number[] = {
    [](Ask& q, double x) { q.motion_a.start.position.y() = x; },
    [](Ask& q, double x) { q.motion_b.start.position.z() = x; },
    [](Ask& q, double x) { q.motion_a.start.orientation.w() = x; },
    [](Ask& q, double x) { q.motion_b.start.orientation.x() = x; },
    [](Ask& q, double x) { q.motion_a.translation.x() = x; },
    [](Ask& q, double x) { q.motion_b.rotation.y() = x; },
    [](Ask& q, double x) { q.motion_a.pivot.z() = x; },
    [](Ask& q, double x) { q.options.t_max = x; },
    [](Ask& q, double x) { q.options.target_gap = x; },
    [](Ask& q, double x) { q.options.tolerance = x; },
};

/// Every number of every shape.
const Spoil spoil_shape[] = {
    [](Ask& q, double x) {
        if (auto* s = std::get_if<Sphere>(&q.a)) s->radius = x;
    },
    [](Ask& q, double x) {
        if (auto* s = std::get_if<Capsule>(&q.a)) s->radius = x;
    },
    [](Ask& q, double x) {
        if (auto* s = std::get_if<Box>(&q.a)) s->half_extents.y() = x;
    },
};
const Spoil spoil_point[] = {
    [](Ask& q, double x) {
        if (auto* s = std::get_if<Capsule>(&q.a)) s->b.z() = x;
    },
    [](Ask& q, double x) {
        if (auto* s = std::get_if<Triangle>(&q.a)) s->c.x() = x;
    },
    [](Ask& q, double x) {
        if (auto* s = std::get_if<Plane>(&q.b)) s->offset = x;
    },
    [](Ask& q, double x) {
        if (auto* s = std::get_if<HalfSpace>(&q.b)) s->normal.x() = x;
    },
};

void check_invalid(const Ask& q)
{
    for (const Toi& toi : {time_of_impact(q.a, q.motion_a, q.b, q.motion_b, q.options),
                           time_of_impact(q.b, q.motion_b, q.a, q.motion_a, q.options)}) {
        CHECK(toi.status == Status::invalid);
        CHECK(toi.t == 0);
    }
}

bool same(const Shape& a, const Shape& b)
{
    return std::visit(
        [&](const auto& s) {
            return std::memcmp(&s, &std::get<std::decay_t<decltype(s)>>(b), sizeof s) == 0;
        },
        a);
}

} // namespace

TEST_CASE("time_of_impact: what is not a number or out of range is told")
{
    int asked = 0;
    for (const support::Pair& pair : support::all_pairs()) {
        const Ask good = fine(pair);
        CAPTURE(pair.name());
        const Status status = support::answer(good).status;
        CHECK((status == Status::invalid) == pair.unbounded());
        for (const double x : {not_a_number, infinity, -infinity}) {
            for (const Spoil& spoil : spoil_number) {
                Ask q = good;
                spoil(q, x);
                check_invalid(q);
            }
            for (const Spoil& spoil : spoil_point) {
                Ask q = good;
                spoil(q, x);
                if (same(q.a, good.a) && same(q.b, good.b)) continue;
                check_invalid(q);
                ++asked;
            }
        }
        for (const double x : {not_a_number, infinity, -1e-300, -1.0}) {
            for (const Spoil& spoil : spoil_shape) {
                Ask q = good;
                spoil(q, x);
                if (same(q.a, good.a)) continue;
                check_invalid(q);
                ++asked;
            }
        }
    }
    CHECK(asked > 50);
}

TEST_CASE(
    "time_of_impact: options, rotations, quaternions and normals just inside and just outside their range")
{
    for (const support::Pair& pair : support::all_pairs()) {
        if (pair.unbounded()) continue;
        const Ask good = fine(pair);
        CAPTURE(pair.name());
        const auto status = [&](const Spoil& spoil) {
            Ask q = good;
            spoil(q, 0);
            return support::answer(q).status;
        };
        CHECK(status([](Ask& q, double) { q.options.t_max = 1.0000001; }) == Status::invalid);
        CHECK(status([](Ask& q, double) { q.options.t_max = -1e-9; }) == Status::invalid);
        CHECK(status([](Ask& q, double) { q.options.t_max = 0; }) != Status::invalid);
        CHECK(status([](Ask& q, double) { q.options.target_gap = -1e-300; }) == Status::invalid);
        CHECK(status([](Ask& q, double) { q.options.tolerance = -1e-300; }) == Status::invalid);
        CHECK(status([](Ask& q, double) { q.options.tolerance = 0; }) != Status::invalid);
        CHECK(status([](Ask& q, double) { q.options.max_iterations = 0; }) == Status::invalid);
        CHECK(status([](Ask& q, double) { q.motion_a.rotation = Vec3(0x1.000001p20, 0, 0); }) ==
              Status::invalid);
        CHECK(status([](Ask& q, double) { q.motion_a.rotation = Vec3(0x1p20, 0, 0); }) != Status::invalid);
        CHECK(status([](Ask& q, double) { q.motion_a.start.orientation.w() = 1 + 1e-6; }) == Status::invalid);
        CHECK(status([](Ask& q, double) { q.motion_a.start.orientation.w() = 1 + 4e-7; }) != Status::invalid);
    }
}

TEST_CASE("time_of_impact: lengths whose products would overflow are never a miss and never late")
{
    for (const double size : {1e80, 1e160, 1e300, 1.7e308}) {
        const Motion a{.start = {Vec3(size, 0, 0), Quat(1, 0, 0, 0)}, .translation = Vec3(-size, 0, 0)};
        const Motion b{.start = {Vec3(-size, 0, 0), Quat(1, 0, 0, 0)}, .translation = Vec3(size, 0, 0)};
        for (std::size_t i = 0; i < 4; ++i) {
            const Toi toi = time_of_impact(Sphere{1}, a, some(i), b);
            CAPTURE(size);
            CHECK(toi.status != Status::separated);
            CHECK(toi.t <= 1);
        }
    }
}

TEST_CASE("the README's table of pairs is the library's own")
{
    std::ifstream readme(BRINK_SOURCE_DIR "/README.md");
    REQUIRE(readme);
    const std::map<Method, std::string> mark{{Method::closed_form, "exact"},
                                             {Method::direct, "direct"},
                                             {Method::advancement, "advance"},
                                             {Method::none, "-"}};
    std::size_t rows = 0;
    for (std::string line; std::getline(readme, line);) {
        std::istringstream cells(line);
        std::string first, name;
        std::getline(cells, first, '|');
        std::getline(cells, name, '|');
        std::erase(name, ' ');
        std::erase(name, '`');
        if (rows >= support::shape_names.size() || name != support::shape_names[rows]) continue;
        for (std::size_t column = 0; column < support::shape_names.size(); ++column) {
            std::string cell;
            std::getline(cells, cell, '|');
            std::erase(cell, ' ');
            CAPTURE(name);
            CAPTURE(column);
            CHECK(cell == mark.at(method(some(rows), some(column))));
        }
        ++rows;
    }
    CHECK(rows == support::shape_names.size());
}
