// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output.h"

namespace brink::bench {

struct IngredientOptions {
    int queries = 10'000; // of each pair, half of them hits; the hits count
};

/// Distance evaluations per hit of pairs that turn by up to 60 degrees, as ingredients of the certificate are
/// added one by one, and the library's own. Table on stdout, ingredients.csv to `output`. Gives the number of
/// answers that are not the library's.
int run_ingredients(const Output& output, const IngredientOptions& options);

} // namespace brink::bench
