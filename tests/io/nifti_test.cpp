// NIfTI read from headers that are written field by field.
#include "nifti_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numeric>

#include "temporary_folder.h"
#include "zlib_bytes.h"

namespace echolucent {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

template <typename T>
std::vector<T> twentyFour() {
    std::vector<T> values(24);
    std::iota(values.begin(), values.end(), T{1});
    return values;
}

struct TypeRow {
    const char* name;
    int code, bits;
    std::function<std::string(bool)> bytes;
    const char* kept;
};

template <typename T>
TypeRow typeRow(const char* name, int code, const char* kept) {
    return {name, code, static_cast<int>(8 * sizeof(T)), [](bool big) { return bytesFrom(twentyFour<T>(), big); },
            kept};
}

class NiftiTypes : public testing::TestWithParam<std::tuple<TypeRow, bool, int>> {};

TEST_P(NiftiTypes, KeepTheirValuesInBothByteOrdersAndVersions) {
    const auto& [row, big, version] = GetParam();
    const TemporaryFolder folder;
    NiftiFields fields;
    fields.version = version;
    fields.bigEndian = big;
    fields.datatype = row.code;
    fields.bitpix = row.bits;
    const auto study = readStudy(folder.write("v.nii", niftiHeader(fields) + row.bytes(big)), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    const Volume& volume = *study->phases.at(0);
    const auto values = twentyFour<int>();
    EXPECT_EQ(storedValues(volume), std::vector<double>(values.begin(), values.end()));
    EXPECT_EQ(volume.typeName(), row.kept);
    EXPECT_EQ(volume.geometry().size, (std::array<std::int64_t, 3>{2, 3, 4}));
    EXPECT_EQ(volume.geometry().spacing, Vec3(0.5, 0.25, 2));
    EXPECT_TRUE(volume.geometry().spacingKnown);
    EXPECT_FALSE(volume.geometry().patientFrameKnown);
    EXPECT_EQ(factOf(*study, "format"), "NIfTI-" + std::to_string(version));
    EXPECT_TRUE(study->warnings.empty()) << study->warnings.front();
}

INSTANTIATE_TEST_SUITE_P(
    All, NiftiTypes,
    testing::Combine(
        testing::Values(typeRow<std::uint8_t>("uint8", 2, "uint8"), typeRow<std::int8_t>("int8", 256, "uint8"),
                        typeRow<std::uint16_t>("uint16", 512, "uint16"), typeRow<std::int16_t>("int16", 4, "uint16"),
                        typeRow<std::uint32_t>("uint32", 768, "uint16"), typeRow<std::int32_t>("int32", 8, "uint16"),
                        typeRow<std::uint64_t>("uint64", 1280, "uint16"),
                        typeRow<std::int64_t>("int64", 1024, "uint16"), typeRow<float>("float32", 16, "float32"),
                        typeRow<double>("float64", 64, "float32")),
        testing::Bool(), testing::Values(1, 2)),
    [](const auto& row) {
        return std::get<0>(row.param).name + std::string(std::get<1>(row.param) ? "Big" : "Little") +
               std::to_string(std::get<2>(row.param));
    });

const std::string voxels = bytesFrom(twentyFour<std::uint8_t>());

Result<Study> readFields(const NiftiFields& fields, const std::string& bytes = voxels, ReadOptions options = {}) {
    const TemporaryFolder folder;
    options.guessNoData = false;
    return readStudy(folder.write("v.nii", niftiHeader(fields) + bytes), options);
}

TEST(Nifti, ColoursAreReducedToLuma) {
    NiftiFields fields;
    fields.dim = {3, 2, 1, 1};
    fields.datatype = 128;
    fields.bitpix = 24;
    const auto study = readFields(fields, bytesFrom<std::uint8_t>({200, 100, 50, 77, 77, 77}));
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_THAT(storedValues(*study->phases[0]), ElementsAre(124, 77));
    EXPECT_TRUE(warnsOf(*study, "luma"));
}

TEST(Nifti, FilesOfAPairOpenByEitherName) {
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
            folder.write(image, pack(image, voxels));
            for (const char* name : {header, image}) {
                const auto study = readStudy(folder.file(name), withoutGuess());
                ASSERT_TRUE(study) << study.error().sentence();
                EXPECT_EQ(storedValues(*study->phases[0])[23], 24) << name;
                EXPECT_THAT(study->files, testing::UnorderedElementsAre(folder.file(header), folder.file(image)));
            }
        }
}

TEST(Nifti, UnitsAreTurnedIntoMillimetresAndSeconds) {
    NiftiFields fields;
    for (const auto& [units, mm] : {std::pair{0, 1.0}, std::pair{1, 1000.0}, std::pair{2, 1.0}, std::pair{3, 0.001}}) {
        fields.units = units;
        fields.pixdim = {1, 1, 2, 4};
        const auto study = readFields(fields);
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(mm, 2 * mm, 4 * mm)) << units;
    }
    fields.dim = {4, 2, 3, 2, 2};
    const auto seconds = [&](int units, double step) {
        fields.units = 2 + units;
        fields.pixdim = {1, 1, 1, 1, step};
        const auto study = readFields(fields);
        EXPECT_TRUE(study) << study.error().sentence();
        return study->phaseSeconds.value_or(-1);
    };
    EXPECT_EQ(seconds(8, 0.5), 0.5);
    EXPECT_EQ(seconds(8, 1), 1);
    EXPECT_EQ(seconds(16, 40), 0.04);
    EXPECT_NEAR(seconds(24, 40000), 0.04, 1e-12);
    EXPECT_EQ(seconds(0, 0.5), 0.5);
    // 1 without a unit is what programs write that know no time.
    EXPECT_EQ(seconds(0, 1), -1);
    for (const double step : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) EXPECT_EQ(seconds(8, step), -1);
}

