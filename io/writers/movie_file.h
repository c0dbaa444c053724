// Movies, through OpenCV's videoio; the ending of the name decides the container. That library loads some two hundred
// others, which would make every command of the command line start ten times slower; so it sits in a module beside the
// program that is loaded when the first movie is begun, by the thread that begins it.
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

/// A container that can be written. What its codec loses stands in docs/cli-sweep.md.
struct MovieContainer {
    std::string_view ending;  ///< of the file's name, lower case
    std::string_view words;   ///< "Motion JPEG in AVI"
    friend bool operator==(const MovieContainer&, const MovieContainer&) = default;
};
inline constexpr std::array movieContainers{MovieContainer{".avi", "Motion JPEG in AVI"},
                                            MovieContainer{".mp4", "H.264 in MP4"},
                                            MovieContainer{".mkv", "lossless FFV1 in Matroska"}};

/// The container that the name's ending asks for, capital letters or not; the path "-" (standard output) asks for AVI.
/// Fails (wrongUsage, naming `path`) with the endings there are where it has none of them.
[[nodiscard]] Result<MovieContainer> movieContainerOf(const std::string& path);

/// A movie being written. Nothing is at its path before finish(), and nothing is left where finish() is not reached.
class MovieFile {
public:
    /// Fails as begin() does before anything is rendered: where the name's ending is none of movieContainers or a side
    /// is odd (wrongUsage: OpenCV would cut it), or `path` is no place of an output (placeOfOutput()).
    [[nodiscard]] static Result<void> check(const std::string& path, int width, int height);

    /// Begins a movie of `width` x `height` pixels (even, 1 to 16384 each) at `framesPerSecond` (above 0, at most
    /// 1000); throws std::invalid_argument where one of them lies outside. Fails as check() does, and (unwritable)
    /// where the module is missing or has no encoder for the container.
    [[nodiscard]] static Result<MovieFile> begin(const std::string& path, int width, int height,
                                                 double framesPerSecond);
    MovieFile(MovieFile&&) noexcept;
    MovieFile& operator=(MovieFile&&) noexcept;
    ~MovieFile();

    /// Adds a picture: 8-bit red, green, blue, rows from the top, width * height * 3 bytes (std::invalid_argument where
    /// `rgb` has another size). Fails (unwritable) where the picture cannot be encoded.
    [[nodiscard]] Result<void> add(std::span<const std::uint8_t> rgb);
    /// Reads the movie back to see that it is whole and of its size, and puts it in its place as UnfinishedFile does.
    /// Fails (unwritable) where the movie has no pictures, is an AVI of more than 2 GB or cannot be written, and
    /// (cancelled) where progress.cancel was raised before it was read back.
    [[nodiscard]] Result<void> finish(const Progress& progress = {});

private:
    struct Parts;
    explicit MovieFile(std::unique_ptr<Parts> parts);
    std::unique_ptr<Parts> m_parts;
};

}  // namespace echolucent
