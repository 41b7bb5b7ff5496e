// SPDX-License-Identifier: BSD-3-Clause
#include "scene_rivals.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision_object.h>

#include <algorithm>
#include <cstdint>
#include <deque>

namespace brink::bench {
namespace {

using Object = fcl::CollisionObject<double>;
using Manager = fcl::DynamicAABBTreeCollisionManager<double>;

/// Its box is what it is told, which costs FCL less than to compute it.
class Boxed : public Object {
public:
    using Object::Object;
    void place(const Aabb& box)
    {
        aabb.min_ = box.min;
        aabb.max_ = box.max;
    }
};

/// Id and whether it moves, in the word that FCL keeps for the user: looked up without another read.
void name(Object& object, std::size_t id, bool moves)
{
    object.setUserData(reinterpret_cast<void*>(std::uintptr_t{2 * id + (moves ? 1U : 0U)})); // NOLINT
}
std::uintptr_t word(const Object* object) { return reinterpret_cast<std::uintptr_t>(object->getUserData()); }

bool keep_pair(Object* a, Object* b, void* pairs)
{
    const std::uintptr_t x = word(a), y = word(b);
    if (((x | y) & 1U) == 0) return false;
    const auto i = static_cast<BodyId>(x >> 1U), j = static_cast<BodyId>(y >> 1U);
    static_cast<std::vector<BodyPair>*>(pairs)->push_back({std::min(i, j), std::max(i, j)});
    return false;
}

/// Of a mover `b` that is asked by itself: another mover asks too, and the higher of the two is heard. A box
/// that came to lie inside the one that the tree has for it leaves that as it was.
bool keep_asked(Object* a, Object* b, void* pairs)
{
    const std::uintptr_t x = word(a), y = word(b);
    if (((x & 1U) != 0 && x >= y) || !a->getAABB().overlap(b->getAABB())) return false;
    return keep_pair(a, b, pairs);
}

class FclRival : public Rival {
public:
    FclRival(Trees trees, const Moves& moves)
    {
        const auto geometry = std::make_shared<fcl::Sphere<double>>(1);
        for (std::size_t i = 0; i < moves.size(); ++i) {
            Boxed& object = objects_.emplace_back(geometry);
            name(object, i, moves[i] != 0);
            if (moves[i] != 0) movers_.push_back(&object);
            (moves[i] != 0 || trees == Trees::one ? first_ : second_).push_back(&object);
        }
        // Where few move, telling FCL of each and asking for each is faster than to refit the whole tree and
        // to join it with itself.
        few_ = movers_.size() * 10 < first_.size();
    }

    void place(std::span<const Aabb> boxes) override
    {
        for (std::size_t i = 0; i < boxes.size(); ++i)
            objects_[i].place(boxes[i]);
    }

    void build() override
    {
        tree_.registerObjects(first_);
        tree_.setup();
        still_.registerObjects(second_);
        still_.setup();
    }

    void update() override
    {
        if (few_)
            tree_.update(movers_);
        else
            tree_.update();
    }

    std::span<const BodyPair> pairs() override
    {
        pairs_.clear();
        if (few_)
            for (Object* mover : movers_)
                tree_.collide(mover, &pairs_, keep_asked);
        else
            tree_.collide(&pairs_, keep_pair);
        tree_.collide(&still_, &pairs_, keep_pair);
        return pairs_;
    }

private:
    std::deque<Boxed, Eigen::aligned_allocator<Boxed>> objects_;
    std::vector<Object*> movers_, first_, second_;
    bool few_ = false;
    Manager tree_, still_;
    std::vector<BodyPair> pairs_;
};

} // namespace

std::unique_ptr<Rival> fcl_rival(Trees trees, const Moves& moves)
{
    return std::make_unique<FclRival>(trees, moves);
}

} // namespace brink::bench
