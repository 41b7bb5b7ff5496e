// SPDX-License-Identifier: BSD-3-Clause
#include "scene_threads.h"

namespace brink::bench {

bool have_threads() { return false; }

void with_threads(int, const std::function<void()>& work) { work(); }

} // namespace brink::bench
