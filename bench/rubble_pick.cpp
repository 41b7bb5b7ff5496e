// SPDX-License-Identifier: BSD-3-Clause
#include "rubble.h"

#include "scene_rivals.h"

#include <random.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <sstream>

namespace brink::bench {
namespace {

constexpr double near = 0.003; // a miss that comes within this is a near one, metres

/// How many of the kind to pick.
struct Kind {
    std::string_view name;
    std::size_t wanted;
};
constexpr std::array<Kind, 4> kind_list{
    {{"touching at the start", 500}, {"meets", 1600}, {"near miss", 900}, {"clear miss", 1000}}};
constexpr std::size_t most_wanted = 1600;

constexpr std::array<double, 2> speed_limits{1, 30}; // m/s
constexpr std::array<std::string_view, 3> speed_names{"below 1 m/s", "1 to 30", "above"};

/// In kind_list, by brink's own answers; what it leaves undecided counts as meeting.
std::size_t kind_of(support::Query q)
{
    q.options.detail = Detail::time_only;
    const Status status = answer(q).status;
    if (status == Status::touching) return 0;
    if (status != Status::separated) return 1;
    q.options.target_gap = near;
    return answer(q).status == Status::separated ? 3 : 2;
}

/// Of the two bodies' middles, m/s.
double speed(const support::Query& q)
{
    return (q.motion_a.translation - q.motion_b.translation).norm() / static_cast<double>(rubble_dt);
}

std::size_t speed_class(double speed)
{
    return static_cast<std::size_t>(std::count_if(speed_limits.begin(), speed_limits.end(),
                                                  [&](double limit) { return speed >= limit; }));
}

} // namespace

void RubbleSample::see(const Sighting& sighting)
{
    const std::size_t kind = kind_of(sighting.query);
    Stratum& stratum = strata_[kind * speeds + speed_class(speed(sighting.query))];
    const std::uint64_t seen = stratum.seen++;
    if (stratum.held.size() < most_wanted) {
        stratum.held.push_back(sighting);
        return;
    }
    const std::uint64_t seat = support::Random(seed_, seen * kinds * speeds + kind).bits() % (seen + 1);
    if (seat < most_wanted) stratum.held[seat] = sighting;
}

/// A third of what is wanted of the kind, and an equal part of what faster ones, which are fewer, do not use.
std::size_t RubbleSample::share(std::size_t kind, std::size_t speed, const std::vector<Stratum>& strata)
{
    std::size_t left = kind_list[kind].wanted;
    for (std::size_t s = speeds - 1;; --s) {
        const std::size_t mine = std::min(strata[kind * speeds + s].held.size(), left / (s + 1));
        if (s == speed) return mine;
        left -= mine;
    }
}

std::vector<support::KeptQuery> RubbleSample::picked() const
{
    struct Picked {
        std::size_t kind;
        Sighting sighting;
    };
    std::vector<Picked> picked;
    for (std::size_t i = 0; i < strata_.size(); ++i) {
        std::vector<Sighting> held = strata_[i].held;
        support::Random random(seed_, i);
        for (std::size_t k = share(i / speeds, i % speeds, strata_); k > 0; --k) {
            const auto which = static_cast<std::size_t>(random.index(static_cast<int>(held.size())));
            picked.push_back({i / speeds, held[which]});
            std::swap(held[which], held.back());
            held.pop_back();
        }
    }
    std::sort(picked.begin(), picked.end(), [](const Picked& p, const Picked& q) {
        const Sighting &x = p.sighting, &y = q.sighting;
        return std::tie(x.step, x.a, x.b) < std::tie(y.step, y.a, y.b);
    });
    std::vector<support::KeptQuery> out;
    for (const Picked& p : picked)
        out.push_back({p.sighting.query,
                       fmt::format("{}, {:.3g} m/s, step {}, bodies {} and {}", kind_list[p.kind].name,
                                   speed(p.sighting.query), p.sighting.step, p.sighting.a, p.sighting.b)});
    return out;
}

std::string RubbleSample::table() const
{
    std::string out = fmt::format("{:<22}", "picked, of so many");
    for (const std::string_view name : speed_names)
        out += fmt::format(" {:>18}", name);
    for (std::size_t i = 0; i < strata_.size(); ++i) {
        if (i % speeds == 0) out += fmt::format("\n{:<22}", kind_list[i / speeds].name);
        const auto count = static_cast<std::int64_t>(share(i / speeds, i % speeds, strata_));
        out += fmt::format(" {:>6} of {:>8}", thousands(count),
                           thousands(static_cast<std::int64_t>(strata_[i].seen)));
    }
    return out;
}

void run_record(const Output& output, const RubbleOptions& options)
{
    RubbleSample sample(options.seed);
    const RubbleRun run = simulate_rubble(options.seed, [&](const Sighting& s) { sample.see(s); });
    const std::vector<support::KeptQuery> queries = sample.picked();
    const std::string comment = fmt::format(
        "Rubble: queries of a pile of stones in a pen of thin walls, and of projectiles of 50 to 300 m/s "
        "shot "
        "at it.\n`brink-bench record --seed {}` made it in {} steps of 1/60 s of Bullet {}, {} bodies; "
        "metres. "
        "A near miss comes\nwithin {} mm. A pair is seen in each step in which the bounds of what it sweeps "
        "overlap; of those, picked at random:\n\n{}",
        options.seed, run.steps, bullet_version(), run.bodies, near * 1000, sample.table());
    std::ostringstream text;
    write_queries(text, queries, comment);
    output.write("rubble.txt", text.str());
    fmt::print("{}\n\nA recorded motion ends within {:.1e} m and {:.1e} rad of where Bullet put the body.\n"
               "{} queries, {:.1f} MB: {}\n",
               comment, run.most_off, run.most_turned_off,
               thousands(static_cast<std::int64_t>(queries.size())),
               static_cast<double>(text.str().size()) / 1e6, output.path_of("rubble.txt"));
}

} // namespace brink::bench
