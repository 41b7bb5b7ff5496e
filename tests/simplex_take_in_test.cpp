// SPDX-License-Identifier: BSD-3-Clause
#include "simplices.h"

#include <doctest/doctest.h>

using namespace brink;
using namespace brink::simplices;

namespace {

/// One to three corners that their nearest point needs, and past them one that GJK would add.
Simplex with_newest(NastyCores& draw)
{
    for (;;) {
        Simplex s = simplex_of({draw.point(), draw.point(), draw.point()});
        s.size = draw.random.index(3) + 1;
        const int size = s.size;
        s.reduce();
        const V3 v = nearest_point(s), p = draw.point();
        const double little = draw.random.log_between(1e-16, 1);
        const V3 newest = draw.random.chance(0.3) ? s.corners[0].w + little * (p - s.corners[0].w) : p;
        if (s.size < size || !(norm(v) > 8 * eps * scale(s)) || !(dot(v, newest) < norm_squared(v))) continue;
        s.corners[size] = {newest, {}, newest, size, size, 1};
        return s;
    }
}

} // namespace

TEST_CASE("simplex: a newest corner is taken in with what the nearest point needs beside it, or left alone")
{
    NastyCores draw(8);
    int nearer[4] = {}, exact = 0, no_nearer = 0, needless = 0, inside = 0;
    for (int i = 0; i < 200'000; ++i) {
        const Simplex before = with_newest(draw);
        Simplex all = before, after = before;
        ++all.size;
        const Simplex::Corner newest = before.corners[before.size];
        const V3 was = nearest_point(before);
        V3 v = was;
        const Simplex::Taken taken = after.take_in(v);
        CAPTURE(i);
        const double rounding = 16 * eps * scale(all);
        const bool closed = all.size == 4 && depth(all) > 0;
        const Real truth = closed ? Real{0} : distance(all);
        inside += closed;
        if (closed && depth(all) > 1e-12 * scale(all)) CHECK(taken == Simplex::Taken::unclear);
        if (taken != Simplex::Taken::nearer) {
            CHECK(after.size == before.size);
            CHECK(v == was);
            for (int k = 0; k <= before.size; ++k)
                CHECK(after.corners[k].w == before.corners[k].w);
            if (taken == Simplex::Taken::no_nearer) CHECK(norm(was) <= truth + 1e-6 * scale(all));
            no_nearer += taken == Simplex::Taken::no_nearer;
            needless += taken == Simplex::Taken::unclear && !closed;
            continue;
        }
        CHECK(after.size <= 3);
        CHECK(after.contains(newest));
        for (int k = 0; k < after.size; ++k)
            CHECK(all.contains(after.corners[k]));
        CHECK(norm_squared(v) < norm_squared(was));
        CHECK(norm(v) >= truth - rounding);
        const bool true_to_rounding = norm(v) <= truth + rounding;
        if (!true_to_rounding) CHECK(norm(v) <= truth + 1e-6 * scale(all));
        exact += true_to_rounding;
        ++nearer[after.size];
        Simplex weighed = after;
        weighed.weigh_all();
        CHECK(std::fabs(weight_sum(weighed) - 1) <= 4 * eps);
        for (int k = 0; k < weighed.size; ++k)
            CHECK(weighed.corners[k].weight >= 0);
        if (true_to_rounding) CHECK(norm(weighed.point()) <= truth + 1e-6 * scale(all));
    }
    for (const int size : {1, 2, 3})
        CHECK(nearer[size] > 20'000);
    CHECK(inside > 4'000);
    CHECK(no_nearer > 100);
    CHECK(needless < 1'000);                                    // of these GJK has to ask all regions
    CHECK(exact > 0.999 * (nearer[1] + nearer[2] + nearer[3])); // needles lose digits
}
