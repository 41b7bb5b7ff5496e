// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "allowance.h"
#include "certificate.h"
#include "window.h"

#include <brink/toi.h>

#include <algorithm>

namespace brink {

/// Two bodies on their way through the step, seen from A's pivot, and what an answer about them needs.
template <class Part> class Course : public Allowance {
public:
    Course(const Mover<Core>& a, const Mover<Part>& b, const Options& options);
    Course(const Course&) = delete;
    Course& operator=(const Course&) = delete;

    /// Moves both to their place at time t.
    void go(double time);
    double now() const { return t_; }
    const Facing<Part>& facing() const { return facing_; }
    /// Where the pivots are and how far the bodies have turned from now to another time.
    struct Later {
        Rotation turn_a, turn_b;
        V3 pivot_b;
    };
    Later later(double time) const
    {
        const auto [a, b] = turns(time - t_);
        return {turned(a_.turn, a), turned(b_.turn, b), from_ + time * facing_.velocity};
    }
    Separation separated() const { return separation(part_a_, part_b_); }
    /// The same with the better of what its axis and another one prove: of curved shapes the points alone may
    /// say too much.
    Separation separated(V3 axis) const;

    Toi apart() const { return {.status = Status::separated, .t = options.t_max, .iterations = iterations}; }
    /// An answer at this time, with a contact as far as the caller wants one.
    Toi answer(Status, const Separation&) const;
    /// A gap that counts as there if need be: within what promise 3 allows.
    double allowed() const;
    /// What rounding may do to the gap at the start, where nothing has moved yet; at most.
    double rounding_at_start() const;
    /// From here on a whole turn of the faster body, if the other one drifts so little until the end that a
    /// part of the gap outlasts it: steps leave that, and after the turn every later one goes as this did.
    void begin_lap(double gap);
    /// Whether there was one to give up.
    bool give_up_lap();
    /// When a way without contact proves that there is none.
    double end() const { return std::min(window.end, lap_end_); }
    /// Whether nothing that turns makes a difference.
    bool translates() const { return a_.turn.angle == 0 && b_.turn.angle == 0; }

    const Options& options;
    double fastest = 0; // no gap changes faster
    double radii = 0;   // with the target gap
    Window window;
    int iterations = 0; // distance evaluations

private:
    /// Sines and cosines of the angles by which both turn in that time.
    TwoSinCos turns(double time) const
    {
        if (a_.turn.angle == 0) return {{}, sin_cos(time * b_.turn.angle)};
        return sin_cos(time * a_.turn.angle, time * b_.turn.angle);
    }

    const Mover<Core>& a_;
    const Mover<Part>& b_;
    V3 from_; // from A's pivot to B's at the start
    double t_ = 0, lap_end_ = infinity;
    Core part_a_; // placed
    Part part_b_;
    Facing<Part> facing_;
};

} // namespace brink
