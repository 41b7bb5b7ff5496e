// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact_features.h"
#include "falling.h"
#include "lanes.h"
#include "trig.h"

namespace brink {

/// Two features as they move on from where they are now, each with a point on it: what guesses of contact
/// follow. Another time takes two sines and cosines and no body put in its place. No bound rests on it.
class Pursuit {
public:
    /// The points as in Facing, the normal from A's feature towards B's; `now` is the time of both, `radii`
    /// what the features are grown by.
    template <class Part>
    Pursuit(const Facing<Part>& f, const Features& features, V3 on_a, V3 on_b, V3 normal, double radii,
            double now)
        : pivots_(f.b.pivot),
          velocity_(f.velocity),
          margin_(f.margin),
          now_(now),
          between_(between(features, radii))
    {
        set_out({f.a.rate, f.a.angle, on_a}, {f.b.rate, f.b.angle, on_b - pivots_}, features, normal);
    }
    /// When the gap between the features falls to `aim`, as nearly as one step more from `near`
    /// tells it; infinity where it does not between the two times, as far as is seen on the way there.
    double falls_to(double aim, double near, double from, double until) const;
    /// The gap at some time, but for what of it stays the same, times `length`: a height that no root is
    /// taken for. What stays are the radii and how high over its pivot a face lies.
    struct Height {
        Guess seen;
        double length = 1, growing = 0; // how fast, times itself, the length grows
    };
    Height at(double time) const;

private:
    enum class Between : unsigned char { face_of_a, face_of_b, edges, edge_of_a, edge_of_b, points, planes };
    static Between between(const Features&, double radii);
    /// A body with a point about its pivot.
    struct Side {
        V3 rate;
        double angle; // |rate|
        V3 point;
    };
    void set_out(const Side& a, const Side& b, const Features&, V3 normal);

    /// Two vectors as they turn, each about an axis of its own.
    struct Path {
        Path() {} // NOLINT(modernize-use-equals-default): as in Core
        Path(const XYZ<Two>& vectors, const XYZ<Two>& axes)
            : still(dot(axes, vectors) * axes), cosine(vectors - still), sine(cross(axes, vectors))
        {
        }
        XYZ<Two> at(const NearSinCos& by) const { return still + by.cos * cosine + by.sin * sine; }
        XYZ<Two> rate(const NearSinCos& by) const { return by.cos * sine - by.sin * cosine; } // per radian
        XYZ<Two> still, cosine, sine;
    };
    struct Moving;
    NearSinCos turned(double h) const { return h == 0 ? NearSinCos{} : near_sin_cos(both(h) * angles_); }
    Moving way(double h, const NearSinCos& by) const;
    Height over_face(double time) const;
    Height between_edges(double time) const;
    Height between_others(double time) const;
    template <class Do> auto with_height(Do go) const;

    V3 pivots_, velocity_; // from A's to B's
    double margin_, now_;  // margin_: what stays of the gap
    Between between_;
    double side_ = 1; // of a face's or of two edges' common normal
    Two angles_;
    V3 normal_;   // of planes that do not turn
    Path points_; // a point on each feature; over a face the other body's, and beside it the normal
    Path along_;  // the directions of edges
};

} // namespace brink
