// Where the probe was, where no file says it: the beam axis from the shape of the scanned sector, else from the echo.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "processing/progress.h"
#include "processing/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// What a guess of the beam axis rests on.
enum class BeamEvidence {
    none,         ///< nothing speaks clearly for one axis
    sectorShape,  ///< the data widen away from the probe between straight edges
    echo,         ///< the echo of one tissue falls with depth, or shadows lie behind bright places
};
/// "none", "sector shape", "echo".
[[nodiscard]] std::string_view nameOf(BeamEvidence evidence);
[[nodiscard]] std::optional<BeamEvidence> beamEvidenceFromName(std::string_view name);

/// The grid axis along which sound seems to have travelled.
struct BeamGuess {
    BeamAxis axis = BeamAxis::plusZ;  ///< the likeliest; +z, the default, where `sure` is false
    BeamEvidence evidence = BeamEvidence::none;
    double confidence = 0.0;  ///< [0,1]; that of the best lead, also where it is not enough
    bool sure = false;        ///< whether the axis may be taken without asking
    std::string sentence{};   ///< what was found, for the person
    friend bool operator==(const BeamGuess&, const BeamGuess&) = default;
};

/// Guesses the beam axis of a volume (docs/beam.md says how, and when it is unsure). It costs about one pass over the
/// voxels, and is the same for any number of threads. The result is empty only where the run was cancelled.
[[nodiscard]] std::optional<BeamGuess> guessBeamAxis(const Volume& volume, const Progress& progress = {});

}  // namespace echolucent
