// What readers hand over of a large volume before they have read all of it: the file's own voxels, few of them, early.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "io/study/study.h"
#include "io/writers/meta_image_writer.h"
#include "nifti_files.h"
#include "processing/volume/coarse_grid.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

// No multiples of the coarse grid's stride, and a little more than the least that has one.
constexpr std::int64_t wholeWidth = 331, wholeHeight = 322, wholeDepth = 316;
constexpr std::int64_t wholeVoxels = wholeWidth * wholeHeight * wholeDepth;

/// Values that neighbours do not share, and none of them 0.
template <typename Value>
std::string voxelBytes(std::int64_t phases = 1) {
    std::vector<Value> values(static_cast<std::size_t>(wholeVoxels * phases));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<Value>(1 + ((i * 2654435761U) >> 9) % 250);
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
}

std::string metaImageHeader(const std::string& type, const std::string& data = "LOCAL", const std::string& more = {}) {
    return fmt::format(
        "ObjectType = Image\nNDims = 3\nDimSize = {} {} {}\nElementSpacing = 0.3 0.3 0.3\n{}ElementType "
        "= {}\nElementDataFile = {}\n",
        wholeWidth, wholeHeight, wholeDepth, more, type, data);
}

/// Bytes that this process has read from files so far.
std::uint64_t bytesRead() {
    std::ifstream counts("/proc/self/io");
    std::string name;
    std::uint64_t count = 0;
    counts >> name >> count;
    return name == "rchar:" ? count : 0;
}

struct ReadWithCoarse {
    Result<Study> study;
    std::vector<CoarseVolume> coarse;
    std::uint64_t bytesBefore = 0;  ///< that were read before the coarse volume was handed over
};

ReadWithCoarse readWithCoarse(const std::string& path, const ReadOptions& options = {}) {
    std::vector<CoarseVolume> told;
    const std::uint64_t begin = bytesRead();
    std::uint64_t before = 0;
    Progress progress;
    progress.coarse = [&](const CoarseVolume& coarse) {
        before = bytesRead() - begin;
        told.push_back(coarse);
    };
    auto study = readStudy(path, options, progress);
    return {std::move(study), std::move(told), before};
}

void expectVoxelsOfTheFile(const ReadWithCoarse& read) {
    ASSERT_TRUE(read.study) << read.study.error().sentence();
    ASSERT_EQ(read.coarse.size(), 1U);
    const Volume& full = *read.study->phases.front();
    const Volume& coarse = *read.coarse.front().voxels;
    const auto grid = coarseGridOf(full.geometry());
    ASSERT_TRUE(grid);
    EXPECT_EQ(coarse.geometry().size, grid->geometry.size);
    EXPECT_EQ(coarse.geometry().spacing, grid->geometry.spacing);
    EXPECT_LT(length(coarse.geometry().origin - grid->geometry.origin), 1e-9);
    EXPECT_EQ(coarse.geometry().direction, grid->geometry.direction);
    EXPECT_EQ(coarse.dataBox(), grid->boxOfVolume());
    EXPECT_EQ(coarse.whiteLevel(), full.whiteLevel());
    EXPECT_EQ(read.coarse.front().units, grid->geometry.unit() / full.geometry().unit());
    const auto& size = grid->geometry.size;
    std::int64_t wrong = 0;
    for (std::int64_t z = 0; z < size[2]; ++z)
        for (std::int64_t y = 0; y < size[1]; ++y)
            for (std::int64_t x = 0; x < size[0]; ++x)
                wrong += coarse.storedValue(grid->geometry.offset(x, y, z)) !=
                         full.storedValue(
                             full.geometry().offset(grid->voxelOf(0, x), grid->voxelOf(1, y), grid->voxelOf(2, z)));
    EXPECT_EQ(wrong, 0);
}

TEST(CoarseReading, HandsOverEveryThirdVoxelOfAMetaImageAndReadsAThirdOfItBefore) {
    const TemporaryFolder folder;
    const auto read = readWithCoarse(folder.write("a.mha", metaImageHeader("MET_UCHAR") + voxelBytes<std::uint8_t>()));
    expectVoxelsOfTheFile(read);
    ASSERT_GT(read.bytesBefore, 0U);
    EXPECT_LT(read.bytesBefore, static_cast<std::uint64_t>(wholeVoxels) * 2 / 5)
        << "the header is read with what follows it";
}

