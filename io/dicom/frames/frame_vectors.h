// The vectors that order the frames of nuclear medicine and of files like it: slices, times, and what is neither.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/dicom/frames/frame_times.h"
#include "processing/result.h"

class DcmItem;

namespace echolucent {

/// The vectors of nuclear medicine: attributes that hold a number of 16 bits for each frame.
[[nodiscard]] std::vector<DicomTag> frameVectorTags();

/// The order of frames by the vectors that Frame Increment Pointer (0028,0009) names.
struct FrameVectors {
    /// In the order of time; frames from 0, in that of Slice Vector. Empty if no vector orders the frames.
    std::vector<std::vector<std::size_t>> phases;
    std::string source;               ///< the vectors that tell phases apart; empty for one phase
    std::optional<DicomTimes> times;  ///< of several phases
    std::vector<std::string> warnings;
};

/// Splits the frames of a file into phases of slices by Slice Vector (0054,0080) and the vectors of time: Time Slot
/// (0054,0070), Phase (0054,0030) and Time Slice (0054,0100). Where Frame Increment Pointer is missing, the vectors
/// that are there count. Left out with a note are vectors that the pointer names and that are missing, and vectors that
/// are not one number for each frame without being named. Slices that are counted in even steps are noted. Fails
/// (unreadable, about the file at `path`, with Failure::framesCouldBeSlices) if a named vector is not one number for
/// each frame; if the frames differ in energy window, detector, R-R interval, rotation or angular view, as no frames of
/// one volume do; if they show one slice over time; or if a time has slices twice, or others than the first time.
[[nodiscard]] Result<FrameVectors> readFrameVectors(DcmItem& dataset, const std::string& path, std::size_t frames);

}  // namespace echolucent
