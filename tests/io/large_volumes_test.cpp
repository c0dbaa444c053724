// Volumes beyond the memory that a study may take: which they are, and what is read of them.
#include "io/voxels/large_volumes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <limits>
#include <random>

#include <fmt/format.h>

#include "dicom_files.h"
#include "io/files/input_file.h"
#include "processing/volume/block_mean.h"
#include "temporary_folder.h"
#include "tests/inputs.h"
#include "zlib_bytes.h"

namespace echolucent {
namespace {

using testing::HasSubstr;
using Size = std::array<std::int64_t, 3>;

constexpr std::int64_t mebi = std::int64_t{1} << 20;

/// The least that may be asked for: a study may take 1 MiB.
ReadOptions leastMemory() {
    ReadOptions options = withoutGuess();
    options.studyMebibytes = 1;
    return options;
}

ReadOptions mebibytes(std::int64_t count) {
    ReadOptions options;
    options.studyMebibytes = count;
    return options;
}

std::optional<Size> factorsFor(const DeclaredVoxels& declared, const ReadOptions& options) {
    const auto chosen = chooseReduction("v.mha", "DimSize", declared, options);
    EXPECT_TRUE(chosen) << chosen.error().sentence();
    if (!chosen || !*chosen) return std::nullopt;
    return (*chosen)->reduction.by;
}

TEST(LargeVolumes, ACubeOf1024IsReducedOnAnyMachine) {
    const auto chosen = chooseReduction("v.mha", "DimSize", {{1024, 1024, 1024}}, mebibytes(1 << 20));
    ASSERT_TRUE(chosen && *chosen);
    EXPECT_EQ((*chosen)->reduction, (Reduction{{2, 2, 2}, {1024, 1024, 1024}}));
    EXPECT_THAT(reductionWarning(**chosen),
                HasSubstr("The file holds 1024 x 1024 x 1024 voxels, and at most 536870912 voxels are kept of a phase: "
                          "one voxel shows the mean of 2 x 2 x 2."));
    EXPECT_EQ(factorsFor({{1024, 1024, 512}}, mebibytes(1 << 20)), std::nullopt);
    // A phase may keep so many voxels, however many phases there are.
    EXPECT_EQ(factorsFor({{1024, 1024, 512}, 4}, mebibytes(1 << 20)), std::nullopt);
    EXPECT_EQ(factorsFor({{1024, 1024, 513}, 4}, mebibytes(1 << 20)), (Size{2, 2, 2}));
}

TEST(LargeVolumes, PhasesAndWideTypesCount) {
    EXPECT_EQ(factorsFor({{100, 100, 100}, 20}, mebibytes(20)), std::nullopt);
    EXPECT_EQ(factorsFor({{100, 100, 100}, 21}, mebibytes(20)), (Size{2, 2, 2}));
    EXPECT_EQ(factorsFor({{100, 100, 100}, 10, StoredType::uint16}, mebibytes(20)), std::nullopt);
    EXPECT_EQ(factorsFor({{100, 100, 100}, 11, StoredType::uint16}, mebibytes(20)), (Size{2, 2, 2}));
    EXPECT_EQ(factorsFor({{100, 100, 100}, 6, StoredType::int16}, mebibytes(20)), (Size{2, 2, 2}));
    EXPECT_EQ(factorsFor({{100, 100, 100}, 6, StoredType::uint8, true}, mebibytes(20)), (Size{2, 2, 2}));
}

TEST(LargeVolumes, AStudyMayTakeASixthOfTheMachinesMemory) {
    EXPECT_EQ(mostStudyBytes({}), machineMemoryBytes() / 6);
    EXPECT_EQ(mostStudyBytes(mebibytes(3)), std::uint64_t{3} << 20);
}

TEST(LargeVolumes, APhaseKeepsNoMoreVoxelsThanTheMachineCanWorkOn) {
    EXPECT_EQ(mostVoxelsOfPhase(std::uint64_t{64} << 30), std::int64_t{1} << 29);
    EXPECT_EQ(mostVoxelsOfPhase(std::uint64_t{9} << 30), std::int64_t{1} << 29);
    EXPECT_EQ(mostVoxelsOfPhase(std::uint64_t{9} << 29), std::int64_t{1} << 28);
}

TEST(LargeVolumes, WhatCannotBeReducedIsRefused) {
    const auto refused =
        chooseReduction("v.mha", "DimSize", {{2, 2, 2}, 4096, StoredType::float32}, [] { return mebibytes(0); }());
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().sentence(),
              "v.mha: DimSize declares 4096 phase(s) of 2 x 2 x 2 voxels, which cannot be reduced to the 0 MiB that "
              "they may take here. Open it on a larger machine, or a smaller part of it.");
    constexpr std::int64_t huge = std::numeric_limits<std::int64_t>::max();
    EXPECT_FALSE(chooseReduction("v.mha", "DimSize", {{huge, huge, huge}}, {}));
}

/// A grid whose voxels take more than 1 MiB, and whose size no factor divides.
constexpr Size largeGrid{151, 101, 101};
constexpr std::size_t gridVoxels = 151 * 101 * 101;

template <typename T>
std::vector<T> randomVoxels(int least, int most, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::vector<T> values(gridVoxels);
    for (T& value : values)
        value = static_cast<T>(least + static_cast<int>(random() % static_cast<unsigned>(most - least + 1)));
    return values;
}

template <typename T>
std::vector<double> meansOf(const std::vector<T>& values, const Reduction& reduction) {
    const auto size = reducedSize(reduction);
    std::vector<T> means(static_cast<std::size_t>(size[0] * size[1] * size[2]));
    BlockMean<T> mean(reduction, means);
    const auto slice = static_cast<std::size_t>(reduction.storedSize[0] * reduction.storedSize[1]);
    for (std::size_t z = 0; z < static_cast<std::size_t>(reduction.storedSize[2]); ++z)
        mean.add(std::span(values).subspan(z * slice, slice));
    return {means.begin(), means.end()};
}

std::string largeMetaImage(const std::string& type, const std::string& more, const std::string& voxels) {
    return fmt::format(
        "ObjectType = Image\nNDims = 3\nDimSize = 151 101 101\nElementSpacing = 0.5 0.25 2\nOffset = 10 20 30\n"
        "ElementType = {}\n{}ElementDataFile = LOCAL\n{}",
        type, more, voxels);
}

/// How a file of one type is read: what is written, what is kept of it.
template <typename T>
void expectMeans(const char* type, std::int64_t factor, const char* kept, int least, int most) {
    const auto voxels = randomVoxels<T>(least, most);
    const Reduction reduction{{factor, factor, factor}, largeGrid};
    for (const bool big : {false, true}) {
        const TemporaryFolder folder;
        const std::string bytes = bytesFrom(voxels, big);
        const std::string order = std::string("BinaryDataByteOrderMSB = ") + (big ? "True\n" : "False\n");
        const std::string path =
            big ? folder.write("v.mha", largeMetaImage(type, order + "CompressedData = True\n", deflated(bytes)))
                : folder.write("v.mha", largeMetaImage(type, order, bytes));
        const auto study = readStudy(path, leastMemory());
        ASSERT_TRUE(study) << study.error().sentence();
        const Volume& volume = *study->phases.at(0);
        EXPECT_EQ(volume.geometry().reduction, reduction) << type;
        EXPECT_EQ(volume.typeName(), kept);
        EXPECT_EQ(storedValues(volume), meansOf(voxels, reduction)) << type;
    }
}

TEST(LargeVolumes, MeansAreReadOfEveryTypeInBothByteOrdersPlainAndCompressed) {
    expectMeans<std::uint8_t>("MET_UCHAR", 2, "uint8", 0, 255);
    expectMeans<std::int16_t>("MET_SHORT", 2, "uint16", 0, 30000);
    if (takesSomeInputs) return;
    expectMeans<std::int8_t>("MET_CHAR", 2, "uint8", -100, 100);
    expectMeans<std::uint16_t>("MET_USHORT", 2, "uint16", 0, 65535);
    expectMeans<std::uint32_t>("MET_UINT", 2, "uint16", 0, 60000);
    expectMeans<std::int64_t>("MET_LONG_LONG", 2, "uint16", 0, 60000);
    expectMeans<float>("MET_FLOAT", 2, "float32", 0, 1000);
    expectMeans<double>("MET_DOUBLE", 2, "float32", 0, 8);
}

TEST(LargeVolumes, AReducedVolumeSaysSoAndStandsWhereItStood) {
    const TemporaryFolder folder;
    const std::string path =
        folder.write("v.mha", largeMetaImage("MET_UCHAR", "", bytesFrom(randomVoxels<std::uint8_t>(0, 9))));
    const auto whole = readStudy(path, withoutGuess());
    const auto study = readStudy(path, leastMemory());
    ASSERT_TRUE(whole && study);
    EXPECT_FALSE(whole->phases[0]->geometry().reduction);
    EXPECT_EQ(factOf(*whole, "reduced"), "none");
    EXPECT_EQ(factOf(*study, "size"), "76 x 51 x 51 voxels");
    EXPECT_EQ(factOf(*study, "spacing"), "1 x 0.5 x 4 mm");
    EXPECT_EQ(factOf(*study, "reduced"), "means of 2 x 2 x 2 of 151 x 101 x 101 voxels");
    EXPECT_EQ(sourceOf(*study, "reduced"), "the voxels of a study may take 1 MiB as asked for");
    EXPECT_TRUE(warnsOf(*study,
                        "The file holds 151 x 101 x 101 voxels, and the voxels of a study may take 1 MiB as "
                        "asked for: one voxel shows the mean of 2 x 2 x 2. Lengths stay true"));
    const VolumeGeometry &from = whole->phases[0]->geometry(), &to = study->phases[0]->geometry();
    EXPECT_LT(length(to.patientFromVoxel(Vec3(3, 4, 5)) - from.patientFromVoxel(Vec3(6.5, 8.5, 10.5))), 1e-9);
}

TEST(LargeVolumes, ValuesThatAreNotFiniteDoNotCount) {
    auto voxels = randomVoxels<float>(0, 1000);
    for (std::size_t index = 0; index < voxels.size(); index += 3) voxels[index] = std::nanf("");
    for (const std::size_t index : {0, 1, 151, 152}) voxels[index] = voxels[index + 151 * 101] = std::nanf("");
    const TemporaryFolder folder;
    const auto study =
        readStudy(folder.write("v.mha", largeMetaImage("MET_FLOAT", "", bytesFrom(voxels))), leastMemory());
    ASSERT_TRUE(study) << study.error().sentence();
    const auto means = meansOf(voxels, *study->phases[0]->geometry().reduction);
    ASSERT_TRUE(std::isnan(means[0]));
    for (std::size_t index = 0; index < means.size(); ++index) {
        const auto offset = static_cast<std::int64_t>(index);
        ASSERT_EQ(study->phases[0]->hasData(offset), std::isfinite(means[index])) << index;
        if (std::isfinite(means[index])) {
            ASSERT_EQ(study->phases[0]->storedValue(offset), means[index]);
        }
    }
}

std::string largeNrrd(const std::string& sizes, const std::string& kinds, const std::string& encoding,
                      const std::string& voxels) {
    return fmt::format("NRRD0004\ntype: uchar\ndimension: 4\nsizes: {}\nkinds: {}\nencoding: {}\n\n{}", sizes, kinds,
                       encoding, voxels);
}

TEST(LargeVolumes, PhasesAreReducedAlikeInWhateverOrderTheyLie) {
    const std::vector<std::vector<std::uint8_t>> phases{randomVoxels<std::uint8_t>(0, 255, 1),
                                                        randomVoxels<std::uint8_t>(0, 200, 2)};
    const Reduction reduction{{2, 2, 2}, largeGrid};
    std::string slowest = bytesFrom(phases[0]) + bytesFrom(phases[1]), fastest;
    for (std::size_t voxel = 0; voxel < gridVoxels; ++voxel)
        for (const auto& phase : phases) fastest.push_back(static_cast<char>(phase[voxel]));
    const TemporaryFolder folder;
    for (const std::string& path :
         {folder.write("slowest.nrrd",
                       largeNrrd("151 101 101 2", "domain domain domain time", "gzip", deflated(slowest, 31))),
          folder.write("fastest.nrrd", largeNrrd("2 151 101 101", "time domain domain domain", "raw", fastest))}) {
        const auto study = readStudy(path, leastMemory());
        ASSERT_TRUE(study) << study.error().sentence();
        ASSERT_EQ(study->phases.size(), 2);
        for (std::size_t phase = 0; phase < 2; ++phase) {
            EXPECT_EQ(study->phases[phase]->geometry().reduction, reduction);
            EXPECT_EQ(storedValues(*study->phases[phase]), meansOf(phases[phase], reduction)) << path;
        }
    }
}

TEST(LargeVolumes, ColourIsReducedToLumaFirst) {
    const auto grey = randomVoxels<std::uint8_t>(0, 255);
    std::vector<std::uint8_t> colours;
    for (const std::uint8_t value : grey) colours.insert(colours.end(), 3, value);
    const TemporaryFolder folder;
    const auto study = readStudy(
        folder.write("v.mha", largeMetaImage("MET_UCHAR", "ElementNumberOfChannels = 3\n", bytesFrom(colours))),
        leastMemory());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(storedValues(*study->phases[0]), meansOf(grey, {{2, 2, 2}, largeGrid}));
}

TEST(LargeVolumes, AFileThatHoldsLessIsRefusedAsEver) {
    const TemporaryFolder folder;
    const std::string path = folder.write("v.mha", largeMetaImage("MET_UCHAR", "", std::string(gridVoxels - 1, 'v')));
    const auto study = readStudy(path, leastMemory()), whole = readStudy(path);
    ASSERT_FALSE(study || whole);
    EXPECT_EQ(study.error().sentence(), whole.error().sentence());
    const std::string cut = deflated(bytesFrom(randomVoxels<std::uint8_t>(0, 255)));
    const auto damaged = readStudy(
        folder.write("c.mha", largeMetaImage("MET_UCHAR", "CompressedData = True\n", cut.substr(0, cut.size() - 40))),
        leastMemory());
    ASSERT_FALSE(damaged);
}

TEST(LargeVolumes, ReadingEndsWhereThePersonEndsIt) {
    const TemporaryFolder folder;
    const std::string path = folder.write("v.mha", largeMetaImage("MET_UCHAR", "", std::string(gridVoxels, 'v')));
    std::atomic<bool> cancel = false;
    const Progress progress{.report = [&](double share) { cancel = share > 0.3; }, .cancel = &cancel};
    const auto study = readStudy(path, leastMemory(), progress);
    ASSERT_FALSE(study);
    EXPECT_EQ(study.error().kind, FailureKind::cancelled);
}

TestImage sliceOf(const std::vector<std::uint8_t>& voxels, int z) {
    TestImage image;
    image.columns = 151;
    image.rows = 101;
    image.instance = z + 1;
    const auto begin = voxels.begin() + std::ptrdiff_t{151} * 101 * z;
    image.pixels8.assign(begin, begin + std::ptrdiff_t{151} * 101);
    image.pixels8.push_back(0);  // pixel data are even
    image.position = Vec3(1, 2, 0.5 * z);
    image.orientation = {1, 0, 0, 0, 1, 0};
    image.pixelSpacing = {0.25, 0.25};
    return image;
}

TEST(LargeVolumes, SlicesOfASeriesAreAveragedOneByOne) {
    const TemporaryFolder folder;
    const auto voxels = randomVoxels<std::uint8_t>(0, 255);
    for (int z = 0; z < 101; ++z) writeDicom(folder.file(fmt::format("{:03}", z)), sliceOf(voxels, z));
    const auto study = readStudy(folder.path(), leastMemory());
    ASSERT_TRUE(study) << study.error().sentence();
    const Reduction reduction{{2, 2, 2}, largeGrid};
    EXPECT_EQ(study->phases[0]->geometry().reduction, reduction);
    EXPECT_EQ(storedValues(*study->phases[0]), meansOf(voxels, reduction));
    EXPECT_LT(length(study->phases[0]->geometry().origin - Vec3(1.125, 2.125, 0.25)), 1e-9);
}

TEST(LargeVolumes, SlicesThatCannotBeReadDoNotCount) {
    const TemporaryFolder folder;
    const auto voxels = randomVoxels<std::uint8_t>(1, 255);
    for (int z = 0; z < 101; ++z) {
        const std::string path = folder.file(fmt::format("{:03}", z));
        writeDicom(path, sliceOf(voxels, z));
        if (z == 0 || z == 21 || z == 30 || z == 31)
            std::filesystem::resize_file(path, std::filesystem::file_size(path) - 200);
    }
    const auto study = readStudy(folder.path(), leastMemory());
    ASSERT_TRUE(study) << study.error().sentence();
    const Volume& volume = *study->phases[0];
    const auto means = meansOf(voxels, {{2, 2, 2}, largeGrid});
    const std::size_t slice = 76 * 51;
    for (std::size_t z = 0; z < 51; ++z) {
        EXPECT_EQ(volume.hasData(static_cast<std::int64_t>(z * slice)), z != 15) << z;
        // Of a layer of which one slice is missing, the other alone is shown.
        const double first = volume.storedValue(static_cast<std::int64_t>(z * slice));
        const std::size_t at = (z == 0 ? 1 : 2 * z) * 151 * 101;
        const double alone =
            std::floor((voxels[at] + voxels[at + 1] + voxels[at + 151] + voxels[at + 152]) / 4.0 + 0.5);
        EXPECT_EQ(first, z == 15 ? 0.0 : z == 0 || z == 10 ? alone : means[z * slice]) << z;
    }
    EXPECT_TRUE(warnsOf(*study, "4 of 101 slices could not be read"));
}

TEST(LargeVolumes, FramesOfOneFileAreAveragedOneByOne) {
    const TemporaryFolder folder;
    const auto voxels = randomVoxels<std::uint8_t>(0, 255);
    TestImage image = sliceOf(voxels, 0);
    image.frames = 101;
    image.pixels8 = voxels;
    image.pixels8.push_back(0);
    image.spacingBetweenSlices = 0.5;
    for (int z = 0; z < 101; ++z) image.gridOffsets.push_back(0.5 * z);
    writeDicom(folder.file("v.dcm"), image);
    const auto whole = readStudy(folder.file("v.dcm"), withoutGuess());
    ASSERT_TRUE(whole) << whole.error().sentence();
    ASSERT_EQ(whole->phases[0]->geometry().size, largeGrid);
    const auto study = readStudy(folder.file("v.dcm"), leastMemory());
    ASSERT_TRUE(study) << study.error().sentence();
    const Reduction reduction{{2, 2, 2}, largeGrid};
    EXPECT_EQ(study->phases[0]->geometry().reduction, reduction);
    EXPECT_EQ(storedValues(*study->phases[0]), meansOf(voxels, reduction));
}

}  // namespace
}  // namespace echolucent
