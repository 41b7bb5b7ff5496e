// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "certificate.h"
#include "lanes.h"
#include "support.h"

#include <cmath>
#include <type_traits>

/// How bodies show along an axis that moves linearly.
namespace brink {

/// The points that support the turning axis at some h, as a line in h: its value at h = 0 and its slope.
struct Line {
    double value = 0, slope = 0;

    double at(double h) const { return value + h * slope; }
};
static inline Line operator+(Line a, Line b) { return {a.value + b.value, a.slope + b.slope}; }
static inline Line operator-(Line a, Line b) { return {a.value - b.value, a.slope - b.slope}; }
static inline Line operator*(double s, Line l) { return {s * l.value, s * l.slope}; }

/// axis + h shift
struct Turned {
    V3 axis, shift;

    /// Its product with a vector
    Line along(V3 v) const { return {dot(axis, v), dot(shift, v)}; }
    /// and with a point, whose slope is told from where the axis turns about.
    Line along(V3 p, V3 pivot) const { return {dot(axis, p), dot(shift, p - pivot)}; }
    V3 at(double h) const { return axis + h * shift; }
};

/// How a body shows along an axis n + h shift, for all h: where its extreme points lie, the farthest along
/// the axis, or against it where `side` is -1. Of a segment and of a box no more is needed than their lines.
class SegmentShadow {
public:
    SegmentShadow(const Posed<Core>& body, V3 axis, V3 shift, double side)
        : start_(Turned{axis, shift}.along(body.part.points[0], body.pivot)),
          end_(Turned{axis, shift}.along(body.part.points[1], body.pivot)),
          side_(side)
    {
    }
    Line now() const { return extreme(0); }
    Line extreme(double h) const { return side_ * end_.at(h) > side_ * start_.at(h) ? end_ : start_; }

private:
    Line start_, end_;
    double side_;
};

class BoxShadow {
public:
    BoxShadow(const Posed<Core>& body, V3 axis, V3 shift, double side) : side_(side)
    {
        const Core& c = body.part;
        const V3 h = c.half_extents;
        const Turned turned{axis, shift};
        middle_ = turned.along(c.centre, body.pivot);
        x_ = h.x * turned.along(c.axes.x);
        y_ = h.y * turned.along(c.axes.y);
        z_ = h.z * turned.along(c.axes.z);
    }
    Line now() const { return extreme(0); }
    Line extreme(double h) const
    {
        const auto farther = [&](Line l) { return std::copysign(1.0, side_ * l.at(h)) * l; };
        return middle_ + farther(x_) + farther(y_) + farther(z_);
    }

private:
    Line middle_, x_, y_, z_;
    double side_;
};

class Shadow {
public:
    Shadow(const Posed<Core>& body, V3 axis, V3 shift, double side)
        : body_(body), axis_{axis, shift}, side_(side), still_(shift == V3{} || body.part.count == 1)
    {
        const Core& c = body.part;
        for (int k = 0; k < c.count && few(); ++k)
            line_[k] = axis_.along(c.points[k], body.pivot);
        now_ = sought(0);
    }
    Line now() const { return now_; }
    Line extreme(double h) const { return still_ ? now_ : sought(h); }

private:
    bool few() const { return body_.part.kind <= Core::Kind::triangle; }
    Line sought(double h) const
    {
        const Core& c = body_.part;
        if (!few()) return axis_.along(farthest(c, side_ * axis_.at(h)).point, body_.pivot);
        Line best = line_[0];
        for (int k = 1; k < c.count; ++k)
            if (side_ * line_[k].at(h) > side_ * best.at(h)) best = line_[k];
        return best;
    }

