// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output.h"

#include <query_text.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace brink::bench {

struct RubbleOptions {
    std::uint64_t seed = 1; // of sizes, places and shots
};

/// Two bodies whose swept bounds overlap in one step of the simulation.
struct Sighting {
    support::Query query; // the default options
    int step = 0;
    std::size_t a = 0, b = 0; // a < b: bodies, in the order in which they came
};

/// What came of a simulation.
struct RubbleRun {
    int steps = 0;
    std::size_t bodies = 0;
    /// The farthest that a recorded motion ends from where the simulator put the body: of a position, in
    /// metres, and of an orientation, in radians. Its arithmetic is in float.
    double most_off = 0, most_turned_off = 0;
};

/// Bullet's seconds per step.
inline constexpr float rubble_dt = 1.0F / 60;

/// A pile of stones falls into a pen of thin walls, settles, and is shot at. Bullet moves it step by step
/// with its continuous features off; `see` gets every pair of each step whose swept bounds overlap and of
/// which one moves, as their true shapes (not grown by Bullet's collision margins) and the motions that
/// Bullet's own integrator makes of their velocities. A function of the seed, on one kind of machine: Bullet
/// picks its instructions by processor. Throws std::runtime_error where Bullet was not found at configure
/// time.
RubbleRun simulate_rubble(std::uint64_t seed, const std::function<void(const Sighting&)>& see);

/// Some 4,000 sightings of many, so that neither what rests nor what passes far away drowns the rest: of each
/// kind of outcome so many, a third of them at each range of speed where there are enough.
class RubbleSample {
public:
    explicit RubbleSample(std::uint64_t seed) : seed_(seed) {}
    void see(const Sighting&);
    /// In the order of the steps, with the outcome, the speed and where it comes from in the note.
    std::vector<support::KeptQuery> picked() const;
    /// How many of each kind and speed there were, and how many of them were picked.
    std::string table() const;

private:
    static constexpr std::size_t kinds = 4, speeds = 3;
    struct Stratum {
        std::uint64_t seen = 0;
        std::vector<Sighting> held; // each that was seen is as likely as another to be here
    };
    static std::size_t share(std::size_t kind, std::size_t speed, const std::vector<Stratum>&);

    std::uint64_t seed_;
    std::vector<Stratum> strata_ = std::vector<Stratum>(kinds * speeds);
};

/// Runs the simulation, writes rubble.txt and prints what is in it.
void run_record(const Output&, const RubbleOptions&);

} // namespace brink::bench
