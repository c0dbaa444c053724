// Recognises 2D frames that a MetaImage, an NRRD or a NIfTI stores like the slices of a volume: cines and tracked
// sweeps.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "io/stored/stored_volume.h"

namespace echolucent {

/// The words of a header about its axes and frames.
struct FrameWords {
    std::array<std::string, 3> kinds;  ///< of x, y and z, in lower case: "domain", "list", "time"; empty if not stated
    std::string kindsKey;              ///< "Kinds", "kinds"
    std::vector<std::string> keys;     ///< all keys of the header; those like Seq_Frame0000_ProbeToTrackerTransform
                                       ///< tell of frames
};

/// Whether an axis of this kind (lower case, as NRRD names them) may belong to a volume or its phases: space, time, a
/// list, or no kind. Vectors, colours, matrices and all others may not.
[[nodiscard]] bool mayBeAxisOfVolume(std::string_view kind);

/// Decides whether `stored` (with its size, spacing and phases) holds frames, not a volume: one slice over time, an
/// axis of kind time, or keys of several frames in a header of one phase. If so, it fails (unreadable, with
/// Failure::framesCouldBeSlices) and says the way out. But if `framesAsSlices` is set, the frames become slices at an
/// unknown distance. An axis of kind list alone makes the spacing unknown, with a note, because true volumes have such
/// axes too. A probe that was tracked over the phases of a volume is noted.
[[nodiscard]] Result<void> settleFrames(StoredVolume& stored, const FrameWords& words, bool framesAsSlices);

}  // namespace echolucent
