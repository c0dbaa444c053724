// The simulated scans of the studies, and their truth.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/measuring/measures/detection_quality.h"
#include "app/measuring/measures/phantom_conditions.h"
#include "processing/adaptive/method_reading.h"
#include "processing/adaptive/quiet_reading.h"
#include "processing/classification.h"
#include "processing/comparison/surface_rays.h"
#include "processing/phantom/phantom.h"
#include "processing/result.h"

namespace CLI {
class App;
}  // namespace CLI

namespace echolucent::cli {

/// The options --seeds and --size: the phantoms of a study.
struct PhantomChoice {
    std::string seeds = "1,2", size;
    void addTo(CLI::App& command);
    /// The scene `shapes` for each seed, in the wanted size. Fails (wrong usage) if an option makes no sense.
    [[nodiscard]] Result<std::vector<PhantomConfig>> bases() const;
};

/// A scan of its usual extent, on a grid of `edge` voxels each way. If `edge` is 0, on its usual grid.
[[nodiscard]] PhantomConfig scaledPhantom(PhantomScene scene, int edge);

/// A view away from every grid axis, so that samples lie between voxel centres.
inline const Viewpoint obliqueView{.azimuthDegrees = 20, .elevationDegrees = -12};

/// The six conditions of CNR_S (docs/experiments.md, "The curve"): base, specular, little_speckle, attenuation_shadow,
/// hard_full_speckle, hard_log_compressed.
[[nodiscard]] std::vector<NamedPhantom> contrastConditions(const PhantomConfig& base);

/// One volume with its truth.
struct StudyPhantom {
    PhantomConfig config;
    PhantomTruth truth;
    Volume volume;
    explicit StudyPhantom(const PhantomConfig& given) : config(given), truth(given), volume(*makePhantom(given)) {}
};

/// The curves to compare the adaptive one with: x^2, and eq. 1 with L_L = 20/255 and a = 0.5.
[[nodiscard]] OpacityCurve parabolaCurve();
[[nodiscard]] OpacityCurve linearCurve();

inline constexpr std::array<MethodReading, 3> allReadings{MethodReading::asPublished, MethodReading::settled,
                                                          MethodReading::standard};
/// The curves whose contrast is measured: parabolaCurve(), linearCurve(), and the adaptive curves of allReadings, made
/// for the shown voxels.
[[nodiscard]] std::vector<Classification> contrastCurvesOf(const Volume& volume, const Viewpoint& view,
                                                           const QuietVoxels& shown = {});
/// The names of the curves of contrastCurvesOf(), in their order.
[[nodiscard]] std::vector<std::string> contrastCurveNames();

/// The mean of the known values; no value if none is known.
[[nodiscard]] std::optional<double> meanOf(const std::vector<std::optional<double>>& values);

}  // namespace echolucent::cli