TEST(Nifti, TheFourthDimensionIsTime) {
    NiftiFields fields;
    fields.dim = {4, 2, 3, 2, 2};
    fields.pixdim = {1, 1, 1, 1, 0.25};
    fields.units = 2 + 8;
    fields.toffset = 1.5;
    const auto study = readFields(fields);
    ASSERT_TRUE(study) << study.error().sentence();
    ASSERT_EQ(study->phases.size(), 2U);
    EXPECT_EQ(study->phases[1]->storedValue(0), 13);
    EXPECT_EQ(factOf(*study, "time between phases"), "0.25 s");
    EXPECT_EQ(factOf(*study, "time of the first phase"), "1.5 s");
    fields.dim = {7, 2, 3, 4, 1, 1, 1, 1};
    EXPECT_EQ(readFields(fields)->phases.size(), 1U);
}

TEST(Nifti, ASlopeAndAnInterceptAreAppliedAndSaid) {
    NiftiFields fields;
    fields.slope = 0.5;
    fields.inter = -3;
    const auto study = readFields(fields);
    ASSERT_TRUE(study) << study.error().sentence();
    const Volume& volume = *study->phases[0];
    EXPECT_EQ(volume.typeName(), "float32");
    EXPECT_EQ(volume.storedValue(0), -2.5);
    EXPECT_EQ(volume.storedValue(23), 9);
    EXPECT_EQ(volume.whiteLevel(), 0.5 * 255 - 3);
    EXPECT_EQ(factOf(*study, "rescale"), "value = 0.5 x stored - 3");
    EXPECT_EQ(factOf(*study, "voxel type"), "uint8, rescaled and kept as float32");
    EXPECT_TRUE(warnsOf(*study, "negative values down to -2.5"));
}

TEST(Nifti, ALineThatChangesNothingIsNone) {
    NiftiFields fields;
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const auto& [slope, inter] : {std::pair{1.0, 0.0}, std::pair{0.0, 7.0}, std::pair{nan, nan}}) {
        fields.slope = slope;
        fields.inter = inter;
        const auto study = readFields(fields);
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_EQ(study->phases[0]->typeName(), "uint8");
        EXPECT_EQ(factOf(*study, "rescale"), "none");
    }
}

TEST(Nifti, TheDisplayRangeGivesWhite) {
    NiftiFields fields;
    fields.datatype = 512;
    fields.bitpix = 16;
    fields.calMax = 30;
    auto study = readFields(fields, bytesFrom(twentyFour<std::uint16_t>()));
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases[0]->whiteLevel(), 30);
    fields.calMax = 3000;  // the picture would be black
    study = readFields(fields, bytesFrom(twentyFour<std::uint16_t>()));
    EXPECT_EQ(study->phases[0]->whiteLevel(), 24);
    EXPECT_TRUE(warnsOf(*study, "cal_min, cal_max") || warnsOf(*study, "from 0 to 3000"));
}

