// MetaImage and NRRD files that are cut anywhere, and paths where nothing is. The table of hostile files
// (tests/hostile) holds headers with one fault each.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>

#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

TEST(MalformedText, EveryTruncationOfAHeaderIsRefused) {
    const TemporaryFolder folder;
    const std::string metaImage =
        "ObjectType = Image\nNDims = 3\nDimSize = 2 3 4\nElementSpacing = 1 1 1\n"
        "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n" +
        std::string(24, 'v');
    const std::string nrrd =
        "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 3 4\nspacings: 1 1 1\nencoding: raw\n\n" + std::string(24, 'v');
    for (const auto& [name, whole] : {std::pair{"a.mha", metaImage}, std::pair{"a.nrrd", nrrd}})
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const auto study = readStudy(folder.write(name, whole.substr(0, length)));
            ASSERT_FALSE(study) << name << " cut to " << length;
            EXPECT_FALSE(study.error().problem.empty());
        }
}

TEST(UnknownFiles, ThatAreNotThereSaySo) {
    const TemporaryFolder folder;
    EXPECT_THAT(readStudy(folder.file("nothing.mha")).error().sentence(), HasSubstr("does not exist"));
    EXPECT_THAT(readStudy(folder.path()).error().sentence(), HasSubstr("folder without DICOM images"));
}

}  // namespace
}  // namespace echolucent
