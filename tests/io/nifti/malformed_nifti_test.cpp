// NIfTI files that are cut anywhere. The table of hostile files (tests/hostile) holds headers with one fault each.
#include <gtest/gtest.h>

#include "nifti_files.h"

namespace echolucent {
namespace {

TEST(MalformedNifti, EveryTruncationIsRefused) {
    const TemporaryFolder folder;
    for (const int version : {1, 2}) {
        NiftiFields fields;
        fields.version = version;
        const std::string whole = niftiHeader(fields) + countedVoxels;
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const auto study = readStudy(folder.write("v.nii", whole.substr(0, length)));
            ASSERT_FALSE(study) << length;
            EXPECT_FALSE(study.error().problem.empty());
        }
    }
}

}  // namespace
}  // namespace echolucent
