// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/scene.h>

#include <array>
#include <string_view>
#include <vector>

/// Scenes of many bodies, the same for tests and benchmarks, and the same bits with every compiler.
namespace brink::support {

struct SceneSample {
    std::vector<Body> bodies;
    std::vector<Vec3> aside; // of each body: how far it goes in every other step
};

/// gas        spheres, boxes and capsules of about one size, all moving, thrown at random: some overlap
/// clustered  as gas, but of sizes over three decades, in clusters of 64 of about one size
/// bullets    99 % immovable boxes in a lattice; 1 % small balls that fly past ten of its cells
/// asleep     gas, 99 % of it asleep
/// stacks     towers of ten boxes at rest that touch exactly, on a half-space
/// rain       eight convex shapes that fall, turn and drift over an immovable ground, some about a pivot off
///            their centre
inline constexpr std::array<std::string_view, 6> scene_names{"gas",    "clustered", "bullets",
                                                             "asleep", "stacks",    "rain"};

/// n bodies, n >= 1, in random order. How many pairs each has does not depend on n, but for the rim. Throws
/// std::invalid_argument where there is no such scene.
SceneSample draw_scene(std::string_view name, std::size_t n, std::uint64_t seed);

/// The same bodies along a Morton curve through their positions.
SceneSample in_spatial_order(const SceneSample&);

/// The bodies that are neither immovable nor asleep.
std::vector<BodyId> movers(const SceneSample&);

/// How the bodies named move in this step, >= 0. They go round a parallelogram in four steps, so that a scene
/// neither disperses nor sweeps the same space twice in a row; what turns, turns back in the next step.
std::vector<Motion> motions_at(const SceneSample&, const std::vector<BodyId>&, int step);

} // namespace brink::support
