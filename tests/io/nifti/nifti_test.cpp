// NIfTI read from headers that are written field by field.
#include "nifti_files.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace echolucent {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

struct NiftiTypeRow {
    const char* name;
    int code, bits;
    std::function<std::string(bool)> bytes;
    const char* kept;
};

template <typename T>
NiftiTypeRow niftiType(const char* name, int code, const char* kept) {
    return {name, code, static_cast<int>(8 * sizeof(T)), [](bool big) { return bytesFrom(twentyFour<T>(), big); },
            kept};
}

class NiftiTypes : public testing::TestWithParam<std::tuple<NiftiTypeRow, bool, int>> {};

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

INSTANTIATE_TEST_SUITE_P(All, NiftiTypes,
                         testing::Combine(testing::Values(niftiType<std::uint8_t>("uint8", 2, "uint8"),
                                                          niftiType<std::int8_t>("int8", 256, "uint8"),
                                                          niftiType<std::uint16_t>("uint16", 512, "uint16"),
                                                          niftiType<std::int16_t>("int16", 4, "uint16"),
                                                          niftiType<std::uint32_t>("uint32", 768, "uint16"),
                                                          niftiType<std::int32_t>("int32", 8, "uint16"),
                                                          niftiType<std::uint64_t>("uint64", 1280, "uint16"),
                                                          niftiType<std::int64_t>("int64", 1024, "uint16"),
                                                          niftiType<float>("float32", 16, "float32"),
                                                          niftiType<double>("float64", 64, "float32")),
                                          testing::Bool(), testing::Values(1, 2)),
                         [](const auto& row) {
                             return std::get<0>(row.param).name +
                                    std::string(std::get<1>(row.param) ? "Big" : "Little") +
                                    std::to_string(std::get<2>(row.param));
                         });

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
        return study->phaseTimes.meanSeconds.value_or(-1);
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
    EXPECT_EQ(volume.fileValue(0), -2.5);
    EXPECT_EQ(volume.fileValue(23), 9);
    EXPECT_EQ(volume.valueWindow(), (ValueWindow{-3, 0.5 * 255 - 3})) << "five of twenty-four lie below 0";
    EXPECT_EQ(factOf(*study, "rescale"), "value = 0.5 x stored - 3");
    EXPECT_EQ(factOf(*study, "voxel type"), "uint8, rescaled, kept as float32 less black");
    EXPECT_TRUE(warnsOf(*study, "The voxels hold -2.5 to 9: black is -3, white 124.5."));
}

TEST(Nifti, ALineThatFloatsCannotHoldIsShownAndOneBeyondDoublesIsRefused) {
    for (const double slope : {1e308, 1e300, 1e37, -1e37, 1e-60})
        for (const auto& [code, bits, one] : {std::tuple{2, 8, 1.0}, std::tuple{512, 16, 257.0}}) {
            NiftiFields fields;
            fields.version = 2;
            fields.slope = slope;
            fields.datatype = code;
            fields.bitpix = bits;
            const auto study = readFields(fields, std::string(192, '\1'));
            if (slope == 1e308) {
                ASSERT_FALSE(study) << slope << " " << code;
                EXPECT_EQ(study.error().element, "scl_slope");
                EXPECT_THAT(study.error().sentence(), HasSubstr("which makes values from"));
                continue;
            }
            ASSERT_TRUE(study) << study.error().sentence();
            EXPECT_NEAR(study->phases[0]->fileValue(0) / (slope * one), 1.0, 1e-6) << slope << " " << code;
        }
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
    const auto study = readFields(fields, countedVoxels, options);
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases.size(), 1U);
    EXPECT_EQ(study->phases[0]->geometry().size, (std::array<std::int64_t, 3>{2, 3, 4}));
    EXPECT_FALSE(study->phases[0]->geometry().spacingKnown);
    EXPECT_EQ(study->phases[0]->geometry().spacing[1], 0.25);
    EXPECT_TRUE(warnsOf(*study, "Within a slice the spacing is known"));
}

// A small file may declare millions of phases; each would take memory of its own.
TEST(Nifti, MorePhasesThanAnyScannerWritesAreRefused) {
    NiftiFields fields;
    fields.version = 2;
    fields.dim = {4, 1, 2, 2, 4096};
    const auto most = readFields(fields, std::string(4 * 4096, 'v'));
    ASSERT_TRUE(most) << most.error().sentence();
    EXPECT_EQ(most->phases.size(), 4096U);
    for (const std::int64_t phases : {4097, 4000000}) {
        fields.dim[4] = phases;
        const auto study = readFields(fields, std::string(4 * 4097, 'v'));
        ASSERT_FALSE(study);
        EXPECT_EQ(study.error().element, "dim");
        EXPECT_THAT(study.error().sentence(),
                    HasSubstr(std::to_string(phases) + " phases, and no more than 4096 can be opened"));
    }
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

}  // namespace
}  // namespace echolucent
