// SPDX-License-Identifier: BSD-3-Clause
#include "scene_run.h"

#include "scene_rivals.h"
#include "scene_threads.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>

namespace brink::bench {
namespace {

using support::SceneSample;

constexpr std::uint64_t seed = 20261122;
constexpr double patience = 20; // seconds of one series of steps; three are done whatever they take
constexpr std::size_t compared_n = 100'000; // up to here pair by pair, beyond their number

/// Samples of what a step is made of, in ms.
struct Samples {
    std::vector<double> motions, update, pairs, step, balls, impacts, first;
};

double ms_of(const std::function<void()>& work) { return 1e3 * time_of(work); }

double per_body(std::size_t bytes, std::size_t n)
{
    return static_cast<double>(bytes) / static_cast<double>(n);
}

/// What has no bounds is tested as what it is: here a floor, by its box. It ends where all others do, because
/// the rivals reckon with volumes and centres; who overlaps whom stays as it is.
std::vector<Aabb> finite_boxes(Scene& scene)
{
    constexpr double far = 1e30;
    std::vector<Aabb> boxes;
    boxes.reserve(scene.size());
    Vec3 least(far, far, far), most = -least;
    for (std::size_t i = 0; i < scene.size(); ++i) {
        const auto id = static_cast<BodyId>(i);
        Aabb& box = boxes.emplace_back(scene.swept_bounds(id));
        if (box.min.minCoeff() < -far) box = swept_bounds(scene.body(id).shape, scene.body(id).motion);
        for (int axis = 0; axis < 3; ++axis) {
            if (box.min[axis] > -far) least[axis] = std::min(least[axis], box.min[axis]);
            if (box.max[axis] < far) most[axis] = std::max(most[axis], box.max[axis]);
        }
    }
    for (Aabb& box : boxes) {
        box.min = box.min.cwiseMax(least);
        box.max = box.max.cwiseMin(most);
    }
    return boxes;
}

std::vector<BodyPair> sorted(std::span<const BodyPair> pairs)
{
    std::vector<BodyPair> all(pairs.begin(), pairs.end());
    std::sort(all.begin(), all.end(),
              [](const BodyPair& x, const BodyPair& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
    return all;
}

struct Contender {
    SceneFigures figures;
    std::unique_ptr<Rival> rival;
    Samples samples;
    double spent = 0; // ms
};

class SceneRun {
public:
    SceneRun(const SceneTask& task, SceneResults results) : task_(task), results_(std::move(results))
    {
        const SceneSample drawn = support::draw_scene(task.scene, task.n, seed);
        sample_ = task.order == "spatial" ? support::in_spatial_order(drawn) : drawn;
        movers_ = support::movers(sample_);
        for (int step = 0; step < 4; ++step)
            motions_[static_cast<std::size_t>(step)] = support::motions_at(sample_, movers_, step);
    }

    SceneResults run()
    {
        build();
        add_rivals();
        for (std::size_t i = 0; i < task_.threads.size(); ++i) {
            if (i == 0)
                measure(task_.threads[i], rivals_);
            else
                measure(task_.threads[i], {});
        }
        for (Contender& c : rivals_)
            finish(c.figures, c.samples);
        return std::move(results_);
    }

private:
    SceneFigures described(std::string_view who, int threads) const
    {
        SceneFigures f;
        f.scene = task_.scene;
        f.order = task_.order;
        f.who = who;
        f.threads = threads;
        f.n = task_.n;
        f.movers = movers_.size();
        return f;
    }

    void build()
    {
        const std::size_t heap = heap_bytes();
        build_ms_ = ms_of([&] {
            with_threads(1, [&] {
                for (const Body& body : sample_.bodies)
                    scene_.add(body);
                scene_.update();
            });
        });
        heap_ = per_body(heap_bytes() - heap, task_.n);
    }

    void add_rivals()
    {
        Moves moves(task_.n, 0);
        for (const BodyId id : movers_)
            moves[id] = 1;
        const std::vector<Aabb> boxes = finite_boxes(scene_);
        const auto add = [&](std::string_view who, std::unique_ptr<Rival> rival) {
            if (!rival) return;
            Contender c{described(who, 1), std::move(rival), {}};
            c.rival->place(boxes);
            const std::size_t heap = heap_bytes();
            c.figures.build_ms = ms_of([&] { c.rival->build(); });
            c.figures.heap = c.figures.bytes = per_body(heap_bytes() - heap, task_.n);
            rivals_.push_back(std::move(c));
        };
        add("FCL", fcl_rival(Trees::one, moves));
        add("Bullet", bullet_rival(Trees::one, moves));
        if (movers_.size() * 10 > task_.n) return;
        add("FCL two trees", fcl_rival(Trees::two, moves));
        add("Bullet two trees", bullet_rival(Trees::two, moves));
    }

    void move_all(Samples& samples)
    {
        const std::vector<Motion>& motions = motions_[static_cast<std::size_t>(++step_ % 4)];
        samples.motions.push_back(ms_of([&] { scene_.set_motions(movers_, motions); }));
        samples.update.push_back(ms_of([&] { scene_.update(); }));
    }

    /// Each question has motions of its own, so that none profits from what another left behind.
    void ask(Samples& samples, SceneFigures& figures)
    {
        move_all(samples);
        samples.impacts.push_back(ms_of([&] { figures.impacts = scene_.impacts().found.size(); }));
        ledgers_.impacts = scene_.ledger();
        move_all(samples);
        samples.first.push_back(ms_of([&] { scene_.first_impact(); }));
        ledgers_.first = scene_.ledger();
        move_all(samples);
        const double balls = ms_of([&] { figures.ball_pairs = scene_.candidates(Bounds::balls).size(); });
        samples.balls.push_back(samples.update.back() + balls);
        move_all(samples); // the last: the rivals are asked about the same boxes
        samples.pairs.push_back(ms_of([&] { figures.pairs = scene_.candidates().size(); }));
        samples.step.push_back(samples.update.back() + samples.pairs.back());
    }

    void measure(int threads, std::span<Contender> rivals)
    {
        SceneFigures figures = described("brink", threads);
        Samples samples;
        with_threads(threads, [&] {
            Samples unheard; // caches and memory of the first round
            ask(unheard, figures);
        });
        double spent = 0;
        for (int step = 0; step < task_.steps && (step < 3 || spent < patience); ++step) {
            spent += time_of([&] { with_threads(threads, [&] { ask(samples, figures); }); });
            challenge(rivals);
        }
        figures.build_ms = build_ms_;
        figures.bytes = per_body(scene_.broad_phase_bytes(), task_.n);
        figures.heap = heap_;
        finish(figures, samples);
        if (threads == 1)
            results_.ledgers.push_back({task_.scene, task_.n, ledgers_.impacts, ledgers_.first});
    }

    /// The rivals, over the boxes of the step that brink was just timed in.
    void challenge(std::span<Contender> rivals)
    {
        if (rivals.empty()) return;
        const std::vector<Aabb> boxes = finite_boxes(scene_);
        const std::vector<BodyPair> ours = sorted(scene_.candidates());
        for (Contender& c : rivals) {
            if (c.samples.step.size() >= 3 && c.spent > 1e3 * patience) continue;
            c.rival->place(boxes);
            std::span<const BodyPair> theirs;
            c.samples.update.push_back(ms_of([&] { c.rival->update(); }));
            c.samples.pairs.push_back(ms_of([&] { theirs = c.rival->pairs(); }));
            c.samples.step.push_back(c.samples.update.back() + c.samples.pairs.back());
            c.spent += c.samples.step.back();
            c.figures.pairs = theirs.size();
            const bool same = task_.n <= compared_n ? sorted(theirs) == ours : theirs.size() == ours.size();
            if (same) continue;
            ++results_.wrong;
            fmt::print(stderr, "{} of {} bodies, {} order: {} has {} pairs, brink {}\n", task_.scene, task_.n,
                       task_.order, c.figures.who, theirs.size(), ours.size());
        }
    }

    void finish(SceneFigures figures, const Samples& samples)
    {
        figures.steps = static_cast<int>(samples.step.size());
        figures.motions_ms = median(samples.motions);
        figures.update_ms = median(samples.update);
        figures.pairs_ms = median(samples.pairs);
        figures.step_ms = median(samples.step);
        figures.balls_ms = median(samples.balls);
        figures.impacts_ms = median(samples.impacts);
        figures.first_ms = median(samples.first);
        figures.floor_ms = floor_ms(figures, results_.bandwidth);
        results_.figures.push_back(figures);
    }

    SceneTask task_;
    SceneResults results_;
    SceneSample sample_;
    std::vector<BodyId> movers_;
    std::array<std::vector<Motion>, 4> motions_;
    Scene scene_;
    double build_ms_ = 0, heap_ = 0;
    std::vector<Contender> rivals_;
    SceneLedgers ledgers_;
    int step_ = 0;
};

} // namespace

double time_of(const std::function<void()>& work)
{
    const auto begin = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values)
{
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

SceneResults measure_scene(const SceneTask& task, SceneResults so_far)
{
    return SceneRun(task, std::move(so_far)).run();
}

} // namespace brink::bench
