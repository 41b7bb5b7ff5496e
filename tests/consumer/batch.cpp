// SPDX-License-Identifier: BSD-3-Clause
#include "batch.h"

void first_contacts(const brink::Shape& a, std::span<const brink::Motion> motions_a, const brink::Shape& b,
                    std::span<const brink::Motion> motions_b, std::span<double> times)
{
    for (std::size_t i = 0; i < times.size(); ++i) {
        const brink::Toi toi = brink::time_of_impact(a, motions_a[i], b, motions_b[i]);
        times[i] = toi.status == brink::Status::hit ? toi.t : std::numeric_limits<double>::quiet_NaN();
    }
}
