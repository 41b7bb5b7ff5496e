// SPDX-License-Identifier: BSD-3-Clause
#include "in_digits.h"

#if BRINK_HAVE_REFEREE
#include "referee.h"

#include <fmt/format.h>
#endif

namespace brink::fuzz {

#if BRINK_HAVE_REFEREE

bool verifiable(const support::Query& q) { return support::refereed(q); }

support::Findings verified(const support::Query& q, const Toi& toi)
{
    support::Findings findings = support::verify(q, toi);
    for (support::Finding& f : findings)
        f.check = "in 200 digits: " + f.check;
    return findings;
}

std::string truth_in_words(const support::Query& q)
{
    const support::Truth truth = support::truth(q);
    const auto shown = [](const support::Digits& x) { return static_cast<double>(x); };
    const double t = shown(truth.t);
    return fmt::format("in 200 digits: contact {} at {:.17g} + {:.6g}, started {}, least gap - target "
                       "{:.6g}, closing {:.6g}{}\n",
                       truth.meets, t, shown(truth.t - t), truth.started, shown(truth.least_gap),
                       shown(truth.closing_speed), truth.in_doubt ? ", in doubt" : "");
}

#else

bool verifiable(const support::Query&) { return false; }
support::Findings verified(const support::Query&, const Toi&) { return {}; }
std::string truth_in_words(const support::Query&) { return {}; }

#endif

} // namespace brink::fuzz
