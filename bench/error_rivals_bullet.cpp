// SPDX-License-Identifier: BSD-3-Clause
#include "error_contender.h"
#include "turn_onto.h"

#include <BulletCollision/CollisionShapes/btBoxShape.h>
#include <BulletCollision/CollisionShapes/btCapsuleShape.h>
#include <BulletCollision/CollisionShapes/btConeShape.h>
#include <BulletCollision/CollisionShapes/btConvexHullShape.h>
#include <BulletCollision/CollisionShapes/btCylinderShape.h>
#include <BulletCollision/CollisionShapes/btSphereShape.h>
#include <BulletCollision/CollisionShapes/btStaticPlaneShape.h>
#include <BulletCollision/CollisionShapes/btTriangleShape.h>
#include <BulletCollision/NarrowPhaseCollision/btContinuousConvexCollision.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btGjkEpaPenetrationDepthSolver.h>
#include <BulletCollision/NarrowPhaseCollision/btSubSimplexConvexCast.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>

#include <array>
#include <fmt/format.h>
#include <optional>

namespace brink::bench {
namespace {

/// Bullet lets a motion turn by no more than a quarter of pi: one that does is asked about in two parts,
/// one after the other.
constexpr double most_turn = 0.78;
constexpr int most_parts = 2;

btVector3 vector(const Vec3& v)
{
    return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

/// A shape of Bullet's, convex or ground, and how its own frame lies in brink's: its capsules lie along z
/// about their middle. Neither where Bullet has none such.
struct Solid {
    std::unique_ptr<btConvexShape> shape;
    std::unique_ptr<btStaticPlaneShape> ground;
    Pose local{};
};

/// What Bullet rounds a box's corners off by, and grows a hull by: 4 cm if nobody says otherwise. With none
/// at all btGjkConvexCast misses half the hits of boxes; with more than this all casts are less exact. (That
/// of spheres and capsules is their radius.)
constexpr btScalar margin{1e-6F};

template <class T, class... Arguments> Solid with_margin(const Arguments&... arguments)
{
    Solid out{std::make_unique<T>(arguments...), nullptr};
    out.shape->setMargin(margin);
    return out;
}

Solid solid(const Sphere& s)
{
    return {std::make_unique<btSphereShape>(static_cast<btScalar>(s.radius)), nullptr};
}

Solid solid(const Capsule& s)
{
    const Vec3 axis = s.b - s.a;
    const double length = axis.norm();
    Solid out{
        std::make_unique<btCapsuleShapeZ>(static_cast<btScalar>(s.radius), static_cast<btScalar>(length)),
        nullptr};
    out.local.position = s.a + 0.5 * axis;
    if (length > 0) out.local.orientation = support::turn_onto(Vec3::UnitZ(), axis);
    return out;
}

Solid solid(const Box& s) { return with_margin<btBoxShape>(vector(s.half_extents)); }

Solid solid(const Triangle& s) { return with_margin<btTriangleShape>(vector(s.a), vector(s.b), vector(s.c)); }

Solid solid(const Cylinder& s)
{
    return with_margin<btCylinderShapeZ>(vector({s.radius, s.radius, s.half_length}));
}

Solid solid(const Cone& s)
{
    return with_margin<btConeShapeZ>(static_cast<btScalar>(s.radius),
                                     static_cast<btScalar>(2 * s.half_length));
}

Solid solid(const Hull& s)
{
    auto hull = std::make_unique<btConvexHullShape>();
    for (const Vec3& point : s.vertices())
        hull->addPoint(vector(point), false);
    hull->recalcLocalAabb();
    hull->setMargin(margin);
    return {std::move(hull), nullptr};
}

template <class Border> Solid ground(const Border& s)
{
    return {nullptr, std::make_unique<btStaticPlaneShape>(vector(s.normal), static_cast<btScalar>(s.offset))};
}

/// Bullet's planes are half-spaces; bodies begin on the side that the normal points to.
Solid solid(const Plane& s) { return ground(s); }
Solid solid(const HalfSpace& s) { return ground(s); }
Solid solid(const Ellipsoid&) { return {}; }

btTransform transform(const Pose& pose, const Pose& local)
{
    const Quat turn = pose.orientation.normalized();
    const Eigen::Matrix3d m = (turn * local.orientation).toRotationMatrix();
    const btMatrix3x3 basis(
        static_cast<btScalar>(m(0, 0)), static_cast<btScalar>(m(0, 1)), static_cast<btScalar>(m(0, 2)),
        static_cast<btScalar>(m(1, 0)), static_cast<btScalar>(m(1, 1)), static_cast<btScalar>(m(1, 2)),
        static_cast<btScalar>(m(2, 0)), static_cast<btScalar>(m(2, 1)), static_cast<btScalar>(m(2, 2)));
    return btTransform(basis, vector(pose.position + turn * local.position));
}

/// A body as the casts take it, prepared before anything is timed.
struct Moving {
    std::unique_ptr<btConvexShape> shape;
    std::unique_ptr<btStaticPlaneShape> ground;
    std::array<btTransform, most_parts + 1> at; // the ends of all parts
    bool far = false;                           // turns by more than Bullet can in one part
};

Moving moving(const Body& body)
{
    Solid made = std::visit([](const auto& s) { return solid(s); }, body.shape);
    Moving out{std::move(made.shape), std::move(made.ground), {}, body.motion.rotation.norm() > most_turn};
    for (std::size_t k = 0; k <= most_parts; ++k)
        out.at[k] = transform(body.motion.at(static_cast<double>(k) / most_parts), made.local);
    return out;
}

using MovingBodies = std::shared_ptr<const std::vector<Moving>>;

class Bullet : public Contender {
public:
    Bullet(std::string_view who, std::string setting, MovingBodies bodies)
        : Contender(fmt::format("Bullet {}", who), std::move(setting)), bodies_(std::move(bodies))
    {
    }

    Answer ask(const Pair& pair) override
    {
        const Moving& a = (*bodies_)[pair.a];
        const Moving& b = (*bodies_)[pair.b];
        const std::size_t parts = a.far || b.far ? most_parts : 1;
        const std::size_t length = most_parts / parts;
        for (std::size_t k = 0; k < parts; ++k) {
            const std::optional<double> fraction = cast({a, b, k * length, (k + 1) * length});
            if (fraction) return {true, (static_cast<double>(k) + *fraction) / static_cast<double>(parts)};
        }
        return {};
    }

protected:
    /// A part of the step, or all of it, by its ends among Moving::at.
    struct Stretch {
        const Moving& a;
        const Moving& b;
        std::size_t from, to;
    };
    using Result = btConvexCast::CastResult;

    /// The fraction of the stretch at which there is contact.
    virtual std::optional<double> cast(const Stretch&) = 0;

    static std::optional<double> run(btConvexCast&& solver, const Stretch& s, Result&& result)
    {
        if (!solver.calcTimeOfImpact(s.a.at[s.from], s.a.at[s.to], s.b.at[s.from], s.b.at[s.to], result))
            return std::nullopt;
        return static_cast<double>(result.m_fraction);
    }

    btVoronoiSimplexSolver simplex_;

private:
    MovingBodies bodies_;
};

/// GJK ray cast (G. van den Bergen 2004) between bodies that do not turn. It ends when the square of what is
/// between them is below `square`, m^2.
class SubsimplexCast final : public Bullet {
public:
    SubsimplexCast(std::string setting, const MovingBodies& bodies, double square)
        : Bullet("btSubsimplexConvexCast", std::move(setting), bodies), square_(static_cast<btScalar>(square))
    {
    }

private:
    std::optional<double> cast(const Stretch& s) override
    {
        Result result;
        result.m_subSimplexCastEpsilon = square_;
        return run(btSubsimplexConvexCast(s.a.shape.get(), s.b.shape.get(), &simplex_), s, std::move(result));
    }

    btScalar square_;
};

/// Conservative advancement between bodies that do not turn, to within 1 mm.
class GjkCast final : public Bullet {
public:
    explicit GjkCast(const MovingBodies& bodies) : Bullet("btGjkConvexCast", "", bodies) {}

private:
    std::optional<double> cast(const Stretch& s) override
    {
        return run(btGjkConvexCast(s.a.shape.get(), s.b.shape.get(), &simplex_), s, {});
    }
};

/// Conservative advancement to within 1 mm, bodies turning or not; against ground none but what moves
/// straight, since its bound leaves the turning of ground out.
class ContinuousCollision final : public Bullet {
public:
    explicit ContinuousCollision(const MovingBodies& bodies)
        : Bullet("btContinuousConvexCollision", "", bodies)
    {
    }

private:
    std::optional<double> cast(const Stretch& s) override
    {
        if (s.a.ground) return cast({s.b, s.a, s.from, s.to});
        if (s.b.ground) return run(btContinuousConvexCollision(s.a.shape.get(), s.b.ground.get()), s, {});
        return run(btContinuousConvexCollision(s.a.shape.get(), s.b.shape.get(), &simplex_, &depth_), s, {});
    }

    btGjkEpaPenetrationDepthSolver depth_;
};

} // namespace

Contenders bullet_contenders(const Questions& questions)
{
    const bool straight = questions.turning == Turning::none;
    std::vector<Moving> made;
    bool grounded = false;
    for (const Body& body : questions.sample.bodies) {
        made.push_back(moving(body));
        if (!made.back().shape && !made.back().ground) return {};
        grounded = grounded || made.back().ground;
    }
    if (grounded && !straight) return {};
    const auto bodies = std::make_shared<const std::vector<Moving>>(std::move(made));
    Contenders out;
    if (straight && !grounded) {
        out.push_back(std::make_unique<SubsimplexCast>("to 1 cm", bodies, 1e-4));
        out.push_back(std::make_unique<SubsimplexCast>("to 1 mm", bodies, 1e-6));
        out.push_back(std::make_unique<GjkCast>(bodies));
    }
    out.push_back(std::make_unique<ContinuousCollision>(bodies));
    return out;
}

} // namespace brink::bench
