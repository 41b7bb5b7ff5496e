// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "query.h"

#include <cstddef>
#include <filesystem>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// Queries as text: one format for the fuzzer's cases, the recorded workloads and whoever writes one by hand.
///
///     brink-queries 1
///     # a comment is a line of its own; blank lines and indentation mean nothing
///     hull stone -0x1p-1 -0x1p-1 0x0p+0 0x1p-1 -0x1p-1 0x0p+0 0x0p+0 0x1p-1 0x0p+0 0x0p+0 0x0p+0 0x1p+0
///     query a ball at 240 m/s meets a stone
///     a sphere 0x1.999999999999ap-5
///       position -0x1.8p+1 0x0p+0 0x1p-2
///       translation 0x1p+2 0x0p+0 0x0p+0
///     b hull stone
///       orientation 0x1.6a09e667f3bcdp-1 0x0p+0 0x0p+0 0x1.6a09e667f3bcdp-1
///     tolerance 0x1p-20
///     end
///
/// The first line names the format. Then blocks from `query` to `end`, in which a line says one thing once,
/// and what no line says has its default (Motion's, Options'):
///
///     query NOTE           whatever helps to recognise it, to the end of the line; or nothing
///     a SHAPE, b SHAPE     both needed; the motion that follows, up to the other body, is this one's
///         sphere RADIUS                  capsule A B RADIUS           box HALF_EXTENTS
///         triangle A B C                 plane NORMAL OFFSET          half_space NORMAL OFFSET
///         cylinder HALF_LENGTH RADIUS    cone HALF_LENGTH RADIUS      ellipsoid RADII
///         hull POINT ...                 hull NAME
///     position V, orientation W X Y Z, translation V, rotation V, pivot V
///     t_max X, target_gap X, tolerance X
///     start_contact report|ignore_if_separating|ignore
///     detail contact|time_only
///     max_iterations N
///
/// Names and order are those of the structs' members, a vector is three numbers. `hull NAME POINT ...`
/// outside of a block names a hull for the blocks below. Numbers are hexadecimal, as %a prints them, so that
/// not a bit is lost, or inf, -inf, nan, -nan; a NaN other than the usual one is nan:BITS, all 64 of them in
/// hexadecimal. A decimal number is read too, rounded to the nearest double. Nothing depends on the locale.
namespace brink::support {

struct KeptQuery {
    Query query;
    std::string note{};
    std::size_t line = 0; // of the file it was read from, where its block begins
};

/// The whole file, hulls that occur more than once named. A line break in a note becomes a blank.
void write_queries(std::ostream&, std::span<const KeptQuery>, std::string_view comment = "");

/// The inverse, bit for bit; `file` is only for what is said about errors. Throws std::runtime_error, which
/// says file and line, what is wrong there, and what would be right.
std::vector<KeptQuery> read_queries(std::istream&, std::string_view file);
/// The same from a file; throws the same where it cannot be read.
std::vector<KeptQuery> read_queries(const std::filesystem::path&);

} // namespace brink::support
