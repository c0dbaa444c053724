// Along which grid axis sound travelled: what the file says, else what the shape of the scanned sector says, else what
// the echo says.
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
    none,         ///< nothing speaks clearly for one axis
    sectorShape,  ///< the data widen away from the probe between straight edges
    echo,         ///< the echo of one tissue falls with depth, or shadows lie behind bright places
    file,         ///< the file says where the probe was (VolumeGeometry::probe): nothing was guessed
};
/// "none", "sector shape", "echo", "file".
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

/// The beam axis of a volume: the one nearest to what its file says of the probe, else a guess (docs/beam.md says how,
/// and when it is unsure). A guess costs about one pass over the voxels, and is the same for any number of threads. The
/// result is empty only where the run was cancelled.
[[nodiscard]] std::optional<BeamGuess> guessBeamAxis(const Volume& volume, const Progress& progress = {});

}  // namespace echolucent
