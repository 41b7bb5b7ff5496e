// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "lanes.h"

/// Two translating polytopes along the axes that can separate them, two axes at a time: each is a slab that
/// the path of one point enters and leaves (separating axes: S. Gottschalk, M. Lin and D. Manocha 1996).
namespace brink {

/// The latest entry and the earliest exit. No contact but between them.
struct Stay {
    double in, out;
    int axis; // the last one to be entered; -1: none
};

/// 2 N slabs |from + t by| <= reach, along axes that are at most of unit length.
template <int N> class Slabs {
public:
    void set(int k, Two from, Two by, Two reach)
    {
        from_[k] = against(from, by);
        pace_[k] = both(1) / magnitude(by);
        reach_[k] = reach;
    }

    /// With reaches so much larger that no rounding can miss, within the whole step: `t_max`
    /// must not decide what is in doubt. An axis along which nothing
    /// moves is infinitely early or late, and on the slab's border NaN, which says nothing.
    Stay stay(double margin) const
    {
        Two in{}, out = both(1), axis = both(-1);
        for (int k = 0; k < N; ++k) {
            const Two reach = reach_[k] + both(margin), begin = (from_[k] - reach) * pace_[k];
            axis = select(begin > in, Two{2.0 * k, 2.0 * k + 1}, axis);
            in = larger(begin, in);
            out = smaller((from_[k] + reach) * pace_[k], out);
        }
        const int last = in[1] > in[0] ? 1 : 0;
        return {in[last], out[1] < out[0] ? out[1] : out[0], static_cast<int>(axis[last])};
    }

    /// The axes, one bit each, along which the point is not proven to be within reach from t to t_upper.
    unsigned contested(double margin, double t, double t_upper) const
    {
        unsigned open = 0;
        for (int k = 0; k < N; ++k) {
            const Two reach = reach_[k] - both(margin);
            const TwoFlags within =
                ((from_[k] - reach) * pace_[k] <= both(t)) & ((from_[k] + reach) * pace_[k] >= both(t_upper));
            open |= (bits(within) ^ 3U) << (2 * k);
        }
        return open;
    }

private:
    Two from_[N], pace_[N], reach_[N]; // `from` mirrored, so that the point moves towards it
};

} // namespace brink
