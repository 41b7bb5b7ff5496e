// SPDX-License-Identifier: BSD-3-Clause
// The join for one instruction set, after join_tests-inl.h in that one's namespace and what says how its
// lanes are stored (store_all, store_some, add_where) and a name for it. No include guard.

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

/// Which lanes of a packet are to look into which leaves, a leaf after the other. They are listed first,
/// because how many lanes a leaf has is guessed wrong at almost every one.
struct Visits {
    static constexpr std::uint32_t enough = 64;
    std::uint32_t count = 0;
    std::uint32_t leaf[enough + lanes * (lanes + 1)], lane[enough + lanes * (lanes + 1)];

    bool begin_leaf(std::uint32_t i) const { return i == 0 || leaf[i] != leaf[i - 1]; }
    JOIN_ATTR void add(std::uint32_t to, Mask from)
    {
        alignas(64) static constexpr std::uint32_t every[lanes] = {0, 1, 2,  3,  4,  5,  6,  7,
                                                                   8, 9, 10, 11, 12, 13, 14, 15};
        for (int i = 0; i < lanes; i += width) {
            const Mask some = from >> i & ((1U << width) - 1);
            store_all(leaf + count, to);
            store_some(lane + count, every + i, some);
            count += static_cast<std::uint32_t>(__builtin_popcount(some));
        }
    }
};

/// Asks memory for what a leaf will be looked into by: most of a search's time is waiting for that.
inline void fetch(const BlockTree& tree, std::uint32_t leaf)
{
    const Boxes& boxes = tree.levels[0][leaf];
    for (int axis = 0; axis < 3; ++axis) {
        __builtin_prefetch(boxes.min[axis]);
        __builtin_prefetch(boxes.max[axis]);
    }
}
inline void fetch_slots(const BlockTree& tree, std::uint32_t leaf)
{
    __builtin_prefetch(tree.slots.data() + std::size_t{lanes} * leaf);
}
inline void fetch_balls(const BlockTree& tree, std::uint32_t leaf)
{
    const Balls& balls = tree.balls[leaf];
    for (int axis = 0; axis < 3; ++axis) {
        __builtin_prefetch(balls.from[axis]);
        if (!tree.still) __builtin_prefetch(balls.by[axis]);
    }
    __builtin_prefetch(balls.radius);
}

/// Which bodies of a leaf a lane of the packet may meet, by the boxes.
JOIN_ATTR inline Mask within_reach(const Packet& p, std::uint32_t lane, const BlockTree& tree,
                                   std::uint32_t leaf, std::uint32_t own, const JoinRules& rules)
{
    const Mask later = own == leaf ? all_lanes << (lane + 1) : all_lanes;
    if (!rules.boxes) return tree.held(leaf) & later;
    return overlap(tree.levels[0][leaf], box_at(p.boxes, static_cast<int>(lane))) & later;
}

/// Fills in the candidates of the visits; where there is no room left before a leaf, that leaf.
JOIN_ATTR inline std::uint32_t visit_by_boxes(const Packet& p, const Visits& visits, const BlockTree& tree,
                                              std::uint32_t own, const JoinRules& rules, Candidates& to,
                                              JoinCounts& counts)
{
    alignas(64) static constexpr float from_the_start[lanes] = {};
    const float* times = rules.times ? from_the_start : nullptr;
    const std::size_t before = to.count;
    std::uint32_t stop = no_leaf;
    for (std::uint32_t i = 0; i < visits.count; ++i) {
        const std::uint32_t leaf = visits.leaf[i], lane = visits.lane[i];
        if (!to.has_room() && visits.begin_leaf(i)) {
            stop = leaf;
            break;
        }
        emit(p.slots[lane], tree.slots.data() + std::size_t{lanes} * leaf,
             within_reach(p, lane, tree, leaf, own, rules), times, to);
    }
    counts.met += to.count - before;
    return stop;
}

