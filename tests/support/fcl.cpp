// SPDX-License-Identifier: BSD-3-Clause
#include "fcl.h"

#include "turn_onto.h"

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/plane.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/math/motion/interp_motion.h>
#include <fcl/math/motion/translation_motion.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include <vector>

namespace brink::support {

/// FCL's capsules lie along z about their centre: `local` places FCL's frame in brink's.
struct FclBody::Geometry {
    std::shared_ptr<fcl::CollisionGeometryd> shape;
    fcl::Transform3d local = fcl::Transform3d::Identity();
};

namespace {

using Geometry = FclBody::Geometry;

Geometry make(const Sphere& s) { return {std::make_shared<fcl::Sphered>(s.radius)}; }

Geometry make(const Capsule& c)
{
    const Vec3 axis = c.b - c.a;
    const double length = axis.norm();
    Geometry made{std::make_shared<fcl::Capsuled>(c.radius, length)};
    if (length > 0) made.local.linear() = turn_onto(Vec3::UnitZ(), axis).toRotationMatrix();
    made.local.translation() = c.a + 0.5 * axis;
    return made;
}

Geometry make(const Box& b) { return {std::make_shared<fcl::Boxd>(Vec3(2 * b.half_extents))}; }

/// FCL does not answer for its TriangleP; a Convex of two faces back to back works.
Geometry make(const Triangle& t)
{
    auto corners = std::make_shared<std::vector<fcl::Vector3d>>(std::vector<fcl::Vector3d>{t.a, t.b, t.c});
    auto faces = std::make_shared<std::vector<int>>(std::vector<int>{3, 0, 1, 2, 3, 0, 2, 1});
    return {std::make_shared<fcl::Convexd>(corners, 2, faces)};
}

Geometry make(const Plane& p) { return {std::make_shared<fcl::Planed>(p.normal, p.offset)}; }

Geometry make(const HalfSpace& h) { return {std::make_shared<fcl::Halfspaced>(h.normal, h.offset)}; }

Geometry make(const Cylinder& s) { return {std::make_shared<fcl::Cylinderd>(s.radius, 2 * s.half_length)}; }

Geometry make(const Cone& s) { return {std::make_shared<fcl::Coned>(s.radius, 2 * s.half_length)}; }

Geometry make(const Ellipsoid& s) { return {std::make_shared<fcl::Ellipsoidd>(s.radii)}; }

/// A Convex without faces looks for its farthest vertex among all of them, as FCL's own choice is up to 32.
Geometry make(const Hull& h)
{
    auto corners = std::make_shared<std::vector<fcl::Vector3d>>(h.vertices().begin(), h.vertices().end());
    return {std::make_shared<fcl::Convexd>(corners, 0, std::make_shared<std::vector<int>>())};
}

fcl::Transform3d placed(const Geometry& geometry, const Pose& pose)
{
    fcl::Transform3d world = fcl::Transform3d::Identity();
    world.linear() = pose.orientation.normalized().toRotationMatrix();
    world.translation() = pose.position;
    return world * geometry.local;
}

/// A fresh object for every call: FCL's motions remember. Its InterpMotion(tf1, tf2) leaves the reference
/// point uninitialised, and InterpMotion(tf1, tf2, point) the velocities: only this constructor sets both.
std::shared_ptr<fcl::MotionBased> moving(const Geometry& geometry, const Motion& motion)
{
    const fcl::Transform3d from = placed(geometry, motion.start);
    if (motion.rotation.isZero(0)) {
        const fcl::Vector3d to = from.translation() + motion.translation;
        return std::make_shared<fcl::TranslationMotion<double>>(fcl::Matrix3d(from.linear()),
                                                                fcl::Vector3d(from.translation()), to);
    }
    const fcl::Transform3d to = placed(geometry, motion.at(1));
    const fcl::Vector3d reference = geometry.local.inverse() * motion.pivot;
    return std::make_shared<fcl::InterpMotion<double>>(
        fcl::Matrix3d(from.linear()), fcl::Vector3d(from.translation()), fcl::Matrix3d(to.linear()),
        fcl::Vector3d(to.translation()), reference);
}

std::optional<double> continuous(const fcl::ContinuousCollisionRequestd& request, const FclBody& a,
                                 const Motion& motion_a, const FclBody& b, const Motion& motion_b)
{
    fcl::ContinuousCollisionResultd result;
    const auto moving_a = moving(a.geometry(), motion_a);
    const auto moving_b = moving(b.geometry(), motion_b);
    fcl::continuousCollide(a.geometry().shape.get(), moving_a.get(), b.geometry().shape.get(), moving_b.get(),
                           request, result);
    if (!result.is_collide) return std::nullopt;
    return result.time_of_contact;
}

enum class Kind : unsigned char { solid, triangle, unbounded };

Kind kind(const Shape& shape)
{
    if (std::holds_alternative<Plane>(shape) || std::holds_alternative<HalfSpace>(shape))
        return Kind::unbounded;
    return std::holds_alternative<Triangle>(shape) ? Kind::triangle : Kind::solid;
}

} // namespace

FclBody::FclBody(const Shape& shape)
{
    Geometry made = std::visit([](const auto& s) { return make(s); }, shape);
    made.shape->computeLocalAABB();
    geometry_ = std::make_shared<const Geometry>(std::move(made));
}

bool fcl_trusts(FclQuestion question, const Shape& a, const Shape& b)
{
    const auto round = [](const Shape& s) { return std::holds_alternative<Ellipsoid>(s); };
    if (question == FclQuestion::conservative_advancement && (round(a) || round(b))) return false; // stale
    const auto convex = [](const Shape& s) { return std::holds_alternative<Hull>(s); };
    const auto plane = [](const Shape& s) { return std::holds_alternative<Plane>(s); };
    if ((convex(a) && plane(b)) || (plane(a) && convex(b))) return false; // segfaults
    const Kind kind_a = kind(a);
    const Kind kind_b = kind(b);
    if (kind_a == Kind::solid && kind_b == Kind::solid) return true;
    const bool distance_like = question == FclQuestion::distance || question == FclQuestion::collide;
    if (kind_a != Kind::solid && kind_b != Kind::solid) return false;
    if (kind_a == Kind::triangle || kind_b == Kind::triangle) return distance_like;
    return question == FclQuestion::collide;
}

double fcl_distance(const FclBody& a, const Pose& pose_a, const FclBody& b, const Pose& pose_b)
{
    fcl::DistanceRequestd request;
    request.gjk_solver_type = fcl::GST_LIBCCD;
    request.distance_tolerance = 1e-10;
    fcl::DistanceResultd result;
    return fcl::distance(a.geometry().shape.get(), placed(a.geometry(), pose_a), b.geometry().shape.get(),
                         placed(b.geometry(), pose_b), request, result);
}

bool fcl_collide(const FclBody& a, const Pose& pose_a, const FclBody& b, const Pose& pose_b)
{
    fcl::CollisionRequestd request;
    fcl::CollisionResultd result;
    fcl::collide(a.geometry().shape.get(), placed(a.geometry(), pose_a), b.geometry().shape.get(),
                 placed(b.geometry(), pose_b), request, result);
    return result.isCollision();
}

std::optional<double> fcl_continuous(FclQuestion solver, const FclBody& a, const Motion& motion_a,
                                     const FclBody& b, const Motion& motion_b)
{
    fcl::ContinuousCollisionRequestd request;
    request.ccd_solver_type =
        solver == FclQuestion::naive ? fcl::CCDC_NAIVE : fcl::CCDC_CONSERVATIVE_ADVANCEMENT;
    return continuous(request, a, motion_a, b, motion_b);
}

std::optional<double> fcl_naive(int poses, const FclBody& a, const Motion& motion_a, const FclBody& b,
                                const Motion& motion_b)
{
    fcl::ContinuousCollisionRequestd request;
    request.ccd_solver_type = fcl::CCDC_NAIVE;
    request.num_max_iterations = static_cast<std::size_t>(poses);
    return continuous(request, a, motion_a, b, motion_b);
}

} // namespace brink::support
