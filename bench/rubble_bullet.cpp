// SPDX-License-Identifier: BSD-3-Clause
#include "rubble.h"

#include "rubble_pieces.h"

#include <btBulletDynamicsCommon.h>
#include <random.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace brink::bench {
namespace {

using support::Random;

constexpr int stones = 240;
constexpr int settling = 300;  // steps before the first shot
constexpr int shooting = 360;  // steps, a shot in every other
constexpr int flight = 40;     // steps after which a projectile is taken away
constexpr double pen = 1.2;    // half the inner width, metres
constexpr double wall = 0.01;  // half the thickness
constexpr double height = 0.4; // half of it

Vec3 vec(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
btVector3 vec(const Vec3& v)
{
    return {static_cast<btScalar>(v.x()), static_cast<btScalar>(v.y()), static_cast<btScalar>(v.z())};
}

Pose pose(const btTransform& t)
{
    const btQuaternion q = t.getRotation();
    return {vec(t.getOrigin()), Quat(q.w(), q.x(), q.y(), q.z())};
}

/// The rotation vector over a step that btTransformUtil::integrateTransform makes of an angular velocity: it
/// shortens the angle where that is large, but not the velocity that it multiplies the half angle's sine by.
Vec3 turn_in_step(const btVector3& velocity)
{
    const btVector3 turn = velocity * rubble_dt;
    const double angle = vec(turn).norm();
    const double most = ANGULAR_MOTION_THRESHOLD;
    if (!(angle > most)) return vec(turn);
    const double half = std::atan2(angle / most * std::sin(most / 2), std::cos(most / 2));
    return vec(turn) * (2 * half / angle);
}

/// A body, and how long it stays.
struct Body {
    Piece piece;
    std::unique_ptr<btRigidBody> rigid;
    int until = std::numeric_limits<int>::max(); // the step before which it is taken away
    Motion motion{};                             // of the step just made
    Aabb swept{};
    bool moves() const { return !rigid->isStaticObject(); }
};

class Rubble {
public:
    explicit Rubble(std::uint64_t seed) : random_(seed)
    {
        world_.setGravity({0, 0, btScalar(-9.81)});
        world_.getDispatchInfo().m_useContinuous = false;
        // Else positions are corrected by pseudo-velocities, and the step is not what the velocities say.
        world_.getSolverInfo().m_splitImpulse = 0;
        add(floor_piece(), Vec3(0, 0, 0), 0);
        for (const double side : {-1.0, 1.0}) {
            add(box_piece({wall, pen + wall, height}), {side * (pen + wall), 0, height}, 0);
            add(box_piece({pen + wall, wall, height}), {0, side * (pen + wall), height}, 0);
        }
        for (int i = 0; i < stones; ++i)
            drop(i);
    }

    ~Rubble()
    {
        for (const Body& body : bodies_)
            world_.removeRigidBody(body.rigid.get());
    }
    Rubble(const Rubble&) = delete;
    Rubble& operator=(const Rubble&) = delete;

    RubbleRun run(const std::function<void(const Sighting&)>& see)
    {
        RubbleRun out;
        for (out.steps = 0; out.steps < settling + shooting; ++out.steps) {
            take_away(out.steps);
            if (out.steps >= settling && out.steps % 2 == 0) shoot(out.steps);
            step(out);
            look(out.steps, see);
        }
        out.bodies = came_;
        return out;
    }

private:
    /// At rest when its density is 0.
    Body& add(Piece piece, const Vec3& at, double density)
    {
        btTransform place = btTransform::getIdentity();
        place.setOrigin(vec(at));
        btVector3 inertia(0, 0, 0);
        const auto mass = static_cast<btScalar>(density * piece.volume);
        if (density > 0) {
            const Quat q = random_.rotation();
            place.setRotation(btQuaternion(static_cast<btScalar>(q.x()), static_cast<btScalar>(q.y()),
                                           static_cast<btScalar>(q.z()), static_cast<btScalar>(q.w())));
            piece.bullet->calculateLocalInertia(mass, inertia);
        }
        btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, piece.bullet.get(), inertia);
        info.m_startWorldTransform = place;
        Body body{std::move(piece), std::make_unique<btRigidBody>(info)};
        body.rigid->setActivationState(DISABLE_DEACTIVATION);
        world_.addRigidBody(body.rigid.get());
        body.rigid->setUserIndex(static_cast<int>(came_++));
        bodies_.push_back(std::move(body));
        return bodies_.back();
    }

    /// The stones begin in layers of 16, one above the other.
    void drop(int i)
    {
        const double x = (i % 4 - 1.5) * 0.55;
        const double y = (i / 4 % 4 - 1.5) * 0.55;
        const double z = 0.5 + i / 16 * 0.55; // NOLINT(bugprone-integer-division): whole layers
        const Vec3 off = random_.in_cube(0.05);
        add(stone(random_), Vec3(x, y, z) + off, 2600);
    }

    /// From outside at a point of the pile, spinning.
    void shoot(int now)
    {
        const double x = random_.between(-pen, pen);
        const double y = random_.between(-pen, pen);
        const double z = random_.between(0.02, 0.8);
        Vec3 from = random_.unit();
        from.z() = std::abs(from.z());
        const double away = random_.between(2, 8);
        const double speed = random_.log_between(50, 300);
        const double spin = random_.log_between(0.5, 200);
        const Vec3 axis = random_.unit();
        Body& body = add(projectile(random_), Vec3(x, y, z) + away * from, 7800);
        body.rigid->setLinearVelocity(vec(Vec3(-speed * from)));
        body.rigid->setAngularVelocity(vec(Vec3(spin * axis)));
        body.until = now + flight;
    }

    void take_away(int now)
    {
        for (const Body& body : bodies_)
            if (body.until <= now) world_.removeRigidBody(body.rigid.get());
        std::erase_if(bodies_, [&](const Body& body) { return body.until <= now; });
    }

    /// One step, and the motions that it made of the velocities it came to, as btTransformUtil does.
    void step(RubbleRun& out)
    {
        for (Body& body : bodies_)
            body.motion = Motion::still(pose(body.rigid->getWorldTransform()));
        world_.stepSimulation(rubble_dt, 0);
        for (Body& body : bodies_) {
            if (body.moves()) {
                body.motion.translation = vec(body.rigid->getLinearVelocity() * rubble_dt);
                body.motion.rotation = turn_in_step(body.rigid->getAngularVelocity());
            }
            const Pose there = body.motion.at(1), put = pose(body.rigid->getWorldTransform());
            out.most_off = std::max(out.most_off, (there.position - put.position).norm());
            out.most_turned_off = std::max(
                out.most_turned_off,
                Eigen::Quaterniond(there.orientation).angularDistance(Eigen::Quaterniond(put.orientation)));
            body.swept = swept_bounds(body.piece.shape, body.motion);
        }
    }

    void look(int now, const std::function<void(const Sighting&)>& see) const
    {
        for (std::size_t i = 0; i < bodies_.size(); ++i)
            for (std::size_t j = i + 1; j < bodies_.size(); ++j) {
                const Body &a = bodies_[i], &b = bodies_[j];
                if (!a.moves() && !b.moves()) continue;
                const bool apart = (a.swept.min.array() > b.swept.max.array()).any() ||
                                   (b.swept.min.array() > a.swept.max.array()).any();
                if (apart) continue;
                see({{a.piece.shape, a.motion, b.piece.shape, b.motion, {}},
                     now,
                     static_cast<std::size_t>(a.rigid->getUserIndex()),
                     static_cast<std::size_t>(b.rigid->getUserIndex())});
            }
    }

    Random random_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broad_phase_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_{&dispatcher_, &broad_phase_, &solver_, &configuration_};
    std::vector<Body> bodies_;
    std::size_t came_ = 0;
};

} // namespace

RubbleRun simulate_rubble(std::uint64_t seed, const std::function<void(const Sighting&)>& see)
{
    return Rubble(seed).run(see);
}

} // namespace brink::bench
