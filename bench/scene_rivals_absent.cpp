// SPDX-License-Identifier: BSD-3-Clause
#include "scene_rivals.h"

namespace brink::bench {

std::unique_ptr<Rival> bullet_rival(Trees, const Moves&) { return nullptr; }

std::string bullet_version() { return ""; }

} // namespace brink::bench
