// SPDX-License-Identifier: BSD-3-Clause
#include "against_advancement.h"
#include "support/moving.h"
#include "support/random.h"

#include <brink/distance.h>

#include <array>
#include <vector>

using namespace brink;
using support::brackets;
using support::moving;
using support::near;
using support::Random;
using support::resting;

namespace {

const Box cube{Vec3(1, 1, 1)};
const Triangle triangle{Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0)};

Hull octahedron()
{
    return Hull::from_points(std::array<Vec3, 6>{Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, -1, 0),
                                                 Vec3(0, 0, 1), Vec3(0, 0, -1)});
}

Hull hull_of(const Box& box)
{
    std::vector<Vec3> corners;
    for (int k = 0; k < 8; ++k)
        corners.emplace_back((k & 1 ? 1 : -1) * box.half_extents.x(), (k & 2 ? 1 : -1) * box.half_extents.y(),
                             (k & 4 ? 1 : -1) * box.half_extents.z());
    return Hull::from_points(corners);
}

Hull hull_of(const Triangle& t) { return Hull::from_points(std::array<Vec3, 3>{t.a, t.b, t.c}); }

/// Corners anywhere, on a ball or on a coarse grid, which gives parallel faces; sometimes flat.
Hull draw_hull(Random& random)
{
    const int kind = random.index(4), count = 4 + random.index(28);
    const Vec3 size = 0.2 * Vec3(1, 1, 1) + random.in_cube(0.19);
    const double flat = random.chance(0.1) ? 0 : 1;
    std::vector<Vec3> points;
    for (int k = 0; k < count; ++k) {
        Vec3 point = kind == 0 ? random.in_cube(1) : random.unit();
        if (kind == 3)
            for (int i = 0; i < 3; ++i)
                point[i] = std::floor(2 * point[i] + 0.5) / 2;
        points.emplace_back(5 * size.x() * point.x(), 5 * size.y() * point.y(),
                            5 * flat * size.z() * point.z());
    }
    return Hull::from_points(points);
}

/// Towards the other one or past it.
support::Query draw_query(Random& random)
{
    const Quat turned_b = random.chance(0.3) ? Quat(1, 0, 0, 0) : random.rotation();
    const Quat turned_a = random.chance(0.2) ? turned_b : random.rotation();
    const Vec3 from = random.between(1.5, 6) * random.unit(), aim = random.in_cube(1.2);
    const double arrival = random.between(0.2, 1.2);
    const Shape a = draw_hull(random), b = draw_hull(random);
    const Vec3 base = random.chance(0.1) ? random.in_cube(1e6) : Vec3(0, 0, 0);
    support::Query q{a, moving(base + from, (aim - from) / arrival), b, resting(base), {}};
    q.motion_a.start.orientation = turned_a;
    q.motion_b.start.orientation = turned_b;
    if (random.chance(0.1)) q.options.t_max = random.between(0, 1);
    return q;
}

} // namespace

TEST_CASE("portal cast: a corner on a face, a face on a corner, sides swapped")
{
    const Shape spike = octahedron();
    const Toi down = time_of_impact(spike, moving(Vec3(0.25, 0.375, 5), Vec3(0, 0, -6)), cube, resting());
    CHECK(brackets(down, 0.5)); // 5 - 1 - 1 = 3
    CHECK(down.normal == Vec3(0, 0, -1));
    CHECK(near(down.point_b, Vec3(0.25, 0.375, 1)));
    CHECK(down.iterations == 0);
    const Toi swapped = time_of_impact(cube, resting(), spike, moving(Vec3(0.25, 0.375, 5), Vec3(0, 0, -6)));
    CHECK(swapped.t == down.t);
    CHECK(swapped.normal == -down.normal);
    const Toi on_spike = time_of_impact(cube, moving(Vec3(0.25, 0.375, 5), Vec3(0, 0, -6)), spike, resting());
    CHECK(brackets(on_spike, 0.5));
}

TEST_CASE("portal cast: crossed edges, and faces that are parallel")
{
    // Octahedra whose edges along (1, -1, 0) and (1, 1, 0) cross: |x| + |y| + |z| <= 1 each, the first turned
    // by 90 degrees about z has the same set, so faces meet: (x, y, z) . (1, 1, 1) <= 1 on both sides.
    const Shape spike = octahedron();
    const Toi faces = time_of_impact(spike, moving(Vec3(2, 2, 2), Vec3(-8, -8, -8) / 3), spike, resting());
    CHECK(faces.t <= 0.5); // 6 - 2 = 4 along (1, 1, 1), at 8
    CHECK(faces.t == doctest::Approx(0.5).epsilon(1e-8));
    const Triangle upright{Vec3(0, -1, 0), Vec3(0, 1, 0), Vec3(0, 0.25, 3)};
    const Triangle across{Vec3(-1, 0, 0), Vec3(1, 0, 0), Vec3(0.125, 0, -3)};
    const Toi edges = time_of_impact(upright, moving(Vec3(0.25, 0.25, 3), Vec3(0, 0, -6)), across, resting());
    CHECK(brackets(edges, 0.5));
    CHECK(near(edges.point_b, Vec3(0.25, 0, 0)));
    CHECK(near(edges.normal, Vec3(0, 0, -1)));
    CHECK(edges.iterations == 0);
}

