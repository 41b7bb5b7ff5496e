// SPDX-License-Identifier: BSD-3-Clause
#include "rubble.h"

#include <stdexcept>

namespace brink::bench {

RubbleRun simulate_rubble(std::uint64_t, const std::function<void(const Sighting&)>&)
{
    throw std::runtime_error("record needs Bullet (Debian: libbullet-dev), which was not found when "
                             "brink-bench was configured; replay needs it not");
}

} // namespace brink::bench
