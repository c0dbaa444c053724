// The parts of a report's rows.
#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "processing/ray_caster/ray_caster.h"
#include "tests/benchmarks/bench_scene.h"
#include "tests/benchmarks/measured_cost.h"
#include "tests/benchmarks/plain_reference.h"

namespace echolucent::bench {

/// Adds WHO_cpu_ms and WHO_wall_ms.
inline void addCost(nlohmann::ordered_json& row, const std::string& who, const Cost& cost) {
    row[who + "_cpu_ms"] = cost.cpuMs;
    row[who + "_wall_ms"] = cost.wallMs;
}

/// Adds cpu_ratio and wall_ratio: theirs divided by ours.
inline void addRatios(nlohmann::ordered_json& row, const Cost& ours, const Cost& theirs) {
    row["cpu_ratio"] = theirs.cpuMs / ours.cpuMs;
    row["wall_ratio"] = theirs.wallMs / ours.wallMs;
}

/// Adds WHO_rmse and WHO_max over the rays that meet the volume, WHO_rmse_picture and WHO_max_picture over all pixels.
inline void addError(nlohmann::ordered_json& row, const std::string& who, const PictureError& error) {
    row[who + "_rmse"] = error.rmse;
    row[who + "_max"] = error.largest;
    row[who + "_rmse_picture"] = error.rmseWhole;
    row[who + "_max_picture"] = error.largestWhole;
}

/// A caster, and the cost of making it: all that depends on the volume only.
struct PreparedCaster {
    std::optional<RayCaster> caster;
    Cost cost;
    explicit PreparedCaster(const std::shared_ptr<const Volume>& volume) {
        cost = costOf([&] { caster.emplace(volume); });
    }
};

/// VTK's CPU mapper ends a ray if less of the light is left than 0xff of 0x7fff.
inline constexpr double vtkEndTransmittance = 255.0 / 32767.0;

/// The look has step 1, trilinear interpolation and sepia. Rays end where VTK's do. If it is shaded, it is shaded as in
/// the program.
inline RayCastSettings lookOf(bool shaded) {
    RayCastSettings look;
    look.terminationTransmittance = vtkEndTransmittance;
    if (shaded) look.shading = Shading{};
    return look;
}

}  // namespace echolucent::bench
