// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "exact_polytope.h"

namespace brink::exact {

/// A square of a length.
struct Square {
    Number over, under; // under > 0
};
bool less(const Square&, const Square&);

/// Of up to four corners of a polytope, the corner, edge or face that is nearest to the origin: what GJK goes
/// on from, with nothing rounded.
class Nearest {
public:
    int count = 0;
    Point corner[4];
    Square distance;

    /// From the origin to it, of any length.
    Point way() const;
    /// With the last corner taken in beside those before, which were nearest without it. Whether the origin
    /// is inside of all four.
    bool take_in();

private:
    struct Choice {
        int corners[3];
        int count;
    };
    void edge(int i, int k, Choice& best);
    void face(int i, int k, int l, Choice& best);
    bool inside() const;
    void offer(const Square&, const Choice&, Choice& best);
};

} // namespace brink::exact
