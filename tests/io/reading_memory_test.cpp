// How much memory small files may take, and how the system's refusals are worded.
#include "io/files/reading_memory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "io/files/input_problems.h"
#include "io/stored/stored_volume.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

TEST(ReadingMemory, GrowsWithTheFileFromALimitThatEveryFileMayTake) {
    EXPECT_EQ(mostReadingMemory(0), std::uint64_t{896} << 20);
    EXPECT_EQ(mostReadingMemory(1000), std::uint64_t{896} << 20);
    EXPECT_EQ(mostReadingMemory(std::uint64_t{1} << 30), std::uint64_t{96} << 30);
    EXPECT_LT(mostReadingMemory(10'000'000), std::uint64_t{1} << 30);
    EXPECT_GT(mostReadingMemory(~std::uint64_t{0}), std::uint64_t{1} << 60);
    EXPECT_TRUE(requireReadingMemory("v.mha", "DimSize", 1000, 1));
    const auto refused = requireReadingMemory("v.mha", "DimSize", std::uint64_t{900} << 20, 1000);
    ASSERT_FALSE(refused);
    EXPECT_THAT(refused.error().sentence(), HasSubstr("v.mha: DimSize declares voxels that would take 900 MiB"));
}

TEST(ReadingMemory, CountsWhatIsHeldAtOneTime) {
    StoredVolume stored;
    stored.geometry.size = {100, 100, 100};
    const auto needed = [&] { return memoryToRead(stored, *countBytes(stored)); };
    EXPECT_EQ(needed(), 2'000'000U);  // the bytes, which are kept as they are, and the mask
    stored.type = StoredType::uint16;
    EXPECT_EQ(needed(), 4'000'000U);  // as they are stored and as they are kept
    stored.phases = 4;
    EXPECT_EQ(needed(), 12'000'000U);  // as they are kept, and the masks of all phases
    stored.rescale = Rescale{2, 0};
    EXPECT_EQ(needed(), 20'000'000U);
    stored.unpackedBytes = 5'000'000;
    EXPECT_EQ(needed(), 25'000'000U);
}

TEST(InputProblems, AreSaidInWordsOfOurOwn) {
    EXPECT_EQ(inputProblem(ENOENT), "it does not exist");
    EXPECT_THAT(inputProblem(EACCES), HasSubstr("permission"));
    for (const int gone : {EIO, ESTALE, ENOTCONN, ENODEV, EHOSTDOWN, ETIMEDOUT})
        EXPECT_EQ(inputProblem(gone), "its disc or the connection to it failed") << gone;
    for (int number = 1; number < 134; ++number) {
        EXPECT_NE(inputProblem(number), std::strerror(number)) << number;
        EXPECT_NE(inputProblem(number), "") << number;
    }
}

// A path without a folder is looked up where the program runs, and there as everywhere a missing file is called
// missing.
TEST(InputProblems, OfADataFileOnARelativePathAreItsOwn) {
    const TemporaryFolder folder;
    folder.write("v.mhd",
                 "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementType = MET_UCHAR\nElementDataFile = v.raw\n");
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder.path());
    const auto missing = readStudy("v.mhd");
    folder.write("v.raw", std::string(24, 'v'));
    const auto there = readStudy("v.mhd");
    std::filesystem::current_path(before);
    ASSERT_FALSE(missing);
    EXPECT_THAT(missing.error().sentence(), HasSubstr("v.raw: could not be opened: it does not exist"));
    EXPECT_TRUE(there) << there.error().sentence();
}

}  // namespace
}  // namespace echolucent
