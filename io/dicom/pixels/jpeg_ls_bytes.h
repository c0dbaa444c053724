// JPEG-LS frames of bytes in data sets of words.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "io/dicom/pixels/dicom_grey.h"

class DcmDataset;

namespace echolucent {

/// Decodes a JPEG-LS frame of at most 8 bits into `out`, a byte a sample, although its data set allocates 16: the
/// library is given one that allocates 8. False if a part of the frame is missing or damaged.
[[nodiscard]] bool decodeJpegLsBytes(DcmDataset& dataset, const DicomPixelFormat& format,
                                     const std::vector<std::uint8_t>& data, std::span<std::uint8_t> out);

}  // namespace echolucent
