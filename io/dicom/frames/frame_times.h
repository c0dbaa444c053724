// When a DICOM data set says that its frames or its volumes were acquired.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "io/dicom/elements/dicom_attributes.h"

class DcmItem;

namespace echolucent {

/// Frame Increment Pointer, which names the attributes that change from frame to frame.
inline constexpr DicomTag incrementPointerTag{0x0028, 0x0009};

/// Times of phases that attributes state.
struct DicomTimes {
    std::vector<double> seconds;  ///< one a phase, strictly rising
    std::string source;           ///< the attributes that state them
};

/// Whether Frame Increment Pointer names Frame Time or Frame Time Vector.
[[nodiscard]] bool framesFollowInTime(DcmItem& dataset);
/// Whether Frame Time, Frame Time Vector or Cine Rate (0018,0040) is stated, whatever the pointer names.
[[nodiscard]] bool statesFrameTime(DcmItem& dataset);
/// Whether Frame Increment Pointer names this attribute, alone or among others.
[[nodiscard]] bool namesAsIncrement(DcmItem& dataset, DicomTag tag);

/// The times of `count` phases `step` seconds apart, from 0 s on.
[[nodiscard]] DicomTimes evenTimes(double step, std::size_t count, std::string source);

/// The times of `count` frames, at least 2. Each frame is a phase, and the first is at 0 s. The times are those of
/// Frame Time Vector (0018,1065), else of Frame Time (0018,1063); if the pointer names Frame Time, it comes first. No
/// value if neither makes sense for that number of frames.
[[nodiscard]] std::optional<DicomTimes> statedFrameTimes(DcmItem& item, std::size_t count);

/// The same by the rate at which the frames were acquired or shall be shown: Cine Rate (0018,0040), else Recommended
/// Display Frame Rate (0008,2144).
[[nodiscard]] std::optional<DicomTimes> statedFrameRate(DcmItem& item, std::size_t count);

}  // namespace echolucent
