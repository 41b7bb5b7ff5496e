// SPDX-License-Identifier: BSD-3-Clause
#include "referee_turning.h"

#include "referee_question.h"

#include <algorithm>
#include <cmath>

namespace brink::support {
namespace {

/// A closing speed below this much of the fastest motion is grazing (design, promise 3).
constexpr double grazing_speed = 1e-3;

/// How soon before contact the closing speed is taken, in steps.
const Hundred moment{"1e-25"};

bool finite(const Vec3& v) { return std::isfinite(v.x()) && std::isfinite(v.y()) && std::isfinite(v.z()); }
bool size(double s) { return s >= 0 && std::isfinite(s); }

/// | |.|^2 - 1 | <= 1e-6, for what has that square: in digits, for it may overflow.
bool unit(const Hundred& square) { return abs(square - 1) <= Hundred("1e-6"); }

bool valid(const Sphere& s) { return size(s.radius); }
bool valid(const Capsule& s) { return finite(s.a) && finite(s.b) && size(s.radius); }
bool valid(const Box& s) { return finite(s.half_extents) && s.half_extents.minCoeff() >= 0; }
bool valid(const Triangle& s) { return finite(s.a) && finite(s.b) && finite(s.c); }
bool valid(const Cylinder& s) { return size(s.half_length) && size(s.radius); }
bool valid(const Cone& s) { return size(s.half_length) && size(s.radius); }
bool valid(const Ellipsoid& s) { return finite(s.radii) && s.radii.minCoeff() >= 0; }
bool valid(const Hull&) { return true; } // or from_points would have thrown
template <class Border> bool valid(const Border& s)
{
    const Vector<Hundred> n = vector_of<Hundred>(s.normal);
    return finite(s.normal) && std::isfinite(s.offset) && unit(dot(n, n));
}

bool valid(const Shape& shape)
{
    return !shape.valueless_by_exception() && std::visit([](const auto& s) { return valid(s); }, shape);
}

bool valid(const Motion& m)
{
    const Quat& q = m.start.orientation;
    const Vector<Hundred> v = vector_of<Hundred>(Vec3(q.x(), q.y(), q.z()));
    const Vector<Hundred> w = vector_of<Hundred>(m.rotation);
    return finite(m.start.position) && finite(m.translation) && finite(m.pivot) && finite(m.rotation) &&
           q.coeffs().allFinite() && unit(dot(v, v) + Hundred(q.w()) * q.w()) && dot(w, w) <= Hundred(0x1p40);
}

bool valid(const Options& o)
{
    return o.t_max >= 0 && o.t_max <= 1 && size(o.target_gap) && size(o.tolerance) && o.max_iterations >= 1 &&
           o.start_contact <= StartContact::ignore && o.detail <= Detail::time_only;
}

/// Fills in what is known of the contact.
Meeting with_speed(const Question& question, Meeting m)
{
    const Hundred back = std::max(Hundred(m.apart - moment), Hundred(0));
    if (!m.meets || m.apart <= back) return m;
    const MovingPair<Hundred>& pair = question.fine();
    m.closing_speed = (pair.at(back).upper - pair.at(m.apart).lower) / (m.apart - back);
    m.grazing = m.closing_speed < grazing_speed * pair.fastest();
    return m;
}

} // namespace

bool judgeable(const Query& q)
{
    const auto border = [](const Shape& s) {
        return std::holds_alternative<Plane>(s) || std::holds_alternative<HalfSpace>(s);
    };
    return valid(q.options) && valid(q.a) && valid(q.b) && valid(q.motion_a) && valid(q.motion_b) &&
           !(border(q.a) && border(q.b));
}

Meeting meeting(const Query& q)
{
    const Question question(q);
    const Hundred t_max = q.options.t_max;
    Meeting out;
    const Start start = question.start();
    out.started = start.contact;
    out.start_gap = start.gap;
    Hundred from = 0;
    if (start.in_doubt) out.in_doubt = true;
    if (start.contact) {
        out.least_gap = start.gap;
        out.meets = q.options.start_contact == StartContact::report;
        if (out.meets) {
            out.by = 0;
            return out;
        }
        const Leaving leaving = question.leaving();
        out.drop = leaving.drop;
        out.left = leaving.left;
        out.apart = t_max;
        if (!leaving.left) return out;
        out.left_by = from = leaving.by;
    }
    const Stretch s = question.clear(from, t_max);
    out.apart = s.clear;
    out.meets = s.contact.has_value();
    if (s.contact) out.by = *s.contact;
    out.in_doubt = out.in_doubt || s.in_doubt;
    out.spent = s.spent;
    out.least_gap = out.started ? std::min(out.start_gap, s.least) : s.least;
    out.evaluations = s.evaluations;
    out.fine_evaluations = s.fine_evaluations;
    return with_speed(question, out);
}

bool grazes(const Query& q, const Meeting& m, double t)
{
    constexpr long double within = 1e-6L;
    if (m.meets && m.grazing) return true;
    const MovingPair<long double> pair(q);
    const Bracket<long double> here = pair.at(t);
    const long double speed = closing_speed(pair, static_cast<long double>(t), here);
    const bool near = here.upper - pair.target() <= 1e-3L * pair.scale();
    if (near && std::abs(speed) < grazing_speed * pair.fastest()) return true;
    return !m.meets && m.least_gap <= Hundred(within * pair.scale());
}

} // namespace brink::support
