// How files encode the bytes of voxels, and the way back.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include <tl/expected.hpp>

#include "io/voxels/voxel_types.h"

namespace echolucent {

/// `zlib` stands for zlib and gzip, which are told apart by the bytes themselves. `text` is decimal numbers between
/// white space and commas, `hex` two hexadecimal digits a byte.
enum class VoxelEncoding { raw, zlib, bzip2, text, hex };

/// The compression in words, for the import report: "none", "zlib/gzip, lossless", "none, written as decimal text".
[[nodiscard]] std::string_view compressionWords(VoxelEncoding encoding);
/// Whether so many encoded bytes may stand for almost any number of bytes.
[[nodiscard]] bool isCompressed(VoxelEncoding encoding);

/// Whether a byte stands between two numbers that are written as text, and in none.
[[nodiscard]] bool separatesNumbers(std::uint8_t byte);

/// Decodes a stream of bytes piece by piece.
class VoxelDecoder {
public:
    /// What one step came to.
    struct Step {
        std::size_t taken = 0;  ///< bytes of the input that are used up
        std::size_t given = 0;  ///< bytes of the output that are filled
        bool ended = false;     ///< whether the stream is over
    };
    /// What is wrong with the bytes: "has damaged compressed data", "a block cannot be decoded".
    struct Problem {
        std::string what;
        std::string detail;
    };

    virtual ~VoxelDecoder() = default;
    /// Decodes what it can of `input` into `output`, which holds whole values. `isLast` says that no more input
    /// follows.
    [[nodiscard]] virtual tl::expected<Step, Problem> decode(std::span<const std::uint8_t> input, bool isLast,
                                                             std::span<std::uint8_t> output) = 0;
};

/// The decoder of an encoding, for values of `type`, which text gives in this machine's byte order; null for `raw`.
[[nodiscard]] std::unique_ptr<VoxelDecoder> makeVoxelDecoder(VoxelEncoding encoding, StoredType type);

}  // namespace echolucent
