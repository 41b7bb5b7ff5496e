// SPDX-License-Identifier: BSD-3-Clause
#include <ccd/ccd.h>
#include <fcl/narrowphase/distance.h>

#include <memory>

double fcl_gap(double radius_a, double radius_b, double distance)
{
    fcl::CollisionObjectd a(std::make_shared<fcl::Sphered>(radius_a));
    fcl::CollisionObjectd b(std::make_shared<fcl::Sphered>(radius_b), fcl::Matrix3d::Identity(),
                            {distance, 0, 0});
    fcl::DistanceRequestd request;
    fcl::DistanceResultd result;
    return fcl::distance(&a, &b, request, result);
}

namespace {
struct Ball {
    ccd_vec3_t centre;
    double radius;
};

void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point)
{
    const Ball& ball = *static_cast<const Ball*>(object);
    ccdVec3Copy(point, direction);
    ccdVec3Scale(point, ball.radius / CCD_SQRT(ccdVec3Len2(direction)));
    ccdVec3Add(point, &ball.centre);
}
} // namespace

bool libccd_intersects(double radius_a, double radius_b, double distance)
{
    const Ball a{{{0, 0, 0}}, radius_a}, b{{{distance, 0, 0}}, radius_b};
    ccd_t settings;
    CCD_INIT(&settings);
    settings.support1 = support;
    settings.support2 = support;
    settings.max_iterations = 100;
    return ccdGJKIntersect(&a, &b, &settings) != 0;
}
