// NIfTI in two files, .hdr and .img, and what else bears those names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "nifti_files.h"
#include "zlib_bytes.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

std::string analyzeHeader() {
    NiftiFields fields;
    fields.apart = true;
    std::string header = niftiHeader(fields);
    header[38] = 'r';
    header.replace(344, 4, std::string(4, '\0'));
    return header;
}

ReadOptions rawOfTwentyFour() {
    ReadOptions options = withoutGuess();
    options.raw = RawLayout{};
    options.raw->size = {2, 3, 4};
    return options;
}

TEST(NiftiPair, FilesOfAPairOpenByEitherName) {
    NiftiFields fields;
    fields.apart = true;
    for (const auto& [header, image] :
         {std::pair{"a.hdr", "a.img"}, std::pair{"A.HDR", "A.IMG"}, std::pair{"a.hdr.gz", "a.img.gz"},
          std::pair{"a.hdr", "a.img.gz"}, std::pair{"a.hdr.gz", "a.img"}})
        for (const int version : {1, 2}) {
            const TemporaryFolder folder;
            fields.version = version;
            const auto pack = [](const std::string& name, const std::string& bytes) {
                return name.ends_with(".gz") ? deflated(bytes, 31) : bytes;
            };
            folder.write(header, pack(header, niftiHeader(fields)));
            folder.write(image, pack(image, countedVoxels));
            for (const char* name : {header, image}) {
                const auto study = readStudy(folder.file(name), withoutGuess());
                ASSERT_TRUE(study) << study.error().sentence();
                EXPECT_EQ(storedValues(*study->phases[0])[23], 24) << name;
                EXPECT_THAT(study->files, testing::UnorderedElementsAre(folder.file(header), folder.file(image)));
            }
        }
}

TEST(NiftiPair, WithoutItsOtherFileIsNamed) {
    const TemporaryFolder folder;
    NiftiFields fields;
    fields.apart = true;
    const auto headerAlone = readStudy(folder.write("a.hdr", niftiHeader(fields)));
    ASSERT_FALSE(headerAlone);
    EXPECT_THAT(headerAlone.error().sentence(), HasSubstr("there is no \"a.img\" beside it"));
    const auto imageAlone = readStudy(folder.write("b.img", countedVoxels));
    ASSERT_FALSE(imageAlone);
    EXPECT_THAT(imageAlone.error().sentence(),
                HasSubstr("is no MetaImage, NRRD, NIfTI, DICOM or GE Voluson (Kretz) file"));
    EXPECT_TRUE(imageAlone.error().layoutUnknown);
}

TEST(NiftiPair, OfAnalyzeIsRefusedByItsName) {
    const TemporaryFolder folder;
    folder.write("a.img", countedVoxels);
    folder.write("a.hdr", analyzeHeader());
    for (const char* name : {"a.hdr", "a.img"}) {
        const auto study = readStudy(folder.file(name));
        ASSERT_FALSE(study);
        EXPECT_THAT(study.error().sentence(), HasSubstr("Analyze 7.5"));
    }
}

// A layout describes the file that was named, whatever lies beside it.
TEST(NiftiPair, VoxelsThatALayoutDescribesAreNotTheHeader) {
    const TemporaryFolder folder;
    folder.write("a.hdr", analyzeHeader());
    const std::string image = folder.write("a.img", countedVoxels);
    const ReadOptions options = rawOfTwentyFour();
    const auto stated = readStudy(image, options);
    ASSERT_TRUE(stated) << stated.error().sentence();
    EXPECT_EQ(storedValues(*stated->phases[0])[23], 24);
    EXPECT_EQ(stated->files, std::vector<std::string>{image});

    ASSERT_TRUE(rememberRawLayout(image, *options.raw));
    const auto recalled = readStudy(image, withoutGuess());
    ASSERT_TRUE(recalled) << recalled.error().sentence();
    EXPECT_EQ(storedValues(*recalled->phases[0])[23], 24);
}

TEST(NiftiPair, OtherFormatsMayBearItsNames) {
    const TemporaryFolder folder;
    const std::string nrrd = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 3 4\nspacings: 1 2 3\nencoding: raw\n\n";
    folder.write("p.hdr", "scanned on a Tuesday");
    const auto study = readStudy(folder.write("p.img", nrrd + countedVoxels), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(factOf(*study, "format").substr(0, 4), "NRRD");

    folder.write("q.hdr", analyzeHeader());
    EXPECT_TRUE(readStudy(folder.write("q.img", nrrd + countedVoxels), withoutGuess()));

    // ENVI: a text header beside raw voxels. The layout of the voxels can be asked for.
    folder.write("e.hdr", "ENVI\nsamples = 2\nlines = 3\nbands = 4\n");
    const auto envi = readStudy(folder.write("e.img", countedVoxels));
    ASSERT_FALSE(envi);
    EXPECT_TRUE(envi.error().layoutUnknown);
    EXPECT_THAT(envi.error().sentence(), HasSubstr("e.img: is no MetaImage, NRRD, NIfTI"));
    EXPECT_THAT(envi.error().sentence(), HasSubstr("--raw-polar"));
}

TEST(NiftiPair, UnpackingAndReadingMakeOneWay) {
    const TemporaryFolder folder;
    NiftiFields fields;
    fields.apart = true;
    folder.write("a.hdr", niftiHeader(fields));
    folder.write("a.img.gz", deflated(countedVoxels, 31));
    std::vector<double> shares;
    Progress progress;
    progress.report = [&](double share) { shares.push_back(share); };
    ASSERT_TRUE(readStudy(folder.file("a.hdr"), withoutGuess(), progress));
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_EQ(shares.back(), 1.0);
}

}  // namespace
}  // namespace echolucent
