// SPDX-License-Identifier: BSD-3-Clause
#include "crossing.h"

#include "crossing_turning.h"
#include "turn_onto.h"

#include <cmath>

namespace brink::bench {
namespace {

using support::Random;

constexpr double wall = 0.01; // thickness of walls and of balls that cross, metres
constexpr double degree = 3.14159265358979324 / 180;
constexpr double earliest_phase = 0.01; // of the moment of contact within the step: far enough from both ends
constexpr double latest_phase = 0.99;   // that rounding cannot move it out

/// Two bodies that touch in one point, and the normal, from B towards A, of a plane between them.
struct Touch {
    Shape a, b;
    Pose pose_a, pose_b;
    Vec3 normal;
};

/// Uniform among the directions within `angle` (radians) of `axis`.
Vec3 within(Random& random, const Vec3& axis, double angle)
{
    for (;;) {
        const Vec3 direction = random.unit();
        if (direction.dot(axis) >= std::cos(angle)) return direction;
    }
}

/// The crossing whose bodies are at `touch` at a random moment of the step, while A moves by `distance`
/// (metres per step) relative to B within `slant` of head-on. B takes `share` of the relative motion.
Crossing set_in_motion(Random& random, const Touch& touch, double distance, double slant, double share)
{
    const Vec3 relative = distance * within(random, -touch.normal, slant);
    const double contact = random.between(earliest_phase, latest_phase);
    Crossing crossing{touch.a, touch.b, {}, {}, contact};
    crossing.motion_a.start = touch.pose_a;
    crossing.motion_a.translation = (1 - share) * relative;
    crossing.motion_a.start.position -= contact * crossing.motion_a.translation;
    crossing.motion_b.start = touch.pose_b;
    crossing.motion_b.translation = -share * relative;
    crossing.motion_b.start.position -= contact * crossing.motion_b.translation;
    return crossing;
}

/// The ball touches the big face of a wall from outside, the face's plane between them.
Crossing ball_at_wall(Random& random, double speed)
{
    const double radius = random.between(0.25, 1) * wall;
    const double height = random.between(0.5, 1);
    const double width = random.between(0.5, 1);
    const double y = random.between(-0.8, 0.8) * height;
    const double z = random.between(-0.8, 0.8) * width;
    const Quat turn = random.rotation();
    const Vec3 place = random.in_cube(5);
    const Vec3 centre = place + turn * Vec3(0.5 * wall + radius, y, z);
    const Touch touch{Sphere{radius},
                      Box{{0.5 * wall, height, width}},
                      {centre, turn},
                      {place, turn},
                      turn * Vec3::UnitX()};
    return set_in_motion(random, touch, speed * wall, 60 * degree, 0);
}

/// The capsule's side touches a long edge of a slat, at any angle across it. The plane between them leans 20
/// to 70 degrees from the faces that meet in the edge, so that it holds the edge and nothing else of the
/// slat, and the capsule's axis is parallel to it.
Crossing capsule_at_edge(Random& random, double speed)
{
    const double radius = random.between(0.25, 0.5) * wall;
    const double length = random.between(0.1, 0.4);
    const Vec3 half{0.5 * wall, random.between(1, 3) * wall, random.between(0.5, 1)};
    const double lean = random.between(20, 70) * degree;
    const double across = random.between(-90, 90) * degree;
    const double along_slat = random.between(-0.8, 0.8) * half.z();
    const double along_capsule = random.between(-0.4, 0.4) * length;

    const Vec3 normal{std::cos(lean), std::sin(lean), 0};
    const Vec3 axis = std::cos(across) * Vec3::UnitZ() + std::sin(across) * normal.cross(Vec3::UnitZ());
    const Vec3 contact{half.x(), half.y(), along_slat};
    const Vec3 centre = contact + radius * normal + along_capsule * axis;

    const Quat turn = random.rotation();
    const Vec3 place = random.in_cube(5);
    const Quat lie = turn * support::turn_onto(Vec3::UnitZ(), axis);
    const Vec3 end{0, 0, 0.5 * length};
    const Touch touch{
        Capsule{-end, end, radius}, Box{half}, {place + turn * centre, lie}, {place, turn}, turn * normal};
    return set_in_motion(random, touch, speed * wall, 15 * degree, 0);
}

/// Two balls touch, their tangent plane between them; both move.
Crossing ball_at_ball(Random& random, double speed)
{
    const double radius_a = random.between(0.3, 0.7) * wall;
    const double radius_b = wall - radius_a;
    const Vec3 normal = random.unit();
    const Vec3 place = random.in_cube(5);
    const double share = random.between(0.2, 0.8);
    const Touch touch{Sphere{radius_a},
                      Sphere{radius_b},
                      {place + wall * normal, {1, 0, 0, 0}},
                      {place, {1, 0, 0, 0}},
                      normal};
    return set_in_motion(random, touch, speed * wall, 60 * degree, share);
}

} // namespace

const std::array<Scene, 6> scenes{{
    {"ball_wall", "a ball at a thin wall", "the wall's thickness", ball_at_wall},
    {"capsule_edge", "a capsule at a thin box, edge-on", "the box's thickness", capsule_at_edge},
    {"ball_ball", "two small balls crossing", "the balls' mean diameter", ball_at_ball},
    {"rod_post", "a spinning rod at a thin post", "the post's thickness", rod_at_post},
    {"blade_ball", "a hinged blade at a small ball", "the ball's diameter", blade_at_ball},
    {"box_wall", "a spinning box at a thin wall", "the wall's thickness", box_at_wall},
}};

} // namespace brink::bench
