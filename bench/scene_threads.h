// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>

namespace brink::bench {

/// Whether more than one thread can be asked for: oneTBB was found at configure time.
bool have_threads();

/// Does the work in an arena of so many of oneTBB's threads, this one among them.
void with_threads(int threads, const std::function<void()>& work);

} // namespace brink::bench
