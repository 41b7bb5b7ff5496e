// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/pose.h>

#include <memory>
#include <span>

namespace brink {

struct HullData;

/// The convex hull of some points (local frame). Immutable: copies share their contents. By default it is the
/// single point at the origin.
class Hull {
public:
    Hull() = default;
    /// The hull of 1 to 2^20 points. Flat, collinear and coincident ones are legal. Points proven to lie in
    /// the hull of the others are dropped, and none else. Throws std::invalid_argument, which names the point
    /// and says why, if there are too few or too many or one is not finite.
    static Hull from_points(std::span<const Vec3> points);

    /// The points kept, in the order given, each once.
    std::span<const Vec3> vertices() const;

    /// For brink's own sources; null for the single point at the origin.
    const HullData* data() const { return data_.get(); }

private:
    explicit Hull(std::shared_ptr<const HullData> data) : data_(std::move(data)) {}
    std::shared_ptr<const HullData> data_;
};

} // namespace brink
