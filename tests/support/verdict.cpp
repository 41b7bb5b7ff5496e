// SPDX-License-Identifier: BSD-3-Clause
#include "verdict.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <utility>

namespace brink::support {
namespace {

constexpr Real eps = 0x1p-52L;

double shown(Real x) { return static_cast<double>(x); }

bool answered(const Toi& toi)
{
    return toi.status == Status::touching || toi.status == Status::hit || toi.status == Status::undecided;
}

/// What may be lost where points are given in the world, far from the origin.
Real world_rounding(Trial& trial)
{
    const Toi& toi = trial.toi();
    return trial.rounding() + 8 * eps * (norm(real3(toi.point_a)) + norm(real3(toi.point_b)));
}

/// The least gap over [from, to], looked at on a grid.
Real least_between(const GapOverTime& motion, Real from, Real to)
{
    Real least = motion.at(to).gap;
    for (int i = 0; i < 8; ++i)
        least = std::min(least, motion.at(from + (to - from) * i / 8).gap);
    return least;
}

/// Promises 1 and 2: apart before t. `separated` and `undecided` say so too.
Findings judge_late(Trial& trial)
{
    const Reference& ref = trial.referee();
    const Toi& toi = trial.toi();
    const Real target = trial.query().options.target_gap;
    const Real slack = trial.rounding() + 2 * eps * std::max<Real>(ref.closing_speed, 0) * toi.t;
    if (!ref.contact || ref.t >= toi.t || trial.start_in_doubt()) return {};
    const Real least =
        toi.status == Status::separated ? ref.least_gap : least_between(trial.motion(), ref.t, toi.t);
    if (least >= target - slack) return {};
    const char* check = toi.status == Status::separated ? "missed a hit" : "late";
    return {
        {check, fmt::format("contact at {:.17g}, t {:.17g}: the gap falls {:.3g} below the target before it",
                            shown(ref.t), toi.t, shown(target - least))}};
}

/// Promise 3: touching at t, and contact by t_upper.
Findings judge_tight(Trial& trial)
{
    const Toi& toi = trial.toi();
    if (toi.status != Status::hit) return {};
    const Reference& ref = trial.referee();
    const Real target = trial.query().options.target_gap;
    const Real over = trial.motion().at(toi.t).gap - target;
    const Real last_bit = eps * std::max<Real>(ref.closing_speed, 0) * toi.t;
    Findings out;
    if (over > trial.band() + last_bit)
        out.push_back({"early", fmt::format("gap - target = {:.3g} at t, allowed {:.3g}", shown(over),
                                            shown(trial.band() + last_bit))});
    if (!(toi.t <= toi.t_upper)) out.push_back({"t_upper", "t_upper before t"});
    if (toi.t_upper < infinity) {
        const bool begun = ref.contact && ref.t <= toi.t_upper + trial.spread();
        const bool nearly = ref.least_gap <= target + trial.rounding() && !ref.gave_up;
        if (!begun && !nearly && !ref.gave_up)
            out.push_back(
                {"t_upper", fmt::format("said to touch by {:.17g}, first contact {:.17g}, least gap {:.3g}",
                                        toi.t_upper, shown(ref.t), shown(ref.least_gap - target))});
    }
    const bool receding =
        toi.t == 0 && !ref.contact && !ref.started && !ref.gave_up && ref.closing_speed <= 0;
    const Real later = trial.motion().at(std::min<Real>(1e-6L, trial.query().options.t_max)).gap;
    if (receding && later - target > over + trial.rounding())
        out.push_back({"sticks", "hit at 0 for a pair that is apart and recedes"});
    return out;
}

/// Promise 5.
Findings judge_start(Trial& trial)
{
    const Reference& ref = trial.referee();
    const Toi& toi = trial.toi();
    const Options& options = trial.query().options;
    const Real over = ref.start_gap - static_cast<Real>(options.target_gap);
    const bool touching = toi.status == Status::touching;
    if (touching && over > trial.rounding())
        return {{"touching", fmt::format("gap(0) is {:.3g} above the target", shown(over))}};
    if (touching && options.start_contact == StartContact::ignore && over < -trial.rounding())
        return {{"start contact", "touching, though contact at the start is to be ignored"}};
    if (touching || over > -trial.rounding()) return {};
    if (options.start_contact == StartContact::report)
        return {{"touching", fmt::format("not said, but gap(0) is {:.3g} below the target", shown(-over))}};
    if (options.start_contact == StartContact::ignore_if_separating && ref.drop > trial.rounding())
        return {{"start contact", fmt::format("not touching, but the gap falls by {:.3g}", shown(ref.drop))}};
    return {};
}

/// How far the core reaches along n, from `origin`.
std::array<Real, 2> extent(const Placed& s, const Real3& n, const Real3& origin)
{
    return {dot(n, farthest(s, -n) - origin), dot(n, farthest(s, n) - origin)};
}

/// A body's height above the ground along `up`, which must be the ground's normal or, for a plane, its
/// opposite.
Real height(const Placed& body, const Placed& ground, const Real3& up)
{
    const auto [low, high] = extent(body, ground.normal, ground.offset * ground.normal);
    constexpr Real parallel = 1e-6L;
    if (norm(up - ground.normal) < parallel) return low - body.radius;
    const bool under = ground.kind == Placed::Kind::plane && norm(up + ground.normal) < parallel;
    return under ? -high - body.radius : -std::numeric_limits<Real>::infinity();
}

/// Separation of the shapes along a direction, to hold a normal to.
Real separation(const Placed& a, const Placed& b, const Real3& n)
{
    if (b.unbounded()) return height(a, b, -n);
    if (a.unbounded()) return height(b, a, n);
    const auto [low_a, high_a] = extent(a, n, Real3{});
    const auto [low_b, high_b] = extent(b, n, Real3{});
    return low_b - high_a - a.radius - b.radius;
}

/// Gap, normal and points at t.
Findings judge_contact(Trial& trial)
{
    const Toi& toi = trial.toi();
    if (!answered(toi)) return {};
    const Placed a = trial.motion().placed_a(toi.t);
    const Placed b = trial.motion().placed_b(toi.t);
    const Gap truth = gap(a, b);
    const Real close = 4 * trial.rounding();
    Findings out;
    if (!(std::abs(toi.gap - truth.gap) <= close))
        out.push_back({"gap", fmt::format("says {:.17g}, is {:.17g}", toi.gap, shown(truth.gap))});
    const Real3 n = real3(toi.normal);
    const Real core = truth.gap + a.radius + b.radius;
    const bool directed = norm(n) > 0.5L;
    if (!directed && core > close) out.push_back({"normal", "zero, though one is defined"});
    const Real loose = std::max<Real>(trial.query().options.tolerance, 1e-6L * trial.motion().scale());
    if (directed && separation(a, b, n) < truth.gap - loose)
        out.push_back({"normal", fmt::format("the separation along it is {:.3g}, the gap {:.3g}",
                                             shown(separation(a, b, n)), shown(truth.gap))});
    const Real off_a = gap_to_point(a, real3(toi.point_a) - trial.motion().origin());
    const Real off_b = gap_to_point(b, real3(toi.point_b) - trial.motion().origin());
    if (!(std::max(off_a, off_b) <= 4 * world_rounding(trial)))
        out.push_back(
            {"points", fmt::format("off the shapes by {:.3g} and {:.3g}", shown(off_a), shown(off_b))});
    return out;
}

} // namespace

Trial::Trial(Query query, Toi toi) : query_(std::move(query)), toi_(std::move(toi)) {}

const GapOverTime& Trial::motion()
{
    if (!motion_) motion_.emplace(query_);
    return *motion_;
}

const Reference& Trial::referee()
{
    if (!reference_) reference_ = reference(query_, motion());
    return *reference_;
}

const Quick& Trial::quick()
{
    if (!quick_) quick_ = quick_judge(query_, toi_);
    return *quick_;
}

Real Trial::band()
{
    const Pair pair{std::min(query_.a.index(), query_.b.index()),
                    std::max(query_.a.index(), query_.b.index())};
    if (pair.closed_form() && motion().translates()) return rounding();
    return std::max<Real>(query_.options.tolerance, rounding());
}

bool Trial::start_in_doubt()
{
    if (query_.options.start_contact == StartContact::report) return false;
    return std::abs(referee().start_gap - static_cast<Real>(query_.options.target_gap)) <= rounding();
}

Real Trial::spread()
{
    const Real speed = referee().closing_speed;
    if (!(speed > 0)) return 1;
    return 8 * eps + 4 * band() / speed;
}

Findings judge_by_reference(Trial& trial)
{
    Findings out;
    for (const auto& part : {judge_late(trial), judge_tight(trial), judge_start(trial), judge_contact(trial)})
        out.insert(out.end(), part.begin(), part.end());
    return out;
}

Findings judge(Trial& trial)
{
    Findings out = judge_alone(trial);
    if (trial.toi().status == Status::invalid) return out;
    const Findings more = judge_by_reference(trial);
    out.insert(out.end(), more.begin(), more.end());
    return out;
}

} // namespace brink::support
