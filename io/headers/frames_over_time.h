// 2D frames that a MetaImage, an NRRD or a NIfTI stores as if they were the slices of a volume: cines and tracked
// sweeps.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "io/stored/stored_volume.h"

namespace echolucent {

/// What a header says of its axes and frames.
struct FrameWords {
    std::array<std::string, 3> kinds;  ///< of x, y and z, in lower case: "domain", "list", "time"; empty where not said
    std::string kindsKey;              ///< "Kinds", "kinds"
    std::vector<std::string> keys;     ///< all keys of the header, of which Seq_Frame0000_ProbeToTrackerTransform and
                                       ///< the like tell of frames
};

/// Whether an axis of that kind (lower case, as NRRD names them) may be one of a volume's, over time or not: space,
/// time, a list, or nothing that is said. Vectors, colours, matrices and all other kinds are none.
[[nodiscard]] bool mayBeAxisOfVolume(std::string_view kind);

/// Settles whether `stored` (its size, spacing and phases are read) holds frames, not a volume: one slice over time, an
/// axis of kind time, or keys of several frames along z. Fails (unreadable) where it
/// does, with the way out, unless `framesAsSlices` is set: then the frames become slices whose distance is unknown. An
/// axis of kind list alone, which true volumes carry too, makes the spacing unknown, with a note.
[[nodiscard]] Result<void> settleFrames(StoredVolume& stored, const FrameWords& words, bool framesAsSlices);

}  // namespace echolucent
