// The reader process gives what reading in this process gives, is held to what it may do, and may die at any moment.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "hostile_file.h"
#include "io/restricted/reader_limits.h"
#include "io/restricted/reader_process.h"
#include "io/restricted/request.h"
#include "io/restricted/restricted_reader.h"
#include "processing/volume/coarse_grid.h"
#include "shared_data.h"
#include "temporary_folder.h"
#include "tests/inputs.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

/// Everything that a study says, but for its voxels.
std::string wordsOf(const Result<Study>& study) {
    if (!study) return "refused: " + study.error().sentence();
    std::string words =
        study->name + fmt::format(" {} {} {} {}", study->phaseTimes.meanSeconds.value_or(-1), study->phases.size(),
                                  static_cast<int>(study->lossyCompression), static_cast<int>(study->burnedInText));
    for (const std::string& file : study->files) words += "\nfile " + file;
    for (const ImportFact& fact : study->facts)
        words += "\n" + fact.name + ": " + fact.value + " [" + fact.source + "]";
    for (const std::string& warning : study->warnings) words += "\n! " + warning;
    return words;
}

void expectSame(const Result<Study>& here, const Result<Study>& apart, const std::string& name) {
    ASSERT_EQ(wordsOf(here), wordsOf(apart)) << name;
    if (!here) return;
    for (std::size_t phase = 0; phase < here->phases.size(); ++phase) {
        const Volume &one = *here->phases[phase], &other = *apart->phases[phase];
        const auto bytesOf = [](const Voxels& voxels) {
            return std::visit(
                [](const auto& values) {
                    return std::string_view(reinterpret_cast<const char*>(values.data()),
                                            values.size() * sizeof(values[0]));
                },
                voxels);
        };
        EXPECT_EQ(one.voxels().index(), other.voxels().index()) << name;
        EXPECT_TRUE(bytesOf(one.voxels()) == bytesOf(other.voxels())) << name << " phase " << phase;
        EXPECT_TRUE(one.dataMask() == other.dataMask()) << name << " phase " << phase;
        EXPECT_EQ(one.dataBox(), other.dataBox()) << name;
        EXPECT_EQ(one.whiteLevel(), other.whiteLevel()) << name;
        const VolumeGeometry &a = one.geometry(), &b = other.geometry();
        EXPECT_TRUE(a.size == b.size && a.spacing == b.spacing && a.origin == b.origin && a.direction == b.direction &&
                    a.spacingKnown == b.spacingKnown && a.patientFrameKnown == b.patientFrameKnown &&
                    a.probe == b.probe && a.reduction == b.reduction)
            << name;
    }
}

class SharedFolders : public testing::TestWithParam<const char*> {};

TEST_P(SharedFolders, AreReadAlikeHereAndInTheReaderProcess) {
    const std::string folder = sharedData + "/" + GetParam();
    if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "the shared data are not here: " << folder;
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) paths.push_back(entry.path().string());
    std::ranges::sort(paths);
    EXPECT_GT(paths.size(), 8U);
    for (std::size_t i = 0; i < paths.size(); i += takesSomeInputs ? 4 : 1)
        expectSame(readStudy(paths[i]), restricted::readStudy(paths[i]), paths[i]);
}

INSTANTIATE_TEST_SUITE_P(All, SharedFolders, testing::Values("volumes", "dicom", "bad"),
                         [](const auto& folder) { return std::string(folder.param); });

/// What a reader process says of every step-th hostile file is, word by word, what reading here says. (A link out of
/// the folder is read by this process only. test_hostile_cli runs all rows through the command line.)
void expectSameOfHostileFiles(std::size_t step) {
    const std::vector<HostileFile>& rows = hostileFiles();
    for (std::size_t index = 0; index < rows.size(); index += step) {
        const HostileFile& row = rows[index];
        if (row.name.find("link") != std::string::npos) continue;
        const TemporaryFolder folder;
        row.write(folder.path());
        const std::string path = row.opened == "." ? folder.path() : folder.file(row.opened);
        expectSame(readStudy(path, row.options), restricted::readStudy(path, row.options), row.name);
    }
}

TEST(RestrictedReader, SaysOfHostileFilesWhatReadingHereSays) { expectSameOfHostileFiles(takesSomeInputs ? 160 : 40); }
TEST(LongRestrictedReader, SaysOfHostileFilesWhatReadingHereSays) { expectSameOfHostileFiles(10); }

