// SPDX-License-Identifier: BSD-3-Clause
#include "in_digits.h"

#if BRINK_HAVE_REFEREE
#include "referee.h"
#include "referee_turning.h"

#include <fmt/format.h>
#endif

namespace brink::fuzz {

#if BRINK_HAVE_REFEREE

namespace {

template <class Number> double shown(const Number& x) { return static_cast<double>(x); }

support::Findings named(support::Findings findings, const char* judge)
{
    for (support::Finding& f : findings)
        f.check = judge + f.check;
    return findings;
}

} // namespace

bool can_judge(const support::Query& q) { return support::judgeable(q); }

Ruled ruled(const support::Query& q, const Toi& toi, Patience patience)
{
    constexpr support::Budget little{1000, 40};
    const support::Budget budget = patience == Patience::all ? support::Budget{} : little;
    const support::Ruling ruling = support::rule(q, toi, budget);
    return {named(ruling.findings, "referee: "), ruling.unsettled, ruling.in_digits};
}

FirstContact first_contact(const support::Query& q, const Toi& toi)
{
    const support::Meeting m = support::meeting(q);
    FirstContact out{m.meets, m.in_doubt, m.spent, support::grazes(q, m, toi.t)};
    if (m.meets) out.early = shown(m.by - toi.t);
    out.least_gap = shown(m.least_gap);
    out.closing_speed = shown(m.closing_speed);
    return out;
}

support::Findings verified(const support::Query& q, const Toi& toi)
{
    if (!support::refereed(q)) return {};
    return named(support::verify(q, toi), "in 200 digits: ");
}

std::string truth_in_words(const support::Query& q)
{
    std::string out;
    if (support::refereed(q)) {
        const support::Truth truth = support::truth(q);
        const double t = shown(truth.t);
        out += fmt::format("in 200 digits: contact {} at {:.17g} + {:.6g}, started {}, least gap - target "
                           "{:.6g}, closing {:.6g}{}\n",
                           truth.meets, t, shown(truth.t - t), truth.started, shown(truth.least_gap),
                           shown(truth.closing_speed), truth.in_doubt ? ", in doubt" : "");
    }
    const support::Meeting m = support::meeting(q);
    const double apart = shown(m.apart);
    return out +
           fmt::format(
               "in 100 digits: contact {}, apart until {:.17g} + {:.6g}, contact by {:.17g}, started {} "
               "by {:.6g}, left {} by {:.17g}, least gap - target {:.6g}, closing {:.6g}, {} and {} "
               "evaluations{}{}{}\n",
               m.meets, apart, shown(m.apart - apart), shown(m.by), m.started, shown(m.start_gap), m.left,
               shown(m.left_by), shown(m.least_gap), shown(m.closing_speed), m.evaluations,
               m.fine_evaluations, m.grazing ? ", grazing" : "", m.in_doubt ? ", in doubt" : "",
               m.spent ? ", gave up" : "");
}

void forget_digits() { mpfr_free_cache(); }

#else

bool can_judge(const support::Query&) { return false; }
Ruled ruled(const support::Query&, const Toi&, Patience) { return {}; }
FirstContact first_contact(const support::Query&, const Toi&) { return {}; }
support::Findings verified(const support::Query&, const Toi&) { return {}; }
std::string truth_in_words(const support::Query&) { return {}; }
void forget_digits() {}

#endif

} // namespace brink::fuzz
