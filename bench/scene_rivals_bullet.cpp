// SPDX-License-Identifier: BSD-3-Clause
#include "scene_rivals.h"

#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace brink::bench {
namespace {

btScalar not_above(double x)
{
    const auto value = static_cast<btScalar>(x);
    return value > x ? std::nextafter(value, -std::numeric_limits<btScalar>::infinity()) : value;
}

/// Exact: the boxes of a scene about the origin are floats, and so are Bullet's. Its own broad phase would
/// give movers a margin; here they have none, so that the pairs are the same.
btDbvtVolume volume(const Aabb& box)
{
    const btVector3 min(not_above(box.min.x()), not_above(box.min.y()), not_above(box.min.z()));
    const btVector3 max(-not_above(-box.max.x()), -not_above(-box.max.y()), -not_above(-box.max.z()));
    return btDbvtVolume::FromMM(min, max);
}

struct Keep : btDbvt::ICollide {
    const char* moves = nullptr;
    std::vector<BodyPair> pairs;

    using ICollide::Process;
    void Process(const btDbvtNode* a, const btDbvtNode* b) override
    {
        const BodyId x = id_of(a), y = id_of(b);
        if (moves[x] != 0 || moves[y] != 0) pairs.push_back({std::min(x, y), std::max(x, y)});
    }
    static BodyId id_of(const btDbvtNode* node)
    {
        return static_cast<BodyId>(reinterpret_cast<std::uintptr_t>(node->data));
    }
};

/// Of one mover that is asked by itself: another asks too, and the higher of the two is heard.
struct KeepAsked : btDbvt::ICollide {
    const char* moves = nullptr;
    BodyId asked = 0;
    std::vector<BodyPair>* pairs = nullptr;

    using ICollide::Process;
    void Process(const btDbvtNode* node) override
    {
        const BodyId other = Keep::id_of(node);
        if (moves[other] == 0 || other < asked)
            pairs->push_back({std::min(asked, other), std::max(asked, other)});
    }
};

class BulletRival : public Rival {
public:
    BulletRival(Trees trees, const Moves& moves)
        : moves_(moves), in_still_(moves.size(), 0), volumes_(moves.size()), leaves_(moves.size(), nullptr)
    {
        for (std::size_t i = 0; i < moves.size(); ++i) {
            if (moves[i] != 0) movers_.push_back(static_cast<BodyId>(i));
            in_still_[i] = moves[i] == 0 && trees == Trees::two ? 1 : 0;
        }
        few_ = trees == Trees::one && movers_.size() * 10 < moves.size();
        keep_.moves = moves_.data();
    }

    void place(std::span<const Aabb> boxes) override
    {
        for (std::size_t i = 0; i < boxes.size(); ++i)
            volumes_[i] = volume(boxes[i]);
    }

    void build() override
    {
        for (std::size_t i = 0; i < volumes_.size(); ++i)
            leaves_[i] = (in_still_[i] != 0 ? still_ : tree_)
                             .insert(volumes_[i], reinterpret_cast<void*>(std::uintptr_t{i})); // NOLINT
        still_.optimizeTopDown();
    }

    /// As btDbvtBroadphase does: each leaf that moved, then one incremental pass.
    void update() override
    {
        for (const BodyId id : movers_)
            tree_.update(leaves_[id], volumes_[id]);
        tree_.optimizeIncremental(1);
    }

    std::span<const BodyPair> pairs() override
    {
        keep_.pairs.clear();
        if (few_) {
            KeepAsked keep;
            keep.moves = moves_.data();
            keep.pairs = &keep_.pairs;
            for (const BodyId id : movers_) {
                keep.asked = id;
                tree_.collideTV(tree_.m_root, volumes_[id], keep);
            }
            return keep_.pairs;
        }
        tree_.collideTTpersistentStack(tree_.m_root, tree_.m_root, keep_);
        if (still_.m_root != nullptr) tree_.collideTTpersistentStack(tree_.m_root, still_.m_root, keep_);
        return keep_.pairs;
    }

private:
    Moves moves_, in_still_;
    std::vector<btDbvtVolume> volumes_;
    std::vector<btDbvtNode*> leaves_;
    std::vector<BodyId> movers_;
    bool few_ = false;
    btDbvt tree_, still_;
    Keep keep_;
};

} // namespace

std::unique_ptr<Rival> bullet_rival(Trees trees, const Moves& moves)
{
    return std::make_unique<BulletRival>(trees, moves);
}

std::string bullet_version()
{
    return std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100);
}

} // namespace brink::bench
