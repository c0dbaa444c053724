// The qualities of the 3D view's pictures, all in this place.
#pragma once

#include <array>
#include <cstddef>

#include "processing/picture/converged.h"
#include "processing/picture/ray_cast_settings.h"

namespace echolucent {

/// What a picture saves.
struct Quality {
    const char* name;        ///< in English, for the status line
    double reduction = 1.0;  ///< of width and height, >= 1: one ray for reduction^2 pixels
    double step = 1.0;       ///< between samples, times the step of the picture's look (Look::step)
    bool atRest = false;     ///< shown on the way to the converged picture when the hand rests
    double terminationTransmittance = 1.0 / 128;  ///< as in RayCastSettings
    double pixelTolerance = 0.5;                  ///< as in RayCastSettings
    friend bool operator==(const Quality&, const Quality&) = default;
};

/// From fine to coarse: each costs less than the one before. The first is the converged picture, which is saved. While
/// the hand moves, the finest within the frame budget is shown (PreviewQuality). At rest all finer ones marked atRest
/// follow, one after another.
///
/// Errors, in grey levels of 255, of the worst of two phantoms and two curves at 512 x 512 (docs/performance.md,
/// "Pictures a second"): converged RMSE 0.1 and 1 at most; high quality 0.7 and 6; a preview of all rays 1.0 and 13 at
/// step 1, and 2.1 and 24 at 1.5. Previews drop rays before they lengthen steps: with steps of 2 units or more, the
/// steep curve of quiet voxels shows rings. docs/rendering.md gives the reasons for these settings.
inline constexpr std::array<Quality, 11> qualities{{
    {"converged", 1.0, convergedStep, true, convergedTransmittance, 0.0},
    {"high quality", 1.0, 0.75, true},
    {"preview", 1.0, 1.0},
    {"preview", 1.0, 1.5},
    {"preview", 1.5, 1.5},
    {"preview", 2.0, 1.5},
    {"preview", 2.5, 1.5},
    {"preview", 3.0, 1.5},
    {"preview", 4.0, 1.5},
    {"preview", 6.0, 2.0},
    {"preview", 8.0, 3.0},
}};
inline constexpr std::size_t convergedQuality = 0;
/// The quality of the kept frames of a motion.
inline constexpr std::size_t highQuality = 1;
/// The quality of a graphics card's pictures in motion: every pixel, and light half as fine as at rest.
inline constexpr std::size_t qualityForCard = 2;
/// The quality of pictures in motion until something is measured.
inline constexpr std::size_t firstQuality = 7;

/// The settings of a picture at a quality. `asked`: the settings of the look, at the view's full size and the look's
/// own step.
[[nodiscard]] RayCastSettings settingsAt(std::size_t quality, const RayCastSettings& asked);

/// The next finer quality that is shown at rest. There is none for convergedQuality, which must not be asked for.
[[nodiscard]] std::size_t nextAtRest(std::size_t quality);

}  // namespace echolucent
