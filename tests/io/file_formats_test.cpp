// The list of formats, and that what people read of it says all of it.
#include "io/file_formats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

namespace echolucent {
namespace {

using testing::HasSubstr;

TEST(FileFormats, AreToldByTheEndingOfANameInAnyCase) {
    ASSERT_NE(formatFromName("a/scan.MHA"), nullptr);
    EXPECT_EQ(formatFromName("a/scan.MHA")->name, "MetaImage");
    EXPECT_EQ(formatFromName("slice.ima")->name, "DICOM");
    EXPECT_EQ(formatFromName("scan.vol"), nullptr) << "a name that tells nothing";
    EXPECT_EQ(formatFromName("mha"), nullptr);
}

TEST(FileFormats, ShareNoEnding) {
    for (const FileFormat& format : fileFormats())
        for (const std::string_view ending : format.endings)
            EXPECT_EQ(formatFromName("scan" + std::string(ending)), &format) << ending;
}

TEST(FileFormats, AreNamedInOneSentence) {
    EXPECT_EQ(namesOfFormats(), "MetaImage, NRRD, NIfTI, DICOM or GE Voluson (Kretz)");
    EXPECT_THAT(namesAndEndingsOfFormats(),
                HasSubstr("NIfTI (.nii, .hdr, .img), DICOM (.dcm, .dicom, .ima, DICOMDIR*)"));
}

TEST(FileFormats, AreAllOfferedByTheDialogThatOpensVolumes) {
    const std::string patterns = ' ' + namesOfVolumes() + ' ';
    for (const FileFormat& format : fileFormats()) {
        for (const std::string_view ending : format.endings)
            EXPECT_THAT(patterns, HasSubstr(" *" + std::string(ending) + ' '));
        for (const std::string_view name : format.otherNames)
            EXPECT_THAT(patterns, HasSubstr(' ' + std::string(name) + ' '));
        EXPECT_FALSE(format.endings.empty() && format.otherNames.empty()) << format.name;
    }
    for (const char* other : {" *.raw ", " *.gz ", " *.ima ", " *.dicom "}) EXPECT_THAT(patterns, HasSubstr(other));
}

TEST(FileFormats, AreDescribedInTheDocumentationWithAllTheirEndings) {
    std::ifstream file(ECHOLUCENT_SOURCE_DIR "/docs/formats-read.md");
    const std::string page{std::istreambuf_iterator<char>(file), {}};
    for (const FileFormat& format : fileFormats()) {
        const auto begin = page.find("\n## " + std::string(format.name));
        ASSERT_NE(begin, std::string::npos) << format.name << " has no heading";
        const std::string section = page.substr(begin, page.find("\n## ", begin + 1) - begin);
        for (const std::string_view ending : format.endings)
            EXPECT_THAT(section, HasSubstr('`' + std::string(ending) + '`')) << format.name;
    }
}

}  // namespace
}  // namespace echolucent
