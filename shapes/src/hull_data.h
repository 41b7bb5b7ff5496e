// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector.h"

#include <algorithm>
#include <cstddef>
#include <vector>

namespace brink {

/// What copies of a Hull share. Its unit of length is the power of two in which the largest coordinate lies
/// in [1, 2): products of directions and corners stay in range whatever the scale. The vertices alone are in
/// the caller's lengths. What a query reads lies side by side: among many hulls most of its time would be
/// waiting for memory.
struct alignas(64) HullData {
    /// Four corners, a register for each coordinate; past the last one NaN, which is never higher than
    /// another.
    struct alignas(32) Corners {
        double x[4], y[4], z[4];
    };
    /// Two planes x . (x, y, z) <= offset with unit normals.
    struct alignas(64) Faces {
        double x[2], y[2], z[2], offset[2];
    };

    /// How the corner farthest along a direction is found soonest: by looking at all of them, in wide
    /// registers where the machine has such, or by walking from one to the next.
    enum class Search : unsigned char { wide_scan, scan, climb };

    double unit = 1;
    double reach = 0; // the largest sum of a corner's coordinates without their signs
    V3 middle;        // of a ball that holds all corners,
    double ball = 0;  // and its radius
    int count = 0;    // of the corners
    Search search = Search::scan;
    std::vector<Corners> corners;
    // What is on the near side of all of these is proven to lie in the hull. Empty where none are known; of
    // an odd number the last plane is as far as can be.
    std::vector<Faces> faces;

    // Only where the hull is proven to have these edges; else empty.
    std::vector<int> neighbours;      // of all corners, one after the other
    std::vector<int> first_neighbour; // where those of a corner begin; one more than there are corners

    std::vector<Vec3> vertices;

    V3 corner(int k) const
    {
        const Corners& four = corners[static_cast<std::size_t>(k) / 4];
        const std::size_t i = static_cast<std::size_t>(k) % 4;
        return {four.x[i], four.y[i], four.z[i]};
    }
};

/// Asks the memory for what will be read before long, as far as that is little: among many hulls most of the
/// time of a first reading is waiting.
template <class T> void expect(const std::vector<T>& all)
{
    constexpr std::size_t line = 64, most = 32 * line;
    const char* bytes = reinterpret_cast<const char*>(all.data());
    for (std::size_t k = 0; k < std::min(all.size() * sizeof(T), most); k += line)
        __builtin_prefetch(bytes + k);
}

/// Of a hull that is complete but for that.
HullData::Search quickest_search(const HullData&);
/// The corner that lies farthest along d.
int farthest(const HullData&, V3 d);
/// How far a point is from the nearest of the planes, on the near side of all of them; else not positive.
double depth(const HullData&, V3 point);

} // namespace brink
