// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <brink/ledger.h>
#include <brink/ray.h>
#include <brink/toi.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

namespace brink {

/// Names a body of a scene. Given in order 0, 1, 2, ... and, once removed, never given again.
using BodyId = std::uint32_t;
inline constexpr BodyId no_body = 0xffffffff;

/// What a scene holds of one body.
struct Body {
    Shape shape{};
    Motion motion{};            // over the step; of a body that is immovable or asleep it must be still
    std::uint32_t category = 1; // the groups it belongs to, a bit each
    std::uint32_t mask =
        0xffffffff;         // the groups it meets: two bodies meet if each is in a group of the other's
    bool immovable = false; // scenery: what never moves is not asked against what never moves
    bool asleep = false;    // at rest for now: not asked against what sleeps or is immovable
};

struct SceneOptions {
    Options pair{}; // what time_of_impact is asked for every pair; of rays and overlaps nothing applies
    /// Pairs that may be decided exactly. Of those beyond only their swept spheres are told, and every answer
    /// says that it is not whole: by `complete`, by Status::undecided, by what a visit returns; a body that
    /// might have to halt halts where the spheres meet. The first of several at the same time need not be
    /// that of the lowest ids then.
    ///
    /// Pairs that masks or the filter exclude do not count, and no visitor hears of them. Bodies near each
    /// other of which none meets any other, by their masks, are passed over together; other pairs whose swept
    /// bounds meet are looked at one by one (some nanoseconds, no memory), and where these are many neither a
    /// budget nor a visitor shortens that.
    std::size_t max_tests = static_cast<std::size_t>(-1);
    /// Of a shape that is cast and of a ray; a body's own say all else. The category must have a bit set.
    std::uint32_t category = 1, mask = 0xffffffff;
    Layers without{}; // switched off, to see what they save: no answer changes
};

/// The first contact of two bodies, a < b, in [0, t_max]: toi.status is touching, hit or undecided. Of a
/// shape that is cast, a is no_body. A pair that is nowhere in contact has none.
struct Impact {
    BodyId a = no_body, b = no_body;
    Toi toi{};
};

/// Ordered by (t, a, b). Valid until the scene is next asked or changed.
struct Impacts {
    std::span<const Impact> found;
    /// No pair beyond those found touches before this time; t_max unless max_tests ran out.
    double known_until = 0;
    bool complete = false; // every pair was decided
};

/// Two bodies, a < b.
struct BodyPair {
    BodyId a = no_body, b = no_body;
    friend bool operator==(const BodyPair&, const BodyPair&) = default;
};

/// Ordered. Valid until the scene is next asked or changed.
struct Overlaps {
    std::span<const BodyPair> found;
    bool complete = false; // every pair was decided
};

/// When a body has to halt.
struct SafeTime {
    BodyId body = no_body;
    double t = 1;
};

struct RayImpact {
    BodyId body = no_body;
    RayHit hit{};
};

/// Ordered by (t, body). Valid until the scene is next asked or changed.
struct RayImpacts {
    std::span<const RayImpact> found;
    /// The ray meets no body beyond those found before this; t_max unless max_tests ran out.
    double known_until = 0;
    bool complete = false; // every body was decided
};

/// What a broad phase goes by.
enum class Bounds : unsigned char {
    boxes, // swept_bounds over the whole step
    balls, // and the balls around the bodies as they travel: what impacts() asks exactly
};

struct SceneData;

/// Many moving bodies, asked as one.
///
/// Pairs in which neither body can move (immovable or asleep) are not asked, nor those that masks or the pair
/// filter exclude, nor two planes or half-spaces. Of all others every query answers exactly as
/// time_of_impact(lower id, higher id) would for each of them alone, bit for bit and on any number of threads
/// (oneTBB's, of the arena it is called in): what is skipped cannot matter. Only where time_of_impact would
/// be undecided about bodies that bounds prove apart, the scene knows better.
///
/// A scene that was moved from can only be assigned to or destroyed.
///
/// Queries use the scene's own memory: one at a time, and none while the scene changes. Once a scene has been
/// asked, a step that is no larger allocates nothing. Lengths up to 1e38 are culled, larger ones only asked.
///
/// Changes and queries throw std::invalid_argument, which names field, value and id, and then leave the scene
/// as it was; changing or asking a scene from its own visitor or filter throws std::logic_error.
class Scene {
public:
    /// Told of one result after the other; returns the time until which it wants to hear of more: what begins
    /// later is left out. t_max changes nothing, a negative number or NaN ends the query. No result is kept:
    /// a visit takes bounded memory. It returns a time before which nothing begins that was left undecided
    /// because max_tests ran out; infinity where that did not happen.
    template <class Result> using VisitorOf = std::function<double(const Result&)>;
    using Visitor = VisitorOf<Impact>;
    /// Whether two bodies, a < b, may meet at all. Called from several threads; must always answer the same.
    using PairFilter = std::function<bool(BodyId a, BodyId b)>;

