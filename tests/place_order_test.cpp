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

/// Every third bit of a place on the curve, from the first on.
std::uint32_t cell_along(std::uint32_t place, int axis)
{
    std::uint32_t cell = 0;
    for (int bit = 0; bit < 10; ++bit)
        cell |= (place >> (3 * bit + axis) & 1U) << bit;
    return cell;
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

bool is_stably_sorted(const PlaceSorting& s)
{
    return std::is_sorted(s.keys.begin(), s.keys.end(), [](const auto& x, const auto& y) {
        return x.place != y.place ? x.place < y.place : x.slot < y.slot;
    });
}

/// Pairs of neighbours along the curve of which one lies farther along an axis but in an earlier cell.
int disordered(const PlaceSorting& s, const std::vector<Vec3>& places)
{
    int wrong = 0;
    for (int axis = 0; axis < 3; ++axis) {
        std::vector<std::pair<double, std::uint32_t>> along;
        for (const auto& k : s.keys)
            along.emplace_back(places[k.slot][axis], cell_along(k.place, axis));
        std::sort(along.begin(), along.end());
        for (std::size_t i = 1; i < along.size(); ++i)
            wrong += along[i].second < along[i - 1].second;
    }
    return wrong;
}

double length_of_tour(const PlaceSorting& s, const std::vector<Vec3>& places)
{
    double sum = 0;
    for (std::size_t i = 1; i < s.keys.size(); ++i)
        sum += (places[s.keys[i].slot] - places[s.keys[i - 1].slot]).norm();
    return sum;
}

} // namespace

TEST_CASE("sort_by_place: a permutation along the curve, near each other what lies near")
{
    Random random(4);
    for (const std::size_t n : {0U, 1U, 2U, 255U, 256U, 257U, 6000U}) {
        std::vector<Vec3> places;
        const Vec3 far = random.in_cube(1e6);
        for (std::size_t i = 0; i < n; ++i)
            places.push_back(far + random.in_cube(50));
        const PlaceSorting s = sorted(store_of(places));
        CAPTURE(n);
        CHECK(s.keys.size() == n);
        CHECK(is_permutation(s));
        CHECK(is_stably_sorted(s));
        CHECK(disordered(s, places) == 0);
        if (n < 6000) continue;
        // 6000 points in this cube have neighbours at about 3, and random ones are 66 apart.
        CHECK(length_of_tour(s, places) < 9.0 * static_cast<double>(n));
        int cells = 0;
        for (std::size_t i = 1; i < n; ++i)
            cells += s.keys[i].place != s.keys[i - 1].place;
        CHECK(cells > 5'900);
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
    CHECK(is_stably_sorted(s));
    CHECK(disordered(s, places) == 0);
    int cells = 0;
    for (std::size_t i = 1; i < s.keys.size(); ++i)
        cells += s.keys[i].place != s.keys[i - 1].place;
    CHECK(cells > 2'900);
}

TEST_CASE("sort_by_place: all at one point, or all beyond what is culled, stay in their order")
{
    for (const double at : {0.0, 3.0, 1e300}) {
        const PlaceSorting s = sorted(store_of(std::vector<Vec3>(1000, Vec3(at, -at, at))));
        CHECK(is_permutation(s));
        CHECK(is_stably_sorted(s));
        CHECK(s.keys.front().place == s.keys.back().place);
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
