// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/aabb.h>
#include <brink/plane.h>
#include <brink/triangle.h>

/// The classical tests at one instant, as textbooks teach them. All in one frame, lengths in the scene's
/// unit. Sets are closed: tangency, shared edges and shared corners count. An input that is not finite meets
/// nothing. (C. Ericson, Real-Time Collision Detection, 2005, is the source where none is named.)
namespace brink::discrete {

/// Every point within `radius` of `centre`; radius >= 0.
struct Ball {
    Vec3 centre{0, 0, 0};
    double radius = 0;
};

/// Every point from + t (to - from) with t in [0, 1]. `from == to` is a point.
struct Segment {
    Vec3 from{0, 0, 0};
    Vec3 to{0, 0, 0};
};

/// Where a segment first meets something, seen from `from`.
struct SegmentHit {
    bool hit = false;
    double t = infinity;       // in [0, 1]; infinity without a hit
    Vec3 point{0, 0, 0};       // from + t (to - from)
    Vec3 barycentric{0, 0, 0}; // triangles only: point = x a + y b + z c; none negative, their sum is 1
};

/// |centre - centre|^2 <= (radius + radius)^2: no square root.
bool overlap(const Ball&, const Ball&);

/// Neither begins past the other's end, in any coordinate. min <= max in each of them; sides may be infinite.
bool overlap(const Aabb&, const Aabb&);

/// Whether the distance of the centre from the plane is at most the radius. The plane's normal is a unit
/// vector up to rounding.
bool overlap(const Ball&, const Plane&);

/// The first point of the segment on the plane. A segment in the plane meets it at t = 0.
SegmentHit first_meeting(const Segment&, const Plane&);

/// The first point of the segment on the triangle, from either side (T. Moller and B. Trumbore, Fast, Minimum
/// Storage Ray/Triangle Intersection, 1997). A segment in the triangle's plane meets its edges, or starts in
/// it; a degenerate triangle, which is a segment or a point, is met where the segment meets that exactly.
/// Lengths between 1e-50 and 1e50.
SegmentHit first_meeting(const Segment&, const Triangle&);

} // namespace brink::discrete