    Scene();
    ~Scene();
    Scene(Scene&&) noexcept;
    Scene& operator=(Scene&&) noexcept;

    BodyId add(const Body&);
    void replace(BodyId, const Body&);
    void remove(BodyId);
    void set_motion(BodyId, const Motion&);
    /// bodies[i] moves as motions[i] from now on; of the same length, no body twice. All or, if one is
    /// invalid, none.
    void set_motions(std::span<const BodyId> bodies, std::span<const Motion> motions);
    /// Makes the body stand still at the start of its motion, and sleep.
    void sleep(BodyId);
    void wake(BodyId);
    /// An empty one lets all pairs meet.
    void set_filter(PairFilter);

    std::size_t size() const;
    bool contains(BodyId) const;
    const Body& body(BodyId) const;
    /// Its bounds over the whole step as the broad phase holds them: rounded outwards to float, and with room
    /// for rounding. All of space where nothing smaller is known.
    Aabb swept_bounds(BodyId);

    /// Brings the bounds of what has changed up to date. Every query does it first; by itself it is of use to
    /// measure, or to do that work early.
    void update();

    /// The earliest of all impacts; of those at the same time, that of the lowest ids. Where there is none,
    /// toi.status is separated; undecided, at a time before which no two bodies touch, where that of the pair
    /// is or where max_tests ran out.
    Impact first_impact(const SceneOptions& = {});

    /// The first impact of every pair that has one.
    Impacts impacts(const SceneOptions& = {});
    /// The same one by one, in no particular order (but always the same).
    double visit_impacts(const Visitor&, const SceneOptions& = {});

    /// For every body, by id: a time such that, when each follows its motion until then and stands still at
    /// Motion::at of it from then on, no two bodies overlap until t_max. A body halts where it first meets
    /// another, moving or halted; of contacts at the same time all count, even where a halt at that very time
    /// would have left one open. Bodies in contact at the start follow options.pair.start_contact. Unlike
    /// the other queries it says nothing closer than the rounding of Motion::at. Valid until the next query.
    std::span<const SafeTime> safe_times(const SceneOptions& = {});
    /// The bodies that halt before t_max, as they do: by time. Those that were not told of may all move on
    /// until the last that was; what max_tests leaves open halts too. Whatever the number of pairs, halts
    /// take memory in proportion to the bodies, here and above.
    void visit_safe_times(const VisitorOf<SafeTime>&, const SceneOptions& = {});

    /// The first of the impacts that a moving shape would have as a body of the scene.
    Impact cast(const Shape&, const Motion&, const SceneOptions& = {});
    /// All of them.
    Impacts cast_all(const Shape&, const Motion&, const SceneOptions& = {});
    /// The same one by one, in no particular order (but always the same).
    double visit_cast(const Shape&, const Motion&, const Visitor&, const SceneOptions& = {});

    /// The pairs that overlap at t = 0; touching is overlapping.
    Overlaps overlapping(const SceneOptions& = {});
    /// The same one by one, in no particular order (but always the same). All begin at 0.
    double visit_overlapping(const VisitorOf<BodyPair>&, const SceneOptions& = {});
    /// What a broad phase alone hands on, in no particular order (but always the same): the pairs whose
    /// bounds meet. Planes and half-spaces are told apart from others by the balls.
    std::span<const BodyPair> candidates(Bounds = Bounds::boxes);

    /// The first body at t = 0 that the ray meets (of equals the lowest id), t in lengths of `direction`;
    /// hit.status is separated where there is none; undecided, at a t before which it meets none, where
    /// max_tests ran out.
    RayImpact ray_cast(const Vec3& origin, const Vec3& direction, double t_max = 1, const SceneOptions& = {});
    /// All of them.
    RayImpacts ray_cast_all(const Vec3& origin, const Vec3& direction, double t_max = 1,
                            const SceneOptions& = {});
    /// The same one by one, in no particular order (but always the same).
    double visit_ray(const Vec3& origin, const Vec3& direction, const VisitorOf<RayImpact>&, double t_max = 1,
                     const SceneOptions& = {});

    /// What the last query did.
    const Ledger& ledger() const;
    /// Bytes that the broad phase holds beside the bodies themselves; with the table of ids, four for each
    /// ever given, that there is once a body was added after another was removed.
    std::size_t broad_phase_bytes() const;

private:
    std::unique_ptr<SceneData> data_;
};

} // namespace brink
