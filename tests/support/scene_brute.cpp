// SPDX-License-Identifier: BSD-3-Clause
#include "scene_brute.h"

#include "scenes.h"

#include <brink/overlap.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace brink::support {

namespace {

bool unbounded(const Body& b)
{
    return std::holds_alternative<Plane>(b.shape) || std::holds_alternative<HalfSpace>(b.shape);
}
bool rests(const Body& b) { return b.immovable || b.asleep; }

template <class Ask> void every_pair(const SceneModel& model, Ask ask)
{
    const auto n = static_cast<BodyId>(model.bodies.size());
    for (BodyId a = 0; a < n; ++a)
        for (BodyId b = a + 1; b < n; ++b)
            if (model.asked(a, b)) ask(a, b);
}

void order(std::vector<Impact>& impacts)
{
    std::sort(impacts.begin(), impacts.end(), [](const Impact& x, const Impact& y) {
        if (x.toi.t != y.toi.t) return x.toi.t < y.toi.t;
        return x.a != y.a ? x.a < y.a : x.b < y.b;
    });
}

bool same(double x, double y)
{
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y) ||
           (std::isnan(x) && std::isnan(y));
}
bool same(const Vec3& x, const Vec3& y)
{
    return same(x.x(), y.x()) && same(x.y(), y.y()) && same(x.z(), y.z());
}

} // namespace

std::size_t SceneModel::count() const
{
    return bodies.size() - static_cast<std::size_t>(std::count(gone.begin(), gone.end(), true));
}

bool SceneModel::asked(BodyId i, BodyId k) const
{
    if (!gone.empty() && (gone[i] || gone[k])) return false;
    const Body &a = bodies[i], &b = bodies[k];
    if ((rests(a) && rests(b)) || (unbounded(a) && unbounded(b))) return false;
    if ((a.category & b.mask) == 0 || (b.category & a.mask) == 0) return false;
    return !filter || filter(i, k);
}

std::vector<Impact> SceneModel::impacts(const Options& options) const
{
    std::vector<Impact> found;
    every_pair(*this, [&](BodyId i, BodyId k) {
        const Body &a = bodies[i], &b = bodies[k];
        const Toi toi = time_of_impact(a.shape, a.motion, b.shape, b.motion, options);
        if (toi.status != Status::separated) found.push_back({i, k, toi});
    });
    order(found);
    return found;
}

std::vector<BodyPair> SceneModel::overlapping() const
{
    std::vector<BodyPair> found;
    every_pair(*this, [&](BodyId i, BodyId k) {
        const Body &a = bodies[i], &b = bodies[k];
        if (overlaps(a.shape, a.motion.start, b.shape, b.motion.start)) found.push_back({i, k});
    });
    return found;
}

std::vector<Impact> SceneModel::cast(const Shape& shape, const Motion& motion,
                                     const SceneOptions& options) const
{
    std::vector<Impact> found;
    for (BodyId i = 0; i < bodies.size(); ++i) {
        const Body& b = bodies[i];
        if (!gone.empty() && gone[i]) continue;
        if ((b.category & options.mask) == 0 || (options.category & b.mask) == 0) continue;
        const Toi toi = time_of_impact(shape, motion, b.shape, b.motion, options.pair);
        if (toi.status != Status::separated && toi.status != Status::invalid)
            found.push_back({no_body, i, toi});
    }
    order(found);
    return found;
}

std::vector<RayImpact> SceneModel::rays(const Vec3& origin, const Vec3& direction, double t_max,
                                        const SceneOptions& options) const
{
    std::vector<RayImpact> found;
    for (BodyId i = 0; i < bodies.size(); ++i) {
        const Body& b = bodies[i];
        if (!gone.empty() && gone[i]) continue;
        if ((b.category & options.mask) == 0 || (options.category & b.mask) == 0) continue;
        const RayHit hit = ray_cast(origin, direction, b.shape, b.motion.start, t_max);
        if (hit.status == Status::hit || hit.status == Status::touching) found.push_back({i, hit});
    }
    std::stable_sort(found.begin(), found.end(),
                     [](const RayImpact& x, const RayImpact& y) { return x.hit.t < y.hit.t; });
    return found;
}

SceneModel draw_model(std::string_view name, std::size_t n, std::uint64_t seed)
{
    SceneModel model{draw_scene(name, n, seed).bodies, {}, {}};
    model.gone.resize(model.bodies.size(), false);
    return model;
}

Scene scene_of(const SceneModel& model)
{
    Scene scene;
    for (const Body& body : model.bodies)
        scene.add(body);
    if (model.filter) scene.set_filter(model.filter);
    return scene;
}

bool same(const Toi& x, const Toi& y)
{
    return x.status == y.status && same(x.t, y.t) && same(x.t_upper, y.t_upper) && same(x.normal, y.normal) &&
           same(x.point_a, y.point_a) && same(x.point_b, y.point_b) && same(x.gap, y.gap) &&
           x.iterations == y.iterations;
}

bool same(const Impact& x, const Impact& y) { return x.a == y.a && x.b == y.b && same(x.toi, y.toi); }

} // namespace brink::support
