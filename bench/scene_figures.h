// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/ledger.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace brink::bench {

/// What one library did with one scene: medians over steps. What was not measured is 0.
struct SceneFigures {
    std::string scene;
    std::string order; // "random" or "spatial": in which the bodies are stored
    std::string who;   // "brink", "FCL", "FCL two trees", "Bullet" or "Bullet two trees"
    int threads = 1;
    std::size_t n = 0;
    std::size_t movers = 0;
    std::size_t pairs = 0;   // that overlap, in the last step
    std::size_t impacts = 0; // in the last step
    int steps = 0;           // that the medians are of
    double build_ms = 0;     // n bodies added and the first update; of a rival, n boxes made a tree
    double motions_ms = 0; // Scene::set_motions of all movers: their swept boxes, too, which rivals are given
    double update_ms = 0;  // the tree, after every mover moved
    double pairs_ms = 0;   // every candidate pair, then
    double step_ms = 0;    // both: median of the sums
    double balls_ms = 0;   // the same as step_ms, but only the pairs whose swept balls meet too
    std::size_t ball_pairs = 0;
    double impacts_ms = 0; // every impact, after an update of its own
    double first_ms = 0;   // the first impact, after an update of its own
    double bytes = 0;      // a body: of the scene's broad phase by its own word, of a rival on the heap
    double heap = 0;       // a body: all that building took on the heap
    double floor_ms = 0;   // see floor_ms()
};

/// One scene with one layer switched off, or none.
struct LayerFigures {
    std::string scene;
    std::string without; // a layer's name, or "nothing"
    std::size_t n = 0;
    bool skipped = false; // it would have taken too long
    double impacts_ms = 0, first_ms = 0;
    std::uint64_t impacts_exact = 0, first_exact = 0; // pairs asked exactly
};

/// The ledgers of the last step of a scene, as tables.
struct SceneLedgers {
    std::string scene;
    std::size_t n = 0;
    Ledger impacts, first;
};

struct SceneResults {
    std::vector<SceneFigures> figures;
    std::vector<LayerFigures> layers;
    std::vector<SceneLedgers> ledgers;
    double bandwidth = 0; // bytes a second, read by one thread
    int wrong = 0;        // times that a rival's pairs were not the scene's
};

/// Null where there is none such.
const SceneFigures* find(const std::vector<SceneFigures>&, std::string_view scene, std::string_view order,
                         std::string_view who, int threads, std::size_t n);

/// Bytes a second that one thread reads from memory, the best of five passes over half a gigabyte.
double read_bandwidth();

/// The milliseconds in which memory hands over what a step cannot do without: the 128 bytes of each mover's
/// motion and the 24 of its swept box, read once, and the 8 of each pair, written. What lies still need not
/// be read at all.
double floor_ms(const SceneFigures&, double bandwidth);

/// Bytes on the heap now; 0 where the C library does not say.
std::size_t heap_bytes();

} // namespace brink::bench
