// SPDX-License-Identifier: BSD-3-Clause
#include "crossing_turning.h"

#include <algorithm>
#include <cmath>

namespace brink::bench {
namespace {

using support::Random;

constexpr double wall = 0.01;          // thickness of walls, metres
constexpr double small = 0.001;        // of posts and balls that are swept over
constexpr double most_turned = 3;      // radians in the step: FCL loses turns beyond pi
constexpr double earliest_phase = 0.1; // of the moment of contact within the step
constexpr double latest_phase = 0.9;

/// A body that turns about its local z axis, through `pivot`, and keeps within `half` of the plane y = 0
/// there; and an obstacle that keeps within `radius` of its own z axis, parallel to the first.
struct Swing {
    Shape body;
    Vec3 pivot;
    double half = 0;
    Shape obstacle;
    double radius = 0;
    double arm = 0; // between the two axes
};

/// In the body's frame the obstacle's axis runs round the pivot on a circle of radius `arm`, its direction
/// turning at a constant rate. When that direction is at the angle phi from x, the obstacle is no nearer to
/// the plane y = 0 than arm |sin phi| - radius. Let alpha = asin((half + radius) / arm). While phi is in
/// (alpha, pi - alpha) the two are apart, whatever their shapes. At phi = alpha the obstacle, if it is round,
/// touches the plane y = half, in the point below its axis: if that is a point of the body, they touch. So
/// phi falls from alpha + t* |rotation|, which must not be above pi - alpha, to alpha at t*, the first
/// contact. Sliding along z changes none of these distances, nor does a velocity that both have. Rounding
/// moves t* by less than 1e-10: a few units in the last place of 5 m at no less than 0.1 mm a step.
Crossing set_swinging(Random& random, const Swing& swing, double distance)
{
    const double contact = random.between(earliest_phase, latest_phase);
    const double alpha = std::asin((swing.half + swing.radius) / swing.arm);
    const double angle = distance / swing.arm;
    const double slide = random.between(-0.5, 0.5) * distance;
    const Vec3 common = distance * random.in_cube(0.5);
    const Quat frame = random.rotation();
    const Vec3 hinge = random.in_cube(1);
    const Vec3 axis = frame * Vec3::UnitZ();

    Crossing crossing{swing.body, swing.obstacle, {}, {}, contact};
    Motion& a = crossing.motion_a;
    a.rotation = angle * axis;
    a.pivot = swing.pivot;
    a.translation = common + slide * axis;
    a.start.orientation = Quat(Eigen::AngleAxisd(-contact * angle, axis)) * frame;
    a.start.position = hinge - contact * a.translation - a.start.orientation * swing.pivot;

    Motion& b = crossing.motion_b;
    b.translation = common;
    b.start.orientation = frame;
    b.start.position =
        hinge + frame * (swing.arm * Vec3(std::cos(alpha), std::sin(alpha), 0)) - contact * common;
    return crossing;
}

/// A box that touches a wall's face at the moment of contact, and how it moves.
struct Throw {
    Vec3 half_extents;
    Quat turned;     // in the frame of the wall, at contact
    Vec3 direction;  // of its centre's motion, unit, likewise; towards -x
    Vec3 axis;       // of its spin, unit, likewise
    double spin = 0; // of the fastest that leaves the proof intact
};

/// The wall's face is x = wall / 2 in its frame. The height above it of a corner, which is |half_extents|
/// from the centre, changes at the centre's rate, `approach` < 0, and at |rotation| |half_extents| at most
/// beside it. That being the less of the two, every corner's height falls throughout; so does the least of
/// them, which is the box's, and which is 0 at t*. Before t* the box is above the face and the wall below:
/// apart. At t* the lowest corner lies in the face, which reaches far enough. Rounding moves t* by less than
/// 1e-10: see set_swinging.
Crossing set_flying(Random& random, const Throw& thrown, double distance)
{
    const double contact = random.between(earliest_phase, latest_phase);
    const double reach = thrown.half_extents.norm();
    const double approach = -distance * thrown.direction.x();
    const double angle = thrown.spin * std::min(approach / reach, most_turned);
    const Vec3 normal = thrown.turned.conjugate() * Vec3::UnitX();
    const double height = normal.cwiseAbs().dot(thrown.half_extents);
    const Vec3 wall_half{0.5 * wall, random.between(0.5, 1), random.between(0.5, 1)};
    const double y = random.between(-0.5, 0.5) * wall_half.y();
    const double z = random.between(-0.5, 0.5) * wall_half.z();
    const Quat frame = random.rotation();
    const Vec3 place = random.in_cube(1);

    Crossing crossing{Box{thrown.half_extents}, Box{wall_half}, {}, {}, contact};
    Motion& a = crossing.motion_a;
    a.translation = distance * (frame * thrown.direction);
    a.rotation = angle * (frame * thrown.axis);
    a.start.orientation =
        Quat(Eigen::AngleAxisd(-contact * angle, frame * thrown.axis)) * (frame * thrown.turned);
    a.start.position = place + frame * Vec3(0.5 * wall + height, y, z) - contact * a.translation;
    crossing.motion_b.start = {place, frame};
    return crossing;
}

/// Within 45 degrees of head-on.
Vec3 towards_wall(Random& random)
{
    for (;;) {
        const Vec3 direction = random.unit();
        if (direction.x() < -0.7071) return direction;
    }
}

} // namespace

Crossing rod_at_post(Random& random, double speed)
{
    const double radius = 0.5 * small * random.between(0.3, 1);
    const double arm = random.between(0.5, 1);
    const double beyond = random.between(0.05, 0.3);
    const bool about_middle = random.chance(0.5);
    const double behind = about_middle ? arm + beyond : random.between(0.05, 1.5);
    const Vec3 end{0.5 * (behind + arm + beyond), 0, 0};
    const double along = random.between(-0.1, 0.1);
    const double half_post = random.between(0.2, 0.5);
    return set_swinging(random,
                        {Capsule{-end, end, radius}, Vec3(behind - end.x(), 0, 0), radius,
                         Capsule{{0, 0, along - half_post}, {0, 0, along + half_post}, 0.5 * small},
                         0.5 * small, arm},
                        speed * small);
}

Crossing blade_at_ball(Random& random, double speed)
{
    const double half = 0.5 * small * random.between(0.2, 0.5);
    const double arm = random.between(0.5, 1);
    const double length = random.between(0.1, 0.3);
    const double along = random.between(-0.4, 0.4) * length;
    const double width = random.between(0.02, 0.1);
    const double off = random.between(-0.8, 0.8) * width; // of the ball, across the blade
    return set_swinging(random,
                        {Box{{0.5 * length, half, width}}, Vec3(along - arm, 0, off), half,
                         Sphere{0.5 * small}, 0.5 * small, arm},
                        speed * small);
}

Crossing box_at_wall(Random& random, double speed)
{
    const double thin = random.between(0.1, 0.3) * wall;
    const double length = random.between(0.5, 2) * wall;
    const double width = random.between(0.5, 2) * wall;
    const Quat turned = random.rotation();
    const Vec3 direction = towards_wall(random);
    const Vec3 axis = random.unit();
    const double spin = random.between(0.3, 0.95);
    return set_flying(random, {{length, width, thin}, turned, direction, axis, spin}, speed * wall);
}

Crossing box_at_wall_in_section(Random& random, const Vec3& half_extents, double speed)
{
    const double turned = random.between(-1.5, 1.5);
    const double slant = random.between(-0.6, 0.6);
    const Vec3 direction{-std::cos(slant), std::sin(slant), 0};
    const double spin = random.chance(0.5) ? 0.95 : -0.95;
    return set_flying(
        random,
        {half_extents, Quat(Eigen::AngleAxisd(turned, Vec3::UnitZ())), direction, Vec3::UnitZ(), spin},
        speed * wall);
}

} // namespace brink::bench
