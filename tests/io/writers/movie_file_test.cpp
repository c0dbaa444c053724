// Movies: the name's ending decides the container, what was written is read back, and nothing is left of one that is
// not finished.
#include "io/writers/movie_file.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <random>
#include <vector>

#include "io/files/input_file.h"
#include "tests/io/written_files/temporary_folder.h"

namespace echolucent {
namespace {

constexpr int movieWidth = 96, movieHeight = 64, movieFrames = 7;

std::vector<std::string> endings() {
    std::vector<std::string> all;
    for (const MovieContainer& container : movieContainers) all.emplace_back(container.ending);
    return all;
}

/// A disc of sepia over black that moves and is speckled, as pictures of volumes are.
std::vector<std::uint8_t> frame(int index) {
    std::mt19937 random(static_cast<unsigned>(index + 1));
    std::uniform_int_distribution<int> speckle(-12, 12);
    std::vector<std::uint8_t> rgb;
    for (int y = 0; y < movieHeight; ++y)
        for (int x = 0; x < movieWidth; ++x) {
            const double inside = 24.0 - std::hypot(x - 30.0 - 4 * index, y - 32.0);
            const double share = std::clamp(inside / 12.0, 0.0, 1.0);
            const int noise = inside > 0 ? speckle(random) : 0;
            for (const double level : {230.0, 190.0, 140.0})
                rgb.push_back(static_cast<std::uint8_t>(std::clamp(std::lround(share * level) + noise, 0L, 255L)));
        }
    return rgb;
}

Result<void> writeMovie(const std::string& path, double rate = 12.5) {
    auto movie = MovieFile::begin(path, movieWidth, movieHeight, rate);
    if (!movie) return tl::unexpected<Failure>(movie.error());
    for (int i = 0; i < movieFrames; ++i)
        if (auto added = movie->add(frame(i)); !added) return added;
    return movie->finish();
}

std::ptrdiff_t filesIn(const TemporaryFolder& folder) {
    return std::distance(std::filesystem::directory_iterator(folder.path()), {});
}

/// RMSE over all frames and the largest error, levels.
struct CodecError {
    double rmse = 0, largest = 0;
};

CodecError codecErrorOf(const std::string& path) {
    cv::VideoCapture movie(path, cv::CAP_FFMPEG);
    EXPECT_TRUE(movie.isOpened());
    EXPECT_NEAR(movie.get(cv::CAP_PROP_FPS), 12.5, 1e-3);
    CodecError error;
    cv::Mat read;
    int count = 0;
    for (; movie.read(read); ++count) {
        EXPECT_EQ(read.size(), cv::Size(movieWidth, movieHeight));
        if (count >= movieFrames) continue;
        std::vector<std::uint8_t> rgb = frame(count);
        cv::Mat expected(movieHeight, movieWidth, CV_8UC3, rgb.data()), apart;
        cv::cvtColor(expected, expected, cv::COLOR_RGB2BGR);
        cv::absdiff(expected, read, apart);
        double largest = 0;
        cv::minMaxLoc(apart.reshape(1), nullptr, &largest);
        error.largest = std::max(error.largest, largest);
        error.rmse += cv::norm(apart, cv::NORM_L2SQR) / (movieWidth * movieHeight * 3.0 * movieFrames);
    }
    EXPECT_EQ(count, movieFrames);
    error.rmse = std::sqrt(error.rmse);
    return error;
}

TEST(MovieFile, IsReadBackWithinTheCodecsError) {
    const TemporaryFolder folder;
    for (const std::string& ending : endings()) {
        const std::string path = folder.file("movie" + ending);
        const auto written = writeMovie(path);
        ASSERT_TRUE(written) << written.error().sentence();
        const CodecError error = codecErrorOf(path);
        std::printf("%s: RMSE %.2f, largest %.0f levels\n", ending.c_str(), error.rmse, error.largest);
        const bool lossless = ending == ".mkv";
        // The bounds of docs/cli-sweep.md.
        EXPECT_LE(error.rmse, lossless ? 0.0 : ending == ".mp4" ? 10.0 : 8.0) << ending;
    }
    EXPECT_EQ(filesIn(folder), static_cast<std::ptrdiff_t>(endings().size())) << "something else is left";
}

TEST(MovieFile, IsOfTheKindThatItsNameSays) {
    const TemporaryFolder folder;
    const auto begins = [&](const std::string& name) {
        EXPECT_TRUE(writeMovie(folder.file(name)));
        return readWholeFile(folder.file(name), 1 << 24).value_or("").substr(0, 12);
    };
    EXPECT_EQ(begins("a.avi").substr(0, 4), "RIFF");
    EXPECT_EQ(begins("a.MP4").substr(4, 4), "ftyp");
    EXPECT_EQ(begins("a.mkv").substr(0, 4), "\x1A\x45\xDF\xA3");
}

TEST(MovieFile, HasSizeRateAndFramesAsFfprobeReadsThem) {
    if (std::system("ffprobe -version >/dev/null 2>&1") != 0) GTEST_SKIP() << "ffprobe is not here";
    const TemporaryFolder folder;
    for (const std::string& ending : endings()) {
        const std::string path = folder.file("movie" + ending), out = folder.file("probed");
        ASSERT_TRUE(writeMovie(path));
        const std::string command =
            "ffprobe -v error -count_frames -show_entries stream=codec_name,width,height,r_frame_rate,nb_read_frames "
            "-of csv=p=0 '" +
            path + "' >'" + out + "'";
        ASSERT_EQ(std::system(command.c_str()), 0);
        const std::string probed = readWholeFile(out, 10000).value_or("");
        EXPECT_NE(probed.find(",96,64,25/2,7"), std::string::npos) << ending << ": " << probed;
        const std::string codec = ending == ".avi" ? "mjpeg" : ending == ".mkv" ? "ffv1" : "h264";
        EXPECT_EQ(probed.substr(0, codec.size()), codec);
    }
}

TEST(MovieFile, RefusesNamesThatSayNothingItCanWrite) {
    const TemporaryFolder folder;
    for (const std::string name : {"a.webm", "a.gif", "a", "a.avi.txt", "avi", ".mp4x"}) {
        for (const auto& refused : {MovieFile::check(folder.file(name), 64, 64), writeMovie(folder.file(name))}) {
            ASSERT_FALSE(refused) << name;
            EXPECT_EQ(refused.error().kind, FailureKind::wrongUsage);
            EXPECT_NE(refused.error().sentence().find(".avi, .mp4 or .mkv"), std::string::npos)
                << refused.error().sentence();
        }
    }
    EXPECT_EQ(filesIn(folder), 0);
    EXPECT_EQ(movieContainerOf("-")->ending, ".avi");
    EXPECT_EQ(movieContainerOf("a.b.MKV")->ending, ".mkv");
}

TEST(MovieFile, HasTheSizeThatWasAskedForOrNone) {
    const TemporaryFolder folder;
    for (const std::string& ending : endings()) {
        const std::string odd = folder.file("odd" + ending);
        for (const auto& [columns, rows] : {std::pair(33, 32), {32, 33}, {33, 31}, {1, 1}}) {
            const auto possible = MovieFile::check(odd, columns, rows);
            ASSERT_FALSE(possible) << ending << ", " << columns << " x " << rows;
            EXPECT_EQ(possible.error().kind, FailureKind::wrongUsage);
            EXPECT_NE(
                possible.error().sentence().find(std::to_string(columns) + " x " + std::to_string(rows) + " pixels"),
                std::string::npos)
                << possible.error().sentence();
            EXPECT_FALSE(MovieFile::begin(odd, columns, rows, 25));
        }
        for (const auto& [columns, rows] : {std::pair(2, 2), {16, 18}, {34, 30}, {510, 126}}) {
            const std::string path = folder.file("even" + ending);
            auto movie = MovieFile::begin(path, columns, rows, 25);
            ASSERT_TRUE(movie) << ending << ", " << columns << " x " << rows;
            const auto bytes = std::size_t{3} * static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
            ASSERT_TRUE(movie->add(std::vector<std::uint8_t>(bytes, 90)));
            const auto finished = movie->finish();
            ASSERT_TRUE(finished) << finished.error().sentence();
            cv::VideoCapture written(path, cv::CAP_FFMPEG);
            cv::Mat picture;
            ASSERT_TRUE(written.read(picture)) << ending;
            EXPECT_EQ(picture.size(), cv::Size(columns, rows)) << ending;
        }
    }
    EXPECT_THROW((void)MovieFile::begin(folder.file("a.avi"), 0, 32, 25), std::invalid_argument);
    EXPECT_THROW((void)MovieFile::begin(folder.file("a.avi"), 32, 32, 0), std::invalid_argument);
}

TEST(MovieFile, LeavesNothingWhereItIsNotFinished) {
    const TemporaryFolder folder;
    for (const std::string& ending : endings()) {
        {
            auto movie = MovieFile::begin(folder.file("ended" + ending), movieWidth, movieHeight, 25);
            ASSERT_TRUE(movie);
            ASSERT_TRUE(movie->add(frame(0)));
            EXPECT_EQ(filesIn(folder), 1) << "it is written beside its place";
        }
        EXPECT_EQ(filesIn(folder), 0) << ending;
        auto empty = MovieFile::begin(folder.file("empty" + ending), movieWidth, movieHeight, 25);
        ASSERT_TRUE(empty);
        EXPECT_FALSE(empty->finish());
    }
    EXPECT_EQ(filesIn(folder), 0);
    EXPECT_EQ(MovieFile::check(folder.file("none/a.mp4"), 32, 32).error().kind, FailureKind::unwritable);
}

TEST(MovieFile, AMovieThatIsThereStaysUntilTheNewOneIsWhole) {
    const TemporaryFolder folder;
    const std::string path = folder.file("movie.mp4");
    ASSERT_TRUE(writeMovie(path));
    const auto before = readWholeFile(path, 1 << 24);
    {
        auto movie = MovieFile::begin(path, movieWidth, movieHeight, 25);
        ASSERT_TRUE(movie);
        ASSERT_TRUE(movie->add(frame(0)));
        EXPECT_EQ(readWholeFile(path, 1 << 24).value(), before.value());
    }
    EXPECT_EQ(readWholeFile(path, 1 << 24).value(), before.value());
    ASSERT_TRUE(writeMovie(path, 30));
    EXPECT_NE(readWholeFile(path, 1 << 24).value(), before.value());
}

TEST(MovieFile, AFullDeviceIsAFailure) {
    if (!std::filesystem::is_character_file("/dev/full")) GTEST_SKIP() << "there is no /dev/full here";
    const TemporaryFolder folder;
    std::filesystem::create_symlink("/dev/full", folder.file("full.mp4"));
    const auto written = writeMovie(folder.file("full.mp4"));
    ASSERT_FALSE(written);
    EXPECT_EQ(written.error().kind, FailureKind::unwritable);
    EXPECT_EQ(filesIn(folder), 1);
}

}  // namespace
}  // namespace echolucent
