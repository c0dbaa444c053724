// What is said of the real and odd DICOM files beside the source tree; the tests are skipped where these are not there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "shared_data.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::AnyOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

std::string sentenceOfShared(const std::string& name) {
    const auto study = readStudy(sharedData + name);
    return study ? "was read" : study.error().sentence();
}

TEST(SharedDicomSentences, NameNoIdentifierAndQuoteNoLibrary) {
    SKIP_WITHOUT_SHARED_DATA();
    for (const char* folder : {"/dicom", "/bad"})
        for (const auto& entry : std::filesystem::directory_iterator(sharedData + folder)) {
            const auto study = readStudy(entry.path().string(), withoutGuess());
            if (study) continue;
            const std::string problem = study.error().element + study.error().problem + study.error().remedy;
            EXPECT_THAT(problem, Not(ContainsRegex("[0-9]+(\\.[0-9]+){4,}"))) << "an identifier: " << entry.path();
            EXPECT_THAT(problem, Not(AnyOf(HasSubstr("i/o suspension"), HasSubstr("nvalid tag"),
                                           HasSubstr("Delimitation Item"), HasSubstr("llegal call"))))
                << entry.path();
            EXPECT_FALSE(study.error().remedy.empty()) << entry.path();
        }
}

TEST(SharedDicomSentences, SinglePicturesAreCalledThat) {
    SKIP_WITHOUT_SHARED_DATA();
    for (const char* name :
         {"/dicom/fodicom_GH364.dcm", "/dicom/pydicomdata_gdcm-US-ALOKA-16.dcm", "/bad/fodicom_FreezePattern.dcm",
          "/bad/fodicom_GH1339.dcm", "/bad/pydicomdata_explicit_VR-UN.dcm", "/dicom/alizams_001US_TESTXX02.dcm"})
        EXPECT_THAT(sentenceOfShared(name), HasSubstr("is a single 2D picture")) << name;
}

TEST(SharedDicomSentences, OthersSayWhatTheyAre) {
    SKIP_WITHOUT_SHARED_DATA();
    for (const auto& [name, words] : std::vector<std::pair<std::string, std::string>>{
             {"/bad/orthanc_MarekLatin2.dcm", "is a basic text structured report"},
             {"/bad/orthanc_Issue137.dcm", "is an encapsulated STL model"},
             {"/bad/dcmjs_no-meta-length-test.dcm", "is an ultrasound image, and (7fe0,0010) Pixel Data is absent"},
             {"/bad/fodicom_GH1146.dcm", "(7fe0,0010) Pixel Data is there but empty"},
             {"/bad/dicomts_20-wrong-transfer-syntax.dcm", "as the transfer syntax (JPEG-LS Lossless) needs"},
             {"/bad/fodicom_GH179B.dcm", "ends after 2848 bytes in the middle of an element"},
             {"/bad/pydicom_no_meta.dcm", "does not begin as a DICOM file does"},
             {"/bad/pydicom_DICOMDIR-bigEnd", "is a DICOMDIR, and none of the 31 files that it names is in its folder"},
             {"/bad/pydicom_DICOMDIR-nooffset", "is a DICOMDIR, and none of the 31 files"},
             {"/bad/pydicomdata_liver_nonbyte_aligned_deflate.dcm", "is deflated frame by frame"}})
        EXPECT_THAT(sentenceOfShared(name), HasSubstr(words)) << name;
}

TEST(SharedDicomVolumes, TheQlabSampleOpensWithWhatItHolds) {
    SKIP_WITHOUT_SHARED_DATA();
    const auto study = readStudy(sharedData + "/dicom/itksnap_echo_cartesian_dummy.dcm", withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    ASSERT_EQ(study->phases.size(), 3u);
    EXPECT_EQ(study->phases[0]->geometry().size, (std::array<std::int64_t, 3>{56, 52, 56}));
    EXPECT_LT(length(study->phases[0]->geometry().spacing - Vec3(3.77657, 3.72161, 3.28731)), 1e-5);
    EXPECT_FALSE(study->phases[0]->geometry().spacingKnown) << "in cm it would be 2 m long";
    EXPECT_TRUE(warnsOf(*study, "declares 30 volumes and holds 3"));
    EXPECT_TRUE(warnsOf(*study, "declares 96911360 bytes, the file holds 489212"));
}

}  // namespace
}  // namespace echolucent
