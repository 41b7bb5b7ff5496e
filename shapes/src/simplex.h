// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector.h"

namespace brink {

/// Up to four points of the difference B - A, and the weights that make the point of their hull which is
/// nearest to the origin. Weights are never negative and sum to 1, so that the point lies in the hull
/// whatever rounding did.
struct Simplex {
    struct Corner {
        V3 w; // on_b - on_a
        V3 on_a, on_b;
        int in_a = 0, in_b = 0; // which corners of A and of B: -1 on smooth shapes
        double weight = 0;
    };
    int size = 0;
    union { // so that those beyond `size` are not cleared
        Corner corners[4];
    };

    Simplex() {} // NOLINT(modernize-use-equals-default): as in Core

    /// Which corners a point of the hull needs, in their order, and their weights.
    struct Needed {
        int count = 0;
        int corner[4] = {};
        double weight[4] = {};
    };
    /// What is known about where the origin lies.
    enum class Origin : unsigned char { anywhere, outside };

    /// The point that the weights stand for.
    [[nodiscard]] V3 point() const;
    /// The same point of the hull as one of A.
    [[nodiscard]] V3 on_a() const;
    /// Whether this very point is among the corners.
    [[nodiscard]] bool contains(const Corner&) const;
    /// One corner more; fewer than four before.
    void add(const Corner& c) { corners[size++] = c; }
    /// What the point nearest to the origin needs: four only where the origin is inside. The last corner must
    /// be the newest one. An origin known to be outside is so whatever rounding makes of a flat simplex.
    [[nodiscard]] Needed nearest(Origin) const;
    /// That point from the line or plane of its corners: true in direction where it is short, while the
    /// rounding of the weights tilts it.
    [[nodiscard]] V3 nearest_point(const Needed&) const;
    /// The same where it needs all of up to three.
    [[nodiscard]] V3 nearest_point() const;
    /// Weights for the point nearest to the origin of up to three corners, where that is likely to need them
    /// all: the same as reduce(), sooner.
    void weigh_all();
    /// Weights for a point in the plane of three corners, as true where they are a sliver as elsewhere.
    void weigh(V3 point);
    /// What a newest corner brings.
    enum class Taken : unsigned char { nearer, no_nearer, unclear };
    /// Takes the newest corner, the one past `size`, in beside those of which the nearest point `v` needs
    /// every one: it leaves what the nearest point needs then, and that in `v`, less true than
    /// nearest_point() tells it of a sliver. Weights wait until someone asks. Where rounding or an origin
    /// inside leave no plain answer it changes nothing.
    [[nodiscard]] Taken take_in(V3& v);
    /// Leaves only those corners.
    void keep(const Needed&);
    /// Both at once.
    void reduce(Origin origin = Origin::anywhere) { keep(nearest(origin)); }

    /// How far inside the origin lies, at least, of four corners; negative outside. Rounding not taken off.
    [[nodiscard]] double depth() const;
};

} // namespace brink
