// Writes movies through OpenCV's videoio. The ending of the file's name decides the container. videoio loads some two
// hundred libraries, which would make every command start ten times slower. So the code that needs videoio is a module
// beside the program; the thread that begins the first movie loads this module.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// A container that can be written. docs/cli-sweep.md says what its codec loses.
struct MovieContainer {
    std::string_view ending;  ///< of the file's name, lower case
    std::string_view words;   ///< "Motion JPEG in AVI"
    friend bool operator==(const MovieContainer&, const MovieContainer&) = default;
};
inline constexpr std::array movieContainers{MovieContainer{".avi", "Motion JPEG in AVI"},
                                            MovieContainer{".mp4", "H.264 in MP4"},
                                            MovieContainer{".mkv", "lossless FFV1 in Matroska"}};

/// The container for the name's ending, in capitals or not; AVI for the path "-" (standard output). Fails (wrongUsage,
/// naming `path` and the possible endings) for any other.
[[nodiscard]] Result<MovieContainer> movieContainerOf(const std::string& path);

/// A movie that is being written. Nothing new is at its path before finish(), and without finish() nothing is left.
class MovieFile {
public:
    /// Fails early as begin() would: (wrongUsage) if the name's ending is none of movieContainers, or if a side is odd,
    /// because OpenCV would cut it; and as placeOfOutput().
    [[nodiscard]] static Result<void> check(const std::string& path, int width, int height);

    /// Begins a movie of `width` x `height` pixels (even, 1 to 16384 each) at `framesPerSecond` (above 0, at most
    /// 1000). Throws std::invalid_argument outside these ranges. Fails as check(), and (unwritable) if the module is
    /// missing or has no encoder for the container.
    [[nodiscard]] static Result<MovieFile> begin(const std::string& path, int width, int height,
                                                 double framesPerSecond);
    MovieFile(MovieFile&&) noexcept;
    MovieFile& operator=(MovieFile&&) noexcept;
    ~MovieFile();

    /// Adds a picture: 8-bit red, green, blue, rows from the top, width * height * 3 bytes (any other size throws
    /// std::invalid_argument, as does a call after finish()). Fails (unwritable) if the picture cannot be encoded.
    [[nodiscard]] Result<void> add(std::span<const std::uint8_t> rgb);
    /// Reads the movie back to verify it, and puts it in its place as UnfinishedFile does. Fails (unwritable) if the
    /// movie has no pictures, is an AVI of more than 2 GB or cannot be written. Fails (cancelled) if progress.cancel
    /// was raised before the movie was read back. Call it once: a second call throws std::invalid_argument.
    [[nodiscard]] Result<void> finish(const Progress& progress = {});

private:
    struct Parts;
    explicit MovieFile(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> m_parts;
};

}  // namespace echolucent
