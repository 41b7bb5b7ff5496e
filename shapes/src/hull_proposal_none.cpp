// SPDX-License-Identifier: BSD-3-Clause
// Built where there is no Qhull.
#include "hull_proposal.h"

namespace brink {

std::vector<Facet> proposed_faces(const std::vector<V3>&) { return {}; }

} // namespace brink
