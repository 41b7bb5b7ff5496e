// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "csv.h"
#include "output.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace CLI {
class App;
}

namespace brink::bench {

inline constexpr double not_measured = std::numeric_limits<double>::quiet_NaN();

/// What one solver did with one question, as a part's CSV has it. What was not measured is not_measured, and
/// a count that was not taken is -1.
struct Figure {
    std::string question;         // solvers are compared within one, as "box-box, turning to 60 degrees"
    std::string who;              // "brink", and perhaps a setting of it ("brink at 1e-09"), or a rival
    double time = not_measured;   // ns per query
    double spread = not_measured; // standard deviation of `time` between repetitions, ns
    double error = not_measured;  // of t, in steps: the median over the hits seen
    double worst = not_measured;  // likewise, the largest
    std::int64_t cases = -1;      // that the counts below are out of
    std::int64_t missed = -1;     // a contact not said
    std::int64_t false_hits = -1; // a contact said where there is none
    std::int64_t wrong = -1;      // either of the two, where they are not told apart
    std::int64_t late = -1;       // a contact said after it happened
};

/// A picture that a part draws, and one sentence that says what to see in it.
struct Picture {
    std::string_view stem; // <stem>.svg and <stem>.png
    std::string_view see;
};

enum class Effort : unsigned char { usual, quick };

/// One thing that the program measures.
class Part {
public:
    Part() = default;
    virtual ~Part() = default;
    Part(const Part&) = delete;
    Part& operator=(const Part&) = delete;

    virtual std::string_view name() const = 0;
    /// What it measures, in a line.
    virtual std::string_view about() const = 0;
    /// Adds its options to the command of its name.
    virtual void describe(CLI::App&) = 0;
    /// Measures; prints tables, writes its CSV and pictures. `quick`: as many queries as keep all parts
    /// together under ten minutes. Gives how many answers broke a promise.
    virtual std::uint64_t run(const Output&, Effort) = 0;
    /// The CSV it writes, and what that says.
    virtual std::string_view csv() const = 0;
    virtual std::vector<Figure> figures(const Csv&) const = 0;
    virtual std::vector<Picture> pictures() const = 0;
    /// What the CSV shows, in words, where figures do not say it; may be empty.
    virtual std::string verdict(const Csv&) const { return {}; }
};

/// An option of one or several names, separated by commas, or "all".
void add_choice(CLI::App&, const std::string& option, std::vector<std::string>& value,
                std::vector<std::string> names);
/// What was chosen of them.
std::vector<std::string> chosen(const std::vector<std::string>& value, std::vector<std::string> names);

std::unique_ptr<Part> tunnelling_part();
std::unique_ptr<Part> error_part();
std::unique_ptr<Part> stability_part();
std::unique_ptr<Part> turning_part();
std::unique_ptr<Part> pairs_part();
std::unique_ptr<Part> replay_part();
std::unique_ptr<Part> ingredients_part();
std::unique_ptr<Part> scene_part();

/// All of them, in the order in which `all` runs them.
std::vector<std::unique_ptr<Part>> all_parts();

} // namespace brink::bench
