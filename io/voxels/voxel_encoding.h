// Decodes the bytes of voxels from the encodings that files use.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "io/voxels/voxel_types.h"

namespace echolucent {

/// `zlib` is zlib or gzip; the bytes tell which. `text` is decimal numbers between white space and commas, `hex` two
/// hexadecimal digits for each byte.
enum class VoxelEncoding { raw, zlib, bzip2, text, hex };

/// The compression in words, for the import report: "none", "zlib/gzip, lossless", "none, written as decimal text".
[[nodiscard]] std::string_view compressionWords(VoxelEncoding encoding);
/// Whether a few encoded bytes may stand for almost any number of bytes.
[[nodiscard]] bool isCompressed(VoxelEncoding encoding);

/// Whether a byte separates numbers that are written as text.
[[nodiscard]] bool separatesNumbers(std::uint8_t byte);

/// Decodes a stream of bytes piece by piece.
class VoxelDecoder {
public:
    /// The result of one step.
    struct Step {
        std::size_t taken = 0;  ///< bytes of the input used up
        std::size_t given = 0;  ///< bytes of the output filled
        bool ended = false;     ///< whether the stream has ended
    };
    /// What is wrong with the bytes: "has damaged compressed data", "a block cannot be decoded".
    struct Problem {
        std::string what;
        std::string detail;
    };

    virtual ~VoxelDecoder() = default;
    /// Decodes as much of `input` as it can into `output`, which holds whole values. `isLast` means that no more input
    /// follows.
    [[nodiscard]] virtual tl::expected<Step, Problem> decode(std::span<const std::uint8_t> input, bool isLast,
                                                             std::span<std::uint8_t> output) = 0;
};

/// The decoder of an encoding; null for `raw`. Text becomes values of `type` in this machine's byte order; with
/// `decimalCommas`, its commas stand for points and separate no numbers.
[[nodiscard]] std::unique_ptr<VoxelDecoder> makeVoxelDecoder(VoxelEncoding encoding, StoredType type,
                                                             bool decimalCommas = false);

}  // namespace echolucent
