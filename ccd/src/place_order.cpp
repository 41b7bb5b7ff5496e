// SPDX-License-Identifier: BSD-3-Clause
#include "place_order.h"

#include "parallel.h"
#include "sweep.h"
#include "tolerance.h"

#include <algorithm>
#include <array>
#include <bit>
#include <span>
#include <utility>

namespace brink {

namespace {

constexpr int bits = 10; // of the curve, an axis
constexpr double cells = 1 << bits;

struct Range {
    double low = 0, high = 0;
};

/// Coordinates of bodies spread evenly over a list: enough to tell where a scene is.
class Sample {
public:
    static constexpr std::size_t most = 256;

    explicit Sample(std::size_t of) : step_(of / most + 1) {}
    std::size_t step() const { return step_; }
    bool empty() const { return count_ == 0; }
    void take(V3 at)
    {
        const bool far = !(sum_of_magnitudes(at) <= tolerance::largest_culled);
        if (far || count_ == most) return;
        x_[count_] = at.x, y_[count_] = at.y, z_[count_] = at.z;
        ++count_;
    }
    /// Where all are but the outermost few.
    std::array<Range, 3> ranges() { return {range(x_), range(y_), range(z_)}; }

private:
    using Coordinates = std::array<double, most>;
    Range range(Coordinates& c) const
    {
        if (count_ == 0) return {};
        const std::span<double> x{c.data(), count_};
        std::sort(x.begin(), x.end());
        const std::size_t off = count_ / 50;
        return {x[off], x[count_ - 1 - off]};
    }

    std::size_t step_, count_ = 0;
    Coordinates x_, y_, z_;
};

/// The bits of x, each followed by two zeros.
std::uint32_t spread(std::uint32_t x)
{
    x = (x | x << 16U) & 0x030000ffU;
    x = (x | x << 8U) & 0x0300f00fU;
    x = (x | x << 4U) & 0x030c30c3U;
    return (x | x << 2U) & 0x09249249U;
}

std::uint32_t cell(double x, double low, double scale)
{
    const double at = (x - low) * scale;
    if (!(at > 0)) return 0;
    return at < cells - 1 ? static_cast<std::uint32_t>(at) : (1U << bits) - 1;
}

/// Least digit first, ten bits at a time; of equal keys the order stays.
void radix_sort(std::vector<PlaceSorting::Key>& keys, std::vector<PlaceSorting::Key>& other)
{
    for (unsigned shift = 0; shift < 3U * bits; shift += bits) {
        const auto digit = [shift](const PlaceSorting::Key& k) {
            return k.place >> shift & ((1U << bits) - 1);
        };
        std::array<std::size_t, 1U << bits> begin{};
        for (const auto& k : keys)
            ++begin[digit(k)];
        std::size_t sum = 0;
        for (std::size_t& b : begin)
            sum += std::exchange(b, sum);
        for (const auto& k : keys)
            other[begin[digit(k)]++] = k;
        keys.swap(other);
    }
}

/// Bodies that come after each other on the curve and are put in better order among themselves.
constexpr std::size_t group = 4096;

struct Spot {
    float at[3];
    std::uint32_t slot;
};

/// Halves a group, at a power of two, across its longest axis, down to what one leaf holds.
void halve(std::span<Spot> spots)
{
    if (spots.size() <= lanes) return;
    std::array<float, 3> low{spots[0].at[0], spots[0].at[1], spots[0].at[2]}, high = low;
    for (const Spot& spot : spots) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], spot.at[axis]);
            high[axis] = std::max(high[axis], spot.at[axis]);
        }
    }
    std::size_t longest = 0;
    for (std::size_t axis = 1; axis < 3; ++axis)
        if (high[axis] - low[axis] > high[longest] - low[longest]) longest = axis;
    const std::size_t left = std::bit_ceil((spots.size() + 1) / 2);
    std::nth_element(spots.begin(), spots.begin() + static_cast<std::ptrdiff_t>(left), spots.end(),
                     [=](const Spot& x, const Spot& y) {
                         return x.at[longest] != y.at[longest] ? x.at[longest] < y.at[longest]
                                                               : x.slot < y.slot;
                     });
    halve(spots.first(left));
    halve(spots.subspan(left));
}

void halve(std::span<PlaceSorting::Key> keys, const BodyStore& store, V3 low)
{
    std::array<Spot, group> spots;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (i + BodyStore::ahead < keys.size()) store.fetch(keys[i + BodyStore::ahead].slot);
        const V3 at = midway(store.bodies[keys[i].slot]) - low;
        const auto place = [](double x) {
            return x * 0 == 0 ? static_cast<float>(std::clamp(x, -1e30, 1e30)) : 0;
        };
        spots[i] = {{place(at.x), place(at.y), place(at.z)}, keys[i].slot};
    }
    halve({spots.data(), keys.size()});
    for (std::size_t i = 0; i < keys.size(); ++i)
        keys[i].slot = spots[i].slot;
}

} // namespace

void sort_by_place(PlaceSorting& sorting, const BodyStore& store)
{
    auto& keys = sorting.keys;
    Sample sample(keys.size());
    for (std::size_t i = 0; i < keys.size(); i += sample.step())
        sample.take(midway(store.bodies[keys[i].slot]));
    const auto [x, y, z] = sample.ranges();
    const double widest = std::max({x.high - x.low, y.high - y.low, z.high - z.low});
    const double scale = widest > 0 ? cells / widest : 0;
    const V3 low{x.low, y.low, z.low};
    for_each_part(
        keys.size(),
        [&](std::size_t i) {
            if (i + BodyStore::ahead < keys.size()) store.fetch(keys[i + BodyStore::ahead].slot);
            const V3 at = midway(store.bodies[keys[i].slot]);
            keys[i].place = spread(cell(at.x, low.x, scale)) | spread(cell(at.y, low.y, scale)) << 1U |
                            spread(cell(at.z, low.z, scale)) << 2U;
        },
        4096);
    sorting.other.reserve(keys.size());
    sorting.other.resize(keys.size());
    radix_sort(keys, sorting.other);
    for_each_part((keys.size() + group - 1) / group,
                  [&](std::size_t i) {
                      const std::size_t end = std::min(keys.size(), group * (i + 1));
                      halve(std::span{keys}.subspan(group * i, end - group * i), store, low);
                  },
                  1);
}

V3 origin_for(const BodyStore& store, V3 present)
{
    Sample sample(store.bodies.size());
    for (std::size_t slot = 0; slot < store.bodies.size(); slot += sample.step())
        if (store.ids[slot] != no_body) sample.take(midway(store.bodies[slot]));
    if (sample.empty()) return present;
    const auto [x, y, z] = sample.ranges();
    const auto middle = [](Range r) { return 0.5 * r.low + 0.5 * r.high; };
    const V3 centre{middle(x), middle(y), middle(z)};
    const double widest = std::max({x.high - x.low, y.high - y.low, z.high - z.low});
    // A float tells 2^24 places apart: 2^14 of them across the scene will do.
    const double far = 0x1p10 * widest;
    return sum_of_magnitudes(centre - present) <= far ? present : centre;
}

} // namespace brink