TEST_CASE("portal cast: box and triangle, past an edge, through the face, resting")
{
    const auto ask = [](const Vec3& from, const Vec3& by) {
        return time_of_impact(cube, moving(from, by), triangle, resting());
    };
    CHECK(brackets(ask(Vec3(1.5, 1.375, 4), Vec3(0, 0, -6)), 0.5));
    CHECK(brackets(ask(Vec3(1.5, 1.375, -4), Vec3(0, 0, 6)), 0.5));
    CHECK(ask(Vec3(3.5, 3.5, 4), Vec3(0, 0, -6)).status == Status::separated);
    CHECK(ask(Vec3(1, 1, 1), Vec3(1, 0, 0)).status == Status::touching);
    CHECK(ask(Vec3(1, 1, 1.5), Vec3(5, 0, 0)).status == Status::separated);
    CHECK(ask(Vec3(1, 1, 4), Vec3(0, 0, 0)).status == Status::separated);
}

TEST_CASE("portal cast: boxes and triangles held against advancement and the reference")
{
    const tests::Held boxes = tests::hold_against_advancement({2, 3}, 20261122, 100'000, 20);
    CHECK(boxes.hits > 30'000);
    CHECK(boxes.separated > 30'000);
    CHECK(boxes.close > 100);
    CHECK(boxes.advanced < 40'000); // those with a target gap and flat ones among them
    const tests::Held triangles = tests::hold_against_advancement({3, 3}, 20261122, 100'000, 20);
    CHECK(triangles.hits > 20'000);
    CHECK(triangles.separated > 40'000);
    CHECK(triangles.close > 100);
    CHECK(triangles.advanced < 40'000);
}

TEST_CASE("portal cast: hulls with the corners of boxes and triangles are boxes and triangles")
{
    int compared = 0;
    for (const support::Pair& pair : {support::Pair{2, 2}, support::Pair{2, 3}, support::Pair{3, 3}})
        for (std::uint64_t index = 0; index < 20'000; ++index) {
            const support::Query q = query(pair, support::Family::translation, 5, index);
            support::Query hulls = q;
            const Box* box = std::get_if<Box>(&q.a);
            hulls.a = box ? hull_of(*box) : hull_of(std::get<Triangle>(q.a));
            if (index % 2 == 0)
                hulls.b = std::holds_alternative<Box>(q.b) ? hull_of(std::get<Box>(q.b))
                                                           : hull_of(std::get<Triangle>(q.b));
            const Toi toi = answer(q), other = answer(hulls);
            const support::GapOverTime motion(q);
            if (q.options.start_contact != StartContact::report) continue;
            const char* wrong = tests::contradiction(q, other, toi, motion);
            CAPTURE(index);
            CAPTURE(pair.name());
            if (wrong) FAIL_CHECK(wrong, "\n", support::as_cpp(q, support::in_words(other)));
            compared += other.status == Status::hit ? 1 : 0;
        }
    CHECK(compared > 15'000);
}

TEST_CASE("portal cast: hulls of many corners, held against advancement and distances")
{
    Random random(20261122);
    int hits = 0, misses = 0, advanced = 0;
    for (int i = 0; i < 50'000; ++i) {
        const support::Query q = draw_query(random);
        const Toi toi = answer(q), other = tests::advancement(q);
        CAPTURE(i);
        const bool far = q.motion_b.start.position.norm() > 1;
        const double scale = 16 + q.motion_a.translation.norm(); // positions within 6, corners within 4
        const double rounding = far ? 1e-8 : 16 * 0x1p-52 * scale;
        hits += toi.status == Status::hit ? 1 : 0;
        misses += toi.status == Status::separated ? 1 : 0;
        advanced += toi.iterations > 0 ? 1 : 0;
        if (toi.status == Status::separated && other.status == Status::hit) CHECK(other.gap > 0);
        if (toi.status != Status::hit) continue;
        CHECK(!(toi.t_upper < infinity && other.status == Status::separated));
        if (other.status == Status::hit) CHECK(other.t <= toi.t_upper + 1e-15);
        if (toi.iterations > 0) continue;
        const double gap = brink::distance(q.a, q.motion_a.at(toi.t), q.b, q.motion_b.at(toi.t)).gap;
        CHECK(gap <= rounding);
        CHECK(gap >= -rounding);
        const Pose before_a = q.motion_a.at(toi.t - 1e-3), before_b = q.motion_b.at(toi.t - 1e-3);
        CHECK(brink::distance(q.a, before_a, q.b, before_b).gap > gap - rounding);
    }
    CHECK(hits > 15'000);
    CHECK(misses > 10'000);
    CHECK(advanced < 10'000);
}
