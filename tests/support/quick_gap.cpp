// SPDX-License-Identifier: BSD-3-Clause
#include "quick_gap.h"

#include <array>

namespace brink::support {
namespace {

using Kind = QuickBody::Kind;

constexpr int most_iterations = 64;
constexpr int most_idle = 3;

/// A point of the difference of the cores, B's less A's.
struct Corner {
    Quick3 p, a, b;
};

/// Corners, the newest last, with the weights of the point that is nearest to the origin.
struct Simplex {
    std::array<Corner, 4> corner;
    std::array<double, 4> weight{};
    std::size_t count = 0;
};

/// The nearest point found so far of all faces that have the newest corner.
class Nearest {
public:
    explicit Nearest(const Simplex& s) : s_(s), others_(s.count - 1), newest_(s.corner[s.count - 1].p)
    {
        keep({}, 0, newest_);
        for (std::size_t i = 0; i < others_; ++i)
            side_[i] = s.corner[i].p - newest_;
        for (std::size_t i = 0; i < others_; ++i)
            edge(i);
        for (std::size_t i = 0; i + 1 < others_; ++i)
            for (std::size_t j = i + 1; j < others_; ++j)
                face(i, j);
        if (others_ == 3) inside();
    }

    const Quick3& point() const { return at_; }
    double squared() const { return squared_; }

    /// The corners that count.
    Simplex reduced() const
    {
        Simplex out;
        double rest = 1;
        for (std::size_t i = 0; i < others_; ++i) {
            if ((mask_ >> i & 1U) == 0) continue;
            out.weight[out.count] = weight_[i];
            rest -= weight_[i];
            out.corner[out.count++] = s_.corner[i];
        }
        out.weight[out.count] = rest;
        out.corner[out.count++] = s_.corner[others_];
        return out;
    }

private:
    void keep(const std::array<double, 3>& weight, unsigned mask, const Quick3& at)
    {
        const double squared = dot(at, at);
        if (squared_ >= 0 && squared >= squared_) return;
        weight_ = weight;
        mask_ = mask;
        at_ = at;
        squared_ = squared;
    }

    void edge(std::size_t i)
    {
        const double length = dot(side_[i], side_[i]);
        if (length == 0) return;
        std::array<double, 3> w{};
        w[i] = -dot(side_[i], newest_) / length;
        if (w[i] > 0 && w[i] <= 1) keep(w, 1U << i, newest_ + w[i] * side_[i]);
    }

    /// By products of sides, not by normal equations, which square what is lost on long thin faces.
    void face(std::size_t i, std::size_t j)
    {
        const Quick3 m = cross(side_[i], side_[j]);
        const double area = dot(m, m);
        if (area == 0) return;
        std::array<double, 3> w{};
        w[i] = dot(cross(side_[j], newest_), m) / area;
        w[j] = dot(cross(newest_, side_[i]), m) / area;
        if (w[i] > 0 && w[j] > 0 && w[i] + w[j] <= 1)
            keep(w, 1U << i | 1U << j, (dot(m, newest_) / area) * m);
    }

    void inside()
    {
        const double volume = dot(side_[0], cross(side_[1], side_[2]));
        if (volume == 0) return;
        const std::array<double, 3> w{-dot(newest_, cross(side_[1], side_[2])) / volume,
                                      -dot(side_[0], cross(newest_, side_[2])) / volume,
                                      -dot(side_[0], cross(side_[1], newest_)) / volume};
        if (w[0] >= 0 && w[1] >= 0 && w[2] >= 0 && w[0] + w[1] + w[2] <= 1) keep(w, 7U, {});
    }

