// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <query.h>

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace brink::bench {

/// Whose answers are compared: see textbook.h for the second and third, fcl.h for the last.
enum class Solver : unsigned char { brink, textbook, stable, fcl };
inline constexpr std::array<std::string_view, 4> solver_names{"brink", "textbook", "stable", "fcl"};

/// What one solver did with a number of cases, against 200 digits. "Hits" have contact in (0, t_max] and are
/// seen by brink and both textbook formulas: errors are taken over the same cases for all (FCL over those
/// among them that it was asked and saw).
struct Score {
    std::uint64_t cases = 0;
    std::uint64_t meets = 0;        // have contact in [0, t_max]
    std::uint64_t wrong = 0;        // contact said where there is none, or the other way round
    std::uint64_t late = 0;         // contact said, at a t after it has begun
    std::uint64_t undecided = 0;    // brink said neither
    std::uint64_t conservative = 0; // brink hits with no proof of contact: t_upper infinite
    std::uint64_t broken = 0;       // brink's answers that break a promise in any way
    double backward = 0;            // most |gap(t) - target_gap| over eps S of design promise 3, eps = 2^-52
    double backward_centres = 0;    // two spheres: likewise over eps (distance at the start + radii)
    double bracket = 0;             // brink: most of t_upper - t in units of t's last place
    std::vector<double> ulps;       // error of t of each hit, in units of the last place of the exact t

    // Where bodies turn:
    std::uint64_t unsettled = 0; // the referee ran out of evaluations: nothing is said of these
    std::uint64_t stuck = 0;     // brink's undecided ones where nothing grazes
    std::vector<double> steps;   // error of t of each hit, in steps
    std::vector<double> used;    // gap(t) - target_gap of each hit, over what design promise 3 allows

    void add(const Score&);
    /// The error that a share of hits does not exceed. 0 without hits.
    double ulp_at(double share) const { return at_share(ulps, share); }
    /// What a share of the values does not exceed; the share 1 is the maximum. 0 without values.
    static double at_share(std::vector<double> values, double share);
};

/// A pair and class by their index, and the step of the class's level.
struct Spot {
    std::size_t pair = 0, kind = 0, step = 0;
    auto operator<=>(const Spot&) const = default;
};

/// A case that brink answered against a promise.
struct Complaint {
    Spot spot;
    std::uint64_t index = 0;
    bool wrong = false; // a wrong decision, which goes before lateness and the rest
    std::string text;   // as C++, with what is wrong as a comment
    bool precedes(const Complaint& other) const;
};

struct Scores {
    std::map<Spot, std::array<Score, solver_names.size()>> at;
    std::vector<Complaint> complaints; // at most one of each pair and class

    Score& score(const Spot& spot, Solver solver) { return at[spot][static_cast<std::size_t>(solver)]; }
    /// Keeps the first complaint of a pair and class, the first wrong decision where there is one.
    void complain(Complaint);
    void add(const Scores&);
    /// Over the levels.
    Score total(std::size_t pair, std::size_t kind, Solver) const;
};

} // namespace brink::bench
