// SPDX-License-Identifier: BSD-3-Clause
#include "expanding_polytope.h"

#include "nearest.h"

#include <algorithm>
#include <utility>

namespace brink {

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
    f = {{i, j, k}, {}, infinity, true};
    if (!(length > 0)) return;
    f.normal = (1 / length) * n;
    f.offset = dot(f.normal, p);
    f.final = false;
}

/// How far a point is beyond a face; 0 for one that is gone or has no area.
double ExpandingPolytope::height(int face, V3 w) const
{
    const Face& f = faces_[face];
    return f.offset == infinity ? 0 : dot(f.normal, w) - f.offset;
}

int ExpandingPolytope::nearest() const
{
    int best = -1;
    for (int i = 0; i < face_count_; ++i)
        if (!faces_[i].final && (best < 0 || faces_[i].offset < faces_[best].offset)) best = i;
    return best;
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

/// The new corner's cone takes the place of the faces seen from it. Rounding may leave islands among them, or
/// scatter some elsewhere: what is taken away hangs together, and so does what is left.
bool ExpandingPolytope::grow(int face, const Corner& corner)
{
    bool seen[most_faces], kept[most_faces] = {}, gone[most_faces] = {};
    int darkest = face;
    double least = 0;
    for (int i = 0; i < face_count_; ++i) {
        const double above = height(i, corner.w);
        seen[i] = above > 0 || i == face;
        if (above < least) least = above, darkest = i;
    }
    if (count_ == most_corners || darkest == face) return false;
    flood(darkest, seen, kept);
    flood(face, kept, gone);

    int border[most_faces][2], length = 0;
    for (int i = 0; i < face_count_; ++i) {
        if (!gone[i]) continue;
        const int* c = faces_[i].corner;
        for (int k = 0; k < 3; ++k) {
            const int from = c[k], to = c[(k + 1) % 3];
            if (gone[owner_[to][from]]) continue;
            if (length == most_faces) return false;
            border[length][0] = from;
            border[length++][1] = to;
        }
    }
    const auto removed = static_cast<int>(std::count(gone, gone + face_count_, true));
    if (face_count_ + std::max(0, length - removed - free_count_) > most_faces) return false;
    for (int i = face_count_ - 1; i >= 0; --i) {
        if (!gone[i]) continue;
        faces_[i] = {{}, {}, infinity, true};
        free_[free_count_++] = i;
    }
    corners_[count_] = corner;
    for (int i = 0; i < length; ++i)
        set_face(free_count_ > 0 ? free_[--free_count_] : face_count_++, border[i][0], border[i][1], count_);
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
