// SPDX-License-Identifier: BSD-3-Clause
#include "output.h"

#include <fmt/format.h>

#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <unistd.h>

namespace brink::bench {

Output::Output(std::filesystem::path folder) : folder_(std::move(folder))
{
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    const auto probe = folder_ / ".brink-bench";
    if (!std::filesystem::is_directory(folder_) || !std::ofstream(probe))
        throw std::runtime_error(fmt::format("cannot write to the folder '{}' (--out)", folder_.string()));
    std::filesystem::remove(probe, error);
}

void Output::write(std::string_view name, std::string_view text) const
{
    std::ofstream file(folder_ / name);
    file << text;
    file.close();
    if (!file) throw std::runtime_error(fmt::format("cannot write '{}'", path_of(name)));
}

std::string Output::draw(std::string_view stem, std::string_view script) const
{
    const std::string name = fmt::format("{}.gp", stem);
    write(name, script);
    if (std::system("command -v gnuplot >/dev/null 2>&1") != 0)
        return fmt::format("No picture: gnuplot is not installed (Debian: gnuplot-nox). Script: {}",
                           path_of(name));
    const std::string command = fmt::format("cd -- {} && gnuplot {}", shell_quoted(folder_.string()), name);
    if (std::system(command.c_str()) != 0)
        return fmt::format("No picture: gnuplot failed on {}", path_of(name));
    return fmt::format("Picture: {0}.svg and {0}.png", path_of(stem));
}

std::string Output::path_of(std::string_view name) const { return (folder_ / name).string(); }

std::string in_both_formats(std::string_view stem, const Sheet& sheet, std::string_view drawing)
{
    const auto begin = [&](std::string_view terminal, const Letters& letters) {
        return fmt::format(
            "        set terminal {} enhanced {} font 'DejaVu Sans,{:g}' background '#ffffff'\n"
            "        large = ',{}'; middle_size = ',{}'; small = ',{}'\n",
            terminal, sheet.lines, letters.usual, letters.large, letters.middle, letters.small);
    };
    const std::string svg = fmt::format("svg size 1500,{} dynamic", sheet.height);
    const std::string png = fmt::format("pngcairo size 1500,{}", sheet.height);
    return fmt::format(
        "\ndo for [format in 'svg png'] {{\n    if (format eq 'svg') {{\n{}    }} else {{\n{}    }}\n"
        "    set output '{}.' . format\n{}    unset output\n}}\n",
        begin(svg, sheet.svg), begin(png, sheet.png), stem, drawing);
}

std::string thousands(std::int64_t n)
{
    return n < 1000 ? std::to_string(n) : fmt::format("{},{:03}", thousands(n / 1000), n % 1000);
}

std::string shell_quoted(std::string_view text)
{
    std::string quoted = "'";
    for (const char c : text) {
        if (c == '\'')
            quoted += "'\\''";
        else
            quoted += c;
    }
    return quoted + "'";
}

Progress::~Progress()
{
    if (shown_ && isatty(STDERR_FILENO) != 0) fmt::print(stderr, "\n");
}

void Progress::step()
{
    const int before = done_++ * 10 / total_;
    const int percent = done_ * 100 / total_;
    shown_ = true;
    if (isatty(STDERR_FILENO) != 0)
        fmt::print(stderr, "\r{} {:3} %", what_, percent);
    else if (done_ * 10 / total_ > before)
        fmt::print(stderr, "{} {:3} %\n", what_, percent);
}

} // namespace brink::bench
