// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/toi.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brink::support {

/// One question to time_of_impact.
struct Query {
    Shape a;
    Motion motion_a;
    Shape b;
    Motion motion_b;
    Options options;
};

Toi answer(const Query&);

/// The shape names in the order of the Shape variant.
inline constexpr std::array<std::string_view, std::variant_size_v<Shape>> shape_names{
    "sphere", "capsule", "box", "triangle", "plane", "half_space", "cylinder", "cone", "ellipsoid", "hull"};

/// Whether a shape has a curved surface beyond a radius: cylinder, cone or ellipsoid.
bool curved(const Shape&);

/// Two shapes by their index in the variant, first <= second.
struct Pair {
    std::size_t first = 0;
    std::size_t second = 0;
    std::string name() const; // "sphere-half_space"
    /// Two of plane and half-space, which every query answers with `invalid`.
    bool unbounded() const;
    /// Whether the dense reference judges it: two of sphere, capsule, box, triangle, plane and half-space.
    bool has_reference() const;
    /// Whether it is one of the nine pairs whose translations the referee knows in closed form: sphere
    /// against what has a reference, capsule against capsule and ground. (The library has closed forms of
    /// more.)
    bool closed_form() const;
};

/// Every pair, in the order of the table: sphere-sphere, sphere-capsule, ...
/// hull-hull.
std::vector<Pair> all_pairs();

/// Empty for a name that is none of all_pairs().
std::optional<Pair> pair_named(std::string_view name);

enum class Family : unsigned char {
    any,         // translation of both for nine in ten of the closed forms and half of the others
    translation, // of both bodies
    rotation,    // of one or both, up to 60 degrees, up to 300, several turns, about centred and other pivots
};

/// How a query that grazes is aimed: in long double, or in doubles, in a fraction of the time and no less
/// near. The two give different queries.
enum class Aim : unsigned char { exact, quick };

/// A query biased to the nasty: a function of its arguments alone. About half of the queries hit; one in ten
/// grazes within 1e-3 to 1e-12, and as many each are parallel, touching or overlapping at the start, far from
/// the origin, exact in small integers, thin walls crossed in one step.
Query query(const Pair&, Family, std::uint64_t seed, std::uint64_t index, Aim = Aim::exact);

/// The same made nastier where something turns, for long campaigns: four in five turn, by up to 60 degrees,
/// up to 300, ten turns and seldom a hundred, one body or both; needles; bodies that rock on their nearest
/// corner; target gaps tuned to the least gap of the whole motion; tolerances of 1e-12, 1e-9, 1e-6, 1e-4 and
/// 0.
Query campaign_query(const Pair&, std::uint64_t seed, std::uint64_t index, Aim = Aim::exact);

} // namespace brink::support
