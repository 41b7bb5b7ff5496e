// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "certificate.h"
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

template <class Part> using ShadowOf = std::conditional_t<std::is_same_v<Part, Core>, Shadow, Level>;

} // namespace brink
