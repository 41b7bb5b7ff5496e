// SPDX-License-Identifier: BSD-3-Clause
#include "place_order.h"

#include "support/moving.h"
#include "support/random.h"

#include <doctest/doctest.h>

#include <algorithm>

using namespace brink;
using support::Random;

namespace {

BodyStore store_of(const std::vector<Vec3>& places)
{
    BodyStore store;
    for (const Vec3& at : places)
        store.add({Sphere{1}, support::resting(at)});
    return store;
}

PlaceSorting sorted(const BodyStore& store)
{
    PlaceSorting sorting;
    for (std::uint32_t slot = 0; slot < store.bodies.size(); ++slot)
        sorting.keys.push_back({0, slot});
    sort_by_place(sorting, store);
    return sorting;
}

bool is_permutation(const PlaceSorting& s)
{
    std::vector<char> seen(s.keys.size());
    for (const auto& k : s.keys) {
        if (k.slot >= seen.size() || seen[k.slot] != 0) return false;
        seen[k.slot] = 1;
    }
    return true;
}

/// The bounds of sixteen after the other: half of their surfaces, those beyond `far` left out.
double surfaces(const PlaceSorting& s, const std::vector<Vec3>& places, double far)
{
    double sum = 0;
    for (std::size_t i = 0; i + 16 <= s.keys.size(); i += 16) {
        Vec3 low = places[s.keys[i].slot], high = low;
        for (std::size_t k = i; k < i + 16; ++k) {
            low = low.cwiseMin(places[s.keys[k].slot]);
            high = high.cwiseMax(places[s.keys[k].slot]);
        }
        const Vec3 d = high - low;
        if (d.norm() < far) sum += d.x() * d.y() + d.y() * d.z() + d.z() * d.x();
    }
    return sum;
}

/// The same of as many cubes that fill a cube of this edge.
double ideal(std::size_t n, double edge)
{
    const double leaves = static_cast<double>(n / 16), side = edge / std::cbrt(leaves);
    return 3 * leaves * side * side;
}

} // namespace

TEST_CASE("sort_by_place: a permutation in which sixteen after the other lie close together")
{
    Random random(4);
    for (const std::size_t n : {0U, 1U, 2U, 17U, 255U, 256U, 257U, 4096U, 6000U, 9000U}) {
        std::vector<Vec3> places;
        const Vec3 far = random.in_cube(1e6);
        for (std::size_t i = 0; i < n; ++i)
            places.push_back(far + random.in_cube(50));
        const PlaceSorting s = sorted(store_of(places));
        CAPTURE(n);
        CHECK(s.keys.size() == n);
        CHECK(is_permutation(s));
        if (n > 4000) CHECK(surfaces(s, places, 1e9) < 1.1 * ideal(n, 100));
    }
}

TEST_CASE("sort_by_place: outliers take no room from the others")
{
    Random random(5);
    std::vector<Vec3> places;
    for (int i = 0; i < 3000; ++i)
        places.push_back(random.in_cube(1));
    for (std::size_t i = 10; i < 3000; i += 500) {
        const Vec3 away = random.unit();
        places[i] = 1e300 * away;
    }
    for (const std::size_t i : {0U, 1200U, 2400U}) // where a sample of 256 looks
        places[i] = Vec3(1e9, -1e9, 1e9);
    const PlaceSorting s = sorted(store_of(places));
    CHECK(is_permutation(s));
    CHECK(surfaces(s, places, 100) < 1.2 * ideal(3000, 2));
}

TEST_CASE("sort_by_place: all at one point, or all beyond what is culled")
{
    for (const double at : {0.0, 3.0, 1e300}) {
        const PlaceSorting s = sorted(store_of(std::vector<Vec3>(1000, Vec3(at, -at, at))));
        CHECK(is_permutation(s));
    }
}

TEST_CASE("sort_by_place: by where the pivot is half way")
{
    BodyStore store;
    for (int i = 0; i < 3; ++i) { // start at 0, -10, -20 and end at 0, 30, 60
        Motion m = support::moving({-10.0 * i, 0, 0}, {40.0 * i, 0, 0});
        m.pivot = Vec3(0, 0, 1);
        store.add({Sphere{1}, m});
    }
    const PlaceSorting s = sorted(store);
    CHECK(s.keys[0].slot == 0);
    CHECK(s.keys[2].slot == 2);
}

TEST_CASE("origin_for: amid the scene, and the present one while it will do")
{
    Random random(6);
    std::vector<Vec3> places;
    for (int i = 0; i < 1000; ++i)
        places.push_back(Vec3(1e8, 0, -2e8) + random.in_cube(10));
    places[17] = Vec3(1e300, 1e300, 1e300);
    BodyStore store = store_of(places);
    const V3 origin = origin_for(store, {});
    CHECK(origin.x == doctest::Approx(1e8).epsilon(1e-7));
    CHECK(origin.z == doctest::Approx(-2e8).epsilon(1e-7));
    CHECK(std::fabs(origin.y) < 10);
    CHECK(origin_for(store, origin) == origin);
    CHECK(origin_for(store, origin + V3{100, 0, 0}) == origin + V3{100, 0, 0});
    for (std::uint32_t slot = 0; slot < 1000; ++slot) // who is gone does not count
        if (slot != 500) store.remove(slot);
    CHECK(origin_for(store, {}) == load(places[500]));
    CHECK(origin_for(store_of({Vec3(0, 0, 0)}), {1e8, 0, 0}) == V3{});
    CHECK(origin_for(BodyStore{}, {1, 2, 3}) == V3{1, 2, 3});
    CHECK(origin_for(store_of({Vec3(1e300, 0, 0)}), {}) == V3{});
}
