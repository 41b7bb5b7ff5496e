// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "quick_gap.h"

#include <optional>

/// Whether two moving shapes stay apart over a time, in doubles: each place looked at proves a time about it
/// by the two supporting planes there and a bound of how every point can move against them.
namespace brink::support {

class QuickPair {
public:
    /// A valid query, of which at most one shape is unbounded. It must live as long.
    explicit QuickPair(const Query&);

    const QuickBody& a() const { return a_; }
    const QuickBody& b() const { return b_; }
    double radii() const { return a_.radius + b_.radius; }
    const Vec3& origin() const { return origin_; }

    /// From A to B at t, in long double: where doubles find no direction that is good enough.
    Quick3 better_normal(double t) const;

    /// S of design promise 3.
    double scale() const { return scale_; }

    /// How far rounding may move a gap that is computed here. Taken, not derived: counted by the worst of
    /// every step it would be 12 eps S; in the tests it never was more than 1.7.
    double blur() const { return 4 * 0x1p-52 * scale_; }

private:
    const Query& query_;
    Vec3 origin_;
    QuickBody a_, b_;
    double scale_ = 0;
};

/// The pair at one time, and its gap.
struct QuickLook {
    double t = 0;
    QuickPlace a, b;
    QuickGap gap; // of the cores
    QuickLook(const QuickPair&, double t, const Quick3& hint, const QuickEffort&);

    /// Takes supporting planes along another unit normal, if they are farther apart.
    void try_normal(const Quick3&);
};

/// How long from a look, forwards or backwards in time, at most `most` > 0, the cores stay more than `level`
/// apart. `toward` is the normal of another look at that side, if there is one, after `after` > 0.
struct QuickToward {
    Quick3 normal;
    double after = 0;
};
enum class QuickWay : signed char { back = -1, on = 1 };
double quick_reach(const QuickPair&, const QuickLook&, QuickWay, double most, double level,
                   const std::optional<QuickToward>&);

/// Whether the cores are proven more than `level` apart over all the time between two looks; false where
/// that takes more than `budget` looks, or is not so. Adds the looks taken to `looks`.
struct QuickProof {
    bool apart = false;
    int looks = 0;
};
QuickProof quick_apart(const QuickPair&, const QuickLook& from, const QuickLook& to, double level,
                       int budget);

} // namespace brink::support
