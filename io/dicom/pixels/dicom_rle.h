// DICOM's RLE Lossless (PS3.5 annex G): PackBits segments, one for each byte of each sample.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace echolucent {

/// Checks that `bytes` bytes can hold a frame of this size: behind the header, two bytes make 128 at most. Gives an
/// empty text, or says what is wrong.
[[nodiscard]] std::string rleTooShort(std::size_t bytes, std::size_t pixels, int samples, int bytesPerSample);

/// The bytes of each sample that the header of an RLE frame declares by its number of segments: `bytesPerSample`, or 1
/// or 2 if that many belong to it. `data` may be shorter than a header.
[[nodiscard]] int rleBytesPerSample(std::span<const std::uint8_t> data, int samples, int bytesPerSample);

/// Decodes one frame into planes, sample after sample, each value in little-endian order. Gives an empty text, or says
/// what is wrong with the data. out.size() must be pixels * samples * bytesPerSample.
[[nodiscard]] std::string decodeRle(std::span<const std::uint8_t> data, std::size_t pixels, int samples,
                                    int bytesPerSample, std::span<std::uint8_t> out);

}  // namespace echolucent
