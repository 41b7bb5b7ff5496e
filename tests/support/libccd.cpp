// SPDX-License-Identifier: BSD-3-Clause
#include "libccd.h"

#include <ccd/ccd.h>

#include <array>

namespace brink::support {
namespace {

/// The hull of a few points grown by a radius, in the world.
struct Hull {
    std::array<Vec3, 8> corners;
    std::size_t count = 0;
    double radius = 0;

    void add(const Pose& pose, const Vec3& local)
    {
        corners[count++] = pose.position + pose.orientation.normalized() * local;
    }
};

Hull hull(const Shape& shape, const Pose& pose)
{
    Hull out;
    if (const auto* s = std::get_if<Sphere>(&shape)) {
        out.add(pose, Vec3(0, 0, 0));
        out.radius = s->radius;
    } else if (const auto* c = std::get_if<Capsule>(&shape)) {
        out.add(pose, c->a);
        out.add(pose, c->b);
        out.radius = c->radius;
    } else if (const auto* t = std::get_if<Triangle>(&shape)) {
        out.add(pose, t->a);
        out.add(pose, t->b);
        out.add(pose, t->c);
    } else if (const auto* b = std::get_if<Box>(&shape)) {
        for (const double x : {-1, 1})
            for (const double y : {-1, 1})
                for (const double z : {-1, 1})
                    out.add(pose, b->half_extents.cwiseProduct(Vec3(x, y, z)));
    }
    return out;
}

ccd_vec3_t given(const Vec3& v) { return {{v.x(), v.y(), v.z()}}; }

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point)
{
    const Hull& hull = *static_cast<const Hull*>(object);
    const Vec3 d(direction->v[0], direction->v[1], direction->v[2]);
    Vec3 farthest = hull.corners[0];
    for (std::size_t i = 1; i < hull.count; ++i)
        if (d.dot(hull.corners[i]) > d.dot(farthest)) farthest = hull.corners[i];
    const double length = d.norm();
    if (length > 0) farthest += hull.radius / length * d;
    *point = given(farthest);
}

void centre(const void* object, ccd_vec3_t* point)
{
    const Hull& hull = *static_cast<const Hull*>(object);
    Vec3 sum(0, 0, 0);
    for (std::size_t i = 0; i < hull.count; ++i)
        sum += hull.corners[i];
    *point = given(sum / static_cast<double>(hull.count));
}

ccd_t question()
{
    ccd_t ccd;
    CCD_INIT(&ccd);
    ccd.support1 = ccd.support2 = support;
    ccd.center1 = ccd.center2 = centre;
    ccd.max_iterations = 500;
    return ccd;
}

} // namespace

bool libccd_trusts(const Shape& a, const Shape& b) { return a.index() < 4 && b.index() < 4; }

bool libccd_gjk_overlap(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b)
{
    const Hull hull_a = hull(a, pose_a);
    const Hull hull_b = hull(b, pose_b);
    const ccd_t ccd = question();
    return ccdGJKIntersect(&hull_a, &hull_b, &ccd) != 0;
}

bool libccd_mpr_overlap(const Shape& a, const Pose& pose_a, const Shape& b, const Pose& pose_b)
{
    const Hull hull_a = hull(a, pose_a);
    const Hull hull_b = hull(b, pose_b);
    const ccd_t ccd = question();
    return ccdMPRIntersect(&hull_a, &hull_b, &ccd) != 0;
}

} // namespace brink::support
