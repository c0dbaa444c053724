// The simulated scans of the studies, with what is true of them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/measuring/measures/detection_quality.h"
#include "app/measuring/measures/phantom_conditions.h"
#include "processing/adaptive/method_reading.h"
#include "processing/adaptive/quiet_reading.h"
#include "processing/comparison/surface_contrast.h"
#include "processing/phantom/phantom.h"

namespace echolucent::cli {

/// The options --seeds and --size: over which phantoms a study is made.
struct PhantomChoice {
    std::string seeds = "1,2", size;
    void addTo(CLI::App& command);
    /// The shapes of a seed, of the size asked for. Fails (wrong usage) where an option makes no sense.
    [[nodiscard]] Result<std::vector<PhantomConfig>> bases() const;
};

/// A scan of its usual extent on a grid of `edge` voxels each way; on its usual grid where `edge` is 0.
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

/// The curves that the adaptive one is compared with: x^2, and eq. 1 with L_L = 20/255 and a = 0.5.
[[nodiscard]] OpacityCurve parabolaCurve();
[[nodiscard]] OpacityCurve linearCurve();

inline constexpr std::array<MethodReading, 3> allReadings{MethodReading::asPublished, MethodReading::settled,
                                                          MethodReading::standard};
/// The curves whose contrast is measured: parabolaCurve(), linearCurve(), and the adaptive curves of allReadings. The
/// adaptive ones are meant for the voxels that are shown.
[[nodiscard]] std::vector<OpacityCurve> contrastCurvesOf(const Volume& volume, const Viewpoint& view,
                                                         const QuietVoxels& shown = {});
/// Their names, in the same order.
[[nodiscard]] std::vector<std::string> contrastCurveNames();

/// CNR_S of each of these curves, on voxels made quiet by this reduction.
[[nodiscard]] std::vector<std::optional<double>> contrastsOf(const StudyPhantom& phantom, const Viewpoint& view,
                                                             SpeckleReduction reduction = SpeckleReduction::off);

/// The mean of those values that are there; nothing where none is.
[[nodiscard]] std::optional<double> meanOf(const std::vector<std::optional<double>>& values);

}  // namespace echolucent::cli
