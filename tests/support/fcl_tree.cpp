// SPDX-License-Identifier: BSD-3-Clause
#include "fcl_tree.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>

#include <algorithm>
#include <memory>

namespace brink::support {

namespace {

struct Found {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
};

std::uint32_t index_of(const fcl::CollisionObjectd* object)
{
    return *static_cast<const std::uint32_t*>(object->getUserData());
}

bool note(fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* found)
{
    static_cast<Found*>(found)->pairs.push_back(std::minmax({index_of(a), index_of(b)}));
    return false; // go on
}

} // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> fcl_overlapping(std::span<const Aabb> boxes)
{
    std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects;
    std::vector<fcl::CollisionObjectd*> all;
    std::vector<std::uint32_t> indices(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        indices[i] = static_cast<std::uint32_t>(i);
        const Vec3 size = boxes[i].max - boxes[i].min, centre = boxes[i].min + 0.5 * size;
        fcl::Transform3d at = fcl::Transform3d::Identity();
        at.translation() = centre;
        objects.push_back(std::make_unique<fcl::CollisionObjectd>(std::make_shared<fcl::Boxd>(size), at));
        objects.back()->setUserData(&indices[i]);
        objects.back()->computeAABB();
        all.push_back(objects.back().get());
    }
    fcl::DynamicAABBTreeCollisionManagerd tree;
    tree.registerObjects(all);
    tree.setup();
    Found found{};
    tree.collide(&found, &note);
    std::sort(found.pairs.begin(), found.pairs.end());
    return found.pairs;
}

} // namespace brink::support
