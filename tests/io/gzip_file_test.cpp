// Files packed with gzip as a whole.
#include "io/voxels/gzip_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numeric>

#include "dicom_files.h"
#include "nifti_files.h"
#include "temporary_folder.h"
#include "zlib_bytes.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

std::string packed(const std::string& bytes) { return deflated(bytes, 31); }

/// Headers of 2 x 3 x 4 bytes, which are countedVoxels.
std::string byteMetaImage(const std::string& data = "LOCAL") {
    return "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 2 3\nElementType = MET_UCHAR\n"
           "ElementDataFile = " +
           data + "\n";
}
std::string byteNrrd(const std::string& encoding) {
    return "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 3 4\nspacings: 1 2 3\nencoding: " + encoding + "\n\n";
}

void expectVoxels(const std::string& file, const ReadOptions& options = withoutGuess()) {
    const auto study = readStudy(file, options);
    ASSERT_TRUE(study) << study.error().sentence();
    const auto values = storedValues(*study->phases[0]);
    ASSERT_EQ(values.size(), 24U) << file;
    for (std::size_t i = 0; i < 24; ++i) EXPECT_EQ(values[i], i + 1) << file;
    EXPECT_THAT(factOf(*study, "file"), testing::StartsWith("gzip, ")) << file;
    EXPECT_THAT(study->files, testing::Contains(file));
}

TEST(GzipFile, OfEveryFormatOpensAsIfItWereNotPacked) {
    const TemporaryFolder folder;
    expectVoxels(folder.write("v.mha.gz", packed(byteMetaImage() + countedVoxels)));
    folder.write("v.raw", countedVoxels);
    expectVoxels(folder.write("v.mhd.gz", packed(byteMetaImage("v.raw"))));
    expectVoxels(folder.write("v.nrrd.gz", packed(byteNrrd("raw") + countedVoxels)));
    expectVoxels(folder.write("w.nrrd.gz", packed(byteNrrd("gzip") + packed(countedVoxels))));
    NiftiFields fields;
    expectVoxels(folder.write("v.nii.gz", packed(niftiHeader(fields) + countedVoxels)));
    expectVoxels(folder.write("content-decides.dat", packed(niftiHeader(fields) + countedVoxels)));
    expectVoxels(folder.write("V.MHA.GZ", packed(byteMetaImage() + countedVoxels)));
}

TEST(GzipFile, OfRawVoxelsIsUnpackedWhereItsNameSaysSo) {
    const TemporaryFolder folder;
    ReadOptions options = withoutGuess();
    options.raw = RawLayout{};
    options.raw->size = {2, 3, 4};
    const std::string file = folder.write("v.raw.gz", packed(countedVoxels));
    expectVoxels(file, options);
    // Layouts kept beside the packed file, and beside what it was packed from.
    ASSERT_TRUE(rememberRawLayout(file, *options.raw));
    expectVoxels(file);
    std::filesystem::remove(folder.file("v.raw.gz.echolucent.json"));
    ASSERT_TRUE(rememberRawLayout(folder.file("v.raw"), *options.raw));
    expectVoxels(file);
    // Voxels that begin like gzip by chance are no gzip file where a layout describes them.
    options.raw->size = {2, 2, 1};
    const auto chance = readStudy(folder.write("v.bin", "\x1f\x8b\x08\x05"), options);
    ASSERT_TRUE(chance) << chance.error().sentence();
    EXPECT_THAT(storedValues(*chance->phases[0]), testing::ElementsAre(0x1f, 0x8b, 8, 5));
}

TEST(GzipFile, OfDicomIsReadThroughMemory) {
    const TemporaryFolder folder;
    TestImage image;
    image.frames = 3;
    image.pixels8.resize(36);
    std::iota(image.pixels8.begin(), image.pixels8.end(), std::uint8_t{1});
    image.pixelSpacing = {0.25, 0.25};
    image.spacingBetweenSlices = 0.5;
    writeDicom(folder.file("v.dcm"), image);
    const std::string bytes = contentsOf(folder.file("v.dcm"));
    const auto plain = readStudy(folder.file("v.dcm"), withoutGuess());
    const auto unpacked = readStudy(folder.write("p.dcm.gz", packed(bytes)), withoutGuess());
    ASSERT_TRUE(plain) << plain.error().sentence();
    ASSERT_TRUE(unpacked) << unpacked.error().sentence();
    EXPECT_EQ(plain->phases[0]->voxels(), unpacked->phases[0]->voxels());
    EXPECT_EQ(plain->phases[0]->geometry().spacing, unpacked->phases[0]->geometry().spacing);
}

TEST(GzipFile, MayHaveSeveralMembersAndPadding) {
    const TemporaryFolder folder;
    const std::string whole = byteMetaImage() + countedVoxels;
    const std::string parts = packed(whole.substr(0, 10)) + packed("") + packed(whole.substr(10));
    expectVoxels(folder.write("v.mha.gz", parts));
    expectVoxels(folder.write("padded.mha.gz", parts + std::string(512, '\0')));
}

TEST(GzipFile, ThatIsCutAnywhereSaysSo) {
    const TemporaryFolder folder;
    const std::string whole = packed(byteMetaImage() + countedVoxels);
    const auto sentenceOf = [&](const std::string& bytes) {
        const auto study = readStudy(folder.write("v.mha.gz", bytes));
        return study ? std::string("was read") : study.error().sentence();
    };
    EXPECT_EQ(sentenceOf(whole), "was read");
    for (std::size_t length = 3; length < whole.size(); ++length)
        EXPECT_THAT(sentenceOf(whole.substr(0, length)), HasSubstr("is gzip that ends too early")) << length;
}

TEST(GzipFile, ThatUnpacksToFarMoreThanAVolumeDoesIsRefused) {
    const TemporaryFolder folder;
    EXPECT_EQ(mostUnpackedBytes(100), std::min(machineMemoryBytes() / 2, std::uint64_t{256} << 20));
    EXPECT_EQ(mostUnpackedBytes(std::uint64_t{10} << 20), std::min(machineMemoryBytes() / 2, std::uint64_t{320} << 20));
    std::string bomb;
    const std::string member = packed(std::string(std::size_t{16} << 20, '\0'));
    for (int i = 0; i < 17; ++i) bomb += member;  // 272 MiB
    const auto study = readStudy(folder.write("bomb.nii.gz", bomb));
    ASSERT_FALSE(study);
    EXPECT_THAT(study.error().sentence(), HasSubstr("unpacks to more than 268435456 bytes"));
}

TEST(GzipFile, IsGivenUpOnCancel) {
    const TemporaryFolder folder;
    const std::string file = folder.write("v.nii.gz", packed(std::string(std::size_t{32} << 20, '\0')));
    std::atomic<bool> cancel{false};
    std::vector<double> shares;
    const Progress progress{[&](double share) {
                                shares.push_back(share);
                                cancel = shares.size() == 5;
                            },
                            &cancel};
    const auto study = readStudy(file, {}, progress);
    ASSERT_FALSE(study);
    EXPECT_EQ(study.error().kind, FailureKind::cancelled);
    EXPECT_LE(shares.size(), 6U);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
}

}  // namespace
}  // namespace echolucent