/// The same where the balls have a say.
JOIN_ATTR inline std::uint32_t visit(const Packet& p, const Visits& visits, const BlockTree& tree,
                                     std::uint32_t own, const JoinRules& rules, Candidates& to,
                                     JoinCounts& counts)
{
    if (rules.boxes && !rules.balls) return visit_by_boxes(p, visits, tree, own, rules, to, counts);
    Visits met;
    Mask with_of[Visits::enough + lanes * lanes + 1];
    for (std::uint32_t i = 0; i < visits.count; ++i) {
        const std::uint32_t leaf = visits.leaf[i], lane = visits.lane[i];
        Mask with = within_reach(p, lane, tree, leaf, own, rules);
        if (rules.boxes && (p.far >> lane & 1U) != 0)
            with &= ~path_apart(p.balls, lane, rules.grown, tree.levels[0][leaf]);
        if (with != 0 && rules.balls) fetch_balls(tree, leaf);
        if (with != 0) fetch_slots(tree, leaf);
        met.leaf[met.count] = leaf;
        met.lane[met.count] = lane;
        with_of[met.count] = with;
        met.count += with != 0 ? 1U : 0U;
    }
    const auto ones = [](Mask m) { return static_cast<std::uint64_t>(__builtin_popcount(m)); };
    for (std::uint32_t i = 0; i < met.count; ++i) {
        const std::uint32_t leaf = met.leaf[i], lane = met.lane[i];
        if (!to.has_room() && met.begin_leaf(i)) return leaf;
        const Mask with = with_of[i];
        counts.met += ones(with);
        Meetings m;
        if (rules.balls) meet(p.balls, lane, tree.balls[leaf], tree.still, rules, m);
        const Mask receding = rules.receding ? with & m.receding : 0;
        const Mask passing = rules.spheres ? with & ~receding & (m.passing | m.receding) : 0;
        const Mask late = rules.late ? with & ~receding & ~passing & m.late : 0;
        counts.receding += ones(receding);
        counts.spheres += ones(passing);
        counts.late += ones(late);
        emit(p.slots[lane], tree.slots.data() + std::size_t{lanes} * leaf,
             with & ~(receding | passing | late), m.t, to);
    }
    return no_leaf;
}

/// The packet's lanes that may meet something within a box.
JOIN_ATTR inline Mask lanes_near(const Packet& p, const Box3f& box, const JoinRules& rules)
{
    Mask mask = overlap(p.boxes, box) & p.held;
    if ((mask & p.far) != 0) mask &= ~(p.far & paths_apart(p.balls, rules.grown, box));
    return mask;
}

/// The boxes that one of its lanes may meet something in.
JOIN_ATTR inline Mask boxes_near(const Packet& p, std::uint32_t lane, const Boxes& boxes,
                                 const JoinRules& rules)
{
    const Mask mask = overlap(boxes, box_at(p.boxes, static_cast<int>(lane)));
    if ((p.far >> lane & 1U) == 0) return mask;
    return mask & ~path_apart(p.balls, lane, rules.grown, boxes);
}

