// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector.h"

#include <vector>

namespace brink {

/// What copies of a Hull share. Its unit of length is the power of two in which the largest coordinate lies
/// in [1, 2): products of directions and corners stay in range whatever the scale. The vertices alone are in
/// the caller's lengths.
struct HullData {
    std::vector<Vec3> vertices;
    // Corners, one list for each coordinate, so that a scan is vectors' work; each filled up with NaN, which
    // is never higher than another, to a multiple of four.
    std::vector<double> x, y, z;
    double unit = 1;
    V3 middle;        // of a ball that holds all corners,
    double ball = 0;  // and its radius
    double reach = 0; // the largest sum of a corner's coordinates without their signs

    // Only where the hull is proven to have these edges; else empty.
    std::vector<int> neighbours;      // of all corners, one after the other
    std::vector<int> first_neighbour; // where those of a corner begin; one more than there are corners

    // Planes x . (face_x, face_y, face_z) <= face_offset, an even number, of unit normals: what is on the
    // near side of all of them is proven to lie in the hull. Empty where none are known.
    std::vector<double> face_x, face_y, face_z, face_offset;

    int count() const { return static_cast<int>(vertices.size()); }
    V3 corner(int k) const
    {
        const auto i = static_cast<std::size_t>(k);
        return {x[i], y[i], z[i]};
    }
};

/// The corner that lies farthest along d.
int farthest(const HullData&, V3 d);
/// How far a point is from the nearest of the planes, on the near side of all of them; else not positive.
double depth(const HullData&, V3 point);

} // namespace brink
