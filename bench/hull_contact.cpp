// SPDX-License-Identifier: BSD-3-Clause
#include "hull_contact.h"

#include <reference_gap.h>

#include <algorithm>
#include <array>
#include <limits>

namespace brink::bench {
namespace {

using support::cross;
using support::direction;
using support::dot;
using support::norm;
using support::Real;
using support::Real3;
using support::real3;

/// exp(angle [axis]x) v, Rodrigues with 1 - cos as 2 sin^2 of the half.
Real3 turned(const Real3& v, const Real3& axis, Real angle)
{
    const Real h = support::sine(angle / 2);
    const Real3 av = cross(axis, v);
    return v + support::sine(angle) * av + (2 * h * h) * cross(axis, av);
}

/// Whether a point lies on either side of the plane through three corners.
struct Sides {
    bool above = false, below = false;
};

Sides sides(const std::vector<Real3>& corners, const std::array<std::size_t, 3>& plane, const Real3& normal)
{
    Sides out;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        if (std::find(plane.begin(), plane.end(), i) != plane.end()) continue;
        const Real height = dot(normal, corners[i] - corners[plane[0]]);
        (height > 0 ? out.above : out.below) = true;
    }
    return out;
}

} // namespace

HullsOverTime::Body::Body(const Hull& hull, const Motion& motion, const Real3& origin)
{
    const support::Real33 orientation = support::rotation_matrix(motion.start.orientation);
    const Real3 local = real3(motion.pivot);
    for (const Vec3& v : hull.vertices())
        corners.push_back(orientation * (real3(v) - local));
    pivot = (real3(motion.start.position) - origin) + orientation * local;
    translation = real3(motion.translation);
    turn = norm(real3(motion.rotation));
    axis = direction(real3(motion.rotation));
    for (const Real3& corner : corners)
        reach = std::max(reach, norm(corner));
    find_faces();
    find_edges();
}

void HullsOverTime::Body::find_faces()
{
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t j = i + 1; j < corners.size(); ++j)
            for (std::size_t k = j + 1; k < corners.size(); ++k) {
                const Real3 normal = direction(cross(corners[j] - corners[i], corners[k] - corners[i]));
                const Sides found = sides(corners, {i, j, k}, normal);
                if (found.above && found.below) continue;
                faces.push_back({found.above ? -normal : normal, i});
            }
}

/// An edge joins two corners that lie on the same two faces.
void HullsOverTime::Body::find_edges()
{
    // A corner lies on a face where it is as high as the face, which no other is (general position).
    const auto on = [&](std::size_t corner, const Face& face) {
        return std::abs(dot(face.normal, corners[corner] - corners[face.corner])) < 1e-14L * reach;
    };
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t j = i + 1; j < corners.size(); ++j) {
            std::vector<std::size_t> shared;
            for (std::size_t f = 0; f < faces.size(); ++f)
                if (on(i, faces[f]) && on(j, faces[f])) shared.push_back(f);
            if (shared.size() == 2) edges.push_back({i, j, shared[0], shared[1]});
        }
}

HullsOverTime::Body HullsOverTime::Body::at(Real t) const
{
    Body out = *this;
    const Real3 middle = pivot + t * translation;
    for (Real3& corner : out.corners)
        corner = middle + turned(corner, axis, t * turn);
    for (Face& face : out.faces)
        face.normal = turned(face.normal, axis, t * turn);
    return out;
}

Real HullsOverTime::beyond_faces(const Body& of, const Body& other)
{
    Real widest = -std::numeric_limits<Real>::infinity();
    for (const Face& face : of.faces) {
        Real least = std::numeric_limits<Real>::infinity();
        for (const Real3& corner : other.corners)
            least = std::min(least, dot(face.normal, corner - of.corners[face.corner]));
        widest = std::max(widest, least);
    }
    return widest;
}

/// The edges whose arcs on the Gauss sphere cross, B's mirrored (D. Gregorius, The Separating Axis Test
/// between Convex Polyhedra, 2013).
Real HullsOverTime::beyond_edges(const Body& a, const Body& b)
{
    Real widest = -std::numeric_limits<Real>::infinity();
    for (const Edge& e : a.edges) {
        const Real3& a1 = a.faces[e.left].normal;
        const Real3& a2 = a.faces[e.right].normal;
        const Real3 along_a = cross(a2, a1);
        for (const Edge& f : b.edges) {
            const Real3 b1 = -b.faces[f.left].normal;
            const Real3 b2 = -b.faces[f.right].normal;
            const Real one = dot(b1, along_a);
            const Real two = dot(b2, along_a);
            if (one * two >= 0) continue;
            const Real3 along_b =
                cross(b2, b1); // no use for the axis where the two faces nearly lie in one plane
            const Real three = dot(a1, along_b);
            const Real four = dot(a2, along_b);
            if (three * four >= 0 || one * four <= 0) continue;
            Real3 normal =
                direction(cross(a.corners[e.to] - a.corners[e.from], b.corners[f.to] - b.corners[f.from]));
            if (dot(normal, a1 + a2) < 0) normal = -normal;
            widest = std::max(widest, dot(normal, b.corners[f.from] - a.corners[e.from]));
        }
    }
    return widest;
}

HullsOverTime::HullsOverTime(const Hull& a, const Motion& motion_a, const Hull& b, const Motion& motion_b)
    : a_(a, motion_a, real3(motion_b.start.position)), b_(b, motion_b, real3(motion_b.start.position))
{
    const Real by = norm(b_.translation - a_.translation);
    fastest_ = by + a_.turn * a_.reach + b_.turn * b_.reach;
    scale_ = norm(b_.pivot - a_.pivot) + by + (1 + a_.turn) * a_.reach + (1 + b_.turn) * b_.reach;
}

Real HullsOverTime::separation(Real t) const
{
    const Body a = a_.at(t);
    const Body b = b_.at(t);
    return std::max({beyond_faces(a, b), beyond_faces(b, a), beyond_edges(a, b)});
}

} // namespace brink::bench
