// SPDX-License-Identifier: BSD-3-Clause
#include "error_contender.h"

#include <fcl.h>
#include <fmt/format.h>

#include <optional>

namespace brink::bench {
namespace {

using support::FclBody;
using support::FclQuestion;

/// Prepared before anything is timed, once for all contenders.
using Geometries = std::shared_ptr<const std::vector<FclBody>>;

class Fcl : public Contender {
public:
    Fcl(std::string who, std::string setting, const Sample& sample, Geometries geometries)
        : Contender(std::move(who), std::move(setting)),
          bodies_(sample.bodies),
          geometries_(std::move(geometries))
    {
    }

protected:
    const Motion& motion(std::uint16_t body) const { return bodies_[body].motion; }
    const FclBody& geometry(std::uint16_t body) const { return (*geometries_)[body]; }
    static Answer told(const std::optional<double>& t) { return {t.has_value(), t.value_or(0)}; }

private:
    const std::vector<Body>& bodies_;
    Geometries geometries_;
};

class Advancement final : public Fcl {
public:
    Advancement(const Sample& sample, const Geometries& geometries)
        : Fcl("FCL conservative advancement", "", sample, geometries)
    {
    }

    Answer ask(const Pair& pair) override
    {
        return told(fcl_continuous(FclQuestion::conservative_advancement, geometry(pair.a), motion(pair.a),
                                   geometry(pair.b), motion(pair.b)));
    }
};

class Naive final : public Fcl {
public:
    Naive(const Sample& sample, const Geometries& geometries, int poses)
        : Fcl("FCL naive", fmt::format("{} poses", poses), sample, geometries), poses_(poses)
    {
    }

    Answer ask(const Pair& pair) override
    {
        return told(fcl_naive(poses_, geometry(pair.a), motion(pair.a), geometry(pair.b), motion(pair.b)));
    }

private:
    int poses_;
};

/// Stops at the first part whose end shows an overlap, as a simulator would. The step's beginning was the end
/// of the step before.
class Discrete final : public Fcl {
public:
    Discrete(const Sample& sample, const Geometries& geometries, int parts)
        : Fcl("FCL discrete", parts == 1 ? "1 substep" : fmt::format("{} substeps", parts), sample,
              geometries),
          parts_(parts)
    {
    }

    Answer ask(const Pair& pair) override
    {
        for (int k = 1; k <= parts_; ++k) {
            const double t = static_cast<double>(k) / parts_;
            if (fcl_collide(geometry(pair.a), pose(pair.a, t), geometry(pair.b), pose(pair.b, t)))
                return {true, t};
        }
        return {};
    }

private:
    Pose pose(std::uint16_t body, double t) const
    {
        const Motion& m = motion(body);
        if (!m.rotation.isZero(0)) return m.at(t);
        return {m.start.position + t * m.translation, m.start.orientation};
    }

    int parts_;
};

bool unbounded(const Shape& shape)
{
    return std::holds_alternative<Plane>(shape) || std::holds_alternative<HalfSpace>(shape);
}

bool polytope(const Shape& shape)
{
    return std::holds_alternative<Triangle>(shape) || std::holds_alternative<Hull>(shape);
}

/// FCL crashes where one of its Convexes, which triangles and hulls are, meets a Plane or a Halfspace.
bool can_collide(const Shape& a, const Shape& b)
{
    if ((unbounded(a) && polytope(b)) || (unbounded(b) && polytope(a))) return false;
    return fcl_trusts(FclQuestion::collide, a, b);
}

} // namespace

Contenders fcl_contenders(const Questions& questions)
{
    const Sample& sample = questions.sample;
    const Shape& a = questions.first_shape();
    const Shape& b = questions.second_shape();
    Contenders out;
    if (!can_collide(a, b)) return out;
    std::vector<FclBody> made;
    for (const Body& body : sample.bodies)
        made.emplace_back(body.shape);
    const auto geometries = std::make_shared<const std::vector<FclBody>>(std::move(made));
    if (fcl_trusts(FclQuestion::conservative_advancement, a, b))
        out.push_back(std::make_unique<Advancement>(sample, geometries));
    for (const int poses : {10, 100, 1000})
        out.push_back(std::make_unique<Naive>(sample, geometries, poses));
    for (const int parts : {1, 10, 100, 1000})
        out.push_back(std::make_unique<Discrete>(sample, geometries, parts));
    return out;
}

} // namespace brink::bench