std::string volumeOf(const TemporaryFolder& folder, int edge) {
    const auto voxels =
        static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge);
    return folder.write("a.mha",
                        fmt::format("ObjectType = Image\nNDims = 3\nDimSize = {0} {0} {0}\nElementSpacing = 1 1 1\n"
                                    "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n",
                                    edge) +
                            std::string(voxels, 'v'));
}

TEST(RestrictedReader, SaysHowAVolumeWasReduced) {
    const TemporaryFolder folder;
    const std::string path = volumeOf(folder, 104);
    ReadOptions options;
    options.studyMebibytes = 1;
    const auto study = restricted::readStudy(path, options);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->geometry().reduction, (Reduction{{2, 2, 2}, {104, 104, 104}}));
    expectSame(readStudy(path, options), study, path);
}

/// A program's standard output and how it ended.
std::pair<std::string, int> outputOf(const std::string& command) {
    const std::unique_ptr<FILE, int (*)(FILE*)> pipe(popen(command.c_str(), "r"), pclose);
    std::string output;
    std::array<char, 256> piece{};
    while (std::fgets(piece.data(), static_cast<int>(piece.size()), pipe.get()) != nullptr) output += piece.data();
    return {output, 0};
}

TEST(RestrictedReader, MayOpenNothingStartNothingAndConnectToNothing) {
    // A sanitizer looks for leaks from another process, which is refused too.
    const std::string output =
        outputOf("ASAN_OPTIONS=detect_leaks=0 '" + restricted::readerProgram() + "' --try").first;
    if (output.find("are not filtered") != std::string::npos)
        GTEST_SKIP() << "this kernel lets no process filter its system calls: " << output;
    for (const char* tried :
         {"opening a file", "creating a file", "making a socket of the network", "making a socket of this machine",
          "signalling another process", "mapping code", "starting a process", "running a program"})
        EXPECT_THAT(output, HasSubstr(std::string(tried) + ": refused (")) << output;
    if (output.find("no Landlock") != std::string::npos)
        std::printf("SKIP in part: this kernel has no Landlock; %s", output.substr(0, output.find('\n') + 1).c_str());
}

std::string requestBytes(const std::string& path) {
    restricted::Request request;
    request.path = path;
    restricted::MessageWriter writer;
    writer(request);
    return writer.bytes();
}

/// What reading a study told of it.
struct Told {
    std::vector<CoarseVolume> coarse;
    bool beforeTheStudy = false;
    Result<Study> study;
};

Told toldBy(const std::function<Result<Study>(const Progress&)>& read) {
    std::vector<CoarseVolume> coarse;
    double furthest = 0.0;
    bool early = true;
    Progress progress{[&](double share) { furthest = std::max(furthest, share); }, nullptr};
    progress.coarse = [&](const CoarseVolume& volume) {
        early = early && furthest < 0.5;
        coarse.push_back(volume);
    };
    auto study = read(progress);
    return {std::move(coarse), early, std::move(study)};
}

TEST(RestrictedReader, HandsOverTheCoarseVolumeThatReadingHereHandsOver) {
    const TemporaryFolder folder;
    const std::string path = volumeOf(folder, 324);
    const Told here = toldBy([&](const Progress& progress) { return readStudy(path, {}, progress); });
    const Told apart = toldBy([&](const Progress& progress) { return restricted::readStudy(path, {}, progress); });
    expectSame(here.study, apart.study, path);
    ASSERT_EQ(here.coarse.size(), 1U);
    ASSERT_EQ(apart.coarse.size(), 1U);
    EXPECT_TRUE(apart.beforeTheStudy);
    EXPECT_EQ(apart.coarse.front().units, here.coarse.front().units);
    const auto asStudy = [](const CoarseVolume& coarse) {
        Study study;
        study.phases = {coarse.voxels};
        return Result<Study>(study);
    };
    expectSame(asStudy(here.coarse.front()), asStudy(apart.coarse.front()), "coarse");
}

