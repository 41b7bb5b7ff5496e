// SPDX-License-Identifier: BSD-3-Clause
// Prints the fingerprint of the library it is linked with: determinism [number of queries], all by default.
// tests/determinism.sh compares what different builds print.
#include "support/fingerprint.h"

#include <cstdio>
#include <cstdlib>

using namespace brink;
using namespace brink::support;

/// What a user's program does with brink's types: Eigen's own products, which use fused multiply-adds where
/// the flags allow. Eigen's inline functions end up in this object file and are linked before the library's.
static double users_own(const Query& q)
{
    const Eigen::Quaterniond a(q.motion_a.start.orientation);
    const Quat both = q.motion_a.start.orientation * q.motion_b.start.orientation;
    const Eigen::Matrix3d turn = both.toRotationMatrix() * a.toRotationMatrix();
    const Vec3 by = q.motion_b.translation - q.motion_a.translation;
    const Vec3 moved = q.motion_a.start.position + 0.5 * by + turn * q.motion_b.start.position;
    return moved.dot(by) + moved.cross(by).norm() + moved.normalized().squaredNorm() +
           moved.cwiseAbs().maxCoeff() + (both * moved).minCoeff();
}

int main(int count, char** arguments)
{
    const std::uint64_t most =
        count > 1 ? std::strtoull(arguments[1], nullptr, 10) : checkpoints[checkpoints.size() - 1];
    Fingerprint so_far;
    std::uint64_t from = 0;
    double sum = 0;
    for (const std::uint64_t to : checkpoints) {
        if (to > most) break;
        so_far = fingerprint(from, to, so_far);
        for (std::uint64_t i = 0; i < 100; ++i)
            sum += users_own(mixed_query(i));
        from = to;
        std::printf("%8llu queries %016llx answers %016llx\n", static_cast<unsigned long long>(to),
                    static_cast<unsigned long long>(so_far.queries),
                    static_cast<unsigned long long>(so_far.answers));
    }
    return sum == 0 || from == 0; // neither happens; the sum is used, so that none of it is left out
}
