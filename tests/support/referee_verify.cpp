// SPDX-License-Identifier: BSD-3-Clause
#include "referee.h"

#include "referee_encounter.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace brink::support {
namespace {

double shown(const Digits& x) { return static_cast<double>(x); }

const Digits eps = 0x1p-52;
/// How far the separation along a normal may lie below the gap, times the scale: a normal's own rounding
/// counts in full where the cores all but touch.
const Digits tilt{"1e-7"};

/// From |x| to the next double.
Digits ulp(double x)
{
    const double least = std::abs(x);
    const double next = std::nextafter(least, infinity);
    if (std::isfinite(next)) return Digits(next) - least;
    return Digits(std::numeric_limits<double>::max()) -
           std::nextafter(std::numeric_limits<double>::max(), 0.0);
}

/// The whole case: what is true and what was answered.
struct Hearing {
    const Query& q;
    const Toi& toi;
    Encounter e;
    Truth truth;
    Standing now;   // at toi.t
    Digits allowed; // 16 eps S

    Hearing(const Query& query, const Toi& answer)
        : q(query),
          toi(answer),
          e(encounter(query)),
          truth(support::truth(query)),
          now(standing(e, answer.t)),
          allowed(16 * eps * truth.scale)
    {
    }
};

/// Sphere against sphere, plane or half-space: hit or miss is the exact answer.
bool always_exact(const Query& q)
{
    const std::size_t first = std::min(q.a.index(), q.b.index());
    const std::size_t second = std::max(q.a.index(), q.b.index());
    return first == 0 && (second == 0 || second >= 4);
}

/// How the gap changes at t = 0: its sign.
int start_trend(const Hearing& h)
{
    const Digits soon{"1e-60"};
    const Digits change = standing(h.e, soon).gap - standing(h.e, 0).gap;
    const Digits nothing = Digits("1e-100") * h.truth.scale;
    if (change > nothing) return 1;
    return change < -nothing ? -1 : 0;
}

/// Promises 1, 2 and 4: never late, never a miss, a hit only where there is one.
void judge_decision(const Hearing& h, Findings& out)
{
    const Truth& truth = h.truth;
    const Status status = h.toi.status;
    const Digits t = h.toi.t;
    if (status == Status::invalid || status == Status::undecided)
        out.push_back({"undecided", "a closed form is always decided"});
    if (status == Status::separated && truth.meets && !truth.in_doubt)
        out.push_back(
            {"missed a hit", fmt::format("contact at {:.17g}, the gap falls {:.3g} below the target",
                                         shown(truth.t), shown(-truth.least_gap))});
    if (status == Status::separated && h.toi.t != h.q.options.t_max)
        out.push_back({"t", "separated, but t is not t_max"});
    if (status != Status::separated && truth.meets && t > truth.t + truth.blur)
        out.push_back({"late", fmt::format("contact {:.3g} before t = {:.17g} ({:.3g} ulp)",
                                           shown(t - truth.t), h.toi.t, ulp_error(truth.t, h.toi.t))});
    const bool claims = h.toi.t_upper < infinity || always_exact(h.q);
    if (status == Status::hit && claims && !truth.meets && !truth.in_doubt)
        out.push_back(
            {"false hit", fmt::format("the least gap is {:.3g} above the target", shown(truth.least_gap))});
    if (status == Status::hit && !truth.meets && h.toi.t == 0 && start_trend(h) > 0)
        out.push_back({"sticks", "hit at 0 for a pair that is apart and recedes"});
}

/// Promise 3: touching at t, and contact by t_upper.
void judge_tight(const Hearing& h, Findings& out)
{
    if (h.toi.status != Status::hit) return;
    const Truth& truth = h.truth;
    const Digits most = h.allowed + truth.closing_speed * ulp(h.toi.t);
    if (h.now.gap > most)
        out.push_back({"early", fmt::format("gap - target = {:.3g} at t, allowed {:.3g}", shown(h.now.gap),
                                            shown(most))});
    if (!(h.toi.t <= h.toi.t_upper)) out.push_back({"t_upper", "t_upper before t"});
    if (truth.meets && h.toi.t_upper < infinity && h.toi.t_upper + truth.blur < truth.t)
        out.push_back({"t_upper", fmt::format("{:.17g}, but first contact comes {:.3g} later", h.toi.t_upper,
                                              shown(truth.t - h.toi.t_upper))});
    if (h.toi.t > h.q.options.t_max) out.push_back({"t", "beyond t_max"});
}

/// Promise 5.
void judge_start(const Hearing& h, Findings& out)
{
    const bool touching = h.toi.status == Status::touching;
    if (touching && h.toi.t != 0) out.push_back({"t", "touching, but t is not 0"});
    if (touching && !h.truth.started)
        out.push_back(
            {"touching", fmt::format("gap(0) is {:.3g} above the target", shown(standing(h.e, 0).gap))});
    if (!touching && h.truth.started)
        out.push_back({"touching", fmt::format("not said, but gap(0) is {:.3g} below the target",
                                               shown(-standing(h.e, 0).gap))});
}

/// Promise 5 for a pair in contact that the options say to ignore.
void judge_ignored(const Hearing& h, Findings& out)
{
    const bool if_separating = h.q.options.start_contact == StartContact::ignore_if_separating;
    const Status status = h.toi.status;
    if (status == Status::touching && !if_separating)
        out.push_back({"start contact", "touching, though contact at the start is to be ignored"});
    if (status == Status::hit) out.push_back({"start contact", "a second contact of convex bodies"});
    if (status == Status::separated && if_separating && start_trend(h) < 0)
        out.push_back({"start contact", "not touching, but the gap falls"});
}

/// The separation along the answer's normal at t, less the target gap: `worst` where ground has another
/// normal.
Digits separation(const Hearing& h, const Digits& worst)
{
    const Digits3 towards = transposed_times(h.e.frame, digits3(h.toi.normal));
    const Digits3 n = h.e.swapped ? -towards : towards; // from the moving point
    const Digits3 p = h.e.ray.at(h.toi.t);
    if (h.e.ground) {
        const Digits length = norm(h.e.ground->normal);
        const auto [low, high] = heights(*h.e.ground, p);
        const Digits3 up = (1 / length) * h.e.ground->normal;
        if (norm(n + up) <= tilt) return low / length - h.e.radius;
        return h.e.ground->two_sided && norm(n - up) <= tilt ? Digits(-high / length - h.e.radius) : worst;
    }
    std::optional<Digits> least;
    for (const Feature& f : h.e.features) {
        if (f.kind != Feature::Kind::corner) continue;
        const Digits along = dot(n, f.at - p);
        if (!least || along < *least) least = along;
    }
    return *least - h.e.radius;
}

/// Gap, normal and points at t.
void judge_contact(const Hearing& h, Findings& out)
{
    const Toi& toi = h.toi;
    if (toi.status != Status::hit && toi.status != Status::touching) return;
    if (h.q.options.detail == Detail::time_only) return;
    const Digits gap = h.now.gap + h.q.options.target_gap;
    if (!std::isfinite(toi.gap) || abs(toi.gap - gap) > 4 * h.allowed)
        out.push_back({"gap", fmt::format("says {:.17g}, is {:.17g}", toi.gap, shown(gap))});
    const Digits3 n = digits3(toi.normal);
    const bool zero = toi.normal == Vec3(0, 0, 0);
    const Digits loose = tilt * h.truth.scale;
    if (!zero && !(abs(dot(n, n) - 1) <= 16 * eps))
        out.push_back({"normal", fmt::format("of length {:.17g}", shown(norm(n)))});
    if (zero ? gap + h.e.radius - h.q.options.target_gap > loose
             : separation(h, -1 - h.truth.scale) < h.now.gap - loose)
        out.push_back({"normal", "not that of the contact"});
    const Digits3 between = digits3(toi.point_b) - digits3(toi.point_a);
    const Digits world = norm(digits3(toi.point_a)) + norm(digits3(toi.point_b));
    const bool finite = toi.point_a.allFinite() && toi.point_b.allFinite();
    if (!finite || (!zero && !(norm(between - Digits(toi.gap) * n) <= 4 * h.allowed + 8 * eps * world)))
        out.push_back({"points", "point_b - point_a is not gap * normal"});
}

} // namespace

Findings verify(const Query& q, const Toi& toi)
{
    if (!(toi.t >= 0 && toi.t <= 1)) return {{"t", fmt::format("{:.17g}", toi.t)}};
    const Hearing h(q, toi);
    const bool start_in_doubt = h.truth.in_doubt && abs(standing(h.e, 0).gap) <= doubt * h.truth.scale;
    Findings out;
    if (start_in_doubt) return out;
    if (h.truth.started && q.options.start_contact != StartContact::report) {
        judge_ignored(h, out);
    } else {
        judge_decision(h, out);
        judge_tight(h, out);
        judge_start(h, out);
    }
    judge_contact(h, out);
    return out;
}

double ulp_error(const Digits& exact, double t)
{
    return static_cast<double>(abs(t - exact) / ulp(static_cast<double>(exact)));
}

} // namespace brink::support