/// Kills a reader process at a random moment, so many times.
void expectSentencesOfKilledReaders(int kills) {
    const TemporaryFolder folder;
    const std::string path = volumeOf(folder, 128);
    std::mt19937 random(20261123);
    int died = 0, answered = 0;
    for (int kill = 0; kill < kills; ++kill) {
        auto process = restricted::ReaderProcess::start(false);
        ASSERT_TRUE(process) << process.error().sentence();
        const auto moment = std::chrono::steady_clock::now() + std::chrono::microseconds(random() % 80000);
        const int number = (*process)->number();
        std::thread killer([moment, number] {
            while (std::chrono::steady_clock::now() < moment) std::this_thread::yield();
            ::kill(number, SIGKILL);
        });
        static_cast<void>((*process)->request(requestBytes(path)));
        restricted::FileBroker broker(path);
        const auto answer = (*process)->serve(broker, path, {});
        killer.join();
        ++(answer ? answered : died);
        const std::string sentence = answer ? "" : answer.error().sentence();
        if (!answer) {
            EXPECT_THAT(sentence, HasSubstr("a.mha: was not read: the system ended the process"));
        }
    }
    std::printf("%d reader processes killed at random moments: %d had answered before, %d sentences\n", kills, answered,
                died);
    EXPECT_GT(died, kills / 10);
}

TEST(RestrictedReader, MayBeKilledAtAnyMoment) { expectSentencesOfKilledReaders(30); }
TEST(LongRestrictedReader, MayBeKilledAtAnyMoment) {
    const char* const asked = std::getenv("ECHOLUCENT_READER_KILLS");
    expectSentencesOfKilledReaders(asked != nullptr ? std::atoi(asked) : 200);
}

TEST(RestrictedReader, ThatDiedWhileItWaitedIsReplaced) {
    const TemporaryFolder folder;
    const std::string path = volumeOf(folder, 16);
    restricted::useReaderProgram("/bin/true");
    restricted::prepareReader(restricted::Readiness::once);
    restricted::useReaderProgram("");
    // The one that waited has ended, or ends before it answers: never is it the person who has to try again.
    for (int time = 0; time < 2; ++time) {
        const auto study = restricted::readStudy(path);
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_EQ(study->phases.front()->storedValue(0), 'v');
    }
}

TEST(RestrictedReader, EndsInASentenceWhereMemoryRunsOut) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    GTEST_SKIP() << "under a sanitizer the reader's memory is not limited";
#endif
    const TemporaryFolder folder;
    // A sparse file: it takes no room, and its voxels, which are not yet too many to be kept whole, half a gigabyte.
    const std::string path =
        folder.write("a.mha",
                     "ObjectType = Image\nNDims = 3\nDimSize = 800 800 800\nElementSpacing = 1 1 1\n"
                     "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n");
    std::filesystem::resize_file(path, std::filesystem::file_size(path) + 800 * 800 * 800);
    const auto readWithLittle = [&path] {
        // The reader inherits what its owner may use at the most.
        const rlimit little{500u << 20, 500u << 20};
        setrlimit(RLIMIT_AS, &little);
        const auto study = restricted::readStudy(path);
        _exit(!study && study.error().sentence().find("needs more memory than there is") != std::string::npos ? 0 : 1);
    };
    // In a process that begins anew: this one may have used much of what it may use.
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(readWithLittle(), testing::ExitedWithCode(0), "");
}

TEST(RestrictedReader, IsCancelledWhileItReads) {
    const TemporaryFolder folder;
    const std::string path = volumeOf(folder, 256);
    std::atomic<bool> cancel = false;
    const auto study = restricted::readStudy(path, {}, {[&](double) { cancel = true; }, &cancel});
    ASSERT_FALSE(study);
    EXPECT_EQ(study.error().kind, FailureKind::cancelled);
}

TEST(ReaderLimits, GrowWithWhatIsRead) {
    EXPECT_EQ(restricted::limitsFor(10000000).memoryBytes,
              restricted::limitsFor(0).memoryBytes + 10000000 * 96 - (896u << 20))
        << "a small file has the same, up to the 9.8 MB at which 96 times its bytes are more";
    EXPECT_GT(restricted::limitsFor(128000000).memoryBytes, std::uint64_t{3} * 128000000);
    EXPECT_LT(restricted::limitsFor(0).processorSeconds, restricted::limitsFor(1000000000).processorSeconds);
    EXPECT_GT(restricted::limitsFor(~std::uint64_t{0}).memoryBytes, 0u) << "nothing overflows";
}

}  // namespace
}  // namespace echolucent
