// SPDX-License-Identifier: BSD-3-Clause
// Built where there is Qhull (C. Barber, D. Dobkin, H. Huhdanpaa, The Quickhull Algorithm for Convex Hulls,
// 1996).
#include "hull_proposal.h"

#include <cstdio>
#include <libqhull_r/qhull_ra.h>
#include <memory>

namespace brink {

namespace {

/// Qhull's state. What it says goes nowhere: its proposal is looked at, whatever it thinks of it.
class Quickhull {
public:
    Quickhull() : nowhere_(std::fopen("/dev/null", "w")), state_(std::make_unique<qhT>())
    {
        qh_zero(state_.get(), nowhere_);
    }
    Quickhull(const Quickhull&) = delete;
    Quickhull& operator=(const Quickhull&) = delete;
    ~Quickhull()
    {
        int left = 0, total = 0;
        qh_freeqhull(state_.get(), !qh_ALL);
        qh_memfreeshort(state_.get(), &left, &total);
        if (nowhere_ != nullptr) std::fclose(nowhere_);
    }

    std::vector<Facet> faces(std::vector<double>& coordinates)
    {
        std::vector<Facet> found;
        char command[] = "qhull Qt Pp"; // all faces triangles, no warnings
        const auto count = static_cast<int>(coordinates.size() / 3);
        if (nowhere_ == nullptr ||
            qh_new_qhull(state_.get(), 3, count, coordinates.data(), 0, command, nowhere_, nowhere_) != 0)
            return found;
        for (const facetT* f = state_->facet_list; f != nullptr && f->next != nullptr; f = f->next) {
            Facet corners{};
            for (std::size_t k = 0; k < 3; ++k) {
                auto* vertex = static_cast<vertexT*>(f->vertices->e[k].p);
                if (vertex == nullptr) return {};
                corners[k] = qh_pointid(state_.get(), vertex->point);
            }
            found.push_back(corners);
        }
        return found;
    }

private:
    std::FILE* nowhere_;
    std::unique_ptr<qhT> state_;
};

} // namespace

std::vector<Facet> proposed_faces(const std::vector<V3>& points)
{
    if (points.size() < 4) return {};
    std::vector<double> coordinates;
    coordinates.reserve(3 * points.size());
    for (const V3 p : points)
        coordinates.insert(coordinates.end(), {p.x, p.y, p.z});
    return Quickhull().faces(coordinates);
}

} // namespace brink
