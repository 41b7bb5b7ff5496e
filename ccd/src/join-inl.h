// SPDX-License-Identifier: BSD-3-Clause
// The join for one instruction set: compiled once for each, in that one's namespace, between what says how
// its lanes are loaded (V, width, load, all_of, bits_of, Abs, Min, Max, Sqrt, IfThenElse, IfThenZeroElse) and
// a name for it. No include guard. Only + - * / and sqrt, in this order: every width finds the same.

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

/// The lanes whose path is apart from a box along a cross product of the path and an axis.
JOIN_ATTR inline Mask paths_apart(const Balls& balls, float grown, const Box3f& box)
{
    const V half = all_of(0.5F), slack = all_of(tolerance::segment_slack);
    V middle[3], extent[3];
    for (int axis = 0; axis < 3; ++axis) {
        const V low = all_of(box.min[axis]), high = all_of(box.max[axis]);
        middle[axis] = half * low + half * high;
        extent[axis] = half * high - half * low + slack * (Abs(low) + Abs(high));
    }
    Mask mask = 0;
    for (int i = 0; i < lanes; i += width) {
        V h[3], q[3], e[3];
        for (int axis = 0; axis < 3; ++axis) {
            const V from = load(balls.from[axis] + i);
            h[axis] = half * load(balls.by[axis] + i);
            q[axis] = middle[axis] - (from + h[axis]);
            e[axis] =
                extent[axis] + (load(balls.radius + i) + all_of(grown)) + slack * (Abs(from) + Abs(h[axis]));
        }
        const auto apart = [&](int x, int y) JOIN_ATTR {
            const V p = h[x] * q[y], m = h[y] * q[x];
            const V most = Abs(h[x]) * e[y] + Abs(h[y]) * e[x] + slack * (Abs(p) + Abs(m));
            return Abs(p - m) > most + (slack * most + all_of(tolerance::smallest_square));
        };
        mask |= bits_of(Or(Or(apart(0, 1), apart(1, 2)), apart(2, 0))) << i;
    }
    return mask;
}

struct Meetings {
    Mask receding = 0, passing = 0, late = 0;
    alignas(64) float t[lanes] = {};
};

