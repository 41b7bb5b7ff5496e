// SPDX-License-Identifier: BSD-3-Clause
#include "quick_judge.h"

#include "quick_walk.h"

#include <algorithm>
#include <optional>

namespace brink::support {
namespace {

constexpr double eps = 0x1p-52;
constexpr int most_looks = 32768;

Quick3 quick(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Quick3 velocity(const QuickPlace& place, const Quick3& point)
{
    return place.body->velocity + cross(place.body->rotation, point);
}

/// How fast the nearest points come nearer: length per step.
double closing_speed(const QuickLook& at)
{
    return -dot(at.gap.normal, velocity(at.b, at.gap.point_b) - velocity(at.a, at.gap.point_a));
}

class Judge {
public:
    Judge(const Query& q, const Toi& toi)
        : q_(q),
          toi_(toi),
          pair_(q),
          blur_(pair_.blur()),
          rounding_(16 * eps * pair_.scale()),
          core_target_(q.options.target_gap + pair_.radii())
    {
    }

    Quick judge()
    {
        out_.doubt = doubt();
        if (out_.doubt == Doubt::nothing)
            out_.acquittal = strict_ ? Acquittal::strict : Acquittal::to_rounding;
        return out_;
    }

private:
    bool ignores() const { return q_.options.start_contact != StartContact::report; }

    QuickLook look(double t, const Quick3& hint, const QuickEffort& effort)
    {
        ++out_.looks;
        return {pair_, t, hint, effort};
    }

    /// To the last bit that doubles have, or past doubt above the target.
    QuickEffort fine() const { return {blur_ / 16, 0.01, core_target_ + blur_}; }
    QuickEffort rough() const { return {blur_ / 16, 0.5, core_target_ + blur_}; }

    Doubt doubt()
    {
        const double t_max = q_.options.t_max;
        const bool in_form = toi_.t >= 0 && toi_.t <= t_max && toi_.t <= toi_.t_upper &&
                             (toi_.status != Status::separated || toi_.t == t_max) &&
                             toi_.status != Status::invalid;
        if (!in_form) return Doubt::form;
        if (toi_.status == Status::touching) return touching();
        QuickLook start = look(0, {}, rough());
        sharpen(start);
        const double over = start.gap.lower - core_target_;
        if (ignores() && over <= rounding_ + blur_) return ignored(start);
        if (over <= blur_ - rounding_) return Doubt::start;
        if (toi_.t == 0) return at_end(start, start);
        QuickLook end = look(toi_.t, quick(toi_.normal), toi_.status == Status::hit ? fine() : rough());
        return at_end(start, end);
    }

    /// Where the gap is near the target, or an overlap may be rounding, the answer's normal may be the best;
    /// whichever it is, planes prove.
    void sharpen(QuickLook& at) const
    {
        if (at.gap.lower > core_target_ + blur_) return;
        at.try_normal(quick(toi_.normal));
        const bool flat = at.gap.upper > core_target_ || (pair_.radii() == 0 && q_.options.target_gap == 0);
        if (flat && at.gap.lower <= core_target_ + blur_ - rounding_)
            at.try_normal(pair_.better_normal(at.t));
    }

    /// Contact at the start that is ignored: looks for where the gap first exceeds the target, between which
    /// an excursion may be passed over (in the answer's favour), and judges what comes after.
    Doubt ignored(const QuickLook& start)
    {
        constexpr double soonest = 0x1p-14, latest = 0x1p-6;
        strict_ = false;
        double highest = start.gap.overlap ? 0 : start.gap.upper;
        double t = 0;
        Quick3 normal = start.gap.normal;
        while (t < toi_.t) {
            t = std::min(toi_.t, t + std::clamp(t / 4, soonest, latest));
            const QuickLook here = look(t, normal, fine());
            normal = here.gap.normal;
            const bool falls = !here.gap.overlap && here.gap.upper < highest - rounding_ / 2;
            if (falls && q_.options.start_contact == StartContact::ignore_if_separating) return Doubt::start;
            highest = std::max(highest, here.gap.upper);
            if (here.gap.lower <= core_target_ + rounding_ + blur_) continue;
            const auto effort = toi_.status == Status::hit ? fine() : rough();
            return t < toi_.t ? at_end(here, look(toi_.t, quick(toi_.normal), effort)) : at_end(here, here);
        }
        return toi_.status == Status::hit ? Doubt::start : Doubt::nothing;
    }

    /// Apart from the start to the end, and at the end as near as a hit must be.
    Doubt at_end(const QuickLook& start, QuickLook end)
    {
        sharpen(end);
        const double lower = end.gap.lower - core_target_;
        if (lower <= blur_ - rounding_) return Doubt::apart;
        if (lower <= blur_) strict_ = false;
        if (!apart(start, end)) return Doubt::apart;
        if (toi_.status != Status::hit) return Doubt::nothing;
        if (!tight(end)) return Doubt::tight;
        if (!met_by_upper(end)) return Doubt::upper;
        return contact(end) ? Doubt::nothing : Doubt::contact;
    }

    /// Whether the shapes are apart in between; at the ends themselves they may touch but for rounding, where
    /// they come nearer towards the end and part from the start. Rounding is no excuse for what lies between:
    /// a thin core would pass through another.
    bool apart(const QuickLook& start, const QuickLook& end)
    {
        if (!(start.t < end.t)) return true;
        const std::optional<QuickLook> from = cleared(start, 1), to = cleared(end, -1);
        if (!from || !to || !(from->t < to->t)) return false;
        const QuickProof proof = quick_apart(pair_, *from, *to, core_target_ + blur_, most_looks);
        out_.looks += proof.looks;
        return proof.apart;
    }

    /// The look, or one so near in time that no more than rounding lies between, where the gap is proven.
    std::optional<QuickLook> cleared(const QuickLook& at, double way)
    {
        constexpr double most = 0x1p-30; // of a step
        if (at.gap.lower > core_target_ + blur_) return at;
        strict_ = false;
        const double speed = -way * closing_speed(at);
        if (!(speed > 0)) return std::nullopt;
        for (double blurs = 4; blurs < 512 && blurs * blur_ <= most * speed; blurs *= 4) {
            const QuickLook near = look(at.t + way * blurs * blur_ / speed, at.gap.normal, fine());
            if (near.gap.lower > core_target_ + blur_) return near;
        }
        return std::nullopt;
    }

    /// Promise 3 at t; a hit at 0 must not stick to what recedes.
    bool tight(const QuickLook& end)
    {
        const Pair pair{std::min(q_.a.index(), q_.b.index()), std::max(q_.a.index(), q_.b.index())};
        const bool turns = pair_.a().rate > 0 || pair_.b().rate > 0;
        const bool closed = pair.closed_form() && !turns;
        const double band = closed ? rounding_ : std::max(rounding_, q_.options.tolerance);
        const double speed = closing_speed(end);
        const double most = band + std::max(speed, 0.0) * eps / 2 * toi_.t;
        const double over = end.gap.upper - core_target_;
        if (over > most) return false;
        if (over + blur_ > most) strict_ = false;
        return toi_.t > 0 || speed > 0;
    }

    /// Contact has begun by t_upper, if it is finite.
    bool met_by_upper(const QuickLook& end)
    {
        if (!(toi_.t_upper < infinity)) return true;
        if (toi_.t_upper > 1) return false;
        const QuickLook later = toi_.t_upper == toi_.t ? end : look(toi_.t_upper, end.gap.normal, fine());
        const double over = later.gap.upper - core_target_;
        if (over > rounding_ - blur_) return false;
        if (over + blur_ > 0 && !later.gap.overlap) strict_ = false;
        return true;
    }

    /// Contact at the start, seen but for how deep it is.
    Doubt touching()
    {
        if (toi_.t != 0 || q_.options.start_contact == StartContact::ignore) return Doubt::start;
        const QuickLook start = look(0, quick(toi_.normal), {blur_ / 16, 0, 0});
        if (start.gap.overlap) return Doubt::contact;
        const double over = start.gap.upper - core_target_;
        if (over > rounding_ - blur_) return Doubt::start;
        if (over + blur_ > 0) strict_ = false;
        return contact(start) ? Doubt::nothing : Doubt::contact;
    }

    /// Gap, normal and points, as the referee judges them.
    bool contact(const QuickLook& at)
    {
        if (q_.options.detail != Detail::contact) return true;
        const bool round = curved(q_.a) || curved(q_.b);
        const double exact = 4 * rounding_;
        const auto up_to = [&](double part) {
            return exact - blur_ + (round ? std::max(q_.options.tolerance / 32, part * pair_.scale()) : 0);
        };
        const double close = up_to(0x1p-30), near = up_to(0x1p-20);
        QuickGap truth = at.gap;
        const bool loose_look = truth.upper - truth.lower > blur_;
        if (loose_look) truth = look(at.t, truth.normal, {blur_ / 16, 0, 0}).gap;
        const double lower = truth.lower - pair_.radii(), upper = truth.upper - pair_.radii();
        if (!(toi_.gap <= upper + close && toi_.gap >= lower - close)) return false;
        if (upper - lower > close) return false;
        const bool directed = dot(quick(toi_.normal), quick(toi_.normal)) > 0.25;
        if (!directed && truth.lower > close) return false;
        const double loose = std::max(q_.options.tolerance, 1e-6 * pair_.scale()) - blur_;
        if (directed && !(quick_separation(at.a, at.b, quick(toi_.normal)) >= truth.lower - loose))
            return false;
        const double world = 32 * eps * (toi_.point_a.norm() + toi_.point_b.norm());
        const auto off = [&](const QuickPlace& place, const Vec3& point) {
            const Quick3 p =
                quick(point - pair_.origin()) - at.t * quick(q_.motion_b.translation) - place.pivot;
            return quick_distance(place, p, blur_ / 16) - place.body->radius;
        };
        const double most = std::max(off(at.a, toi_.point_a), off(at.b, toi_.point_b));
        if (!(most <= near + world)) return false;
        const Vec3 apart = toi_.point_b - toi_.point_a - toi_.gap * toi_.normal;
        return !directed || norm(quick(apart)) <= exact - blur_ + world;
    }

    const Query& q_;
    const Toi& toi_;
    QuickPair pair_;
    double blur_, rounding_, core_target_;
    bool strict_ = true;
    Quick out_;
};

} // namespace

Quick quick_judge(const Query& q, const Toi& toi) { return Judge(q, toi).judge(); }

} // namespace brink::support
