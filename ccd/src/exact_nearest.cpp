// SPDX-License-Identifier: BSD-3-Clause
#include "exact_nearest.h"

#include <algorithm>

namespace brink::exact {

bool less(const Square& s, const Square& t) { return (s.over * t.under - t.over * s.under).sign() < 0; }

Point Nearest::way() const
{
    const Point& a = corner[0];
    if (count == 1) return a;
    const Point e = corner[1] - a;
    if (count == 2) return dot(e, e) * a - dot(a, e) * e;
    const Point n = cross(e, corner[2] - a);
    return dot(n, a).sign() < 0 ? -n : n;
}

/// Its nearest point is that of one of the parts that the last corner makes, all of whose weights are
/// positive.
bool Nearest::take_in()
{
    const int last = count - 1;
    Choice best{{last}, 1};
    distance = {dot(corner[last], corner[last]), Number(1)};
    for (int i = 0; i < last; ++i) {
        edge(i, last, best);
        for (int k = i + 1; k < last; ++k)
            face(i, k, last, best);
    }
    if (count == 4 && inside()) return true;
    Point kept[3];
    for (int i = 0; i < best.count; ++i)
        kept[i] = corner[best.corners[i]];
    count = best.count;
    std::copy_n(kept, count, corner);
    return false;
}

void Nearest::edge(int i, int k, Choice& best)
{
    const Point &a = corner[i], &b = corner[k], e = b - a;
    const Number length = dot(e, e), past = -dot(a, e);
    if (past.sign() <= 0 || (length - past).sign() <= 0) return;
    offer({dot(a, a) * length - past * past, length}, {{i, k}, 2}, best);
}

void Nearest::face(int i, int k, int l, Choice& best)
{
    const Point &a = corner[i], &b = corner[k], &c = corner[l], n = cross(b - a, c - a);
    const Number area = dot(n, n);
    if (dot(n, cross(a, b)).sign() <= 0 || dot(n, cross(b, c)).sign() <= 0 || dot(n, cross(c, a)).sign() <= 0)
        return;
    const Number height = dot(n, a);
    offer({height * height, area}, {{i, k, l}, 3}, best);
}

bool Nearest::inside() const
{
    int all = 0;
    for (int i = 0; i < 4; ++i) {
        const Point &a = corner[(i + 1) % 4], &b = corner[(i + 2) % 4], &c = corner[(i + 3) % 4];
        const int side = dot(a, cross(b, c)).sign();
        all += i % 2 == 0 ? side : -side;
    }
    return all == 4 || all == -4;
}

void Nearest::offer(const Square& here, const Choice& choice, Choice& best)
{
    if (less(here, distance)) distance = here, best = choice;
}

} // namespace brink::exact