    const Simplex& s_;
    std::size_t others_;
    Quick3 newest_, at_;
    std::array<Quick3, 3> side_;
    std::array<double, 3> weight_{};
    unsigned mask_ = 0;
    double squared_ = -1;
};

bool has(const Simplex& s, const Quick3& p)
{
    for (std::size_t i = 0; i < s.count; ++i)
        if (s.corner[i].p.x == p.x && s.corner[i].p.y == p.y && s.corner[i].p.z == p.z) return true;
    return false;
}

bool narrow(const QuickGap& found, const QuickEffort& effort)
{
    const double width = found.upper - found.lower;
    const bool touching = effort.share > 0 && found.upper <= effort.level;
    return touching || width <= effort.enough || width <= effort.share * (found.lower - effort.level);
}

Quick3 mixed(const Simplex& s, Quick3 Corner::*of)
{
    Quick3 out = s.corner[s.count - 1].*of;
    const Quick3 base = out;
    for (std::size_t i = 0; i + 1 < s.count; ++i)
        out = out + s.weight[i] * (s.corner[i].*of - base);
    return out;
}

/// The longest way between two corners on one body.
Quick3 longest(const Simplex& s, Quick3 Corner::*of)
{
    Quick3 out;
    for (std::size_t i = 0; i + 1 < s.count; ++i)
        for (std::size_t j = i + 1; j < s.count; ++j) {
            const Quick3 way = s.corner[j].*of - s.corner[i].*of;
            if (dot(way, way) > dot(out, out)) out = way;
        }
    return out;
}

/// The body's height over ground that is `sign` times its normal up, from A to B or from B to A.
QuickGap over_ground(const QuickPlace& body, const QuickPlace& ground)
{
    const Quick3 between = body.pivot - ground.pivot;
    const auto height = [&](double sign) {
        const Quick3 up = sign * ground.normal;
        QuickGap out;
        out.point_a = body.least(up).point;
        out.lower = out.upper = dot(up, between + out.point_a) - sign * ground.body->offset;
        out.normal = -up;
        out.point_b = between + out.point_a - out.lower * up;
        return out;
    };
    const QuickGap above = height(1);
    if (!ground.body->two_sided || above.lower >= 0) return above;
    const QuickGap below = height(-1);
    return below.lower > above.lower ? below : above;
}

} // namespace

QuickGap quick_gap(const QuickPlace& a, const QuickPlace& b, const Quick3& hint, const QuickEffort& effort)
{
    if (b.body->kind == Kind::ground) return over_ground(a, b);
    if (a.body->kind == Kind::ground) {
        QuickGap out = over_ground(b, a);
        std::swap(out.point_a, out.point_b);
        out.normal = -out.normal;
        return out;
    }
    const Quick3 between = b.pivot - a.pivot;
    const auto corner = [&](const Quick3& n) {
        Corner out{{}, a.least(-n).point, b.least(n).point};
        out.p = between + (out.b - out.a);
        return out;
    };
    QuickGap out;
    Simplex simplex;
    Quick3 first = hint;
    if (dot(first, first) == 0) first = between + (b.centre - a.centre);
    if (dot(first, first) == 0) first = {1, 0, 0};
    simplex.corner[simplex.count++] = corner(first);
    bool any = false;
    int idle = 0;
    for (int i = 0; i < most_iterations && idle < most_idle; ++i) {
        const Nearest nearest(simplex);
        simplex = nearest.reduced();
        const double length = std::sqrt(nearest.squared());
        const bool sliver = any && out.lower > 0; // a plane between them says no to four points that hold 0
        out.overlap = (simplex.count == 4 || length == 0) && !sliver;
        if (out.overlap) {
            out.lower = -infinity;
            out.upper = 0;
        }
        if (out.overlap || simplex.count == 4 || length == 0) return out;
        const Quick3 at_a = mixed(simplex, &Corner::a);
        const Quick3 at_b = mixed(simplex, &Corner::b);
        const double apart = norm(between + (at_b - at_a));
        const bool gained = !any || apart < out.upper;
        idle = gained ? 0 : idle + 1;
        if (gained) {
            out.upper = apart;
            out.point_a = at_a;
            out.point_b = at_b;
            out.edge_a = longest(simplex, &Corner::a);
            out.edge_b = longest(simplex, &Corner::b);
        }
        const Quick3 n = (1 / length) * nearest.point();
        const Corner next = corner(n);
        const double lower = dot(n, next.p);
        if (!any || lower > out.lower) {
            out.lower = lower;
            out.normal = n;
            idle = 0;
        }
        any = true;
        if (narrow(out, effort) || has(simplex, next.p)) break;
        simplex.corner[simplex.count++] = next;
    }
    return out;
}

double quick_separation(const QuickPlace& a, const QuickPlace& b, const Quick3& n)
{
    constexpr double parallel = 1e-6;
    const bool on_b = b.body->kind == Kind::ground;
    if (!on_b && a.body->kind != Kind::ground)
        return dot(n, b.pivot - a.pivot) + (dot(n, b.least(n).point) - dot(n, a.least(-n).point));
    const QuickPlace& ground = on_b ? b : a;
    const QuickPlace& body = on_b ? a : b;
    const Quick3 up = on_b ? -n : n;
    const bool above = norm(up - ground.normal) < parallel;
    const bool below = ground.body->two_sided && norm(up + ground.normal) < parallel;
    if (!above && !below) return -infinity;
    const double sign = above ? 1 : -1;
    const Quick3 lowest = body.least(sign * ground.normal).point;
    return sign * (dot(ground.normal, body.pivot - ground.pivot + lowest) - ground.body->offset);
}

double quick_distance(const QuickPlace& place, const Quick3& point, double enough)
{
    if (place.body->kind == Kind::ground) {
        const double height = dot(place.normal, point) - place.body->offset;
        return place.body->two_sided ? std::abs(height) : height;
    }
    QuickBody speck;
    speck.points = {{}};
    speck.pivot = place.pivot + point;
    return quick_gap(place, QuickPlace(speck, 0), {}, {enough, 0, 0}).upper;
}

} // namespace brink::support
