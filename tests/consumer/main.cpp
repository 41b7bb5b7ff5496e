// SPDX-License-Identifier: BSD-3-Clause
// A stranger's program: asks brink, FCL and libccd about the same two spheres and exits with 1 on a wrong
// answer.
#include "batch.h"

#include <array>
#include <cmath>
#include <cstdio>

#ifdef WITH_RIVALS
double fcl_gap(double radius_a, double radius_b, double distance);         // rivals.cpp
bool libccd_intersects(double radius_a, double radius_b, double distance); // rivals.cpp
#endif

static int wrong = 0;

static void expect(bool right, const char* what)
{
    std::printf("%s: %s\n", right ? "right" : "WRONG", what);
    wrong += !right;
}

/// Bodies in arrays, filled here and read by files compiled with other flags: were the layout to depend on
/// flags, all bodies but the first would be misread.
static void ask_arrays()
{
    const double half = std::sqrt(0.5); // a quarter turn about z stands the rod along y
    const brink::Shape ball = brink::Sphere{0.5};
    const brink::Shape rod = brink::Capsule{{-1, 0, 0}, {1, 0, 0}, 0.5};
    std::array<brink::Motion, 8> balls, rods;
    std::array<double, 8> times{};
    for (int i = 0; i < 8; ++i) {
        balls[i].start.position = {-2.0 - i, 3, 7};
        balls[i].translation = {4.0 + 3 * i, 0, 0};
        rods[i].start = {{2.0 + i, 3, 7}, {half, 0, 0, half}};
        rods[i].translation = {-4.0, 0, 0};
    }
    first_contacts(ball, balls, rod, rods, times);
    int right = 0;
    for (int i = 0; i < 8; ++i)
        right += std::abs(times[i] - (3.0 + 2 * i) / (8.0 + 3 * i)) < 1e-12; // gap / speed
    expect(right == 8, "brink: balls against rods, in arrays");
    const brink::Pose end = rods[7].at(1);
    expect((end.position - brink::Vec3(5, 3, 7)).norm() < 1e-12 &&
               std::abs(end.orientation.z() - half) < 1e-12,
           "brink: a motion's last pose");
}

int main()
{
    // Gap 5 - 1 - 0.5 = 3.5, closing at 7 per step: t = 0.5, exact in binary.
    const brink::Toi toi =
        brink::time_of_impact(brink::Sphere{1}, {}, brink::Sphere{0.5},
                              {.start = {.position = {5, 0, 0}}, .translation = {-7, 0, 0}});
    expect(toi.status == brink::Status::hit && toi.t == 0.5, "brink: two spheres touch at t = 0.5");
    ask_arrays();
#ifdef WITH_RIVALS
    expect(std::abs(fcl_gap(1, 0.5, 5) - 3.5) < 1e-6, "FCL: two spheres 3.5 apart");
    expect(libccd_intersects(1, 0.5, 1.4) && !libccd_intersects(1, 0.5, 1.6), "libccd: two spheres");
#else
    std::puts("built without FCL and libccd");
#endif
    return wrong != 0;
}
