// SPDX-License-Identifier: BSD-3-Clause
#include "error_contender.h"

#include <array>
#include <fmt/format.h>

namespace brink::bench {
namespace {

constexpr std::array tolerances{1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14};

class Brink final : public Contender {
public:
    Brink(const Sample& sample, double tolerance)
        : Contender(std::string(brink_name), fmt::format("{:.0e}", tolerance)), bodies_(sample.bodies)
    {
        options_.tolerance = tolerance;
    }

    Answer ask(const Pair& pair) override
    {
        const Body& a = bodies_[pair.a];
        const Body& b = bodies_[pair.b];
        const Toi toi = time_of_impact(a.shape, a.motion, b.shape, b.motion, options_);
        return {toi.status != Status::separated, toi.t, toi.iterations, toi.status == Status::undecided};
    }

private:
    const std::vector<Body>& bodies_;
    Options options_;
};

} // namespace

Contenders brink_contenders(const Questions& questions)
{
    Contenders out;
    for (const double tolerance : tolerances)
        out.push_back(std::make_unique<Brink>(questions.sample, tolerance));
    return out;
}

} // namespace brink::bench