TEST(CoarseReading, KnowsWhatIsStoredInTwoBytesOfEitherOrder) {
    const TemporaryFolder folder;
    const std::string bytes = voxelBytes<std::uint16_t>();
    expectVoxelsOfTheFile(readWithCoarse(folder.write("a.mha", metaImageHeader("MET_USHORT") + bytes)));
    std::string swapped = bytes;
    for (std::size_t i = 0; i < swapped.size(); i += 2) std::swap(swapped[i], swapped[i + 1]);
    expectVoxelsOfTheFile(readWithCoarse(
        folder.write("b.mha", metaImageHeader("MET_USHORT", "LOCAL", "BinaryDataByteOrderMSB = True\n") + swapped)));
}

TEST(CoarseReading, FindsSlicesInFilesOfTheirOwn) {
    const TemporaryFolder folder;
    const std::string bytes = voxelBytes<std::uint8_t>();
    for (std::int64_t z = 0; z < wholeDepth; ++z)
        folder.write(fmt::format("s{:03}.raw", z), bytes.substr(static_cast<std::size_t>(z * wholeWidth * wholeHeight),
                                                                static_cast<std::size_t>(wholeWidth * wholeHeight)));
    expectVoxelsOfTheFile(readWithCoarse(
        folder.write("a.mhd", metaImageHeader("MET_UCHAR", fmt::format("s%03d.raw 0 {} 1", wholeDepth - 1)))));
}

TEST(CoarseReading, IsThatOfNrrdAndOfARawLayoutToo) {
    const TemporaryFolder folder;
    const std::string bytes = voxelBytes<std::uint8_t>();
    expectVoxelsOfTheFile(readWithCoarse(folder.write(
        "a.nrrd", fmt::format("NRRD0004\ntype: uint8\ndimension: 3\nsizes: {} {} {}\nspacings: 0.3 0.3 0.4\nencoding: "
                              "raw\n\n",
                              wholeWidth, wholeHeight, wholeDepth) +
                      bytes)));
    ReadOptions options;
    options.raw = RawLayout{};
    options.raw->size = {wholeWidth, wholeHeight, wholeDepth};
    options.raw->headerBytes = 17;
    options.raw->spacing = Vec3(0.2, 0.3, 0.3);
    expectVoxelsOfTheFile(readWithCoarse(folder.write("a.raw", std::string(17, '\0') + bytes), options));
}

TEST(CoarseReading, OfALeftHandedGridIsThatOfTheGridThatWasTurnedRound) {
    const TemporaryFolder folder;
    const auto read = readWithCoarse(folder.write(
        "a.mha", metaImageHeader("MET_UCHAR", "LOCAL", "TransformMatrix = 1 0 0 0 -1 0 0 0 1\nOffset = 1 2 3\n") +
                     voxelBytes<std::uint8_t>()));
    expectVoxelsOfTheFile(read);
    EXPECT_EQ(read.study->turnedAxis, GridAxis::y);
}

TEST(CoarseReading, ShowsTheFirstPhase) {
    const TemporaryFolder folder;
    std::string header = metaImageHeader("MET_UCHAR");
    const auto replace = [&](const std::string& before, const std::string& after) {
        header.replace(header.find(before), before.size(), after);
    };
    replace("NDims = 3", "NDims = 4");
    replace(fmt::format("{} {} {}", wholeWidth, wholeHeight, wholeDepth),
            fmt::format("{} {} {} 2", wholeWidth, wholeHeight, wholeDepth));
    replace("0.3 0.3 0.3", "0.3 0.3 0.3 1");
    const auto read = readWithCoarse(folder.write("a.mha", header + voxelBytes<std::uint8_t>(2)));
    expectVoxelsOfTheFile(read);
    EXPECT_EQ(read.study->phases.size(), 2U);
}

