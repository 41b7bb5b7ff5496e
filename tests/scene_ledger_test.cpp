// SPDX-License-Identifier: BSD-3-Clause
#include "moving.h"

#include <brink/scene.h>

#include <doctest/doctest.h>

#include <chrono>

using namespace brink;
using support::moving;

namespace {

Body at(const Shape& shape, const Vec3& position, const Vec3& translation = {0, 0, 0})
{
    return {shape, moving(position, translation)};
}

template <class Work> double seconds(const Work& work)
{
    const auto began = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
}

double told(const Ledger& l)
{
    return l.update_seconds + l.search_seconds + l.exact_seconds + l.order_seconds;
}

} // namespace

TEST_CASE("scene: the ledger tells where the time went")
{
    Scene scene;
    Body wall = at(Box{{0.5, 5, 5}}, {0.5, 0, 0});
    wall.immovable = true;
    scene.add(wall);
    for (int k = 0; k < 2000; ++k) {
        scene.add(at(Box{{0.4, 0.4, 0.4}}, {-1 - 1.25 * k, 0, 0}, {16, 0, 0}));
        scene.add(at(Plane{{0, 0, 1}, 0}, {0, 0, 10}));
    }
    scene.update();
    const double halts = seconds([&] { scene.safe_times(); });
    CHECK(told(scene.ledger()) > 0.5 * halts);
    CHECK(told(scene.ledger()) <= halts);
    CHECK(scene.ledger().again > 100);
    const double cast = seconds([&] { scene.cast_all(HalfSpace{}, moving({0, 0, -2}, {0, 0, -9})); });
    CHECK(told(scene.ledger()) > 0.5 * cast);
    CHECK(scene.ledger().exact == 2001);
    const double ray = seconds([&] { scene.ray_cast_all({0, 0, 0}, {0, 0, 20}); });
    CHECK(told(scene.ledger()) > 0.5 * ray);
    CHECK(scene.ledger().exact >= 2000);
}
