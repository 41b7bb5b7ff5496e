// SPDX-License-Identifier: BSD-3-Clause
#include <brink/hull.h>

#include "hull_data.h"
#include "scaling.h"
#include "validity.h"

#include <set>
#include <stdexcept>
#include <string>
#include <tuple>

namespace brink {

namespace {

constexpr std::size_t most_points = std::size_t{1} << 20U;
/// 2^exponent and its inverse are normal numbers.
constexpr int least_exponent = -1000;

std::string in_words(const Vec3& p)
{
    return "(" + std::to_string(p.x()) + ", " + std::to_string(p.y()) + ", " + std::to_string(p.z()) + ")";
}

void check(std::span<const Vec3> points)
{
    if (points.empty()) throw std::invalid_argument("Hull::from_points: no points, at least 1 is needed");
    if (points.size() > most_points)
        throw std::invalid_argument("Hull::from_points: " + std::to_string(points.size()) +
                                    " points, more than 2^20");
    for (std::size_t i = 0; i < points.size(); ++i)
        if (!is_finite(load(points[i])))
            throw std::invalid_argument("Hull::from_points: points[" + std::to_string(i) +
                                        "] = " + in_words(points[i]) + " is not finite");
}

std::vector<Vec3> distinct(std::span<const Vec3> points)
{
    std::set<std::tuple<double, double, double>> seen;
    std::vector<Vec3> out;
    for (const Vec3& p : points)
        if (seen.insert({p.x(), p.y(), p.z()}).second) out.push_back(p);
    return out;
}

V3 least(V3 a, V3 b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
V3 most(V3 a, V3 b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

/// The corners in the hull's own unit of length, and what holds them.
void place_corners(HullData& data)
{
    double largest = 0;
    for (const Vec3& p : data.vertices)
        largest = std::max(largest, largest_coordinate(load(p)));
    data.exponent = largest > 0 ? std::max(exponent(largest) - 1, least_exponent) : 0;
    V3 low = scaled(load(data.vertices[0]), -data.exponent), high = low;
    for (const Vec3& p : data.vertices) {
        const V3 corner = scaled(load(p), -data.exponent);
        data.x.push_back(corner.x);
        data.y.push_back(corner.y);
        data.z.push_back(corner.z);
        low = least(low, corner);
        high = most(high, corner);
        data.reach = std::max(data.reach, sum_of_magnitudes(corner));
    }
    data.middle = 0.5 * (low + high);
    for (int k = 0; k < data.count(); ++k)
        data.ball = std::max(data.ball, norm(data.corner(k) - data.middle));
}

} // namespace

Hull Hull::from_points(std::span<const Vec3> points)
{
    check(points);
    auto data = std::make_shared<HullData>();
    data->vertices = distinct(points);
    place_corners(*data);
    return Hull(std::move(data));
}

std::span<const Vec3> Hull::vertices() const
{
    static const Vec3 origin{0, 0, 0};
    return data_ == nullptr ? std::span(&origin, 1) : std::span<const Vec3>(data_->vertices);
}

} // namespace brink
