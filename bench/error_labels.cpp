// SPDX-License-Identifier: BSD-3-Clause
#include "error_labels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace brink::bench {
namespace {

constexpr double mark_reach = 6; // of a mark from its middle, pixels
constexpr double gap = 2;

struct Area {
    double left, right, bottom, top;
};

double overlap(const Area& a, const Area& b)
{
    const double wide = std::min(a.right, b.right) - std::max(a.left, b.left);
    const double high = std::min(a.top, b.top) - std::max(a.bottom, b.bottom);
    return std::max(wide, 0.0) * std::max(high, 0.0);
}

double size(const Area& a) { return (a.right - a.left) * (a.top - a.bottom); }

Area around(const Spot& at, double half_width, double half_height)
{
    return {at.x - half_width, at.x + half_width, at.y - half_height, at.y + half_height};
}

class Placer {
public:
    Placer(const std::vector<Spot>& marks, const Canvas& canvas) : canvas_(canvas)
    {
        for (const Spot& mark : marks)
            taken_.push_back(around(mark, mark_reach, mark_reach));
    }

    /// Beside the mark if there is room, else above or below, else farther away.
    Spot place(const Spot& mark)
    {
        constexpr std::array<std::array<int, 2>, 8> ways{
            {{1, 0}, {-1, 0}, {1, -1}, {-1, 1}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}}};
        const double half_width = canvas_.letter_width * static_cast<double>(mark.text.size()) / 2;
        const double half_height = canvas_.letter_height / 2;
        Spot best = mark;
        double least = -1;
        for (int ring = 0; ring < 4; ++ring)
            for (const auto& [right, up] : ways) {
                const double more = mark_reach + gap + ring * canvas_.letter_height * 0.6;
                const Spot here{mark.x + right * (half_width + more), mark.y + up * (half_height + more),
                                mark.text};
                const double cost = in_the_way(around(here, half_width, half_height)) + ring;
                if (least >= 0 && cost >= least) continue;
                least = cost;
                best = here;
            }
        taken_.push_back(around(best, half_width, half_height));
        return best;
    }

private:
    double in_the_way(const Area& area) const
    {
        double sum = 10 * (size(area) - overlap(area, {0, canvas_.width, 0, canvas_.height}));
        for (const Area& other : taken_)
            sum += overlap(area, other);
        return sum;
    }

    Canvas canvas_;
    std::vector<Area> taken_;
};

} // namespace

std::vector<Spot> placed_labels(const std::vector<Spot>& marks, const Canvas& canvas)
{
    Placer placer(marks, canvas);
    std::vector<Spot> out;
    for (const Spot& mark : marks)
        out.push_back(mark.text.empty() ? mark : placer.place(mark));
    return out;
}

} // namespace brink::bench
