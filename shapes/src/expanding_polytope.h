// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "simplex.h"

#include <cstdint>

namespace brink {

/// A point of A and what leads from there to one of B.
struct Witness {
    V3 on_a, v;
};
/// The point that a simplex stands for.
Witness witness(const Simplex&);

/// A closed surface of triangles between points of a convex body, which grows with each new one. It stays
/// closed by construction, whatever rounding decides, and needs no memory but the stack's.
class ExpandingPolytope {
public:
    static constexpr int most_faces = 252;
    static constexpr int most_corners = most_faces / 2 + 2; // Euler
    using Corner = Simplex::Corner;

    struct Face {
        int corner[3];
        V3 normal; // outwards, unit; zero for a face without an area
        double offset;
    };

    /// Four points that do not lie in a plane.
    explicit ExpandingPolytope(const Corner (&first)[4]);

    /// How many places there are for faces: those that are gone name one corner three times.
    int places() const { return face_count_; }
    const Face& face(int i) const { return faces_[i]; }
    /// The face that is nearest to the origin, or the farthest before it, and not final; -1 where all are.
    int nearest() const;
    /// Makes a face final: as far out as it gets, up to rounding.
    void finish(int face) { open_[face] = infinity; }
    /// The face that w is the farthest beyond; -1 where it is beyond none.
    int brightest(V3 w) const;
    bool has(const Corner&) const;
    /// By how much more than a corner of the face rounding may move another point of its plane: slivers tilt
    /// about their longest edge.
    double tilt(const Face&, V3 w) const;
    /// A new corner, seen from a face; false where there is no room for it.
    bool grow(int face, const Corner&);
    /// Where its surface comes nearest to a point.
    Witness around(V3 point) const;

private:
    struct Region;
    void set_face(int at, int i, int j, int k);
    void flood(int from, const bool (&barred)[most_faces], bool (&reached)[most_faces]) const;
    double height(int face, V3 w) const;
    bool enclose(Region&, const bool (&inside)[most_faces]) const;
    bool see_nearby(Region&, int face, V3 w);
    bool see_all(Region&, int face, V3 w) const;

    Corner corners_[most_corners];
    Face faces_[most_faces];
    double open_[most_faces]; // the offsets of faces that are not final, else infinity
    bool marked_[most_faces] = {};
    int count_ = 4, face_count_ = 0;
    int free_[most_faces], free_count_ = 0;          // places of faces that are gone
    std::uint8_t owner_[most_corners][most_corners]; // the face that goes round with this edge
};

} // namespace brink
