// How the fragments of encapsulated Pixel Data are coded, by their own bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace echolucent {

/// Bytes of a fragment's beginning that tell its coding: the header of RLE, or the markers of a JPEG file.
inline constexpr std::size_t fragmentBeginning = 4096;

/// The number in the first four bytes, which must be there, the lowest byte first.
[[nodiscard]] std::uint32_t littleEndian32(std::span<const std::uint8_t> bytes);

/// Whether a fragment begins with the header of an RLE frame: 1 to 15 segments that follow each other from byte 64 on.
[[nodiscard]] bool beginsWithRleHeader(std::span<const std::uint8_t> bytes);

/// The transfer syntax (UID) that the first fragment's beginning shows: RLE, JPEG, JPEG-LS or JPEG 2000. Empty if the
/// bytes begin like none of them.
[[nodiscard]] std::string syntaxOfFragment(std::span<const std::uint8_t> bytes);

}  // namespace echolucent
