// SPDX-License-Identifier: BSD-3-Clause
#include "print.h"
#include "random.h"
#include "verdict.h"

#include <algorithm>
#include <bit>
#include <fmt/format.h>
#include <utility>

namespace brink::support {
namespace {

constexpr double eps = 0x1p-52;

bool unbounded(const Shape& shape)
{
    return std::holds_alternative<Plane>(shape) || std::holds_alternative<HalfSpace>(shape);
}

bool same_bits(double x, double y)
{
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
}

Findings judge_range(Trial& trial)
{
    const Toi& toi = trial.toi();
    const double t_max = trial.query().options.t_max;
    const bool both = unbounded(trial.query().a) && unbounded(trial.query().b);
    if (toi.status > Status::undecided) return {{"status", "none of the five"}};
    if (both != (toi.status == Status::invalid)) return {{"status", in_words(toi)}};
    if (!(toi.t >= 0 && toi.t <= t_max)) return {{"t", fmt::format("{:.17g} is outside [0, t_max]", toi.t)}};
    if (toi.status == Status::separated && toi.t != t_max) return {{"t", "separated, but t is not t_max"}};
    if ((both || toi.status == Status::touching) && toi.t != 0) return {{"t", "not 0"}};
    if (toi.iterations < 0 || toi.iterations > trial.query().options.max_iterations)
        return {{"iterations", fmt::format("{}", toi.iterations)}};
    return {};
}

Findings judge_witness(Trial& trial)
{
    const Toi& toi = trial.toi();
    if (toi.status == Status::invalid || toi.status == Status::separated) return {};
    const double length = toi.normal.norm();
    if (!(length == 0 || std::abs(length - 1) <= 8 * eps))
        return {{"normal", fmt::format("length - 1 = {:.3g}", length - 1)}};
    const double off = (toi.point_b - toi.point_a - toi.gap * toi.normal).norm();
    const double size = toi.point_a.norm() + toi.point_b.norm() + std::abs(toi.gap);
    if (length > 0 && off <= 32 * eps * size) return {};
    if (length == 0 && off <= 32 * eps * size && std::abs(toi.gap) >= 0) return {};
    if (off <= static_cast<double>(4 * trial.rounding())) return {};
    return {{"points", fmt::format("point_b - point_a is off gap * normal by {:.3g}", off)}};
}

Findings judge_detail(Trial& trial)
{
    Query q = trial.query();
    q.options.detail = Detail::time_only;
    const Toi& toi = trial.toi();
    const Toi bare = answer(q);
    if (bare.status == toi.status && same_bits(bare.t, toi.t) && same_bits(bare.t_upper, toi.t_upper))
        return {};
    return {{"time_only", in_words(bare), q}};
}

/// A t_max by which contact is proven changes nothing; a t_max below t is separated.
Findings judge_t_max(Trial& trial)
{
    const Toi& toi = trial.toi();
    Query q = trial.query();
    Findings out;
    // Whether a pair in contact is separating may depend on how far one looks.
    const bool looks_ahead =
        toi.status == Status::touching && q.options.start_contact == StartContact::ignore_if_separating;
    if ((toi.status == Status::hit || toi.status == Status::touching) && !looks_ahead) {
        q.options.t_max = toi.t_upper < infinity ? toi.t_upper : toi.t;
        const Toi there = answer(q);
        if (there.status != toi.status || !same_bits(there.t, toi.t) || there.normal != toi.normal)
            out.push_back({"t_max = t_upper", in_words(there), q});
    }
    if ((toi.status == Status::hit || toi.status == Status::separated) && toi.t > 0) {
        q.options.t_max = toi.t * (1 - 1e-6);
        const Toi before = answer(q);
        if (before.status != Status::separated || before.t != q.options.t_max)
            out.push_back({"t_max < t", in_words(before), q});
    }
    return out;
}

/// Whether two hits are right together, without the reference: at the earlier one the shapes are within
/// `band` of contact, and from there to the later one certified steps find them apart, but for `rounding`.
bool both_right(Trial& trial, double earlier, double later, Real band, Real rounding)
{
    constexpr int most_steps = 64;
    const Real target = trial.query().options.target_gap, level = target - rounding;
    Real t = earlier;
    for (int i = 0; i < most_steps; ++i) {
        const Gap here = trial.motion().at(t);
        if (!here.points_known || !(here.gap > level) || here.gap - target > band) return false;
        if (t >= later) return true;
        t += trial.motion().safe_step(t, here, level, later - t);
    }
    return false;
}

/// Whether another answer, to the same question asked as `asked`, agrees, given rounding that moves gaps by
/// `moved`.
bool agrees(Trial& trial, const Query& asked, const Toi& other, Real moved)
{
    const Toi& toi = trial.toi();
    if (other.status == toi.status && std::abs(other.t - toi.t) <= 8 * eps * toi.t) return true;
    const Real band = trial.band() + moved;
    if (toi.status == Status::undecided || other.status == Status::undecided) return true;
    const bool acquitted = trial.quick().acquittal != Acquittal::none;
    if (acquitted && quick_judge(asked, other).acquittal != Acquittal::none) return true;
    const bool hits = toi.status == Status::hit && other.status == Status::hit;
    const Real doubt = trial.rounding() + moved;
    if (hits && both_right(trial, std::min(toi.t, other.t), std::max(toi.t, other.t), band, doubt))
        return true;
    const Reference& ref = trial.referee();
    const Real target = trial.query().options.target_gap;
    if (ref.gave_up) return true;
    // Within the band of contact at the start, either may call it contact, to be reported or ignored.
    const bool ignores_start = trial.query().options.start_contact != StartContact::report;
    const bool at_start = std::abs(ref.start_gap - target) <= 2 * band;
    if (at_start && (other.status != toi.status || ignores_start)) return true;
    if (other.status == toi.status) {
        constexpr Real slow = 0.1L; // of the fastest motion: the closing speed itself changes within the band
        // Within the band of contact some time before it: a hit that the tolerance allows.
        const bool touched_in_passing =
            std::abs(toi.t - ref.t) > trial.spread() && trial.motion().at(toi.t).gap - target <= 2 * band;
        const bool each_by_its_gap = !ref.contact || ref.closing_speed < slow * trial.motion().fastest();
        if (each_by_its_gap || touched_in_passing) return true;
        return std::abs(other.t - toi.t) <= trial.spread() + 4 * moved / ref.closing_speed;
    }
    // A proof that a pair in contact is separating may fail by rounding alone; so may contact at the nearest.
    const bool marginal = trial.query().options.start_contact == StartContact::ignore_if_separating &&
                          ref.started && ref.drop <= 4 * band;
    return marginal || std::abs(ref.least_gap - target) <= 2 * band;
}

Findings judge_swap(Trial& trial)
{
    Query q = trial.query();
    std::swap(q.a, q.b);
    std::swap(q.motion_a, q.motion_b);
    const Toi swapped = answer(q);
    const Toi& toi = trial.toi();
    if (!agrees(trial, q, swapped, 4 * trial.rounding())) return {{"swap", in_words(swapped), q}};
    if (swapped.status != toi.status || !same_bits(swapped.t, toi.t)) return {};
    // At the same t the sides change places; where several normals are right another may come.
    const double gap_off = std::abs(swapped.gap - toi.gap);
    if (toi.status == Status::separated || toi.status == Status::invalid) return {};
    const double told = curved(q.a) || curved(q.b) ? q.options.tolerance / 16 : 0; // twice what toi.h says
    if (gap_off <= static_cast<double>(4 * trial.rounding()) + told) return {};
    return {{"swap", fmt::format("gap {:.17g}, swapped {:.17g}", toi.gap, swapped.gap), q}};
}

Vec3 turned(const Quat& q, const Vec3& v) { return rounded(rotation_matrix(q) * real3(v)); }

Motion moved(const Motion& m, const Quat& turn, const Vec3& shift)
{
    Motion out = m;
    const Quat& q = m.start.orientation;
    out.start.position = turned(turn, m.start.position) + shift;
    const Vec3 u(turn.x(), turn.y(), turn.z());
    const Vec3 v(q.x(), q.y(), q.z());
    const Vec3 w = turn.w() * v + q.w() * u + u.cross(v);
    out.start.orientation = Quat(turn.w() * q.w() - u.dot(v), w.x(), w.y(), w.z());
    out.translation = turned(turn, m.translation);
    out.rotation = turned(turn, m.rotation);
    return out;
}

/// The whole world turned and shifted: the same t but for the rounding of the move itself.
Findings judge_rigid(Trial& trial)
{
    const Query& q = trial.query();
    Random random(std::bit_cast<std::uint64_t>(q.motion_a.start.position.x()));
    const Quat turn = random.rotation();
    const Vec3 shift = random.in_cube(2);
    const Query other{q.a, moved(q.motion_a, turn, shift), q.b, moved(q.motion_b, turn, shift), q.options};
    const Toi toi = answer(other);
    const Real size = norm(real3(q.motion_a.start.position)) + norm(real3(q.motion_b.start.position));
    if (agrees(trial, other, toi, 4 * trial.rounding() + 64 * static_cast<Real>(eps) * (size + 4))) return {};
    return {{"rigid motion", in_words(toi), other}};
}

} // namespace

Findings judge_form(Trial& trial)
{
    const Findings range = judge_range(trial);
    return range.empty() ? judge_witness(trial) : range;
}

Findings judge_otherwise(Trial& trial)
{
    Findings out;
    for (const auto& part : {judge_detail(trial), judge_t_max(trial), judge_swap(trial), judge_rigid(trial)})
        out.insert(out.end(), part.begin(), part.end());
    return out;
}

Findings judge_alone(Trial& trial)
{
    Findings out = judge_range(trial);
    if (trial.toi().status == Status::invalid || !out.empty()) return out;
    for (const auto& part : {judge_witness(trial), judge_otherwise(trial)})
        out.insert(out.end(), part.begin(), part.end());
    return out;
}

} // namespace brink::support
