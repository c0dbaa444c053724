// Whether uncompressed pixels are as many bytes as a data set describes, and in what order they lie.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "io/dicom/pixels/dicom_grey.h"

namespace echolucent {

/// Fills the span with bytes of the uncompressed pixels from this one on; false if they cannot be read.
using ReadPixelBytes = std::function<bool(std::uint64_t from, std::span<std::uint8_t> bytes)>;

/// What is wrong if `held` bytes of uncompressed pixels are too few for `format`, or too many; else no value. Left over
/// may be up to a 32nd of a frame, at least one byte. Less than a frame may be left over if all these bytes, which
/// `read` gives, are 0, or all are 255. They may not be as many as if each of several frames lacked whole rows or
/// columns. If more than one byte is left over, a note is added to `format`.
/// The layout of YBR pixels is set as their length says, with a note if that is not what their name says: 4:4:4 under a
/// name of 4:2:2, 4:2:2 under a name of 4:4:4, and rows of 4:2:2 of which each ends with half a pair.
[[nodiscard]] std::optional<PixelFormatProblem> wrongPixelBytes(DicomPixelFormat& format, std::uint64_t held,
                                                                const ReadPixelBytes& read);

}  // namespace echolucent
