// SPDX-License-Identifier: BSD-3-Clause
#include "epa.h"

#include "nearest.h"
#include "round_axis.h"
#include "simplex.h"
#include "support.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace brink {

namespace {

using Corner = Simplex::Corner;

constexpr int most_faces = 252;
constexpr int most_rounds = 64;                  // where there is no volume to grow in
constexpr int most_corners = most_faces / 2 + 2; // Euler

/// The corner of the difference B - A that lies farthest along m.
Corner extreme(const Core& a, const Core& b, V3 m)
{
    const SupportPoint on_a = farthest(a, -m), on_b = farthest(b, m);
    return {on_b.point - on_a.point, on_a.point, on_a.corner, on_b.corner, 1};
}

/// Of two corners the one that is farther by some measure of its place.
template <class Measure> Corner farther(const Corner& p, const Corner& q, Measure measure)
{
    return measure(q.w) > measure(p.w) ? q : p;
}

struct Face {
    int corner[3];
    V3 normal; // outwards, unit; zero for a face without an area
    double offset;
    bool final; // as far out as it gets, up to rounding
};

/// A point of A and what leads from there to one of B.
struct Witness {
    V3 on_a, v;
};

/// A closed surface of triangles between corners of the difference.
class Polytope {
public:
    Corner corners[most_corners];
    int count = 0;
    Face faces[most_faces];
    int face_count = 0;

    /// The first four corners, whatever their orientation.
    void close()
    {
        count = 4;
        const V3 n = face_normal(corners[0].w, corners[1].w, corners[2].w);
        if (dot(n, corners[3].w - corners[0].w) > 0) std::swap(corners[0], corners[1]);
        set_face(face_count++, 0, 1, 2);
        set_face(face_count++, 1, 0, 3);
        set_face(face_count++, 2, 1, 3);
        set_face(face_count++, 0, 2, 3);
    }

    /// The face nearest to the origin that is not final; -1 where all are.
    int nearest() const
    {
        int best = -1;
        for (int i = 0; i < face_count; ++i)
            if (!faces[i].final && (best < 0 || faces[i].offset < faces[best].offset)) best = i;
        return best;
    }

    bool has(const Corner& corner) const
    {
        for (int i = 0; i < count; ++i)
            if (corners[i].w == corner.w) return true;
        return false;
    }

    /// By how much more than a corner of the face rounding may move another point of its plane: slivers tilt
    /// about their longest edge.
    double tilt(const Face& f, V3 w) const
    {
        const Leaning t = leaning(corners[f.corner[0]].w, corners[f.corner[1]].w, corners[f.corner[2]].w);
        const V3 edge = t.q - t.p;
        return 1 + std::sqrt(norm_squared(across(w - t.p, edge)) / norm_squared(across(t.apex - t.p, edge)));
    }

    /// A new corner, seen from `face`; false where there is no room for it.
    bool grow(int face, const Corner& corner);

    /// Where its surface comes nearest to a point.
    Witness around(V3 point) const;

private:
    void set_face(int at, int i, int j, int k);
    void flood(int from, const bool (&barred)[most_faces], bool (&reached)[most_faces]) const;

