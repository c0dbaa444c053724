#include "io/output/movie_file.h"

#include <dlfcn.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

#include "io/input_file.h"
#include "io/movie_encoder/movie_encoder.h"
#include "io/output/atomic_file.h"

namespace echolucent {

namespace {

constexpr int largestEdge = 16384;
constexpr double highestFrameRate = 1000;
/// The most bytes a movie may have, because AVI counts in 32 bits.
constexpr std::size_t largestMovie = 2'000'000'000;

/// The module's functions; null where it is not there. The module is never unloaded, because OpenCV's threads may
/// outlive the movie.
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
    // The program's run path says where the module lies: beside the program, or in the library folder it is installed
    // to.
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

tl::unexpected<Failure> cannotWrite(const std::string& path, const std::string& problem) {
    return fail(FailureKind::unwritable, path, "", problem);
}

/// Fails where `path` cannot be written, so that this is said before minutes of rendering.
Result<void> checkFolder(const std::string& path) {
    if (path == "-") return {};
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) return cannotWrite(path, "could not be written: it is a folder");
    std::filesystem::path folder = std::filesystem::path(path).parent_path();
    if (folder.empty()) folder = ".";
    if (!std::filesystem::is_directory(folder, error))
        return cannotWrite(path, "could not be written: its folder is not there");
    if (access(folder.c_str(), W_OK) != 0) return cannotWrite(path, "could not be written: its folder is read-only");
    return {};
}

/// An empty file of its own, whose name ends as OpenCV expects of an AVI.
std::string temporaryMovie() {
    constexpr std::string_view ending = ".avi";
    std::error_code error;
    auto folder = std::filesystem::temp_directory_path(error);
    if (error) folder = ".";
    std::string name = (folder / "echolucent-XXXXXX").string() + std::string(ending);
    const int descriptor = mkstemps(name.data(), static_cast<int>(ending.size()));
    if (descriptor < 0) return {};
    ::close(descriptor);
    return name;
}

}  // namespace

struct MovieFile::Parts {
    std::string path, temporary;
    std::size_t pictureBytes = 0;
    void* movie = nullptr;
    int pictures = 0;

    Parts() = default;
    Parts(const Parts&) = delete;
    Parts& operator=(const Parts&) = delete;
    ~Parts() {
        if (movie) encoder().close(movie);
        std::error_code ignored;
        if (!temporary.empty()) std::filesystem::remove(temporary, ignored);
    }
};

MovieFile::MovieFile(std::unique_ptr<Parts> parts) : m_parts(std::move(parts)) {}
MovieFile::MovieFile(MovieFile&&) noexcept = default;
MovieFile& MovieFile::operator=(MovieFile&&) noexcept = default;
MovieFile::~MovieFile() = default;

Result<MovieFile> MovieFile::begin(const std::string& path, int width, int height, double framesPerSecond) {
    if (width < 1 || height < 1 || width > largestEdge || height > largestEdge)
        throw std::invalid_argument("MovieFile: the size must be 1 to 16384 pixels");
    if (!(framesPerSecond > 0.0 && framesPerSecond <= highestFrameRate))
        throw std::invalid_argument("MovieFile: the frame rate must be above 0, at most 1000");
    if (auto possible = checkFolder(path); !possible) return tl::unexpected<Failure>(possible.error());
    if (!encoder().complete())
        return cannotWrite(
            path, std::string("could not be made a movie: ") + ECHOLUCENT_MOVIE_MODULE +
                      " is neither beside the program nor in its library folder, or is not the one of this version");
    auto parts = std::make_unique<Parts>();
    parts->path = path;
    parts->pictureBytes = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3;
    parts->temporary = temporaryMovie();
    if (!parts->temporary.empty())
        parts->movie = encoder().open(parts->temporary.c_str(), width, height, framesPerSecond);
    if (!parts->movie)
        return cannotWrite(path, "could not be made a movie: the temporary folder cannot be written into");
    return MovieFile(std::move(parts));
}

Result<void> MovieFile::add(std::span<const std::uint8_t> rgb) {
    if (!m_parts || !m_parts->movie || rgb.size() != m_parts->pictureBytes)
        throw std::invalid_argument("MovieFile::add: the picture's bytes do not match the movie's size");
    if (encoder().add(m_parts->movie, rgb.data()) != 0)
        return cannotWrite(m_parts->path, "could not be made a movie: a picture could not be encoded");
    ++m_parts->pictures;
    return {};
}

Result<void> MovieFile::finish() {
    if (!m_parts || !m_parts->movie) throw std::invalid_argument("MovieFile::finish: the movie is finished already");
    encoder().close(m_parts->movie);
    m_parts->movie = nullptr;
    if (m_parts->pictures == 0) return cannotWrite(m_parts->path, "could not be made a movie: it has no pictures");
    // OpenCV does not say where a write failed.
    if (encoder().count(m_parts->temporary.c_str()) != m_parts->pictures)
        return cannotWrite(m_parts->path, "could not be made a movie: the temporary folder may be full");
    const auto bytes = readWholeFile(m_parts->temporary, largestMovie);
    if (!bytes) return cannotWrite(m_parts->path, "could not be made a movie: it is longer than 2 GB");
    return writeFileAtomically(m_parts->path, *bytes);
}

}  // namespace echolucent
