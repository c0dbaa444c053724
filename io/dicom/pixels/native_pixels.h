// Whether uncompressed pixels are as many bytes as a data set describes, and in what order they lie.
#pragma once

#include <cstdint>
#include <optional>

#include "io/dicom/pixels/dicom_grey.h"

namespace echolucent {

/// What is wrong if `held` bytes of uncompressed pixels are too few for `format`, or too many; else no value. Left over
/// may be up to a 32nd of a frame, at least one byte. If more than one byte is left over, a note is added to `format`.
/// The layout of YBR pixels is set as their length says, with a note if that is not what their name says: 4:4:4 under a
/// name of 4:2:2, 4:2:2 under a name of 4:4:4, and rows of 4:2:2 of which each ends with half a pair.
[[nodiscard]] std::optional<PixelFormatProblem> wrongPixelBytes(DicomPixelFormat& format, std::uint64_t held);

}  // namespace echolucent
