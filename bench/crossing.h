// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/ccd.h>
#include <random.h>

#include <array>
#include <string_view>

/// Steps in which two bodies certainly meet, by construction and not by anybody's solver.
///
/// Each is built backwards from the moment of contact. Pose the bodies so that they touch in one point P,
/// with a plane through P that has A on one side and B on the other, n its normal towards A. Let the relative
/// displacement of A over the step be D with n . D < 0, and the moment of contact be t*. At t* they touch.
/// At any t before it A stands at its touching pose moved by (t - t*) D, hence by (t* - t)(-n . D) > 0 beyond
/// the plane: they are apart. So t* is the first contact, whatever the rest of the shapes. After t* the point
/// of A that was at P moves into B's interior, so the contact is no graze. Rounding moves t* by less than
/// 1e-11: a few units in the last place of 15 m, at no less than 0.5 mm a step towards each other.
namespace brink::bench {

struct Crossing {
    Shape a, b;
    Motion motion_a, motion_b; // both only translate
    double contact = 0;        // t*, the true first contact, in (0, 1)
};

/// One kind of crossing. `draw` gives a random one (shapes, sides, directions, phase) at a relative speed in
/// wall thicknesses per step.
struct Scene {
    std::string_view name;      // in the CSV
    std::string_view title;     // in table and picture
    std::string_view thickness; // what "wall thickness" is here
    Crossing (*draw)(support::Random&, double speed);
};

/// A ball at a thin wall; a capsule at a thin box edge-on; two small balls.
extern const std::array<Scene, 3> scenes;

} // namespace brink::bench
