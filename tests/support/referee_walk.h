// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "referee_motion.h"

/// A walk along the time axis that cannot pass a root: each step is proven by MovingPair::bulge.
namespace brink::support {

template <class T> struct Limits {
    T near = 0;     // stop where the gap is within this of the level (a length) ...
    T far = -1;     // ... or beyond it by this; never if negative
    int budget = 0; // evaluations of the gap
};

enum class Halt : unsigned char { done, near, far, spent };

template <class T> struct Walk {
    Halt halt = Halt::done;
    T clear = 0;               // the gap is above the level over [from, clear] (from itself too unless near)
    Bracket<T> gap;            // at `clear`
    T closing_speed = 0;       // there, by the nearest points: length per step
    std::optional<T> touched;  // a time after `clear` at which the gap is proven to be at most the level
    T least = 0, least_at = 0; // of the gap's upper bounds seen
    int evaluations = 0;
};

/// From `from` towards `to` while the gap is above the target gap, which is the level.
template <class T> Walk<T> walk(const MovingPair<T>&, const T& from, const T& to, const Limits<T>&);

/// How fast the nearest points of the bracket at t come nearer along its normal: length per step.
template <class T> T closing_speed(const MovingPair<T>&, const T& t, const Bracket<T>&);

extern template Walk<long double> walk(const MovingPair<long double>&, const long double&, const long double&,
                                       const Limits<long double>&);
extern template Walk<Hundred> walk(const MovingPair<Hundred>&, const Hundred&, const Hundred&,
                                   const Limits<Hundred>&);
extern template long double closing_speed(const MovingPair<long double>&, const long double&,
                                          const Bracket<long double>&);
extern template Hundred closing_speed(const MovingPair<Hundred>&, const Hundred&, const Bracket<Hundred>&);

} // namespace brink::support
