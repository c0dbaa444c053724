// Movies as AVI files of JPEG pictures (Motion JPEG), through OpenCV's videoio. That library loads some two hundred
// others, which would make every command of the command line start ten times slower; so it sits in a module beside the
// program that is loaded when the first movie is begun.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "processing/result.h"

namespace echolucent {

/// A movie being written. Nothing is at its path before finish(), and nothing is left where finish() is not reached.
class MovieFile {
public:
    /// Begins a movie of `width` x `height` pixels (1 to 16384 each) at `framesPerSecond` (above 0, at most 1000);
    /// throws std::invalid_argument where one of them lies outside. Fails (unwritable) where the folder of `path`
    /// cannot be written into or the module is missing.
    [[nodiscard]] static Result<MovieFile> begin(const std::string& path, int width, int height,
                                                 double framesPerSecond);
    MovieFile(MovieFile&&) noexcept;
    MovieFile& operator=(MovieFile&&) noexcept;
    ~MovieFile();

    /// Adds a picture: 8-bit red, green, blue, rows from the top, width * height * 3 bytes (std::invalid_argument where
    /// `rgb` has another size). Fails (unwritable) where the picture cannot be encoded.
    [[nodiscard]] Result<void> add(std::span<const std::uint8_t> rgb);
    /// Reads the movie back to see that it is whole, and puts it in its place as writeFileAtomically() does. Fails
    /// (unwritable) where the movie has no pictures, is longer than 2 GB or cannot be written.
    [[nodiscard]] Result<void> finish();

private:
    struct Parts;
    explicit MovieFile(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> m_parts;
};

}  // namespace echolucent
