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

/// A movie being written. Nothing is at its path before finish(), and nothing is left where that is not reached.
class MovieFile {
public:
    /// width, height: 1 to 16384 pixels; framesPerSecond: above 0, at most 1000 (std::invalid_argument beyond). Fails
    /// (unwritable) where the folder of `path` cannot be written into or the module is missing.
    [[nodiscard]] static Result<MovieFile> begin(const std::string& path, int width, int height,
                                                 double framesPerSecond);
    MovieFile(MovieFile&&) noexcept;
    MovieFile& operator=(MovieFile&&) noexcept;
    ~MovieFile();

    /// 8-bit RGB, rows from the top, width * height * 3 bytes.
    [[nodiscard]] Result<void> add(std::span<const std::uint8_t> rgb);
    /// Reads the movie back to see that it is whole, and puts it in its place as writeFileAtomically() does.
    [[nodiscard]] Result<void> finish();

private:
    struct Parts;
    explicit MovieFile(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> m_parts;
};

}  // namespace echolucent