    int free_[most_faces], free_count_ = 0;
    std::uint8_t owner_[most_corners][most_corners]; // the face that goes round with this edge
};

void Polytope::set_face(int at, int i, int j, int k)
{
    owner_[i][j] = owner_[j][k] = owner_[k][i] = static_cast<std::uint8_t>(at);
    const V3 p = corners[i].w, q = corners[j].w, r = corners[k].w, n = face_normal(p, q, r);
    const double length = norm(n);
    Face& f = faces[at];
    f = {{i, j, k}, {}, infinity, true}; // never seen
    if (!(length > 0)) return;
    f.normal = (1 / length) * n;
    f.offset = dot(f.normal, p);
    f.final = false;
}

/// Marks a face and all that hang together with it and are not barred.
void Polytope::flood(int from, const bool (&barred)[most_faces], bool (&reached)[most_faces]) const
{
    int open[most_faces], waiting = 0;
    reached[from] = true;
    open[waiting++] = from;
    while (waiting > 0) {
        const int* c = faces[open[--waiting]].corner;
        for (int i = 0; i < 3; ++i) {
            const int next = owner_[c[(i + 1) % 3]][c[i]];
            if (barred[next] || reached[next]) continue;
            reached[next] = true;
            open[waiting++] = next;
        }
    }
}

/// The new corner's cone takes the place of the faces seen from it. Rounding may leave islands among them, or
/// scatter some elsewhere: what is taken away hangs together, and so does what is left.
bool Polytope::grow(int face, const Corner& corner)
{
    bool seen[most_faces], kept[most_faces] = {}, gone[most_faces] = {};
    int darkest = face;
    double least = 0;
    for (int i = 0; i < face_count; ++i) {
        const bool empty = faces[i].offset == infinity;
        const double height = empty ? 0 : dot(faces[i].normal, corner.w) - faces[i].offset;
        seen[i] = height > 0 || i == face;
        if (height < least) least = height, darkest = i;
    }
    if (count == most_corners || darkest == face) return false;
    flood(darkest, seen, kept);
    flood(face, kept, gone);

    int border[most_faces][2], length = 0;
    for (int i = 0; i < face_count; ++i) {
        if (!gone[i]) continue;
        const int* c = faces[i].corner;
        for (int k = 0; k < 3; ++k) {
            const int from = c[k], to = c[(k + 1) % 3];
            if (gone[owner_[to][from]]) continue;
            if (length == most_faces) return false;
            border[length][0] = from;
            border[length++][1] = to;
        }
    }
    const auto removed = static_cast<int>(std::count(gone, gone + face_count, true));
    if (face_count + std::max(0, length - removed - free_count_) > most_faces) return false;
    for (int i = face_count - 1; i >= 0; --i) {
        if (!gone[i]) continue;
        faces[i] = {{}, {}, infinity, true};
        free_[free_count_++] = i;
    }
    corners[count] = corner;
    for (int i = 0; i < length; ++i)
        set_face(free_count_ > 0 ? free_[--free_count_] : face_count++, border[i][0], border[i][1], count);
    ++count;
    return true;
}

Witness witness(const Simplex& s)
{
    Witness w;
    for (int k = 0; k < s.size; ++k) {
        w.on_a = w.on_a + s.corners[k].weight * s.corners[k].on_a;
        w.v = w.v + s.corners[k].weight * s.corners[k].w;
    }
    return w;
}

Witness Polytope::around(V3 point) const
{
    Simplex best;
    double least = infinity;
    for (int i = 0; i < face_count; ++i) {
        const Face& f = faces[i];
        const double height = dot(f.normal, point) - f.offset;
        if (!(height * height < least)) continue;
        Simplex s{3, {}};
        for (int k = 0; k < 3; ++k) {
            s.corners[k] = corners[f.corner[k]];
            s.corners[k].w = s.corners[k].w - point;
        }
        s = s.reduced();
        const double square = norm_squared(s.point());
        if (!(square < least)) continue;
        least = square;
        best = s;
    }
    const Witness w = witness(best);
    return {w.on_a, point + w.v};
}

/// Four corners far apart; fewer where the difference has no volume.
int spread(const Core& a, const Core& b, double slack, Corner (&c)[most_corners])
{
    const auto length = [&](V3 w) { return norm_squared(w - c[0].w); };
    for (const V3 axis : {V3{1, 0, 0}, V3{0, 1, 0}, V3{0, 0, 1}}) {
        const Corner low = extreme(a, b, -axis), high = extreme(a, b, axis);
        const bool longer = norm_squared(high.w - low.w) > length(c[1].w);
        if (longer || axis.x == 1) c[0] = low, c[1] = high;
    }
    if (!(norm(c[1].w - c[0].w) > slack)) return 1;

    const V3 along = c[1].w - c[0].w, aside = any_perpendicular(along);
    const V3 upright = (1 / norm(along)) * cross(along, aside);
    const auto width = [&](V3 w) { return norm_squared(across(w - c[0].w, along)); };
    c[2] = farther(farther(extreme(a, b, aside), extreme(a, b, -aside), width),
                   farther(extreme(a, b, upright), extreme(a, b, -upright), width), width);
    if (!(width(c[2].w) > slack * slack)) return 2;

    const V3 n = face_normal(c[0].w, c[1].w, c[2].w), normal = (1 / norm(n)) * n;
    if (n == V3{}) return 2;
    const auto height = [&](V3 w) { return std::fabs(dot(normal, w - c[0].w)); };
    c[3] = farther(extreme(a, b, normal), extreme(a, b, -normal), height);
    return height(c[3].w) > slack ? 4 : 3;
}

/// A difference without a volume: its own plane, or one that holds its line or point.
Penetration flat(const Core& a, const Core& b, const Corner (&c)[most_corners], int size)
{
    V3 n = size == 3 ? face_normal(c[0].w, c[1].w, c[2].w) : any_perpendicular(c[size - 1].w - c[0].w);
    n = (1 / norm(n)) * n;
    const double ahead = gap_along(a, b, n), behind = gap_along(a, b, -n);
    const double gap = std::max(ahead, behind);
    Simplex simplex;
    for (int i = 0; i < size; ++i)
        simplex = simplex.with(c[i]).reduced();
    for (int round = 0; round < most_rounds; ++round) {
        const V3 v = simplex.point();
        const Corner corner = extreme(a, b, dot(n, v) * n - v);
        if (simplex.size == 4 || simplex.contains(corner)) break;
        const Simplex next = simplex.with(corner).reduced();
        if (!(norm_squared(next.point()) < norm_squared(v))) break;
        simplex = next;
    }
    const Witness w = witness(simplex);
    return {gap, gap, ahead >= behind ? n : -n, w.on_a, w.v};
}

Penetration expanded(const Core& a, const Core& b, double slack)
{
    Polytope polytope;
    const int size = spread(a, b, slack, polytope.corners);
    if (size < 4) return flat(a, b, polytope.corners, size);
    polytope.close();
    Axis best;
    double least = 0;
    for (int round = 0; round < most_faces; ++round) {
        const int nearest = polytope.nearest();
        if (nearest < 0) break;
        Face& face = polytope.faces[nearest];
        least = face.offset;
        if (least + slack >= -best.gap) break;
        const Corner corner = extreme(a, b, face.normal);
        const double height = dot(face.normal, corner.w);
        if (-height > best.gap) best = {-height, -face.normal};
        if (height - least <= slack * polytope.tilt(face, corner.w) || polytope.has(corner))
            face.final = true;
        else if (!polytope.grow(nearest, corner))
            break;
    }
    best.gap = gap_along(a, b, best.normal);
    Penetration p{best.gap, std::max(best.gap, -least), best.normal, {}, {}};
    const Witness w = polytope.around(best.gap > slack ? V3{} : p.gap * best.normal);
    p.point_a = w.on_a;
    p.v = w.v;
    return p;
}

} // namespace

Penetration penetration(const Core& a, const Core& b, double slack)
{
    const Penetration found = expanded(a, b, slack);
    if (is_polytope(a) && is_polytope(b)) return found;
    const LocalTop local = locally_best(a, b, {found.lower, found.normal}, slack);
    const Axis axis = local.axis;
    if (!(axis.gap > found.lower - slack)) return found;
    Penetration p{axis.gap, local.top ? axis.gap : std::max(found.gap, axis.gap), axis.normal, found.point_a,
                  found.v};
    // Where it is apart, the shortest v; else the one that is most nearly upright on the surface.
    const V3 wanted = axis.gap > 0 ? V3{} : axis.gap * axis.normal;
    if (norm_squared(local.v - wanted) < norm_squared(found.v - wanted))
        p.point_a = local.point_a, p.v = local.v;
    return p;
}

} // namespace brink
