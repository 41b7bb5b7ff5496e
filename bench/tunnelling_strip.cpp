// SPDX-License-Identifier: BSD-3-Clause
#include "tunnelling_strip.h"

#include "crossing_turning.h"
#include "method.h"
#include "output.h"

#include <algorithm>
#include <fmt/format.h>

namespace brink::bench {
namespace {

constexpr std::size_t checks = 10;
constexpr double speed = 60; // wall thicknesses a step
constexpr std::uint64_t attempts = 1000;
const Vec3 half_extents{0.026, 0.005, 0.02}; // metres

double time_of(std::size_t check) { return static_cast<double>(check) / checks; }

Distance apart(const Crossing& c, double t) { return distance(c.a, c.motion_a.at(t), c.b, c.motion_b.at(t)); }

/// A point of the world in the wall's frame, in millimetres; turned by half a turn, so that the box flies to
/// the right.
Vec3 seen(const Crossing& c, const Vec3& point)
{
    const Pose& wall = c.motion_b.start;
    const Vec3 local = wall.orientation.conjugate() * (point - wall.position);
    return {-1000 * local.x(), -1000 * local.y(), 1000 * local.z()};
}

/// The section of the box by the plane of motion through its centre: x and y of its corners.
std::string outline(const Crossing& c, double t)
{
    const Pose pose = c.motion_a.at(t);
    const Vec3 half = std::get<Box>(c.a).half_extents;
    std::string text;
    for (const auto& [x, y] :
         {std::pair(1, 1), std::pair(-1, 1), std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1)}) {
        const Vec3 corner = seen(c, pose.position + pose.orientation * Vec3(x * half.x(), y * half.y(), 0));
        text += fmt::format("{:.4f} {:.4f}\n", corner.x(), corner.y());
    }
    return text;
}

std::string at(const Vec3& point) { return fmt::format("{:.4f} {:.4f}", point.x(), point.y()); }

/// The figures: $checks, an outline at each check; $contact, that at brink's t; $labels, where the centre is
/// at each check; $point, brink's witness point.
std::string figures(const StripCase& s)
{
    const Crossing& c = s.crossing;
    std::string poses = "$checks << END\n";
    std::string labels = "$labels << END\n";
    for (std::size_t k = 0; k <= checks; ++k) {
        poses += outline(c, time_of(k)) + "\n\n";
        labels += fmt::format("{} {}\n", at(seen(c, c.motion_a.at(time_of(k)).position)), k);
    }
    return poses + "END\n" + labels + "END\n$contact << END\n" + outline(c, s.toi.t) +
           "END\n$point << END\n" + at(seen(c, s.toi.point_a)) + "\nEND\n";
}

std::string words(const StripCase& s)
{
    const Crossing& c = s.crossing;
    const double before = time_of(s.before);
    const double after = time_of(s.before + 1);
    const Vec3 middle =
        0.5 * (seen(c, c.motion_a.at(before).position) + seen(c, c.motion_a.at(after).position));
    const Vec3 whole = seen(c, c.motion_a.at(0.5).position);
    std::string text =
        fmt::format("wall = {:g}\nbefore = {}\n", 1000 * std::get<Box>(c.b).half_extents.x(), s.before);
    text += fmt::format("whole_x = {:.3f}\nwhole_y = {:.3f}\nnear_y = {:.3f}\n", whole.x(), whole.y(),
                        middle.y());
    text += fmt::format("short = 'check {}, t = {:.1f}: apart by {:.1f} mm'\n", s.before, before,
                        1000 * apart(c, before).gap);
    text += fmt::format("past = 'check {}, t = {:.1f}: apart by {:.1f} mm'\n", s.before + 1, after,
                        1000 * apart(c, after).gap);
    text += fmt::format("said = 'brink: t = {:.12f}, gap {:.1e} mm'\n", s.toi.t, 1000 * s.toi.gap);
    text += fmt::format("truth = 'true, by construction: t = {:.12f}'\n", c.contact);
    const Vec3 size = 2000 * std::get<Box>(c.a).half_extents;
    return text +
           fmt::format(
               "story = 'a box of {:.0f} × {:.0f} mm moves {:.0f} mm and turns by {:.0f}° in the step, "
               "through a wall {:.0f} mm thick (section; computed poses)'\n",
               size.x(), size.y(), 1000 * c.motion_a.translation.norm(),
               c.motion_a.rotation.norm() * 180 / 3.14159265358979324,
               2000 * std::get<Box>(c.b).half_extents.x());
}

constexpr Sheet sheet{.height = 700, .svg = {17, 26, 20, 16}, .png = {13, 20, 15, 12}, .lines = "rounded"};

/// Wants figures() and words().
constexpr std::string_view drawing = R"GP(
    set multiplot
    unset key
    unset tics
    set border 31 linecolor '#999999'
    set style fill transparent solid 0.35 border
    frame(k) = 0.025 + 0.325 * (k - 1)
    set label 1 'A fast body, one time step: what ten discrete checks see, and what brink sees' at screen 0.5, 0.952 center font large
    set label 2 story at screen 0.5, 0.902 center font middle_size textcolor rgb '#444444'
    do for [k = 1:3] {
        set lmargin at screen frame(k)
        set rmargin at screen frame(k) + 0.30
        set tmargin at screen 0.82
        set bmargin at screen 0.82 - 0.30 * 1500 / 700
        half = k == 1 ? 345 : 62
        set xrange [(k == 1 ? whole_x : 0) - half:(k == 1 ? whole_x : 0) + half]
        set yrange [(k == 1 ? whole_y : near_y) - half:(k == 1 ? whole_y : near_y) + half]
        set object 1 rectangle from -wall, graph 0 to wall, graph 1 fillcolor rgb '#777777' fillstyle solid 1 noborder
        if (k == 1) {
            set label 3 '10 checks a step: all say “apart”' at graph 0, 1.035 left font middle_size
            set label 4 'wall' at wall + 8, graph 0.95 left
            set label 5 'the box at the checks 0 to 10, t = 0, 0.1, ... 1' at graph 0, -0.06 left
            plot for [i = 0:10] $checks index i with filledcurves closed linewidth 1.5 linecolor rgb \
                     (i == before || i == before + 1 ? '#D55E00' : '#56B4E9'), \
                 $labels using 1:($2 - 45):(sprintf('%d', $3)) with labels font small
        }
        if (k == 2) {
            set label 3 'the wall stands between two poses' at graph 0, 1.035 left font middle_size
            set label 4 short at graph 0, -0.06 left textcolor rgb '#a04000'
            set label 5 past at graph 0, -0.12 left textcolor rgb '#a04000'
            plot for [i = before:before + 1] $checks index i with filledcurves closed linewidth 2.5 \
                     linecolor rgb '#D55E00', \
                 $labels using ($3 == before || $3 == before + 1 ? $1 : NaN):2:(sprintf('%d', $3)) \
                     with labels font middle_size
        }
        if (k == 3) {
            set label 3 'brink: the pose of contact' at graph 0, 1.035 left font middle_size
            set label 4 said at graph 0, -0.06 left textcolor rgb '#007A5A'
            set label 5 truth at graph 0, -0.12 left
            plot for [i = before:before + 1] $checks index i with lines linewidth 1.5 dashtype 3 \
                     linecolor rgb '#D55E00', \
                 $contact with filledcurves closed linewidth 2.5 linecolor rgb '#007A5A', \
                 $point with points pointtype 7 pointsize 1.6 linecolor rgb '#000000'
        }
        unset label
        unset object
    }
    unset multiplot
)GP";

} // namespace

std::optional<StripCase> strip_case(std::uint64_t seed)
{
    const Method& ten = methods[1];
    for (std::uint64_t i = 0; i < attempts; ++i) {
        support::Random random(seed, i);
        const Crossing c = box_at_wall_in_section(random, half_extents, speed);
        if (c.contact < 0.35 || c.contact > 0.65 || ten.ask(Question(c))) continue;
        const auto before = static_cast<std::size_t>(c.contact * checks);
        const Toi toi = time_of_impact(c.a, c.motion_a, c.b, c.motion_b);
        return StripCase{c, before, toi};
    }
    return std::nullopt;
}

std::string strip_plot(const StripCase& s)
{
    return "# Draws a step that ten discrete checks say is free of contact: gnuplot tunnelling_strip.gp\n" +
           words(s) + figures(s) + in_both_formats("tunnelling_strip", sheet, drawing);
}

} // namespace brink::bench