    const Posed<Core>& body_;
    Turned axis_;
    double side_;
    bool still_;
    Line line_[3]{}, now_;
};

/// A plane has one possible axis, its own normal, which stays with it.
class Level {
public:
    Level(const Posed<Border>& body, V3 axis, V3, double)
        : value_(dot(axis, body.part.normal) < 0 ? -body.part.offset : body.part.offset)
    {
    }
    Line now() const { return Line{value_, 0}; }
    Line extreme(double) const { return now(); }

private:
    double value_;
};

/// The largest x . q over a body's points about its pivot.
static inline double reach_along(const Posed<Core>& body, V3 q)
{
    return highest(body.part, q) - dot(q, body.pivot);
}
static inline double reach_along(const Posed<Border>&, V3) { return 0; }

/// The shadows of both bodies: A's axis moves with the first shift, B's with the second.
template <class Part, class OfA = Shadow,
          class OfB = std::conditional_t<std::is_same_v<Part, Core>, Shadow, Level>>
class Shadows {
public:
    Shadows(const Posed<Core>& a, const Posed<Part>& b, V3 axis, const XYZ<Two>& shift)
        : a_(a, axis, first(shift), 1), b_(b, axis, second(shift), -1)
    {
    }
    Line now() const { return b_.now() - a_.now(); }
    /// How far apart they are.
    Line between(double h) const { return b_.extreme(h) - a_.extreme(h); }
    using Reach = double;
    /// The largest x . q over the points of A about its pivot, with the first q, and the same of B, added up.
    static Reach reach(const Posed<Core>& a, const Posed<Part>& b, const XYZ<Two>& q)
    {
        return reach_along(b, second(q)) + reach_along(a, first(q));
    }
    /// That over points that are extreme along an axis that bends by q, n + h shift + h^2 / 2 q, somewhere up
    /// to h; or over more.
    static double until(double, Reach reach) { return reach; }

private:
    OfA a_;
    OfB b_;
};

/// The same of two boxes, A's numbers beside B's.
class BoxShadows {
public:
    BoxShadows(const Posed<Core>& a, const Posed<Core>& b, V3 axis, const XYZ<Two>& shift)
    {
        const Core &c = a.part, &d = b.part;
        const XYZ<Two> n = both(axis), centre = pair(c.centre, d.centre);
        const auto half = [&](double of_a, double of_b, V3 axis_a, V3 axis_b) {
            const XYZ<Two> axes = pair(axis_a, axis_b);
            return Lines{Two{of_a, of_b} * dot(n, axes), Two{of_a, of_b} * dot(shift, axes)};
        };
        middle_ = {dot(n, centre), dot(shift, centre - pair(a.pivot, b.pivot))};
        x_ = half(c.half_extents.x, d.half_extents.x, c.axes.x, d.axes.x);
        y_ = half(c.half_extents.y, d.half_extents.y, c.axes.y, d.axes.y);
        z_ = half(c.half_extents.z, d.half_extents.z, c.axes.z, d.axes.z);
    }
    Line now() const { return between(0); }
    Line between(double h) const
    {
        const auto farther = [h](const Lines& l) {
            const Two side = Two{1, -1} * (l.value + both(h) * l.slope);
            return Lines{along(l.value, side), along(l.slope, side)};
        };
        const Lines x = farther(x_), y = farther(y_), z = farther(z_);
        const Two value = middle_.value + x.value + y.value + z.value;
        const Two slope = middle_.slope + x.slope + y.slope + z.slope;
        return {value[1] - value[0], slope[1] - slope[0]};
    }
    /// The parts of x . q that add up to it for every corner x.
    struct Reach {
        Two middle, x, y, z; // of the middle; of half an edge towards its end on the positive side
    };
    static Reach reach(const Posed<Core>& a, const Posed<Core>& b, const XYZ<Two>& q)
    {
        const Core &c = a.part, &d = b.part;
        const XYZ<Two> h = pair(c.half_extents, d.half_extents);
        const auto along_q = [&](V3 axis_a, V3 axis_b) { return dot(pair(axis_a, axis_b), q); };
        return {dot(pair(c.centre, d.centre) - pair(a.pivot, b.pivot), q), h.x * along_q(c.axes.x, d.axes.x),
                h.y * along_q(c.axes.y, d.axes.y), h.z * along_q(c.axes.z, d.axes.z)};
    }
    double until(double h, const Reach& reach) const
    {
        // As long as an edge cannot turn over, its same end is the extreme one.
        const auto of_end = [h](const Lines& l, Two q) {
            const Two size = magnitude(q), moves = both(h) * (magnitude(l.slope) + both(0.5 * h) * size);
            return select(magnitude(l.value) > moves, along(q, Two{1, -1} * l.value), size);
        };
        const Two most = reach.middle + of_end(x_, reach.x) + of_end(y_, reach.y) + of_end(z_, reach.z);
        return most[1] + most[0];
    }

private:
    struct Lines {
        Two value, slope;
    };
    Lines middle_, x_, y_, z_;
};

} // namespace brink
