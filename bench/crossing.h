// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/ccd.h>
#include <random.h>

#include <array>
#include <string_view>

/// Steps in which two bodies certainly meet, by construction and not by anybody's solver.
///
/// Each is built backwards from the moment of contact t*, with a proof that the bodies are apart before it
/// and interpenetrate after it. Those that turn: crossing_turning.cpp. Those that only translate: pose the
/// bodies so that they touch in one point P, with a plane through P that has A on one side and B on the
/// other, n its normal towards A. Let the relative displacement of A over the step be D with n . D < 0. At t*
/// they touch. At any t before it A stands at its touching pose moved by (t - t*) D, hence by (t* - t)(-n .
/// D) > 0 beyond the plane: they are apart. So t* is the first contact, whatever the rest of the shapes.
/// After t* the point of A that was at P moves into B's interior, so the contact is no graze. Rounding moves
/// t* by less than 1e-11: a few units in the last place of 15 m, at no less than 0.5 mm a step towards each
/// other.
namespace brink::bench {

struct Crossing {
    Shape a, b;
    Motion motion_a, motion_b;
    double contact = 0; // t*, the true first contact, in (0, 1)
};

/// One kind of crossing. `draw` gives a random one (shapes, sides, directions, phase) at a relative speed of
/// the points that meet, or of the centres where a spin adds to it, in wall thicknesses per step.
struct Scene {
    std::string_view name;      // in the CSV
    std::string_view title;     // in table and picture
    std::string_view thickness; // what "wall thickness" is here
    Crossing (*draw)(support::Random&, double speed);
};

/// A ball at a thin wall; a capsule at a thin box edge-on; two small balls; then what turns: a rod at a post,
/// a blade at a ball, a box at a wall.
extern const std::array<Scene, 6> scenes;
inline constexpr std::size_t translating_scenes = 3; // of these, the first

} // namespace brink::bench