TEST(Nifti, WithoutAnyVoxelSizeTheSpacingIsUnknown) {
    NiftiFields fields;
    fields.pixdim = {1, 0, 0, 0};
    const auto study = readFields(fields);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_FALSE(study->phases[0]->geometry().spacingKnown);
    EXPECT_TRUE(warnsOf(*study, "spacing of the voxels is unknown"));
}

TEST(Nifti, FramesOverTimeBecomeSlicesOnlyWhenAsked) {
    NiftiFields fields;
    fields.dim = {4, 2, 3, 1, 4};
    const auto refused = readFields(fields);
    ASSERT_FALSE(refused);
    EXPECT_TRUE(refused.error().framesCouldBeSlices);
    EXPECT_THAT(refused.error().sentence(), HasSubstr("2D frames over time"));
    ReadOptions options;
    options.framesAsSlices = true;
    const auto study = readFields(fields, voxels, options);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases.size(), 1U);
    EXPECT_EQ(study->phases[0]->geometry().size, (std::array<std::int64_t, 3>{2, 3, 4}));
    EXPECT_FALSE(study->phases[0]->geometry().spacingKnown);
    EXPECT_EQ(study->phases[0]->geometry().spacing[1], 0.25);
}

TEST(Nifti, ContradictionsThatDoNoHarmAreSaid) {
    NiftiFields fields;
    fields.bitpix = 16;
    EXPECT_TRUE(warnsOf(*readFields(fields), "bitpix says 16 bits"));
    fields = {};
    fields.pixdim = {1, -0.5, 0.25, 2};
    const auto negative = readFields(fields);
    EXPECT_TRUE(warnsOf(*negative, "pixdim is negative"));
    EXPECT_EQ(negative->phases[0]->geometry().spacing, Vec3(0.5, 0.25, 2));
    fields = {};
    fields.intent = 1002;
    EXPECT_TRUE(warnsOf(*readFields(fields), "labels, not echoes"));
}

struct MalformedRow {
    std::function<void(NiftiFields&)> change;
    std::vector<std::string> words;
    std::string bytes = voxels;
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
        {[](auto&) {}, {"dim declares 24 bytes", "holds only 23"}, voxels.substr(1)},
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
        const std::string whole = niftiHeader(fields) + voxels;
        for (std::size_t length = 0; length < whole.size(); ++length) {
            const auto study = readStudy(folder.write("v.nii", whole.substr(0, length)));
            ASSERT_FALSE(study) << length;
            EXPECT_FALSE(study.error().problem.empty());
        }
    }
}

TEST(MalformedNifti, AFileThatOnlyItsNameCallsNiftiIsNoNifti) {
    const TemporaryFolder folder;
    for (const std::string& bytes : {std::string(), std::string("whatever"), std::string(400, '\0')})
        for (const char* name : {"v.nii", "v.nii.gz"}) {
            const auto study = readStudy(folder.write(name, name[5] == '\0' ? bytes : deflated(bytes, 31)));
            ASSERT_FALSE(study);
            EXPECT_THAT(study.error().sentence(), HasSubstr("does not begin with a NIfTI header"));
        }
}

TEST(MalformedNifti, APairWithoutItsOtherFileIsNamed) {
    const TemporaryFolder folder;
    NiftiFields fields;
    fields.apart = true;
    const auto headerAlone = readStudy(folder.write("a.hdr", niftiHeader(fields)));
    ASSERT_FALSE(headerAlone);
    EXPECT_THAT(headerAlone.error().sentence(), HasSubstr("there is no \"a.img\" beside it"));
    const auto imageAlone = readStudy(folder.write("b.img", voxels));
    ASSERT_FALSE(imageAlone);
    EXPECT_THAT(imageAlone.error().sentence(), HasSubstr("is not a MetaImage, NRRD, NIfTI or DICOM file"));
    EXPECT_TRUE(imageAlone.error().layoutUnknown);
}

TEST(MalformedNifti, AnalyzeIsRefusedByItsName) {
    const TemporaryFolder folder;
    NiftiFields fields;
    fields.apart = true;
    std::string header = niftiHeader(fields);
    header[38] = 'r';
    header.replace(344, 4, std::string(4, '\0'));
    folder.write("a.img", voxels);
    for (const char* name : {"a.hdr", "a.img"}) {
        folder.write("a.hdr", header);
        const auto study = readStudy(folder.file(name));
        ASSERT_FALSE(study);
        EXPECT_THAT(study.error().sentence(), HasSubstr("Analyze 7.5"));
    }
}

}  // namespace
}  // namespace echolucent
