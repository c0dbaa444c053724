// NIfTI files that are damaged or no volume: each ends in a sentence of its own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "nifti_files.h"
#include "zlib_bytes.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

struct MalformedRow {
    std::function<void(NiftiFields&)> change;
    std::vector<std::string> words;
    std::string bytes = countedVoxels;
};

TEST(MalformedNifti, EachGetsItsOwnSentence) {
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    const std::vector<MalformedRow> rows{
        {[](auto& f) { f.dim[0] = 0; }, {"dim[0] must be 1 to 7, not 0"}},
        {[](auto& f) { f.dim[0] = 8; }, {"dim[0] must be 1 to 7, not 8"}},
        {[](auto& f) { f.dim[0] = -3; }, {"dim[0] must be 1 to 7, not -3"}},
        {[](auto& f) {
             f.dim = {2, 2, 3};
         },
         {"dim[0] is 2", "2D picture"}},
        {[](auto& f) { f.dim[2] = 0; }, {"dim[2] must be above 0, not 0"}},
        {[](auto& f) { f.dim[2] = -3; }, {"dim[2] must be above 0, not -3"}},
        {[](auto& f) { f.dim = {5, 2, 3, 4, 1, 3}; }, {"dim[5] is 3", "several values"}},
        {[](auto& f) {
             f.dim = {3, 2, 3, 5};
         },
         {"dim declares 30 bytes", "holds only 24"}},
        {[](auto& f) {
             f.dim = {3, 32767, 32767, 32767};
         },
         {"dim declares 35181150961663 bytes", "holds only 24"}},
        {[](auto& f) {
             f.version = 2;
             f.dim = {3, 1LL << 40, 1LL << 40, 2};
         },
         {"dim declares more voxels than any"}},
        {[](auto& f) {
             f.version = 2;
             f.dim = {4, 1LL << 62, 1, 1, 2};
         },
         {"dim", "2D frames over time"}},
        {[](auto& f) { f.datatype = 0; }, {"datatype is 0", "unknown type"}},
        {[](auto& f) { f.datatype = 1; }, {"datatype is 1", "single bits"}},
        {[](auto& f) { f.datatype = 32; }, {"datatype is 32", "complex64"}},
        {[](auto& f) { f.datatype = 1792; }, {"complex128"}},
        {[](auto& f) { f.datatype = 2048; }, {"complex256"}},
        {[](auto& f) { f.datatype = 1536; }, {"128-bit floats"}},
        {[](auto& f) { f.datatype = 2304; }, {"RGBA32"}},
        {[](auto& f) { f.datatype = 77; }, {"datatype is 77, which is not known"}},
        {[](auto& f) { f.intent = 1006; }, {"intent_code is 1006", "displacements"}},
        {[](auto& f) { f.intent = 1007; }, {"intent_code is 1007", "vectors"}},
        {[](auto& f) { f.intent = 1008; }, {"intent_code is 1008", "points of a surface"}},
        {[](auto& f) { f.intent = 2003; }, {"intent_code is 2003", "colours on a surface"}},
        {[](auto& f) { f.voxOffset = 0; }, {"vox_offset must be a whole number of 352 or more, not 0"}},
        {[](auto& f) { f.voxOffset = 351; }, {"vox_offset must be"}},
        {[](auto& f) { f.voxOffset = 352.5; }, {"vox_offset must be", "352.5"}},
        {[](auto& f) { f.voxOffset = -400; }, {"vox_offset must be", "-400"}},
        {[=](auto& f) { f.voxOffset = nan; }, {"vox_offset must be", "nan"}},
        {[](auto& f) { f.voxOffset = 1e30; }, {"vox_offset must be", "e+30"}},
        {[](auto& f) { f.voxOffset = 1e9; }, {"dim declares 24 bytes", "holds only 0"}},
        {[](auto& f) {
             f.version = 2;
             f.voxOffset = 540;
         },
         {"vox_offset must be a whole number of 544 or more"}},
        {[](auto& f) {
             f.pixdim = {1, 1, 0, 1};
         },
         {"pixdim must be finite and not 0", "1 0 1"}},
        {[=](auto& f) {
             f.pixdim = {1, 1, nan, 1};
         },
         {"pixdim must be finite and not 0"}},
        {[=](auto& f) {
             f.pixdim = {1, 1, inf, 1};
         },
         {"pixdim must be finite and not 0"}},
        {[](auto& f) {
             f.pixdim = {1, 1e-9, 1, 1};
         },
         {"pixdim", "no scanner makes"}},
        {[](auto& f) { f.units = 5; }, {"xyzt_units is 5", "no length"}},
        {[](auto& f) {
             f.dim = {4, 2, 3, 2, 2};
             f.units = 2 + 32;
         },
         {"xyzt_units", "frequency"}},
        {[](auto& f) {
             f.dim = {4, 2, 3, 2, 2};
             f.units = 2 + 56;
         },
         {"xyzt_units is 58", "no time"}},
        {[=](auto& f) {
             f.slope = 2;
             f.inter = nan;
         },
         {"scl_inter is no number"}},
        {[](auto& f) { f.sformCode = 1; }, {"srow_x, srow_y, srow_z do not hold three independent directions"}},
        {[=](auto& f) {
             f.sformCode = 1;
             f.srow = {{{nan, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
         },
         {"srow_x, srow_y, srow_z"}},
        {[](auto& f) {
             f.sformCode = 1;
             f.srow = {{{1, 0, 0, 1e30}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
         },
         {"srow_x, srow_y, srow_z"}},
        {[](auto& f) {
             f.qformCode = 1;
             f.quatern = {1, 1, 0};
         },
         {"quatern_b, quatern_c, quatern_d are no rotation"}},
        {[=](auto& f) {
             f.qformCode = 1;
             f.quatern = {nan, 0, 0};
         },
         {"quatern_b", "no rotation"}},
        {[=](auto& f) {
             f.qformCode = 1;
             f.pixdim[0] = nan;
         },
         {"pixdim[0] must be 1 or -1"}},
        {[](auto& f) {
             f.qformCode = 1;
             f.pixdim = {1, 0, 0, 0};
         },
         {"pixdim must be finite", "qform_code"}},
        {[=](auto& f) {
             f.qformCode = 1;
             f.qoffset = {0, inf, 0};
         },
         {"qoffset_x"}},
        {[](auto&) {}, {"dim declares 24 bytes", "holds only 23"}, countedVoxels.substr(1)},
        {[](auto&) {}, {"dim declares 24 bytes", "holds only 0"}, ""},
    };
    for (const MalformedRow& row : rows) {
        NiftiFields fields;
        row.change(fields);
        const auto study = readFields(fields, row.bytes);
        ASSERT_FALSE(study) << "was read: " << row.words[0];
        const std::string sentence = study.error().sentence();
        EXPECT_THAT(sentence, testing::EndsWith("."));
        for (const std::string& words : row.words) EXPECT_THAT(sentence, HasSubstr(words));
    }
}

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

TEST(MalformedNifti, AFileThatOnlyItsNameCallsNiftiIsNoNifti) {
    const TemporaryFolder folder;
    for (const std::string& bytes : {std::string("whatever"), std::string(400, '\0')})
        for (const char* name : {"v.nii", "v.nii.gz"}) {
            const auto study = readStudy(folder.write(name, name[5] == '\0' ? bytes : deflated(bytes, 31)));
            ASSERT_FALSE(study);
            EXPECT_THAT(study.error().sentence(), HasSubstr("does not begin with a NIfTI header"));
        }
}

}  // namespace
}  // namespace echolucent
