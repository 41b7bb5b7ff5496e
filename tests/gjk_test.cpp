// SPDX-License-Identifier: BSD-3-Clause
#include "brute_force.h"
#include "gjk.h"
#include "simplex.h"

#include <doctest/doctest.h>

using namespace brink;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr Core::Kind kinds[] = {Core::Kind::point, Core::Kind::segment, Core::Kind::triangle,
                                Core::Kind::box};

Simplex nearest_of(std::initializer_list<V3> points)
{
    Simplex s;
    for (const V3 p : points)
        s.add({p, {}, p, s.size, s.size, 0});
    s.reduce();
    return s;
}

double weight_sum(const Simplex& s)
{
    double sum = 0;
    for (int k = 0; k < s.size; ++k)
        sum += s.corners[k].weight;
    return sum;
}

} // namespace

TEST_CASE("simplex: the nearest point by corner, edge, face and volume")
{
    CHECK(nearest_of({{1, 2, 3}}).point() == V3{1, 2, 3});
    CHECK(nearest_of({{1, -1, 0}, {1, 3, 0}}).point() == V3{1, 0, 0});
    CHECK(nearest_of({{1, 1, 0}, {1, 3, 0}}).size == 1);

    const Simplex on_edge = nearest_of({{1, -1, 0}, {1, 1, 0}, {3, 0, 0}});
    CHECK(on_edge.size == 2);
    CHECK(on_edge.point() == V3{1, 0, 0});
    const Simplex on_face = nearest_of({{-1, -1, 2}, {3, -1, 2}, {-1, 3, 2}});
    CHECK(on_face.size == 3);
    CHECK(norm(on_face.point() - V3{0, 0, 2}) <= 4 * eps);

    CHECK(nearest_of({{-1, -1, -1}, {3, -1, -1}, {-1, 3, -1}, {-1, -1, 3}}).size == 4);
    const Simplex beside = nearest_of({{1, 0, 0}, {3, -1, -1}, {3, 2, -1}, {3, -1, 2}});
    CHECK(beside.point() == V3{1, 0, 0});
    CHECK(beside.size == 1);
}

TEST_CASE("simplex: degenerate ones keep their weights and get no farther")
{
    NastyCores draw(5);
    int flat = 0;
    for (int i = 0; i < 50'000; ++i) {
        const V3 p = draw.point(), q = draw.point(), far = draw.point();
        const double s = draw.random.between(-1, 2), little = draw.random.log_between(1e-18, 1);
        const int choice = draw.random.index(4);
        const V3 third = choice == 0 ? q : choice == 1 ? p + s * (q - p) : p + s * (q - p) + little * far;
        const V3 fourth = choice == 3 ? 0.5 * (p + third) : far;
        const Simplex least = nearest_of({p, q, third, fourth});
        CAPTURE(i);
        const double sum = weight_sum(least);
        CHECK((least.size == 4 || std::fabs(sum - 1) <= 4 * eps));
        for (int k = 0; k < least.size; ++k)
            CHECK(least.corners[k].weight >= 0);
        flat += choice < 2;
    }
    CHECK(flat > 20'000);
}

TEST_CASE("gjk: two boxes, by hand")
{
    const Core box = core(Box{{1, 1, 1}});
    const Closest c = gjk(box, placed(box, {}, {5, 0.5, 0}), {1e-14});
    CHECK(c.certain);
    CHECK(norm(c.v - V3{3, 0, 0}) <= 1e-14);
    CHECK(c.point_a.x == 1);
    CHECK(std::fabs(c.lower - 3) <= 1e-14);
    CHECK(!gjk(box, placed(box, {}, {0.5, 0.5, 0.25}), {1e-14}).certain); // they overlap
}

TEST_CASE("gjk: what it is certain of is so")
{
    NastyCores cores(99);
    int certain = 0, apart = 0;
    for (int i = 0; i < 16'000; ++i) {
        const auto [a, b] = cores.pair(kinds[i % 4], kinds[i / 4 % 4]);
        CAPTURE(i);
        const double scale = brute::scale(a, b), slack = 8 * eps * scale, rounding = 32 * eps * scale;
        const Closest c = gjk(a, b, {slack});
        const double truth = brute::distance(a, b);
        apart += truth > 1e-6 * scale;
        if (!c.certain) continue;
        CHECK(std::fabs(norm(c.v) - truth) <= rounding);
        CHECK(norm(c.v) - c.lower <= 2 * slack);
        CHECK(c.lower <= truth + rounding);
        CHECK(norm(c.v - norm(c.v) * c.normal) <= rounding);
        certain += truth > 1e-6 * scale;
    }
    CHECK(apart > 7'000);
    CHECK(certain > 0.98 * apart); // the long way round is for the few
}

TEST_CASE("gjk: begun from the corners of a neighbouring pose it gives the same distance")
{
    NastyCores cores(100);
    int same = 0;
    for (int i = 0; i < 16'000; ++i) {
        const auto [a, b] = cores.pair(kinds[i % 4], kinds[i / 4 % 4]);
        CAPTURE(i);
        const double scale = brute::scale(a, b), slack = 8 * eps * scale;
        const Closest cold = gjk(a, b, {slack});
        if (!cold.certain || cold.inside) continue;
        const V3 shift = 0.125 * norm(cold.v) * load(cores.random.unit());
        const Core moved = placed(b, {}, shift);
        Simplex corners = cold.simplex;
        for (int k = 0; k < corners.size; ++k) {
            corners.corners[k].on_b = corners.corners[k].on_b + shift;
            corners.corners[k].w = corners.corners[k].w + shift;
        }
        const Closest warm = gjk(a, moved, {slack}, corners), again = gjk(a, moved, {slack});
        if (!warm.certain || !again.certain) continue;
        CHECK(std::fabs(norm(warm.v) - norm(again.v)) <= 64 * eps * scale);
        ++same;
    }
    CHECK(same > 12'000);
}
