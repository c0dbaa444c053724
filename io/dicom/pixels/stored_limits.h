// Decoded samples against the stored bits that the data set declares: what does not fit must not wrap.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "io/dicom/pixels/dicom_grey.h"
#include "io/dicom/pixels/jpeg2000.h"

namespace echolucent {

/// Takes right-aligned samples of format.bytesPerSample() bytes, each in this machine's byte order, that the stored
/// bits of `format` cannot hold as the largest that they can; samples whose upper bits repeat the sign fit. Returns how
/// many did not fit.
std::size_t limitToStoredBits(const DicomPixelFormat& format, std::span<std::uint8_t> samples);

/// Writes decoded JPEG 2000 values into `out` as limitToStoredBits() takes them; those that the stored bits cannot
/// hold, negative ones of unsigned pixels among them, as the nearest that they can. Bits of an unsigned codestream mean
/// signed values where the data set says so. Returns how many did not fit.
std::size_t storeLimited(const DicomPixelFormat& format, const Jpeg2000Samples& samples,
                         std::vector<std::uint8_t>& out);

}  // namespace echolucent
