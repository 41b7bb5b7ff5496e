// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "toi_query.h"

#include <array>
#include <cstddef>
#include <type_traits>

/// What the table of pairs is made of.
namespace brink {

/// Answers like time_of_impact, for one pair of shapes.
using Solver = decltype(&time_of_impact);

/// One pair of the table. The types keep every solver in its row and column.
template <class A, class B> struct Cell {
    Solver solve;
    Method method;
};

template <class T, class... Ts> constexpr std::size_t index_in(const std::variant<Ts...>*)
{
    const bool same[] = {std::is_same_v<T, Ts>...};
    std::size_t i = 0;
    while (!same[i])
        ++i;
    return i;
}
template <class T> constexpr std::size_t index_of = index_in<T>(static_cast<const Shape*>(nullptr));

template <class A, class... B> constexpr std::array<Cell<void, void>, sizeof...(B)> row(Cell<A, B>... cells)
{
    static_assert(std::is_same_v<std::variant<B...>, Shape>, "a row has one cell for each shape, in order");
    return {Cell<void, void>{cells.solve, cells.method}...};
}

} // namespace brink
