// SPDX-License-Identifier: BSD-3-Clause
#include "exact_contact.h"

#include "exact_model.h"
#include "tolerance.h"

#include <algorithm>
#include <optional>

namespace brink {

namespace {

using exact::Degrees;
using exact::EntryTimes;
using exact::Spans;

/// A model's question with its numbers' sizes looked at.
template <class Model> struct Asked {
    const Model& model;
    const Spans& spans;
    Degrees degrees;

    /// Whether there is contact by t; empty where the numbers do not fit.
    std::optional<bool> meets(double t) const
    {
        Span at = spans.time;
        at.add(t);
        if (!degrees.fit(spans, at)) return {};
        return model.meets(t);
    }
    bool certainly(bool contact, double t) const { return meets(t) == contact; }
};

/// The bracket about the first of the sorted times by which there is contact. Steps outwards from where it
/// should be until both ends are proven.
template <class Model> Verdict bracket(const Asked<Model>& asked, EntryTimes times, double t_max)
{
    std::sort(times.t, times.t + times.count);
    const auto upwards = [&](double t) { return std::min(t + t * tolerance::exact_root, t_max); };
    const auto reached = [&](double t) { return asked.certainly(true, upwards(t)); };
    const double* first =
        std::partition_point(times.t, times.t + times.count, [&](double t) { return !reached(t); });
    const double found = first == times.t + times.count ? t_max : *first;
    double low = 0, high = found + found * tolerance::exact_root;
    for (double down = tolerance::exact_root; low == 0 && down < 1; down *= 16) {
        const double t = found - found * down;
        if (asked.certainly(false, t)) low = t;
    }
    // A few places more. Not by way of t_max, on which t must not depend.
    for (int i = 0; i < tolerance::halvings; ++i) {
        const double middle = low + (high - low) / 2;
        const std::optional<bool> met = asked.meets(middle);
        if (!met) break;
        (*met ? high : low) = middle;
    }
    return {Status::hit, low, std::min(high, t_max)};
}

template <class A, class B> Verdict verdict(const Query& q)
{
    const double t_max = q.options.t_max;
    const A& a = *std::get_if<A>(&q.a);
    const B& b = *std::get_if<B>(&q.b);
    const Spans spans = exact::spans_of(a, b, q);
    const Degrees degrees = exact::degrees<A, B>;
    if (!degrees.fit(spans, spans.time)) return {};
    const auto world = exact::model(a, b, q, spans.length.shift());
    const Asked<std::decay_t<decltype(world)>> asked{world, spans, degrees};
    if (world.meets(0)) return {Status::touching, 0, 0};
    const std::optional<bool> met = asked.meets(t_max);
    if (!met) return {};
    if (!*met) return {Status::separated, t_max, infinity};
    return bracket(asked, world.entry_times(), t_max);
}

template <class A, class B> bool are(const Query& q)
{
    return std::holds_alternative<A>(q.a) && std::holds_alternative<B>(q.b);
}

} // namespace

Verdict exact_contact(const Query& q)
{
    if (are<Sphere, Sphere>(q)) return verdict<Sphere, Sphere>(q);
    if (are<Sphere, Capsule>(q)) return verdict<Sphere, Capsule>(q);
    if (are<Sphere, Box>(q)) return verdict<Sphere, Box>(q);
    if (are<Sphere, Triangle>(q)) return verdict<Sphere, Triangle>(q);
    if (are<Sphere, Plane>(q)) return verdict<Sphere, Plane>(q);
    if (are<Sphere, HalfSpace>(q)) return verdict<Sphere, HalfSpace>(q);
    if (are<Capsule, Capsule>(q)) return verdict<Capsule, Capsule>(q);
    if (are<Capsule, Plane>(q)) return verdict<Capsule, Plane>(q);
    if (are<Capsule, HalfSpace>(q)) return verdict<Capsule, HalfSpace>(q);
    if (are<Box, Plane>(q)) return verdict<Box, Plane>(q);
    if (are<Box, HalfSpace>(q)) return verdict<Box, HalfSpace>(q);
    if (are<Triangle, Plane>(q)) return verdict<Triangle, Plane>(q);
    return verdict<Triangle, HalfSpace>(q);
}

} // namespace brink
