// SPDX-License-Identifier: BSD-3-Clause
// Rays against the bodies where they stand at the start.
#include "scene_met.h"
#include "sweep.h"
#include "tolerance.h"

#include <algorithm>
#include <cmath>

namespace brink {

namespace {

struct Ray {
    Vec3 origin, direction; // not what a caller refers to, which may be what a ray met before
    double t_max;
    const SceneOptions& options;

    RayImpact ask(const BodyStore& store, std::uint32_t slot) const
    {
        const Body& b = store.bodies[slot];
        return {store.id(slot), ray_cast(origin, direction, b.shape, b.motion.start, t_max)};
    }
    static bool met(const RayImpact& r)
    {
        return r.hit.status == Status::hit || r.hit.status == Status::touching;
    }
    static double begins(const RayImpact& r) { return r.hit.t; }
};

/// As many lengths of `direction` as it takes to leave all trees behind, at most t_max: bounds in floats need
/// an end. Infinite where a body lies too far away for bounds, or the ray is too slow.
double leaving(const Ray& ray, const BroadPhase& broad)
{
    double far = 0;
    for (const BlockTree* tree : {&broad.movers, &broad.resting, &broad.arrived}) {
        if (tree->height == 0) continue;
        const Box3f all = bound_of(tree->levels[static_cast<std::size_t>(tree->height - 1)][0]);
        for (int axis = 0; axis < 3; ++axis)
            if (all.min[axis] <= all.max[axis])
                far += std::fabs(static_cast<double>(all.min[axis])) +
                       std::fabs(static_cast<double>(all.max[axis]));
    }
    far += sum_of_magnitudes(load(ray.origin) - broad.origin);
    const Vec3& d = ray.direction;
    const double longest = std::max({std::fabs(d.x()), std::fabs(d.y()), std::fabs(d.z())});
    return longest > 0 ? std::min(ray.t_max, 2 * far / longest) : 0;
}

template <class Met> void ask_unbounded(SceneData& data, const Plan& plan, Met& met)
{
    const Timed deciding(data.search.decide_seconds);
    for (const std::uint32_t slot : data.broad.unbounded)
        look_unsearched(data, plan, slot, met);
}

/// Tells of what a ray meets; returns a t before which it meets nothing that was not asked about.
template <class Tell> double cast(SceneData& data, const Asking& asking, const Ray& ray, Tell tell)
{
    Plan plan = asking.plan(ray.options);
    plan.category = ray.options.category;
    plan.mask = ray.options.mask;
    plan.grown = 0;
    plan.rules.grown = 0;
    plan.rules.until = 1;
    plan.rules.follow = 0;
    plan.with_unbounded = false; // the path ends where bounded bodies do
    const double end = leaving(ray, data.broad);
    Motion along;
    along.start.position = ray.origin;
    along.translation = end * ray.direction;
    const Packet packet = packet_of(sweep({Sphere{0}, along}, data.broad.origin), plan);
    plan.alone = &packet;

    Met met(data.store, plan, ray, tell);
    data.search.run(
        data.store, data.broad, plan, [](Chunk&) {},
        [&](Chunk& chunk) {
            for (const Candidate& c : by_time(chunk, chunk.candidates.count))
                met.look(c.b, c.t > 0 ? static_cast<double>(c.t) * end : 0); // the end may be infinite
            return met.until() >= 0;
        });
    ask_unbounded(data, plan, met);
    asking.write_ledger(plan, met.asked());
    return met.least_open();
}

Ray checked(const Vec3& origin, const Vec3& direction, double t_max, const SceneOptions& options)
{
    check(options);
    check_ray(origin, direction, t_max);
    return {origin, direction, t_max, options};
}

} // namespace

RayImpact Scene::ray_cast(const Vec3& origin, const Vec3& direction, double t_max,
                          const SceneOptions& options)
{
    const Ray ray = checked(origin, direction, t_max, options);
    const Asking asking(*data_);
    std::vector<RayImpact>& found = data_->rays;
    found.clear();
    const double open = brink::cast(*data_, asking, ray, keep_first(found, Ray::begins));
    if (!found.empty() && found.front().hit.t <= open) return found.front();
    RayImpact none;
    none.hit.t = std::min(open, t_max);
    none.hit.status = open < infinity ? Status::undecided : Status::separated;
    return none;
}

RayImpacts Scene::ray_cast_all(const Vec3& origin, const Vec3& direction, double t_max,
                               const SceneOptions& options)
{
    const Ray ray = checked(origin, direction, t_max, options);
    const Asking asking(*data_);
    std::vector<RayImpact>& found = data_->rays;
    found.clear();
    const double open = brink::cast(*data_, asking, ray, keep_all(found));
    const Timed ordering(data_->ledger.order_seconds);
    std::sort(found.begin(), found.end(),
              [](const RayImpact& x, const RayImpact& y) { return earlier(x, y); });
    return {found, std::min(open, t_max), open == infinity};
}

double Scene::visit_ray(const Vec3& origin, const Vec3& direction, const VisitorOf<RayImpact>& visitor,
                        double t_max, const SceneOptions& options)
{
    const Ray ray = checked(origin, direction, t_max, options);
    check_visitor(visitor);
    const Asking asking(*data_);
    return brink::cast(*data_, asking, ray, std::cref(visitor));
}

} // namespace brink
