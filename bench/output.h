// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <string_view>

namespace brink::bench {

/// The folder that CSVs and pictures go to. Made, and proven writable, before anything is measured: the
/// constructor throws std::runtime_error, naming the folder, where that fails.
class Output {
public:
    explicit Output(std::filesystem::path folder);

    /// Writes folder/name. Throws std::runtime_error, naming the file, where it cannot be written.
    void write(std::string_view name, std::string_view text) const;

    /// Writes the gnuplot script as folder/<stem>.gp and runs it there: it draws <stem>.svg and <stem>.png.
    /// Gives a line that says where they are, or why there are none.
    std::string draw(std::string_view stem, std::string_view script) const;

    std::string path_of(std::string_view name) const;

private:
    std::filesystem::path folder_;
};

/// The sizes of a picture's letters, in points.
struct Letters {
    double usual = 0;
    int large = 0, middle = 0, small = 0;
};

/// A picture 1500 pixels wide, once as SVG and once as PNG.
struct Sheet {
    int height = 760; // pixels
    Letters svg, png;
    std::string_view lines = "butt"; // their ends and corners, in gnuplot's words; or "rounded"
};

/// The part of a gnuplot script that draws <stem>.svg and <stem>.png: `drawing` twice, for which the fonts
/// are called large, middle_size and small.
std::string in_both_formats(std::string_view stem, const Sheet&, std::string_view drawing);

/// 1234567 as "1,234,567"; n >= 0.
std::string thousands(std::int64_t n);

/// `text` between single quotes, for a shell.
std::string shell_quoted(std::string_view text);

/// One line on stderr that is rewritten while long work goes on; every tenth of it a line of its own where
/// stderr is not a terminal.
class Progress {
public:
    Progress(std::string_view what, int total) : what_(what), total_(total) {}
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// One more of the total is done.
    void step();

private:
    std::string what_;
    int total_;
    int done_ = 0;
    bool shown_ = false;
};

} // namespace brink::bench
