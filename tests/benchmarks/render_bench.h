// The measurements of echolucent-bench-render, each a part of its report.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tests/benchmarks/bench_scene.h"

namespace echolucent::bench {

struct BenchPlan {
    int threads = 2;            ///< threads of oneTBB and of VTK's mapper
    int repeats = 9;            ///< for medians; VTK's slow frames get three
    bool quick = false;         ///< only shows that it works, with a small phantom, small pictures and few rows
    std::string cacheFolder;    ///< where references are kept
    std::string pictureFolder;  ///< for PNGs of ours and VTK's side by side; empty: none are kept
    std::vector<int> sizes{512, 1024};
    int errorSize = 512;  ///< pixels of the pictures whose error is measured
};

/// Each function returns the rows of one part, as objects. docs/performance.md lists their keys.

/// Whether both cast the same rays through the same places; see docs/performance.md, "The same rays".
[[nodiscard]] nlohmann::ordered_json registrationOf(const BenchPlan& plan);
/// Every volume, curve, size, unshaded and shaded: ours beside VTK's CPU mapper.
[[nodiscard]] nlohmann::ordered_json renderRows(const BenchPlan& plan, const std::vector<BenchVolume>& volumes);
/// A few of them with VTK's GPU mapper on any OpenGL that is there. `openGl` is set to its name.
[[nodiscard]] nlohmann::ordered_json gpuRows(const BenchPlan& plan, const std::vector<BenchVolume>& volumes,
                                             std::string& openGl);
/// The same picture of volumes from 64^3 to 512^3 voxels.
[[nodiscard]] nlohmann::ordered_json growthRows(const BenchPlan& plan);
/// The same picture on one thread, on two, and so on up to all threads.
[[nodiscard]] nlohmann::ordered_json threadRows(const BenchPlan& plan, const BenchVolume& volume);
/// Ours alone: pictures of each quality, and edits of the OTF, as frames a second.
[[nodiscard]] nlohmann::ordered_json frameRateRows(const BenchPlan& plan, const BenchVolume& volume);

}  // namespace echolucent::bench
