// SPDX-License-Identifier: BSD-3-Clause
#include "brute_force.h"
#include "gjk.h"

#include <doctest/doctest.h>

using namespace brink;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();
constexpr Core::Kind kinds[] = {Core::Kind::point, Core::Kind::segment, Core::Kind::triangle,
                                Core::Kind::box};

} // namespace

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

TEST_CASE("gjk: of cores proven farther apart than asked the axis proves what it says")
{
    NastyCores cores(101);
    int proven = 0, near = 0;
    for (int i = 0; i < 16'000; ++i) {
        const auto [a, b] = cores.pair(kinds[i % 4], kinds[i / 4 % 4]);
        CAPTURE(i);
        const double scale = brute::scale(a, b), slack = 8 * eps * scale, rounding = 32 * eps * scale;
        const double truth = brute::distance(a, b), apart = cores.random.between(0, 1.5) * truth;
        const Closest c = gjk(a, b, {slack, 0.125, 0, apart});
        if (c.inside) continue;
        CHECK(c.lower <= truth + rounding);
        if (c.lower > apart) {
            CHECK(std::fabs(norm(c.normal) - 1) <= 4 * eps);
            CHECK(std::fabs(gap_along(a, b, c.normal) - c.lower) <= rounding);
            proven += c.certain ? 0 : 1;
        }
        if (c.certain) {
            CHECK(norm(c.v) - c.lower <= 2 * slack + 0.125 * norm(c.v));
            ++near;
        }
    }
    CHECK(proven > 5'000);
    CHECK(near > 3'000);
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
