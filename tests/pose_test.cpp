// SPDX-License-Identifier: BSD-3-Clause
#include "random.h"
#include "vector.h"

#include <brink/pose.h>
#include <doctest/doctest.h>

using namespace brink;

namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

double difference(const Quat& p, const Quat& q)
{
    const double plus = (p.coeffs() - q.coeffs()).norm(), minus = (p.coeffs() + q.coeffs()).norm();
    return std::min(plus, minus); // q and -q are one rotation
}

} // namespace

TEST_CASE("pose: the default is the identity")
{
    CHECK(Pose{}.isometry().matrix() == Eigen::Matrix4d::Identity());
    CHECK(Pose::from(Eigen::Isometry3d::Identity()).orientation.coeffs() == Quat(1, 0, 0, 0).coeffs());
}

TEST_CASE("pose: world = position + orientation * local")
{
    const double half = std::sqrt(0.5);
    const Pose pose{{1, 2, 3}, Quat(half, 0, 0, half)}; // a quarter turn about z: x to y
    const Vec3 p = pose.isometry() * Vec3(5, 0, 0);
    CHECK((p - Vec3(1, 7, 3)).norm() <= 8 * eps);
}

TEST_CASE("pose: to a matrix and back")
{
    support::Random random(20261122);
    int each[4] = {};
    for (int i = 0; i < 20'000; ++i) {
        const Vec3 p = random.in_cube(100);
        const Quat any = random.rotation();
        // Half turns too, where the trace says nothing about the axis.
        const Quat q(Quat(i % 4 == 0 ? 0 : any.w(), any.x(), any.y(), any.z()).normalized());
        const Pose there{p, q}, back = Pose::from(there.isometry());
        CAPTURE(i);
        CHECK(back.position == p);
        CHECK(difference(back.orientation, q) <= 8 * eps);
        int largest = 0;
        for (int k = 1; k < 4; ++k)
            if (std::fabs(q.coeffs()[k]) > std::fabs(q.coeffs()[largest])) largest = k;
        ++each[largest];
        const Eigen::Isometry3d reference =
            Eigen::Translation3d(p) * Eigen::Quaterniond(q.w(), q.x(), q.y(), q.z());
        CHECK((there.isometry().matrix() - reference.matrix()).norm() <= 16 * eps);
    }
    for (const int count : each)
        CHECK(count > 2'000);
}

TEST_CASE("pose: a quaternion off unit stands for the same rotation")
{
    support::Random random(4);
    for (int i = 0; i < 1'000; ++i) {
        const Quat q = random.rotation();
        const double length = random.between(1 - 5e-7, 1 + 5e-7);
        Quat longer = q;
        longer.coeffs() *= length;
        CHECK((Pose{{0, 0, 0}, longer}.isometry().matrix() - Pose{{0, 0, 0}, q}.isometry().matrix()).norm() <=
              16 * eps);
    }
}