/// A packet on its way down a tree.
class Descent {
public:
    Descent(const Packet& packet, const BlockTree& tree, std::uint32_t first, const JoinRules& rules)
        : p_(packet), tree_(tree), rules_(rules), first_(first), level_(tree.height)
    {
    }
    /// Goes one level down, into a block that these lanes are near to.
    JOIN_ATTR void enter(std::uint32_t block, Mask near)
    {
        Frame& f = frames_[--level_];
        f.block = block;
        f.todo = children();
        const Boxes& boxes = tree_.levels[static_cast<std::size_t>(level_)][block];
        if (rules_.boxes) f.todo &= overlap(boxes, p_.bound);
        const bool all =
            !rules_.boxes || (p_.dense && level_ > 1); // some lane is near whatever the bound is near
        if (all)
            std::fill_n(f.near, lanes, near);
        else if (__builtin_popcount(near) < __builtin_popcount(f.todo))
            by_lanes(f, boxes, near);
        else
            by_boxes(f, boxes, near);
    }
    bool done() const { return level_ == tree_.height; }
    int level() const { return level_; }
    struct Child {
        std::uint32_t block;
        Mask near;
    };
    bool more()
    {
        if (frames_[level_].todo != 0) return true;
        ++level_;
        return false;
    }
    Child next()
    {
        Frame& f = frames_[level_];
        const int k = __builtin_ctz(f.todo);
        f.todo &= f.todo - 1;
        return {f.block * lanes + static_cast<std::uint32_t>(k), f.near[k]};
    }
    bool matters(std::uint32_t child) const
    {
        if (rules_.groups) {
            const std::vector<Groups>& groups = tree_.groups[static_cast<std::size_t>(level_ - 1)];
            if (!groups.empty() && !may_meet(p_.groups, groups[child])) return false;
        }
        if (!(p_.least > rules_.below)) return true;
        return !(tree_.least[static_cast<std::size_t>(level_ - 1)][child] > rules_.below);
    }

private:
    struct Frame {
        std::uint32_t block;
        Mask todo;
        alignas(64) Mask near[lanes];
    };
    Mask children() const
    {
        const std::uint64_t begin = std::uint64_t{frames_[level_].block} * lanes;
        const std::uint64_t from = first_ >> (4 * (level_ - 1));
        const std::uint64_t end = tree_.levels[static_cast<std::size_t>(level_ - 1)].size();
        const Mask mask = end - begin < lanes ? (1U << (end - begin)) - 1 : all_lanes;
        if (from <= begin) return mask;
        return from - begin < lanes ? mask & (all_lanes << (from - begin)) : 0;
    }
    JOIN_ATTR void by_lanes(Frame& f, const Boxes& boxes, Mask near)
    {
        std::fill_n(f.near, lanes, 0);
        Mask some = 0;
        for (; near != 0; near &= near - 1) {
            const auto lane = static_cast<std::uint32_t>(__builtin_ctz(near));
            const Mask in = boxes_near(p_, lane, boxes, rules_);
            for (int i = 0; i < lanes; i += width)
                add_where(f.near + i, 1U << lane, in >> i & ((1U << width) - 1));
            some |= in;
        }
        f.todo &= some;
    }
    JOIN_ATTR void by_boxes(Frame& f, const Boxes& boxes, Mask near)
    {
        Mask some = 0;
        for (Mask todo = f.todo; todo != 0; todo &= todo - 1) {
            const int k = __builtin_ctz(todo);
            f.near[k] = lanes_near(p_, box_at(boxes, k), rules_) & near;
            some |= (f.near[k] != 0 ? 1U : 0U) << k;
        }
        f.todo &= some;
    }

    const Packet& p_;
    const BlockTree& tree_;
    const JoinRules& rules_;
    std::uint32_t first_;
    int level_;
    Frame frames_[BlockTree::max_levels];
};

JOIN_ATTR inline std::uint32_t join(const Packet& p, const BlockTree& tree, std::uint32_t own,
                                    std::uint32_t first, const JoinRules& rules, Candidates& to,
                                    JoinCounts& counts)
{
    if (tree.height == 0 || first >= tree.leaves()) return no_leaf;
    Visits visits;
    if (tree.height == 1) {
        visits.add(0, p.held);
        return visit(p, visits, tree, own, rules, to, counts);
    }
    Descent descent(p, tree, first, rules);
    descent.enter(0, p.held);
    while (!descent.done()) {
        if (descent.level() > 1) {
            if (!descent.more()) continue;
            const auto [block, near] = descent.next();
            if (descent.matters(block)) descent.enter(block, near);
            continue;
        }
        while (descent.more()) {
            const auto [leaf, near] = descent.next();
            if (!descent.matters(leaf)) continue;
            visits.add(leaf, near);
            fetch(tree, leaf);
            if (!rules.balls) fetch_slots(tree, leaf);
        }
        if (visits.count < Visits::enough) continue;
        const std::uint32_t stop = visit(p, visits, tree, own, rules, to, counts);
        if (stop != no_leaf) return stop;
        visits.count = 0;
    }
    return visit(p, visits, tree, own, rules, to, counts);
}
