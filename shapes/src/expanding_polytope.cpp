// SPDX-License-Identifier: BSD-3-Clause
#include "expanding_polytope.h"

#include "lanes.h"
#include "nearest.h"

#include <algorithm>
#include <utility>

namespace brink {

/// Faces that hang together, in their order, and the edges around them.
struct ExpandingPolytope::Region {
    int count = 0, length = 0;
    int faces[most_faces], edges[most_faces][2];

    Region() {} // NOLINT(modernize-use-equals-default): as in Core
    /// Whether the edges go round once: then the faces around hang together, too.
    bool closed_once() const;
};

Witness witness(const Simplex& s)
{
    Witness w;
    for (int k = 0; k < s.size; ++k) {
        w.on_a = w.on_a + s.corners[k].weight * s.corners[k].on_a;
        w.v = w.v + s.corners[k].weight * s.corners[k].w;
    }
    return w;
}

ExpandingPolytope::ExpandingPolytope(const Corner (&first)[4])
{
    std::copy(first, first + 4, corners_);
    const V3 n = face_normal(first[0].w, first[1].w, first[2].w);
    if (dot(n, first[3].w - first[0].w) > 0) std::swap(corners_[0], corners_[1]);
    set_face(face_count_++, 0, 1, 2);
    set_face(face_count_++, 1, 0, 3);
    set_face(face_count_++, 2, 1, 3);
    set_face(face_count_++, 0, 2, 3);
}

void ExpandingPolytope::set_face(int at, int i, int j, int k)
{
    owner_[i][j] = owner_[j][k] = owner_[k][i] = static_cast<std::uint8_t>(at);
    const V3 p = corners_[i].w, n = face_normal(p, corners_[j].w, corners_[k].w);
    const double length = norm(n);
    Face& f = faces_[at];
    f = {{i, j, k}, {}, infinity};
    finish(at);
    if (!(length > 0)) return;
    f.normal = (1 / length) * n;
    f.offset = open_[at] = dot(f.normal, p);
}

/// How far a point is beyond a face; 0 for one that is gone or has no area.
double ExpandingPolytope::height(int face, V3 w) const
{
    const Face& f = faces_[face];
    return f.offset == infinity ? 0 : dot(f.normal, w) - f.offset;
}

int ExpandingPolytope::nearest() const
{
    Two low = both(infinity);
    int i = 0;
    for (; i + 1 < face_count_; i += 2)
        low = smaller(load_two(&open_[i]), low);
    double least = std::min(low[0], low[1]);
    if (i < face_count_) least = std::min(least, open_[i]);
    if (!(least < infinity)) return -1;
    return static_cast<int>(std::find(open_, open_ + face_count_, least) - open_);
}

int ExpandingPolytope::brightest(V3 w) const
{
    int best = -1;
    double most = 0;
    for (int i = 0; i < face_count_; ++i) {
        const double above = height(i, w);
        if (above > most) most = above, best = i;
    }
    return best;
}

bool ExpandingPolytope::has(const Corner& corner) const
{
    return std::any_of(corners_, corners_ + count_, [&](const Corner& c) { return c.w == corner.w; });
}

double ExpandingPolytope::tilt(const Face& f, V3 w) const
{
    const Leaning t = leaning(corners_[f.corner[0]].w, corners_[f.corner[1]].w, corners_[f.corner[2]].w);
    const V3 edge = t.q - t.p;
    return 1 + std::sqrt(norm_squared(across(w - t.p, edge)) / norm_squared(across(t.apex - t.p, edge)));
}

/// Marks a face and all that hang together with it and are not barred.
void ExpandingPolytope::flood(int from, const bool (&barred)[most_faces], bool (&reached)[most_faces]) const
{
    int open[most_faces], waiting = 0;
    reached[from] = true;
    open[waiting++] = from;
    while (waiting > 0) {
        const int* c = faces_[open[--waiting]].corner;
        for (int i = 0; i < 3; ++i) {
            const int next = owner_[c[(i + 1) % 3]][c[i]];
            if (barred[next] || reached[next]) continue;
            reached[next] = true;
            open[waiting++] = next;
        }
    }
}

bool ExpandingPolytope::Region::closed_once() const
{
    int after[most_corners] = {}, steps = 0; // one more than the corner
    for (int i = 0; i < length; ++i) {
        if (after[edges[i][0]] != 0) return false;
        after[edges[i][0]] = edges[i][1] + 1;
    }
    if (length == 0) return false;
    const int first = edges[0][0];
    int at = first;
    do
        at = after[at] - 1, ++steps;
    while (at != first && steps < length);
    return steps == length;
}

/// Finds the edges around a region; false where they are too many.
bool ExpandingPolytope::enclose(Region& r, const bool (&inside)[most_faces]) const
{
    for (int i = 0; i < r.count; ++i) {
        const int* c = faces_[r.faces[i]].corner;
        for (int k = 0; k < 3; ++k) {
            const int from = c[k], to = c[(k + 1) % 3];
            if (inside[owner_[to][from]]) continue;
            if (r.length == most_faces) return false;
            r.edges[r.length][0] = from;
            r.edges[r.length++][1] = to;
        }
    }
    return true;
}

/// The faces that are seen from a corner and hang together with one that is taken for seen; false where
/// rounding leaves more than one way around them, or none.
bool ExpandingPolytope::see_nearby(Region& r, int face, V3 w)
{
    bool below = false;
    r.faces[r.count++] = face;
    marked_[face] = true;
    for (int i = 0; i < r.count; ++i) {
        const int* c = faces_[r.faces[i]].corner;
        for (int k = 0; k < 3; ++k) {
            const int next = owner_[c[(k + 1) % 3]][c[k]];
            if (marked_[next]) continue;
            const double above = height(next, w);
            below = below || above < 0;
            if (!(above > 0)) continue;
            marked_[next] = true;
            r.faces[r.count++] = next;
        }
    }
    std::sort(r.faces, r.faces + r.count);
    const bool enclosed = enclose(r, marked_);
    for (int i = 0; i < r.count; ++i)
        marked_[r.faces[i]] = false;
    return below && enclosed && r.closed_once();
}

/// The same by a look at all faces. Rounding may leave islands among them, or scatter some elsewhere: what is
/// taken away hangs together, and so does what is left.
bool ExpandingPolytope::see_all(Region& r, int face, V3 w) const
{
    bool seen[most_faces], kept[most_faces] = {}, gone[most_faces] = {};
    int darkest = face;
    double least = 0;
    for (int i = 0; i < face_count_; ++i) {
        const double above = height(i, w);
        seen[i] = above > 0 || i == face;
        if (above < least) least = above, darkest = i;
    }
    if (darkest == face) return false;
    flood(darkest, seen, kept);
    flood(face, kept, gone);
    r.count = r.length = 0;
    for (int i = 0; i < face_count_; ++i)
        if (gone[i]) r.faces[r.count++] = i;
    return enclose(r, gone);
}

/// The new corner's cone takes the place of the faces seen from it.
bool ExpandingPolytope::grow(int face, const Corner& corner)
{
    if (count_ == most_corners) return false;
    Region seen;
    if (!see_nearby(seen, face, corner.w) && !see_all(seen, face, corner.w)) return false;
    if (face_count_ + std::max(0, seen.length - seen.count - free_count_) > most_faces) return false;
    for (int i = seen.count - 1; i >= 0; --i) {
        const int place = seen.faces[i];
        faces_[place] = {{}, {}, infinity};
        finish(place);
        free_[free_count_++] = place;
    }
    corners_[count_] = corner;
    for (int i = 0; i < seen.length; ++i) {
        const int* edge = seen.edges[i];
        set_face(free_count_ > 0 ? free_[--free_count_] : face_count_++, edge[0], edge[1], count_);
    }
    ++count_;
    return true;
}

Witness ExpandingPolytope::around(V3 point) const
{
    Simplex best;
    double least = infinity;
    for (int i = 0; i < face_count_; ++i) {
        const Face& f = faces_[i];
        const double above = dot(f.normal, point) - f.offset;
        if (!(above * above < least)) continue;
        Simplex s;
        s.size = 3;
        for (int k = 0; k < 3; ++k) {
            s.corners[k] = corners_[f.corner[k]];
            s.corners[k].w = s.corners[k].w - point;
        }
        s.reduce();
        const double square = norm_squared(s.point());
        if (!(square < least)) continue;
        least = square;
        best = s;
    }
    const Witness w = witness(best);
    return {w.on_a, point + w.v};
}

} // namespace brink
