// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/scene.h>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace brink::bench {

/// Another library's broad phase over boxes that it is given. Its steps are apart, to be timed one by one.
class Rival {
public:
    Rival() = default;
    virtual ~Rival() = default;
    Rival(const Rival&) = delete;
    Rival& operator=(const Rival&) = delete;

    /// The boxes of all bodies from now on, into the library's own objects: nobody's time.
    virtual void place(std::span<const Aabb>) = 0;
    virtual void build() = 0;
    /// Takes note of where the movers are.
    virtual void update() = 0;
    /// The pairs that overlap and of which at least one moves, a < b. Valid until asked again.
    virtual std::span<const BodyPair> pairs() = 0;
};

/// Of the trees: all bodies in one, or those that move and those that do not in one each.
enum class Trees : unsigned char { one, two };

/// For each body whether it moves.
using Moves = std::vector<char>;

/// FCL 0.7's DynamicAABBTreeCollisionManager<double>.
std::unique_ptr<Rival> fcl_rival(Trees, const Moves&);

/// Bullet's btDbvt. Null where Bullet was not found at configure time.
std::unique_ptr<Rival> bullet_rival(Trees, const Moves&);

/// "3.24", or empty.
std::string bullet_version();

} // namespace brink::bench
