// SPDX-License-Identifier: BSD-3-Clause
// The join's arithmetic for one instruction set: compiled once for each, in that one's namespace, after what
// says how its lanes are loaded (V, width, load, all_of, bits_of, Abs, Min, Max, Sqrt, IfThenElse). No
// include guard. Only + - * / and sqrt, in this order: every width finds the same.

JOIN_ATTR inline Mask overlap(const Boxes& boxes, const Box3f& box)
{
    Mask mask = 0;
    for (int i = 0; i < lanes; i += width) {
        const auto x =
            And(load(boxes.min[0] + i) <= all_of(box.max[0]), load(boxes.max[0] + i) >= all_of(box.min[0]));
        const auto y =
            And(load(boxes.min[1] + i) <= all_of(box.max[1]), load(boxes.max[1] + i) >= all_of(box.min[1]));
        const auto z =
            And(load(boxes.min[2] + i) <= all_of(box.max[2]), load(boxes.max[2] + i) >= all_of(box.min[2]));
        mask |= bits_of(And(And(x, y), z)) << i;
    }
    return mask;
}

/// Paths and boxes, side by side: the path of a ball of radius `radius` from `from` by `by`.
struct Passing {
    V from[3], by[3], radius;
    V low[3], high[3];
};

/// Where path and box are apart along a cross product of the path and an axis.
JOIN_ATTR inline Mask paths_apart(const Passing& p)
{
    const V half = all_of(0.5F), slack = all_of(tolerance::segment_slack);
    V h[3], q[3], e[3];
    for (int axis = 0; axis < 3; ++axis) {
        const V low = p.low[axis], high = p.high[axis];
        const V middle = half * low + half * high;
        h[axis] = half * p.by[axis];
        q[axis] = middle - (p.from[axis] + h[axis]);
        e[axis] = half * high - half * low + slack * (Abs(low) + Abs(high)) + p.radius +
                  slack * (Abs(p.from[axis]) + Abs(h[axis]));
    }
    const auto apart = [&](int x, int y) JOIN_ATTR {
        const V r = h[x] * q[y], m = h[y] * q[x];
        const V most = Abs(h[x]) * e[y] + Abs(h[y]) * e[x] + slack * (Abs(r) + Abs(m));
        return Abs(r - m) > most + (slack * most + all_of(tolerance::smallest_square));
    };
    return bits_of(Or(Or(apart(0, 1), apart(1, 2)), apart(2, 0)));
}

/// The lanes whose path is apart from a box.
JOIN_ATTR inline Mask paths_apart(const Balls& balls, float grown, const Box3f& box)
{
    Passing p;
    for (int axis = 0; axis < 3; ++axis) {
        p.low[axis] = all_of(box.min[axis]);
        p.high[axis] = all_of(box.max[axis]);
    }
    Mask mask = 0;
    for (int i = 0; i < lanes; i += width) {
        for (int axis = 0; axis < 3; ++axis) {
            p.from[axis] = load(balls.from[axis] + i);
            p.by[axis] = load(balls.by[axis] + i);
        }
        p.radius = load(balls.radius + i) + all_of(grown);
        mask |= paths_apart(p) << i;
    }
    return mask;
}

/// The boxes that one lane's path is apart from.
JOIN_ATTR inline Mask path_apart(const Balls& balls, std::uint32_t lane, float grown, const Boxes& boxes)
{
    Passing p;
    for (int axis = 0; axis < 3; ++axis) {
        p.from[axis] = all_of(balls.from[axis][lane]);
        p.by[axis] = all_of(balls.by[axis][lane]);
    }
    p.radius = all_of(balls.radius[lane]) + all_of(grown);
    Mask mask = 0;
    for (int i = 0; i < lanes; i += width) {
        for (int axis = 0; axis < 3; ++axis) {
            p.low[axis] = load(boxes.min[axis] + i);
            p.high[axis] = load(boxes.max[axis] + i);
        }
        mask |= paths_apart(p) << i;
    }
    return mask;
}

struct Meetings {
    Mask receding = 0, passing = 0, late = 0;
    alignas(64) float t[lanes] = {};
};

/// When one ball meets sixteen, or sixteen that stand still: the least distance over the time asked for, and
/// the root of the quadratic.
JOIN_ATTR inline void meet(const Balls& one, std::uint32_t lane, const Balls& balls, bool still,
                           const JoinRules& rules, Meetings& m)
{
    const V zero = all_of(0), follow = all_of(rules.follow), until = all_of(rules.until);
    const V slack = all_of(tolerance::ball_slack), least = all_of(tolerance::smallest_square);
    for (int i = 0; i < lanes; i += width) {
        V d[3], v[3];
        for (int axis = 0; axis < 3; ++axis) {
            d[axis] = load(balls.from[axis] + i) - all_of(one.from[axis][lane]);
            v[axis] = (still ? zero : follow * load(balls.by[axis] + i)) - all_of(one.by[axis][lane]);
        }
        const V sum = Abs(d[0]) + Abs(d[1]) + Abs(d[2]) + (Abs(v[0]) + Abs(v[1]) + Abs(v[2]));
        const V radius =
            load(balls.radius + i) + all_of(one.radius[lane]) + all_of(rules.grown) + slack * sum;
        const V square = radius * radius;
        const V enough =
            IfThenElse(sum <= all_of(tolerance::largest_squared), square + slack * square + least,
                       all_of(std::numeric_limits<float>::infinity()));
        const V dd = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
        const V b = d[0] * v[0] + d[1] * v[1] + d[2] * v[2];
        const V a = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        const auto nearing = b < zero;
        const V inverse = all_of(1) / a, nearest = (zero - b) * inverse;
        const V t = IfThenElse(nearing, Min(nearest, until), zero);
        const V x = d[0] + t * v[0], y = d[1] + t * v[1], z = d[2] + t * v[2];
        const auto apart = x * x + y * y + z * z > enough;

        // In times, not in squares of squares, which would leave the range of floats below 1e-9 and above
        // 1e9.
        const V c = (dd - square) * inverse;
        const V root = Sqrt(Max(nearest * nearest - c, zero) + slack * (dd * inverse));
        const V entry = c / (root + nearest);
        const V early = entry - all_of(tolerance::time_slack) * entry;
        const V start = IfThenElse(And(dd > enough, early > zero), early, zero); // NaN is not above zero
        store(m.t + i, start);
        m.receding |= bits_of(AndNot(nearing, apart)) << i;
        m.passing |= bits_of(And(nearing, apart)) << i;
        m.late |= bits_of(start > until) << i;
    }
}