/// When one ball meets sixteen: the least distance over the time asked for, and the root of the quadratic.
JOIN_ATTR inline void meet(const Balls& one, int lane, const Balls& balls, const JoinRules& rules,
                           Meetings& m)
{
    const V zero = all_of(0), follow = all_of(rules.follow), until = all_of(rules.until);
    const V slack = all_of(tolerance::ball_slack), least = all_of(tolerance::smallest_square);
    for (int i = 0; i < lanes; i += width) {
        V d[3], v[3];
        for (int axis = 0; axis < 3; ++axis) {
            d[axis] = load(balls.from[axis] + i) - all_of(one.from[axis][lane]);
            v[axis] = follow * load(balls.by[axis] + i) - all_of(one.by[axis][lane]);
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

/// Without a branch for how many there are.
JOIN_ATTR inline void emit(std::uint32_t slot, const std::uint32_t* slots, Mask with, const float* times,
                           Candidates& to)
{
    for (int i = 0; i < lanes; i += width) {
        const Mask some = with >> i & ((1U << width) - 1);
        store_all(to.a.data() + to.count, slot);
        store_some(to.b.data() + to.count, slots + i, some);
        if (times) store_some(to.t.data() + to.count, times + i, some);
        to.count += static_cast<std::size_t>(__builtin_popcount(some));
    }
}

/// Boxes alone, and of bodies that all have some.
JOIN_ATTR inline void leaf_pairs_by_boxes(const Packet& p, Mask from, const BlockTree& tree,
                                          std::uint32_t leaf, std::uint32_t own, const JoinRules& rules,
                                          Candidates& to, JoinCounts& counts)
{
    alignas(64) static constexpr float from_the_start[lanes] = {};
    const float* times = rules.times ? from_the_start : nullptr;
    const Boxes& boxes = tree.levels[0][leaf];
    const std::uint32_t* slots = tree.slots.data() + std::size_t{lanes} * leaf;
    const std::size_t before = to.count;
    for (; from != 0; from &= from - 1) {
        const int lane = __builtin_ctz(from);
        const Mask later = own == leaf ? all_lanes << (lane + 1) : all_lanes;
        emit(p.slots[lane], slots, overlap(boxes, box_at(p.boxes, lane)) & later, times, to);
    }
    counts.met += to.count - before;
}

JOIN_ATTR inline void leaf_pairs(const Packet& p, Mask from, const BlockTree& tree, std::uint32_t leaf,
                                 std::uint32_t own, const JoinRules& rules, Candidates& to,
                                 JoinCounts& counts)
{
    if (rules.boxes && !rules.balls) return leaf_pairs_by_boxes(p, from, tree, leaf, own, rules, to, counts);
    const Boxes& boxes = tree.levels[0][leaf];
    const std::uint32_t* slots = tree.slots.data() + std::size_t{lanes} * leaf;
    const auto ones = [](Mask m) { return static_cast<std::uint64_t>(__builtin_popcount(m)); };
    for (; from != 0; from &= from - 1) {
        const int lane = __builtin_ctz(from);
        Mask with = rules.boxes ? overlap(boxes, box_at(p.boxes, lane)) : tree.held(leaf);
        if (own == leaf) with &= all_lanes << (lane + 1);
        if (with == 0) continue;
        counts.met += ones(with);
        Meetings m;
        if (rules.balls) meet(p.balls, lane, tree.balls[leaf], rules, m);
        const Mask receding = rules.receding ? with & m.receding : 0;
        const Mask passing = rules.spheres ? with & ~receding & (m.passing | m.receding) : 0;
        const Mask late = rules.late ? with & ~receding & ~passing & m.late : 0;
        counts.receding += ones(receding);
        counts.spheres += ones(passing);
        counts.late += ones(late);
        emit(p.slots[lane], slots, with & ~(receding | passing | late), m.t, to);
    }
}

/// The packet's lanes that may meet something within a box.
JOIN_ATTR inline Mask lanes_near(const Packet& p, const Box3f& box, const JoinRules& rules)
{
    Mask mask = overlap(p.boxes, box) & p.held;
    if ((mask & p.far) != 0) mask &= ~(p.far & paths_apart(p.balls, rules.grown, box));
    return mask;
}

JOIN_ATTR inline std::uint32_t join(const Packet& p, const BlockTree& tree, std::uint32_t own,
                                    std::uint32_t first, const JoinRules& rules, Candidates& to,
                                    JoinCounts& counts)
{
    struct Frame {
        std::uint32_t block;
        Mask todo;
    } frames[BlockTree::max_levels];
    const auto children = [&](int level, std::uint32_t block) JOIN_ATTR {
        const std::uint64_t begin = std::uint64_t{block} * lanes;
        const std::uint64_t from = first >> (4 * (level - 1));
        const auto l = static_cast<std::size_t>(level);
        const std::uint64_t end = tree.levels[l - 1].size();
        Mask mask = end - begin < lanes ? (1U << (end - begin)) - 1 : all_lanes;
        if (rules.boxes) mask &= overlap(tree.levels[l][block], p.bound);
        if (from <= begin) return mask;
        return from - begin < lanes ? mask & (all_lanes << (from - begin)) : 0;
    };
    if (tree.height == 0 || first >= tree.leaves()) return no_leaf;
    if (tree.height == 1) {
        if (!to.has_room()) return 0;
        leaf_pairs(p, p.held, tree, 0, own, rules, to, counts);
        return no_leaf;
    }
    int level = tree.height - 1;
    frames[level] = {0, children(level, 0)};
    while (level < tree.height) {
        Frame& f = frames[level];
        if (f.todo == 0) {
            ++level;
            continue;
        }
        const int k = __builtin_ctz(f.todo);
        f.todo &= f.todo - 1;
        const auto l = static_cast<std::size_t>(level);
        const auto child = f.block * lanes + static_cast<std::uint32_t>(k);
        if (p.least > rules.below && tree.least[l - 1][child] > rules.below) continue;
        if (level > 1 && p.dense) { // some lane is near whatever the packet's bound is near
            --level;
            frames[level] = {child, children(level, child)};
            continue;
        }
        const Mask from = rules.boxes ? lanes_near(p, box_at(tree.levels[l][f.block], k), rules) : p.held;
        if (from == 0) continue;
        if (level > 1) {
            --level;
            frames[level] = {child, children(level, child)};
        } else {
            if (!to.has_room()) return child;
            leaf_pairs(p, from, tree, child, own, rules, to, counts);
        }
    }
    return no_leaf;
}
