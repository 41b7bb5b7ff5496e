// SPDX-License-Identifier: BSD-3-Clause
// Rays against the bodies where they stand at the start.
#include "packet.h"
#include "scene_data.h"
#include "sweep.h"
#include "tolerance.h"

#include <algorithm>
#include <cmath>

namespace brink {

namespace {

struct Ray {
    const Vec3& origin;
    const Vec3& direction;
    double t_max;
    const SceneOptions& options;
};

/// As many lengths of `direction` as it takes to leave all trees behind, at most t_max: bounds in floats need
/// an end.
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

bool is_hit(const RayHit& hit) { return hit.status == Status::hit || hit.status == Status::touching; }
bool earlier(const RayImpact& x, const RayImpact& y)
{
    return x.hit.t != y.hit.t ? x.hit.t < y.hit.t : x.body < y.body;
}

enum class Wanted : unsigned char { first, all };

/// Puts what the ray meets into data.rays: all, or only the first of them.
void cast_ray(SceneData& data, const Ray& ray, Wanted wanted)
{
    const Asking asking(data);
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

    data.rays.clear();
    Asked asked;
    const auto look = [&](const Candidate& c) {
        const bool known = wanted == Wanted::first && !data.rays.empty();
        if (known && static_cast<double>(c.t) * end > data.rays.front().hit.t) {
            ++asked.late;
            return;
        }
        ++asked.exact;
        const Body& b = data.store.bodies[c.b];
        const RayImpact r{data.store.ids[c.b],
                          ray_cast(ray.origin, ray.direction, b.shape, b.motion.start, ray.t_max)};
        if (!is_hit(r.hit) || !(plan.without.bits == 0 || meets(c, data.store, plan))) return;
        if (!known)
            data.rays.push_back(r);
        else if (earlier(r, data.rays.front()))
            data.rays.front() = r;
    };
    data.search.run(
        data.store, data.broad, plan, [](Chunk&) {},
        [&](Chunk& chunk) {
            for (const Candidate& c : by_time(chunk, chunk.candidates.count))
                look(c);
            return true;
        });
    for (const std::uint32_t slot : data.broad.unbounded) {
        const Candidate c{no_slot, slot, 0};
        ++data.search.counts.met;
        if (plan.without.has(Layer::mask) || meets(c, data.store, plan))
            look(c);
        else
            ++data.search.masked;
    }
    asking.write_ledger(plan, asked);
}

} // namespace

RayImpact Scene::ray_cast(const Vec3& origin, const Vec3& direction, double t_max,
                          const SceneOptions& options)
{
    check(options);
    check_ray(origin, direction, t_max);
    cast_ray(*data_, {origin, direction, t_max, options}, Wanted::first);
    if (!data_->rays.empty()) return data_->rays.front();
    RayImpact none;
    none.hit.status = Status::separated;
    none.hit.t = t_max;
    return none;
}

std::span<const RayImpact> Scene::ray_cast_all(const Vec3& origin, const Vec3& direction, double t_max,
                                               const SceneOptions& options)
{
    check(options);
    check_ray(origin, direction, t_max);
    cast_ray(*data_, {origin, direction, t_max, options}, Wanted::all);
    std::sort(data_->rays.begin(), data_->rays.end(),
              [](const RayImpact& x, const RayImpact& y) { return earlier(x, y); });
    return data_->rays;
}

} // namespace brink
