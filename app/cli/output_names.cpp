#include "app/cli/output_names.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>

#include "app/cli/options/option_text.h"
#include "io/file_formats.h"
#include "io/files/header_text.h"
#include "io/writers/movie_file.h"
#include "processing/ascii_letters.h"

namespace echolucent::cli {

namespace {

// Endings that name a kind of file, whether the program writes it or not.
constexpr std::array<std::string_view, 21> pictureEndings{".bmp", ".exr", ".gif", ".heic", ".jp2",  ".jpe",  ".jpeg",
                                                          ".jpg", ".jxl", ".pbm", ".pdf",  ".pgm",  ".png",  ".pnm",
                                                          ".ppm", ".svg", ".tga", ".tif",  ".tiff", ".webp", ".xpm"};
constexpr std::array<std::string_view, 10> movieEndings{".avi",  ".m4v", ".mkv", ".mov",  ".mp4",
                                                        ".mpeg", ".mpg", ".ogv", ".webm", ".wmv"};
/// Endings of volumes in formats that the program does not read by name.
constexpr std::array<std::string_view, 5> volumeEndings{".gipl", ".gz", ".hdr", ".img", ".vtk"};

template <std::size_t count>
bool holds(const std::array<std::string_view, count>& endings, std::string_view ending) {
    return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

std::string endingOf(const std::string& path) { return lowerCase(std::filesystem::path(path).extension().string()); }

Result<void> refused(const std::string& path, const std::string& option, const std::string& written,
                     const std::string& remedy) {
    return wrongUsage(option, "is " + quotedText(path) + ", but " + written, remedy);
}

bool isPictureOrMovie(std::string_view ending) { return holds(pictureEndings, ending) || holds(movieEndings, ending); }

}  // namespace

Result<void> checkPictureName(const std::string& path, const std::string& option) {
    const std::string ending = endingOf(path);
    if (!isPictureOrMovie(ending) || ending == ".png") return {};
    return refused(path, option, "pictures are written as PNG", "Give it a name that ends in .png.");
}

Result<void> checkMovieName(const std::string& path, const std::string& option) {
    if (path.empty()) return {};
    const auto container = movieContainerOf(path);
    if (container) return {};
    Failure failure = container.error();
    failure.element = option;
    return tl::unexpected<Failure>(failure);
}

Result<void> checkMetaImageName(const std::string& path, const std::string& option) {
    const std::string ending = endingOf(path);
    const bool known = isPictureOrMovie(ending) || holds(volumeEndings, ending) || formatFromName(path) != nullptr;
    if (!known || ending == ".mha" || ending == ".mhd") return {};
    return refused(path, option, "volumes are written as MetaImage", "Give it a name that ends in .mha.");
}

}  // namespace echolucent::cli
