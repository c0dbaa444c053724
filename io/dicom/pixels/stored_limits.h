// Limits decoded samples to the stored bits that the data set declares, so that larger values do not wrap.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "io/dicom/pixels/dicom_grey.h"
#include "io/dicom/pixels/jpeg2000.h"

namespace echolucent {

/// Limits right-aligned samples of format.bytesPerSample() bytes each, in this machine's byte order. `codedBits` is
/// how many bits of a sample the codestream declares; those above repeat the sign or are 0. A sample beyond the stored
/// bits of `format` becomes the nearest value that they can hold. Returns how many did not fit.
std::size_t limitToStoredBits(const DicomPixelFormat& format, std::span<std::uint8_t> samples, int codedBits);

/// Writes decoded JPEG 2000 values into `out`, in the form that limitToStoredBits() takes. A value beyond the stored
/// bits becomes the nearest that they can hold; so does a negative value of unsigned pixels. The bits of an unsigned
/// codestream mean signed values if the data set says so. Returns how many did not fit.
std::size_t storeLimited(const DicomPixelFormat& format, const Jpeg2000Samples& samples,
                         std::vector<std::uint8_t>& out);

}  // namespace echolucent
