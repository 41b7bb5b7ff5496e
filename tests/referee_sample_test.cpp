// SPDX-License-Identifier: BSD-3-Clause
#include "support/print.h"
#include "support/referee.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace brink;
using namespace brink::support;

namespace {

double shown(const Digits& x) { return static_cast<double>(x); }

std::vector<Pair> closed_forms()
{
    std::vector<Pair> out;
    for (const Pair& pair : all_pairs())
        if (pair.closed_form()) out.push_back(pair);
    return out;
}

/// Nasty translations of one pair, every other with its sides swapped.
std::vector<Query> translations(const Pair& pair, std::uint64_t count)
{
    std::vector<Query> out;
    for (std::uint64_t i = 0; i < count; ++i) {
        Query q = query(pair, Family::translation, 20261203, i);
        q.options.start_contact = StartContact::report;
        if (i % 2 == 1) q = Query{q.b, q.motion_b, q.a, q.motion_a, q.options};
        out.push_back(q);
    }
    return out;
}

struct Scaling {
    double by;

    Vec3 operator()(const Vec3& v) const { return {by * v.x(), by * v.y(), by * v.z()}; }
    Shape operator()(const Sphere& s) const { return Sphere{by * s.radius}; }
    Shape operator()(const Capsule& s) const { return Capsule{(*this)(s.a), (*this)(s.b), by * s.radius}; }
    Shape operator()(const Box& s) const { return Box{(*this)(s.half_extents)}; }
    Shape operator()(const Triangle& s) const { return Triangle{(*this)(s.a), (*this)(s.b), (*this)(s.c)}; }
    Shape operator()(const Plane& s) const { return Plane{s.normal, by * s.offset}; }
    Shape operator()(const HalfSpace& s) const { return HalfSpace{s.normal, by * s.offset}; }
    template <class Unjudged> Shape operator()(const Unjudged& s) const { return s; }
    Shape operator()(const Shape& s) const { return std::visit(*this, s); }
    Motion operator()(const Motion& m) const
    {
        return {{(*this)(m.start.position), m.start.orientation},
                (*this)(m.translation),
                m.rotation,
                (*this)(m.pivot)};
    }
    Query operator()(const Query& q) const
    {
        Query out{(*this)(q.a), (*this)(q.motion_a), (*this)(q.b), (*this)(q.motion_b), q.options};
        out.options.target_gap *= by;
        out.options.tolerance *= by;
        return out;
    }
};

} // namespace

TEST_CASE("referee: agrees with the long double reference")
{
    for (const Pair& pair : closed_forms()) {
        CAPTURE(pair.name());
        int hits = 0;
        int compared = 0;
        for (const Query& q : translations(pair, 400)) {
            CAPTURE(as_cpp(q));
            REQUIRE(refereed(q));
            const Truth truth = support::truth(q);
            const GapOverTime motion(q);
            const double scale = shown(truth.scale);
            CHECK(std::abs(scale - static_cast<double>(motion.scale())) <= 1e-15 * scale);
            for (const double t : {0.0, 0.375, q.options.t_max}) {
                const Real gap = motion.at(t).gap - static_cast<Real>(q.options.target_gap);
                CHECK(std::abs(shown(gap_minus_target(q, t) - gap)) <= 1e-17 * scale);
            }
            const Reference ref = reference(q, motion);
            if (std::abs(shown(truth.least_gap)) <= 1e-17 * scale) continue;
            CHECK(truth.meets == ref.contact);
            CHECK(truth.started == ref.started);
            if (!truth.meets || truth.started) continue;
            ++hits;
            const double speed = shown(truth.closing_speed);
            if (speed < 1e-3 * static_cast<double>(motion.fastest())) continue;
            ++compared;
            CHECK(std::abs(shown(truth.t - ref.t)) <= 1e-17 * (1 + scale / speed));
        }
        CHECK(hits > 120);
        CHECK(compared > 80);
    }
}

TEST_CASE("referee: its own answers hold, to 1e-90 of the scale")
{
    for (const Pair& pair : closed_forms()) {
        CAPTURE(pair.name());
        int hits = 0;
        int misses = 0;
        int doubts = 0;
        for (const Query& q : translations(pair, 400)) {
            CAPTURE(as_cpp(q));
            const Truth truth = support::truth(q);
            const Digits slack = Digits("1e-95") * truth.scale;
            doubts += truth.in_doubt ? 1 : 0;
            const Digits end = truth.started ? Digits(0) : truth.meets ? truth.t : Digits(q.options.t_max);
            for (int k = 0; k < 4; ++k)
                CHECK((end == 0 || gap_minus_target(q, end * k / 4) > 0));
            const Digits first = gap_minus_target(q, end);
            CHECK((truth.started ? first <= slack : truth.meets ? abs(first) <= slack : first > -slack));
            CHECK((first >= truth.least_gap -
                                slack)); // in brackets: a Digits that doctest takes apart does not compile
            CHECK(truth.meets == (truth.started || (truth.t >= 0 && truth.t <= q.options.t_max)));
            if (truth.meets) CHECK((truth.least_gap <= slack));
            if (!truth.meets) CHECK((truth.least_gap >= -slack));
            if (truth.t > 0) {
                const Digits moment("1e-80");
                const Digits rate =
                    (gap_minus_target(q, truth.t - moment) - gap_minus_target(q, truth.t)) / moment;
                CHECK(shown(abs(rate - truth.closing_speed) / truth.scale) < 1e-40);
            }
            hits += truth.meets && !truth.started ? 1 : 0;
            misses += truth.meets ? 0 : 1;
        }
        CHECK(hits > 120);
        CHECK(misses > 60);
        CHECK(doubts < 5);
    }
}

TEST_CASE("referee: the same from the smallest lengths to the largest")
{
    for (const Pair& pair : closed_forms()) {
        CAPTURE(pair.name());
        int hits = 0;
        for (const Query& q : translations(pair, 60)) {
            CAPTURE(as_cpp(q));
            const Truth truth = support::truth(q);
            hits += truth.meets ? 1 : 0;
            for (const int exponent : {498, -498, 990}) {
                const double factor = std::ldexp(1, exponent);
                const Truth scaled = support::truth(Scaling{factor}(q));
                CHECK(scaled.meets == truth.meets);
                CHECK(scaled.started == truth.started);
                CHECK(shown(scaled.t) == shown(truth.t));
                CHECK(shown(scaled.least_gap / factor) == shown(truth.least_gap));
                CHECK(shown(scaled.closing_speed / factor) == shown(truth.closing_speed));
            }
        }
        CHECK(hits > 15);
    }
}
