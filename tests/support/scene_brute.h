// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/scene.h>

#include <string_view>
#include <vector>

/// A scene's questions answered pair by pair, without any culling.
namespace brink::support {

/// Bodies that a scene was given in this order: the index is the id. Those with an id in `gone` are not
/// there.
struct SceneModel {
    std::vector<Body> bodies;
    std::vector<bool> gone;
    Scene::PairFilter filter;

    std::size_t count() const;
    /// Whether the scene is to be asked about this pair at all, a < b.
    bool asked(BodyId a, BodyId b) const;
    std::vector<Impact> impacts(const Options& = {}) const;
    std::vector<BodyPair> overlapping() const;
    std::vector<Impact> cast(const Shape&, const Motion&, const SceneOptions& = {}) const;
    std::vector<RayImpact> rays(const Vec3& origin, const Vec3& direction, double t_max,
                                const SceneOptions& = {}) const;
};

/// The bodies of draw_scene(), all of them there.
SceneModel draw_model(std::string_view name, std::size_t n, std::uint64_t seed);

/// The bodies of a model in a scene, added one by one.
Scene scene_of(const SceneModel&);

/// Bit for bit, NaN being equal to NaN.
bool same(const Toi&, const Toi&);
bool same(const Impact&, const Impact&);

} // namespace brink::support
