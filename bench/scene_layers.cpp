// SPDX-License-Identifier: BSD-3-Clause
#include "scene_run.h"
#include "scene_threads.h"

#include <array>

namespace brink::bench {
namespace {

constexpr std::uint64_t seed = 20261122;
constexpr double too_long = 30; // seconds, of one query

struct NamedLayer {
    std::string_view name;
    Layers layers;
};

/// Not mask and filter: what they remove depends on the user's alone, and no scene here has any.
constexpr std::array<NamedLayer, 8> switched{{{"nothing", {}},
                                              {"immovable", Layer::immovable},
                                              {"asleep", Layer::asleep},
                                              {"bounds", Layer::bounds},
                                              {"receding", Layer::receding},
                                              {"spheres", Layer::spheres},
                                              {"late", Layer::late},
                                              {"simd", Layer::simd}}};

/// The scene, warm.
Scene scene_of(std::string_view name, std::size_t n)
{
    Scene scene;
    for (const Body& body : support::in_spatial_order(support::draw_scene(name, n, seed)).bodies)
        scene.add(body);
    scene.impacts();
    return scene;
}

LayerFigures measure(Scene& scene, Layers without)
{
    SceneOptions options;
    options.without = without;
    LayerFigures f;
    std::vector<double> impacts, first;
    double spent = 0;
    for (int i = 0; i < 7 && (i == 0 || spent < 2); ++i) {
        impacts.push_back(1e3 * time_of([&] { scene.impacts(options); }));
        f.impacts_exact = scene.ledger().exact;
        first.push_back(1e3 * time_of([&] { scene.first_impact(options); }));
        f.first_exact = scene.ledger().exact;
        spent += 1e-3 * (impacts.back() + first.back());
    }
    f.impacts_ms = median(impacts);
    f.first_ms = median(first);
    return f;
}

} // namespace

std::vector<LayerFigures> measure_layers(std::string_view name, std::size_t n)
{
    std::vector<LayerFigures> all;
    with_threads(1, [&] {
        Scene small = scene_of(name, std::max<std::size_t>(n / 10, 1));
        Scene scene = scene_of(name, n);
        for (const NamedLayer& layer : switched) {
            // A tenth of the bodies have a hundredth of the pairs, where it comes to all of them.
            const LayerFigures tenth = measure(small, layer.layers);
            LayerFigures f;
            if (tenth.impacts_ms * 100 > 1e3 * too_long)
                f.skipped = true;
            else
                f = measure(scene, layer.layers);
            f.scene = name;
            f.without = layer.name;
            f.n = n;
            all.push_back(f);
        }
    });
    return all;
}

} // namespace brink::bench
