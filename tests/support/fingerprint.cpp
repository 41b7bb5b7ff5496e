// SPDX-License-Identifier: BSD-3-Clause
#include "fingerprint.h"

#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace brink::support {
namespace {

/// A hash of 64-bit words in the order given: each is mixed in as splitmix64 mixes (S. Vigna 2015).
class Hash {
public:
    explicit Hash(std::uint64_t value) : value_(value) {}
    std::uint64_t value() const { return value_; }

    Hash& operator<<(std::uint64_t word)
    {
        std::uint64_t z = (value_ ^ word) + 0x9e3779b97f4a7c15U;
        z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
        z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
        value_ = z ^ (z >> 31U);
        return *this;
    }
    Hash& operator<<(double x)
    {
        const double one_nan = std::numeric_limits<double>::quiet_NaN();
        return *this << std::bit_cast<std::uint64_t>(std::isnan(x) ? one_nan : x);
    }
    Hash& operator<<(const Vec3& v) { return *this << v.x() << v.y() << v.z(); }
    Hash& operator<<(const Quat& q) { return *this << q.w() << q.x() << q.y() << q.z(); }
    Hash& operator<<(const Sphere& s) { return *this << s.radius; }
    Hash& operator<<(const Capsule& s) { return *this << s.a << s.b << s.radius; }
    Hash& operator<<(const Box& s) { return *this << s.half_extents; }
    Hash& operator<<(const Triangle& s) { return *this << s.a << s.b << s.c; }
    Hash& operator<<(const Plane& s) { return *this << s.normal << s.offset; }
    Hash& operator<<(const HalfSpace& s) { return *this << s.normal << s.offset; }
    Hash& operator<<(const Cylinder& s) { return *this << s.half_length << s.radius; }
    Hash& operator<<(const Cone& s) { return *this << s.half_length << s.radius; }
    Hash& operator<<(const Ellipsoid& s) { return *this << s.radii; }
    Hash& operator<<(const Hull& s)
    {
        for (const Vec3& p : s.vertices())
            *this << p;
        return *this << std::uint64_t{s.vertices().size()};
    }
    Hash& operator<<(const Shape& shape)
    {
        *this << std::uint64_t{shape.index()};
        return std::visit([this](const auto& s) -> Hash& { return *this << s; }, shape);
    }
    Hash& operator<<(const Motion& m)
    {
        return *this << m.start.position << m.start.orientation << m.translation << m.rotation << m.pivot;
    }
    Hash& operator<<(const Options& o)
    {
        return *this << o.t_max << o.target_gap << o.tolerance << static_cast<std::uint64_t>(o.start_contact)
                     << static_cast<std::uint64_t>(o.detail) << static_cast<std::uint64_t>(o.max_iterations);
    }
    Hash& operator<<(const Query& q) { return *this << q.a << q.motion_a << q.b << q.motion_b << q.options; }
    Hash& operator<<(const Toi& toi)
    {
        return *this << static_cast<std::uint64_t>(toi.status) << toi.t << toi.t_upper << toi.normal
                     << toi.point_a << toi.point_b << toi.gap << static_cast<std::uint64_t>(toi.iterations);
    }

private:
    std::uint64_t value_;
};

bool turns(const Motion& m) { return m.rotation.x() != 0 || m.rotation.y() != 0 || m.rotation.z() != 0; }

} // namespace

Query mixed_query(std::uint64_t index)
{
    static const std::vector<Pair> pairs = all_pairs();
    const std::uint64_t number = index / pairs.size();
    Query q = query(pairs[index % pairs.size()], Family::any, 20261122, number);
    if (number % 2 == 1) {
        std::swap(q.a, q.b);
        std::swap(q.motion_a, q.motion_b);
    }
    if (number % 8 >= 6) q.options.detail = Detail::time_only;
    return q;
}

Fingerprint fingerprint(std::uint64_t from, std::uint64_t to, Fingerprint so_far)
{
    Hash queries(so_far.queries);
    Hash answers(so_far.answers);
    for (std::uint64_t i = from; i < to; ++i) {
        const Query q = mixed_query(i);
        const Toi toi = answer(q);
        queries << q;
        answers << toi;
        ++so_far.said.at(static_cast<std::size_t>(toi.status));
        so_far.turning += turns(q.motion_a) || turns(q.motion_b) ? 1U : 0U;
        so_far.time_only += q.options.detail == Detail::time_only ? 1U : 0U;
    }
    so_far.queries = queries.value();
    so_far.answers = answers.value();
    return so_far;
}

} // namespace brink::support
