// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "box_axes.h"
#include "certificate.h"
#include "closed_sight.h"
#include "round_axis.h"

#include <optional>

namespace brink {

/// What a look at two bodies shows.
struct Sight {
    Sight() {}                // NOLINT(modernize-use-equals-default): as in Core
    TurningAxis axis;         // as their features ask for; zero where they ask for none
    V3 normal;                // the axis of the distance itself; zero where none was found
    double apart = -infinity; // what it is known to keep the cores apart by, up to rounding
    bool guessed = false;     // the axis' spin is a guess: other ones may do better
    double upper = infinity;  // a distance between points of the cores, radii left out, where one was taken
    V3 point_a, v;            // those points: v leads from A's to B's
    double astray = 0;        // how far from B point_a + v may lie
    double axis_gap = -infinity; // what best_normal() is known to keep the cores apart by, up to rounding

    V3 best_normal() const { return axis.normal == V3{} ? normal : axis.normal; }
};

/// How fast the normal between curved surfaces turns, as far as looks at different times tell.
struct Rolling {
    V3 spin; // of the axis; zero before it is known

    void see(V3 normal, double time);
    /// The axis that it has come to at another time, if it goes on like that.
    TurningAxis at(double time) const;

private:
    V3 normal_; // from which on it is told
    double time_ = 0;
};

/// The contact that a look shows, where its axis proves what its points say up to `doubt`.
std::optional<Separation> shown(const Sight&, const Facing<Core>&, double doubt);

/// Looks at two bounded bodies as they move on, each in the cheapest way that serves.
class Watch {
public:
    /// Witness points farther apart than `nearby` need not be found.
    Watch(const Core& a, const Core& b, double nearby);

    /// An evaluation of the distance.
    Sight look(const Facing<Core>&);
    /// The same from a place that may lie beyond contact: where cores overlap, nothing.
    Sight look_ahead(const Facing<Core>&);
    /// Whether a closed form tells the nearest points, so that the axis can wait: that of
    bool can_glance() const { return method_ < Method::boxes; }
    Glance glance(const Facing<Core>& f) const
    {
        if (method_ == Method::segments) return AtSegments::glance(f.a.part, f.b.part);
        if (method_ == Method::thin_box) return AtThinBox::glance(f.a.part, f.b.part);
        return AtPointRound::glance(f.a.part, f.b.part);
    }
    /// What such a glance from this place shows.
    Sight sight(const Facing<Core>&, const Glance&) const;
    /// The same as nearly as GJK tells it.
    Sight look_closely(const Facing<Core>&);
    /// The same by the longest way, which nothing can lead astray.
    static Sight look_hard(const Facing<Core>&);
    /// Whether the features last seen can be followed without an evaluation.
    bool can_follow() const { return method_ == Method::boxes || corners_.known(); }
    /// Whether what is seen from afar is likely to be what meets: of a corner among many it is not.
    bool far_sighted() const { return method_ != Method::any; }
    /// The axis that the features last seen ask for now.
    Sight follow(const Facing<Core>&);
    /// Those features where they were last seen or followed.
    const Features& features() const { return features_; }
    /// Fills in the nearest points of those features where they were last followed.
    void land(const Facing<Core>&, Sight&);

    /// Whether four corners of the difference hold the origin that deep, which proves that the cores overlap.
    bool overlap(const Facing<Core>&, double depth) const;

private:
    enum class Method : unsigned char { segments, thin_box, point_round, boxes, any };
    static Method method(const Core& a, const Core& b);
    Sight look_at_boxes(const Facing<Core>&);
    Sight seen(const LocalTop&);
    Sight look_by_gjk(const Facing<Core>&, double relative, double apart = infinity);

    Method method_;
    double nearby_;
    Corners corners_;   // of the simplex last seen
    int box_index_ = 0; // the axis last seen
    V3 towards_;        // the normal last seen
    Features features_; // unless glances tell them
    Simplex followed_;  // of those corners where they were last followed
};

/// Looks at a body and a plane or half-space, which takes no more than support points.
class BorderWatch {
public:
    BorderWatch(const Core&, const Border&, double) {}
    static Sight look(const Facing<Border>&);
    static Sight look_ahead(const Facing<Border>& f) { return look(f); }
    static Sight look_hard(const Facing<Border>& f) { return look(f); }
    static bool can_follow() { return true; }
    static bool can_glance() { return false; }
    static Glance glance(const Facing<Border>&) { return {}; }
    static Sight sight(const Facing<Border>& f, const Glance&) { return look(f); }
    static bool far_sighted() { return true; }
    static Sight follow(const Facing<Border>& f) { return look(f); }
    static Features features() { return {{}, {Feature::Kind::face, {}}}; }
    static void land(const Facing<Border>&, const Sight&) {}
};

} // namespace brink
