// SPDX-License-Identifier: BSD-3-Clause
#include <brink/hull.h>

#include "hull_data.h"
#include "hull_proof.h"
#include "scaling.h"
#include "validity.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <tuple>

namespace brink {

namespace {

constexpr std::size_t most_points = std::size_t{1} << 20U;

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

/// Each point once, in the order given.
std::vector<Vec3> distinct(std::span<const Vec3> points)
{
    const auto place = [&](std::size_t i) {
        return std::tuple(points[i].x(), points[i].y(), points[i].z(), i);
    };
    const auto same = [&](std::size_t i, std::size_t j) { return load(points[i]) == load(points[j]); };
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return place(i) < place(j); });
    order.erase(std::unique(order.begin(), order.end(), same), order.end());
    std::sort(order.begin(), order.end());
    std::vector<Vec3> out;
    out.reserve(order.size());
    for (const std::size_t i : order)
        out.push_back(points[i]);
    return out;
}

V3 least(V3 a, V3 b) { return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)}; }
V3 most(V3 a, V3 b) { return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}; }

/// The exponent of a unit of length in which no coordinate reaches 2, and the largest reaches 1.
int unit_exponent(std::span<const Vec3> points)
{
    double largest = 0;
    for (const Vec3& p : points)
        largest = std::max(largest, largest_coordinate(load(p)));
    return largest > 0 ? std::max(exponent(largest) - 1, least_exponent) : 0;
}

/// The corners in the hull's own unit of length, and what holds them.
void place_corners(HullData& data, const std::vector<V3>& corners)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    constexpr HullData::Corners nowhere{{nan, nan, nan, nan}, {nan, nan, nan, nan}, {nan, nan, nan, nan}};
    V3 low = corners[0], high = low;
    for (const V3 corner : corners) {
        const auto i = static_cast<std::size_t>(data.count++ % 4);
        if (i == 0) data.corners.push_back(nowhere);
        HullData::Corners& four = data.corners.back();
        four.x[i] = corner.x;
        four.y[i] = corner.y;
        four.z[i] = corner.z;
        low = least(low, corner);
        high = most(high, corner);
        data.reach = std::max(data.reach, sum_of_magnitudes(corner));
    }
    data.middle = 0.5 * (low + high);
    for (const V3 corner : corners)
        data.ball = std::max(data.ball, norm(corner - data.middle));
}

/// Whether exactly: only then is every point in their plane, and so are four that share none.
bool collinear(V3 a, V3 b, V3 c)
{
    const V3 of_no_plane[] = {{}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    return std::all_of(std::begin(of_no_plane), std::end(of_no_plane),
                       [&](V3 p) { return side(a, b, c, p) == 0; });
}

/// Of points on one line the ends, between which all others lie; else nothing.
std::vector<bool> ends_of_line(const std::vector<V3>& points)
{
    const auto before = [](V3 p, V3 q) { return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z); };
    const auto [first, last] = std::minmax_element(points.begin(), points.end(), before);
    const auto on_line = [a = *first, b = *last](V3 p) { return collinear(a, b, p); };
    if (!std::all_of(points.begin(), points.end(), on_line)) return {};
    std::vector<bool> ends(points.size());
    ends[static_cast<std::size_t>(first - points.begin())] = true;
    ends[static_cast<std::size_t>(last - points.begin())] = true;
    return ends;
}

/// Which of the points stay: the corners of a surface, and those that it does not hold.
std::vector<bool> kept(const std::vector<V3>& points, const Surface& surface)
{
    if (surface.empty())
        if (std::vector<bool> ends = ends_of_line(points); !ends.empty()) return ends;
    std::vector<bool> stays(points.size(), surface.empty());
    for (const Facet& f : surface.faces())
        for (const int k : f)
            stays[static_cast<std::size_t>(k)] = true;
    for (std::size_t i = 0; i < points.size(); ++i)
        stays[i] = stays[i] || !surface.holds(points[i]);
    return stays;
}

/// Who is whose neighbour along the edges of a surface; `place` says where a point is among the corners.
void connect(HullData& data, const Surface& surface, const std::vector<int>& place)
{
    std::vector<std::vector<int>> next(static_cast<std::size_t>(data.count));
    for (const Facet& f : surface.faces())
        for (std::size_t k = 0; k < 3; ++k) {
            const int from = place[static_cast<std::size_t>(f[k])];
            const int to = place[static_cast<std::size_t>(f[(k + 1) % 3])];
            next[static_cast<std::size_t>(from)].push_back(to);
        }
    for (const std::vector<int>& list : next) {
        data.first_neighbour.push_back(static_cast<int>(data.neighbours.size()));
        data.neighbours.insert(data.neighbours.end(), list.begin(), list.end());
    }
    data.first_neighbour.push_back(static_cast<int>(data.neighbours.size()));
}

/// The planes of a surface's faces, each as far inwards as its rounding may have moved it.
void bound(HullData& data, const std::vector<V3>& points, const Surface& surface)
{
    const auto at = [&](int k) { return points[static_cast<std::size_t>(k)]; };
    std::size_t side = 0; // of the last two
    const auto add = [&](V3 normal, double offset) {
        if (side == 0) data.faces.push_back({{}, {}, {}, {infinity, infinity}});
        HullData::Faces& two = data.faces.back();
        two.x[side] = normal.x;
        two.y[side] = normal.y;
        two.z[side] = normal.z;
        two.offset[side] = offset;
        side = 1 - side;
    };
    for (const Facet& f : surface.faces()) {
        const V3 a = at(f[0]), e = at(f[1]) - a, g = at(f[2]) - a, n = cross(e, g);
        const double length = norm(n), doubt = tolerance::face * norm(e) * norm(g);
        const bool flat = !(length > doubt); // no side of it is known
        const V3 unit = flat ? V3{} : (1 / length) * n;
        add(unit, flat ? -infinity : dot(unit, a) - doubt / length);
    }
}

} // namespace

Hull Hull::from_points(std::span<const Vec3> points)
{
    check(points);
    const std::vector<Vec3> given = distinct(points);
    auto data = std::make_shared<HullData>();
    const int exponent = unit_exponent(given);
    data->unit = std::ldexp(1, exponent);
    std::vector<V3> all;
    all.reserve(given.size());
    for (const Vec3& p : given)
        all.push_back(scaled(load(p), -exponent));

    const Surface surface(all, proposed_faces(all));
    const std::vector<bool> stays = kept(all, surface);
    std::vector<V3> corners;
    std::vector<int> place(all.size(), -1);
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!stays[i]) continue;
        place[i] = static_cast<int>(corners.size());
        corners.push_back(all[i]);
        data->vertices.push_back(given[i]);
    }
    place_corners(*data, corners);
    bound(*data, all, surface);
    if (surface.convex() && surface.corner_count() == corners.size()) connect(*data, surface, place);
    data->search = quickest_search(*data);
    return Hull(std::move(data));
}

std::span<const Vec3> Hull::vertices() const
{
    static const Vec3 origin{0, 0, 0};
    return data_ == nullptr ? std::span(&origin, 1) : std::span<const Vec3>(data_->vertices);
}

} // namespace brink
