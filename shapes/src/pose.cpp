// SPDX-License-Identifier: BSD-3-Clause
#include <brink/pose.h>

#include "vector.h"

namespace brink {

namespace {

/// The quaternion of a rotation matrix by its largest component (S. Shepperd, 1978), so that nothing cancels.
Quat quaternion(const Rotation& r)
{
    const double trace = r.x.x + r.y.y + r.z.z;
    double w = 0, x = 0, y = 0, z = 0;
    if (trace >= r.x.x && trace >= r.y.y && trace >= r.z.z) {
        w = 1 + trace, x = r.y.z - r.z.y, y = r.z.x - r.x.z, z = r.x.y - r.y.x;
    } else if (r.x.x >= r.y.y && r.x.x >= r.z.z) {
        w = r.y.z - r.z.y, x = 1 + r.x.x - r.y.y - r.z.z, y = r.x.y + r.y.x, z = r.x.z + r.z.x;
    } else if (r.y.y >= r.z.z) {
        w = r.z.x - r.x.z, x = r.x.y + r.y.x, y = 1 + r.y.y - r.z.z - r.x.x, z = r.y.z + r.z.y;
    } else {
        w = r.x.y - r.y.x, x = r.x.z + r.z.x, y = r.y.z + r.z.y, z = 1 + r.z.z - r.x.x - r.y.y;
    }
    const double length = std::sqrt(w * w + x * x + y * y + z * z);
    return {w / length, x / length, y / length, z / length};
}

V3 column(const Eigen::Isometry3d& isometry, int k)
{
    const double* c = isometry.data() + std::ptrdiff_t{4} * k; // 4 x 4, by columns
    return {c[0], c[1], c[2]};
}

} // namespace

Pose Pose::from(const Eigen::Isometry3d& isometry)
{
    const Rotation r{column(isometry, 0), column(isometry, 1), column(isometry, 2)};
    return {store(column(isometry, 3)), quaternion(r)};
}

Eigen::Isometry3d Pose::isometry() const
{
    const Rotation r = rotation(orientation);
    Eigen::Isometry3d isometry = Eigen::Isometry3d::Identity();
    int k = 0;
    for (const V3 v : {r.x, r.y, r.z, load(position)}) {
        double* c = isometry.data() + std::ptrdiff_t{4} * k++;
        c[0] = v.x, c[1] = v.y, c[2] = v.z;
    }
    return isometry;
}

} // namespace brink
