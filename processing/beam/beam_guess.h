// The grid axis along which sound travelled: from the file, else from the shape of the scanned sector, else from the
// echo.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "processing/progress.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// What a beam axis rests on.
enum class BeamEvidence {
    none,         ///< nothing clearly points to one axis
    sectorShape,  ///< the data widen away from the probe between straight edges
    echo,         ///< the echo falls with depth, altogether or within one tissue, or shadows lie behind bright places
    file,         ///< the file says where the probe was (VolumeGeometry::probe): nothing was guessed
};
/// "none", "sector shape", "echo", "file".
[[nodiscard]] std::string_view nameOf(BeamEvidence evidence);

struct BeamGuess {
    BeamAxis axis = BeamAxis::plusZ;  ///< the likeliest axis if sure; else +z, the default
    BeamEvidence evidence = BeamEvidence::none;
    /// Of the best lead, [0,1]. If not sure, at most the least confidence of a sure guess.
    double confidence = 0.0;
    bool sure = false;       ///< whether the axis may be taken without asking
    std::string sentence{};  ///< for a person: what was found
    friend bool operator==(const BeamGuess&, const BeamGuess&) = default;
};

/// The beam axis of a volume: the axis nearest to the probe's direction in the file, else a guess (docs/beam.md says
/// how, and when it is unsure). A guess costs about one pass over the voxels. It is the same for any number of threads.
/// The result is empty only if the work was cancelled.
[[nodiscard]] std::optional<BeamGuess> guessBeamAxis(const Volume& volume, const Progress& progress = {});

}  // namespace echolucent