TEST(CoarseReading, GuessesWhereThereAreNoDataAsReadingDoes) {
    const TemporaryFolder folder;
    std::string bytes = voxelBytes<std::uint8_t>();
    // A wedge without data, thick enough for both grids.
    for (std::int64_t i = 0; i < wholeVoxels; ++i)
        if (i % wholeWidth < 60) bytes[static_cast<std::size_t>(i)] = '\0';
    const auto read = readWithCoarse(folder.write("a.mha", metaImageHeader("MET_UCHAR") + bytes));
    ASSERT_TRUE(read.study && read.coarse.size() == 1U);
    const Volume& full = *read.study->phases.front();
    const Volume& coarse = *read.coarse.front().voxels;
    ASSERT_FALSE(full.dataMask().empty());
    const auto grid = coarseGridOf(full.geometry());
    ASSERT_EQ(coarse.dataMask().size(), static_cast<std::size_t>(grid->geometry.voxelCount()));
    for (std::int64_t x = 0; x < grid->geometry.size[0]; ++x)
        EXPECT_EQ(coarse.hasData(grid->geometry.offset(x, 40, 40)),
                  full.hasData(full.geometry().offset(grid->voxelOf(0, x), grid->voxelOf(1, 40), grid->voxelOf(2, 40))))
            << x;
}

TEST(CoarseReading, IsLeftOutWhereVoxelsArePackedOrFewOrNobodyWantsIt) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.mha", metaImageHeader("MET_UCHAR") + voxelBytes<std::uint8_t>());
    const auto plain = readStudy(path);
    ASSERT_TRUE(plain);
    ASSERT_TRUE(writeMetaImage(folder.file("packed.mha"), plain->phases));
    const auto packed = readWithCoarse(folder.file("packed.mha"));
    ASSERT_TRUE(packed.study) << packed.study.error().sentence();
    EXPECT_TRUE(packed.coarse.empty());
    const auto small = readWithCoarse(
        folder.write("small.mha",
                     "ObjectType = Image\nNDims = 3\nDimSize = 8 8 8\nElementSpacing = 1 1 1\nElementType = MET_UCHAR\n"
                     "ElementDataFile = LOCAL\n" +
                         std::string(512, 'v')));
    ASSERT_TRUE(small.study);
    EXPECT_TRUE(small.coarse.empty());
}

TEST(CoarseReading, DoesNotHideThatTheFileIsRefused) {
    const TemporaryFolder folder;
    std::string bytes = voxelBytes<float>();
    bytes.resize(bytes.size() - sizeof(float));
    const auto cut = readWithCoarse(folder.write("cut.mha", metaImageHeader("MET_FLOAT") + bytes));
    ASSERT_FALSE(cut.study);
    EXPECT_TRUE(cut.coarse.empty()) << "the file's size says it before";

    // The last voxel is on no coarse grid, and on this line larger than float64 holds.
    std::string floats = voxelBytes<float>();
    const float large = 1e30F;
    floats.replace(floats.size() - sizeof large, sizeof large, reinterpret_cast<const char*>(&large), sizeof large);
    NiftiFields fields;
    fields.version = 2;
    fields.dim = {3, wholeWidth, wholeHeight, wholeDepth};
    fields.datatype = 16;
    fields.bitpix = 32;
    fields.slope = 1e280;
    const auto late = readWithCoarse(folder.write("late.nii", niftiHeader(fields) + floats));
    ASSERT_FALSE(late.study);
    EXPECT_EQ(late.coarse.size(), 1U);
}

TEST(CoarseReading, TakesNoSpacingThatReadingRefuses) {
    const TemporaryFolder folder;
    const std::string bytes = voxelBytes<std::uint8_t>();
    for (const char* spacing : {"1e-9 1e-9 1e-9", "1e300 1e300 1e300", "1e-3 1 1e3"}) {
        std::string header = metaImageHeader("MET_UCHAR");
        header.replace(header.find("0.3 0.3 0.3"), 11, spacing);
        const auto read = readWithCoarse(folder.write("a.mha", header + bytes));
        EXPECT_FALSE(read.study) << spacing;
        EXPECT_TRUE(read.coarse.empty()) << spacing;
    }
}

TEST(CoarseReading, MayBeCancelledThere) {
    const TemporaryFolder folder;
    const std::string path = folder.write("a.mha", metaImageHeader("MET_UCHAR") + voxelBytes<std::uint8_t>());
    std::atomic<bool> cancel = false;
    Progress progress{{}, &cancel};
    progress.coarse = [&](const CoarseVolume&) { cancel = true; };
    const auto study = readStudy(path, {}, progress);
    ASSERT_FALSE(study);
    EXPECT_EQ(study.error().kind, FailureKind::cancelled);
}

}  // namespace
}  // namespace echolucent
