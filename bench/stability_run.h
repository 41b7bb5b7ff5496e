// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "part.h"
#include "stability_case.h"

#include <string_view>

namespace brink::bench {

/// All blocks, by so many workers (0: as many as the machine has), each with an FCL process of its own.
Scores measure_all(std::string_view what, const std::vector<Block>&,
                   Scores (*measure)(const Block&, support::FclProcess&), unsigned threads);

/// The first few, wrong decisions before the rest.
void print_complaints(const Scores&, std::string_view (*class_name)(std::size_t kind));

/// Of each pair and solver: all classes and levels together, which differ too much for one error to stand for
/// all, so that only counts are given. `motion` goes behind the pair's name.
std::vector<Figure> figures_by_pair(const Csv&, std::string_view motion);

/// How many of brink's answers break a promise.
std::uint64_t broken(const Scores&);

} // namespace brink::bench
