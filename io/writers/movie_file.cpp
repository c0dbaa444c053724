#include "io/writers/movie_file.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "io/movie_encoder/movie_encoder.h"
#include "io/output/output_place.h"
#include "io/output/unfinished_file.h"
#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

constexpr int largestEdge = 16384;
constexpr double highestFrameRate = 1000;
/// The largest AVI, bytes: it counts in 32 bits.
constexpr std::uintmax_t largestAvi = 2'000'000'000;
constexpr std::string_view aviEnding = ".avi";

/// The module's functions; null if it is missing. The module is never unloaded, because OpenCV's threads may outlive
/// the movie.
struct Encoder {
    decltype(&echolucentOpenMovie) open = nullptr;
    decltype(&echolucentAddPicture) add = nullptr;
    decltype(&echolucentCloseMovie) close = nullptr;
    decltype(&echolucentCountPictures) count = nullptr;

    [[nodiscard]] bool complete() const { return open && add && close && count; }
};

template <typename Function>
void resolve(void* module, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(module, name));
}

Encoder loadEncoder() {
    Encoder encoder;
    // The program's run path leads to the module: beside the program, or in the library folder of the installation.
    void* const module = dlopen(ECHOLUCENT_MOVIE_MODULE, RTLD_NOW | RTLD_LOCAL);
    if (!module) return encoder;
    resolve(module, "echolucentOpenMovie", encoder.open);
    resolve(module, "echolucentAddPicture", encoder.add);
    resolve(module, "echolucentCloseMovie", encoder.close);
    resolve(module, "echolucentCountPictures", encoder.count);
    return encoder;
}

const Encoder& encoder() {
    static const Encoder loaded = loadEncoder();
    return loaded;
}

tl::unexpected<Failure> failed(const std::string& path, const std::string& problem) {
    return fail(FailureKind::unwritable, path, "", problem);
}

EcholucentMovieCodec codecOf(const MovieContainer& container) {
    if (container.ending == aviEnding) return echolucentMotionJpeg;
    return container.ending == ".mp4" ? echolucentH264 : echolucentLossless;
}

std::string lowerCaseEnding(const std::string& path) {
    return lowerCase(std::filesystem::path(path).extension().string());
}

/// ".avi, .mp4 or .mkv".
std::string allEndings() {
    std::string list;
    for (const MovieContainer& container : movieContainers) {
        if (!list.empty()) list += &container == &movieContainers.back() ? " or " : ", ";
        list += container.ending;
    }
    return list;
}

}  // namespace

Result<MovieContainer> movieContainerOf(const std::string& path) {
    const std::string ending = path == "-" ? std::string(aviEnding) : lowerCaseEnding(path);
    const auto found = std::ranges::find(movieContainers, ending, &MovieContainer::ending);
    if (found != movieContainers.end()) return *found;
    return fail(FailureKind::wrongUsage, path, "",
                ending.empty() ? "does not say by its ending what kind of movie it is to be"
                               : "ends in " + ending + ", which is no kind of movie that can be written",
                "Give it a name that ends in " + allEndings() + ".");
}

struct MovieFile::Parts {
    std::string path;
    MovieContainer container;
    std::optional<UnfinishedFile> file{};
    int width = 0, height = 0;
    void* movie = nullptr;
    int pictures = 0;

    Parts(std::string where, const MovieContainer& what) : path(std::move(where)), container(what) {}
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    [[nodiscard]] std::size_t pictureBytes() const {
        return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3;
    }
    ~Parts() {
        if (movie) encoder().close(movie);
    }
};

MovieFile::MovieFile(std::unique_ptr<Parts> parts) : m_parts(std::move(parts)) {}
MovieFile::MovieFile(MovieFile&&) noexcept = default;
MovieFile& MovieFile::operator=(MovieFile&&) noexcept = default;
MovieFile::~MovieFile() = default;

Result<void> MovieFile::check(const std::string& path, int width, int height) {
    const auto container = movieContainerOf(path);
    if (!container) return tl::unexpected<Failure>(container.error());
    if (width % 2 != 0 || height % 2 != 0)
        return fail(FailureKind::wrongUsage, path, "",
                    "would have " + std::to_string(width) + " x " + std::to_string(height) +
                        " pixels, but those of movies are counted in twos",
                    "Take an even width and height.");
    // Failing here saves minutes of rendering.
    if (const auto place = placeOfOutput(path); !place) return tl::unexpected<Failure>(place.error());
    return {};
}

Result<MovieFile> MovieFile::begin(const std::string& path, int width, int height, double framesPerSecond) {
    if (width < 1 || height < 1 || width > largestEdge || height > largestEdge)
        throw std::invalid_argument("MovieFile: the size must be 1 to 16384 pixels");
    if (!(framesPerSecond > 0.0 && framesPerSecond <= highestFrameRate))
        throw std::invalid_argument("MovieFile: the frame rate must be above 0, at most 1000");
    if (auto possible = check(path, width, height); !possible) return tl::unexpected<Failure>(possible.error());
    if (!encoder().complete())
        return failed(
            path, std::string("could not be made a movie: ") + ECHOLUCENT_MOVIE_MODULE +
                      " is neither beside the program nor in its library folder, or is not the one of this version");
    auto parts = std::make_unique<Parts>(path, *movieContainerOf(path));
    parts->width = width;
    parts->height = height;
    auto file = UnfinishedFile::beside(path, parts->container.ending);
    if (!file) return tl::unexpected<Failure>(file.error());
    parts->file = std::move(*file);
    parts->movie =
        encoder().open(parts->file->name().c_str(), codecOf(parts->container), width, height, framesPerSecond);
    if (!parts->movie)
        return failed(path, "could not be made a movie: this machine has no encoder of " +
                                std::string(parts->container.words) + " for this size and rate");
    return MovieFile(std::move(parts));
}

Result<void> MovieFile::add(std::span<const std::uint8_t> rgb) {
    if (!m_parts || !m_parts->movie || rgb.size() != m_parts->pictureBytes())
        throw std::invalid_argument("MovieFile::add: the picture's bytes do not match the movie's size");
    if (encoder().add(m_parts->movie, rgb.data()) != 0)
        return failed(m_parts->path, "could not be made a movie: a picture could not be encoded");
    ++m_parts->pictures;
    return {};
}

Result<void> MovieFile::finish(const Progress& progress) {
    if (!m_parts || !m_parts->movie) throw std::invalid_argument("MovieFile::finish: the movie is finished already");
    encoder().close(m_parts->movie);
    m_parts->movie = nullptr;
    if (m_parts->pictures == 0) return failed(m_parts->path, "could not be made a movie: it has no pictures");
    std::error_code error;
    const std::uintmax_t bytes = std::filesystem::file_size(m_parts->file->name(), error);
    if (m_parts->container.ending == aviEnding && !error && bytes > largestAvi)
        return failed(m_parts->path, "could not be made a movie: it is longer than 2 GB, which AVI cannot hold");
    // OpenCV does not report a failed write, so the pictures are read back.
    const auto wasCancelled = [](const void* asked) {
        return static_cast<const Progress*>(asked)->cancelled() ? 1 : 0;
    };
    const int whole =
        encoder().count(m_parts->file->name().c_str(), m_parts->width, m_parts->height, wasCancelled, &progress);
    if (progress.cancelled()) return fail(FailureKind::cancelled, m_parts->path, "", "was cancelled");
    if (whole != m_parts->pictures)
        return failed(m_parts->path,
                      "could not be made a movie: it does not read back whole, and the disk may be full");
    return m_parts->file->putInPlace();
}

}  // namespace echolucent
