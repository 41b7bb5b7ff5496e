// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "digits.h"

#include <optional>

/// The corners, edges and faces that a convex core is made of, each grown by a radius: the rounded core is
/// the union of balls, cylinders between two ends and slabs over a face.
namespace brink::support {

/// Decisions nearer than this, times the scale, are in doubt unless they were computed without rounding.
inline const Digits doubt{"1e-90"};

/// A point's foot this far outside a feature's border, times the scale, still counts as on it: rounding must
/// not make it miss both neighbours.
inline const Digits border{"1e-95"};

/// One feature. The distance of a point from its line or plane is |offset(point)| / sqrt(weight), and
/// offset() is linear.
struct Feature {
    enum class Kind : unsigned char { corner, edge, triangle, parallelogram };
    Kind kind = Kind::corner;
    Digits3 at;                                // a corner of it
    Digits3 u, v;                              // the edge; the two edges of a face
    Digits3 normal;                            // of a face: u x v
    Digits weight = 1;                         // |u|^2 of an edge, |normal|^2 of a face
    Digits unit_u = 0, unit_v = 0, unit_w = 0; // what turns the border tests of foot_inside into lengths
    bool exact = true;                         // normal and weight were computed without rounding

    Digits3 offset(const Digits3& from_at) const;

    /// Whether the point's foot is at most `outside` (a length; negative: at least so far inside) beyond the
    /// borders. A corner has none.
    bool foot_inside(const Digits3& point, const Digits& outside) const;

    /// Squared distance from the line or plane.
    Digits squared_distance(const Digits3& point) const;
};

Feature corner(const Digits3& at);
/// None without a length.
std::optional<Feature> edge(const Digits3& from, const Digits3& to);
/// None without an area: its edges are all there is.
std::optional<Feature> face(Feature::Kind, const Digits3& at, const Digits3& u, const Digits3& v);

/// A moving point: from + t * by.
struct Ray {
    Digits3 from, by;
    bool exact = true; // both were computed without rounding
    Digits3 at(const Digits& t) const { return from + t * by; }
};

struct FirstTouch {
    Digits t;
    Digits closing_speed; // length per step
    bool exact = false;   // t was computed without rounding
    bool certain = false; // that there is this contact, whatever the rounding
};

/// When the point first comes within `radius` of the feature, from outside of it, at a foot on it.
std::optional<FirstTouch> first_touch(const Feature&, const Ray&, const Digits& radius, const Digits& scale);

/// When the point is nearest to the feature's line or plane; none where the distance stays.
std::optional<Digits> nearest_time(const Feature&, const Ray&);

} // namespace brink::support
