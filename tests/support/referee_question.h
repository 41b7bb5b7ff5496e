// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "referee_turning.h"
#include "verdict.h"

/// The two precisions of one query, and the questions that take both.
namespace brink::support {

struct Start {
    bool contact = false;  // gap(0) <= target_gap
    bool in_doubt = false; // by less than 1e-40 of the scale
    bool deep = false;     // as in Question::Over
    Hundred gap = 0;       // gap(0) - target_gap
};

/// How a pair that starts in contact comes apart.
struct Leaving {
    bool left = false; // the gap exceeded the target ...
    Hundred by = 0;    // ... at this time, and next to nothing before it did not
    double drop = 0;   // how far the gap fell before; cores that overlap count where their depth is known
};

struct Stretch {
    Hundred clear = 0;              // no contact in [from, clear)
    std::optional<Hundred> contact; // proven by then; near `clear` unless in doubt
    bool in_doubt = false;          // the gap comes within 1e-40 of the scale of the target at `clear`
    bool spent = false;             // out of evaluations
    Hundred least = 0;              // least gap seen, less the target
    int evaluations = 0, fine_evaluations = 0;
};

class Question {
public:
    explicit Question(const Query& q, const Budget& budget = {})
        : coarse_(q), fine_(q), t_max_(q.options.t_max), budget_(budget)
    {
    }

    const MovingPair<long double>& coarse() const { return coarse_; }
    const MovingPair<Hundred>& fine() const { return fine_; }

    /// gap(t) - target_gap from below and above: in long double with its blur, in digits where the two are
    /// not on the same side of `level`.
    struct Over {
        Hundred lower, upper;
        bool deep = false; // the cores overlap, and how deep is not known: the bounds are those of touching
    };
    Over over(double t, const Hundred& level) const;

    Start start() const;
    Leaving leaving() const;
    /// First contact in [from, to], the gap being above the target just after `from`.
    Stretch clear(const Hundred& from, const Hundred& to) const;

private:
    bool fine_walk(Stretch& out, const Hundred& to) const;

    MovingPair<long double> coarse_;
    MovingPair<Hundred> fine_;
    double t_max_;
    Budget budget_;
};

/// Gap, normal and points of a hit or of touching, in long double: all of them are doubles.
Findings judge_contact(const Query&, const Toi&, const Question&);

} // namespace brink::support
