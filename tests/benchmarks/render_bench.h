// The measurements of echolucent-bench-render, each a part of its report.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/benchmarks/bench_scene.h"

namespace echolucent::bench {

struct BenchPlan {
    int threads = 2;            ///< of oneTBB and of VTK's mapper
    int repeats = 9;            ///< of which medians are taken; VTK's slow frames get three
    bool quick = false;         ///< a small phantom, small pictures, few rows: to see that it works
    std::string cacheFolder;    ///< of references
    std::string pictureFolder;  ///< ours and VTK's side by side as PNG; empty: none
    std::vector<int> sizes{512, 1024};
    int errorSize = 512;  ///< pixels of the pictures whose error is measured
};

/// Each returns the rows of one part, as objects; keys in docs/performance.md.

/// Whether both cast the same rays through the same places: see docs/performance.md, "The same rays".
[[nodiscard]] nlohmann::ordered_json registrationOf(const BenchPlan& plan);
/// Every volume, curve, size, unshaded and shaded: ours beside VTK's CPU mapper.
[[nodiscard]] nlohmann::ordered_json renderRows(const BenchPlan& plan, const std::vector<BenchVolume>& volumes);
/// A few of them with VTK's GPU mapper on whatever OpenGL is there; `openGl` becomes its name.
[[nodiscard]] nlohmann::ordered_json gpuRows(const BenchPlan& plan, const std::vector<BenchVolume>& volumes,
                                             std::string& openGl);
/// From 64^3 to 512^3 voxels, the same picture.
[[nodiscard]] nlohmann::ordered_json growthRows(const BenchPlan& plan);
/// On 1, 2, ... all threads, the same picture.
[[nodiscard]] nlohmann::ordered_json threadRows(const BenchPlan& plan, const BenchVolume& volume);
/// Ours alone: whole pictures, OTF edits, and levels of quality, as frames a second.
[[nodiscard]] nlohmann::ordered_json frameRateRows(const BenchPlan& plan, const BenchVolume& volume);

}  // namespace echolucent::bench
