// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact_features.h"
#include "falling.h"
#include "lanes.h"

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
    /// That gap at some time.
    Guess at(double time) const;

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
        XYZ<Two> at(Two s, Two c) const { return still + c * cosine + s * sine; }
        XYZ<Two> rate(Two s, Two c) const { return c * sine - s * cosine; } // per radian
        XYZ<Two> still, cosine, sine;
    };
    struct Moving;
    Trend over_face(const Moving& point, const Moving& normal, V3 by) const;
    Trend between_edges(const Moving& e, const Moving& g, const Moving& way) const;

    V3 pivots_, velocity_; // from A's to B's
    double margin_, now_;
    Between between_;
    double side_ = 1; // of a face's or of two edges' common normal
    Two angles_;
    V3 normal_;   // of planes that do not turn
    Path points_; // a point on each feature; over a face the other body's, and beside it the normal
    Path along_;  // the directions of edges
};

} // namespace brink
