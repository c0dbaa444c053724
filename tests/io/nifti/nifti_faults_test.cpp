// NIfTI headers whose geometry, sizes or place of voxels is wrong, and whose other fields say enough.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "nifti_files.h"
#include "python_script.h"
#include "zlib_bytes.h"

namespace echolucent {
namespace {

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

Result<Study> readChanged(const std::function<void(NiftiFields&)>& change, const std::string& voxels = countedVoxels) {
    NiftiFields fields;
    change(fields);
    return readFields(fields, voxels);
}

void expectVoxels(const Result<Study>& study, const std::string& what) {
    ASSERT_TRUE(study) << what << ": " << study.error().sentence();
    const auto values = storedValues(*study->phases[0]);
    for (std::size_t i = 0; i < values.size(); ++i) ASSERT_EQ(values[i], i + 1) << what;
}

TEST(NiftiFaults, AFormThatIsNoGeometryLeavesTheSizesOfVoxels) {
    struct Row {
        std::string words;
        std::function<void(NiftiFields&)> change;
    };
    const std::vector<Row> rows{{"sform is ignored: srow_x", [](NiftiFields& f) { f.sformCode = 1; }},
                                {"sform is ignored: srow_x",
                                 [](NiftiFields& f) {
                                     f.sformCode = 2;
                                     f.srow = {{{1, 0, 0, 5}, {2, 0, 0, 5}, {0, 0, 1, 5}}};
                                 }},
                                {"sform is ignored: srow_x",
                                 [](NiftiFields& f) {
                                     f.version = 2;
                                     f.sformCode = 1;
                                     f.srow = {{{noNumber, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
                                 }},
                                {"qform is ignored: quatern_b",
                                 [](NiftiFields& f) {
                                     f.qformCode = 1;
                                     f.quatern = {0, noNumber, 0};
                                 }},
                                {"qform is ignored: quatern_b",
                                 [](NiftiFields& f) {
                                     f.bigEndian = true;
                                     f.qformCode = 1;
                                     f.quatern = {1, 1, 1};
                                 }},
                                {"qform is ignored: qoffset_x",
                                 [](NiftiFields& f) {
                                     f.qformCode = 1;
                                     f.qoffset = {0, 0, 1e30};
                                 }},
                                {"qform is ignored: pixdim[0]", [](NiftiFields& f) {
                                     f.sformCode = f.qformCode = 1;
                                     f.pixdim[0] = noNumber;
                                 }}};
    for (const Row& row : rows) {
        const auto study = readChanged(row.change);
        expectVoxels(study, row.words);
        const VolumeGeometry& geometry = study->phases[0]->geometry();
        EXPECT_EQ(geometry.spacing, Vec3(0.5, 0.25, 2)) << row.words;
        EXPECT_TRUE(geometry.spacingKnown);
        EXPECT_FALSE(geometry.patientFrameKnown);
        EXPECT_EQ(geometry.direction, Mat3::eye());
        EXPECT_EQ(factOf(*study, "patient frame"), "unknown");
        EXPECT_TRUE(warnsOf(*study, row.words)) << row.words;
        EXPECT_TRUE(warnsOf(*study, "the sizes of pixdim count, and the patient's frame is unknown"));
    }
}

TEST(NiftiFaults, AZeroSformLeavesAGoodQform) {
    const auto study = readChanged([](NiftiFields& f) {
        f.sformCode = f.qformCode = 1;
        f.quatern = {0, 0, 1};
        f.qoffset = {1, 2, 3};
    });
    expectVoxels(study, "qform");
    EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(0.5, 0.25, 2));
    EXPECT_EQ(study->phases[0]->geometry().origin, Vec3(-1, -2, 3));
    EXPECT_TRUE(warnsOf(*study, "qform counts"));
    // A quaternion of zeros is no turn at all.
    const auto zeros = readChanged([](NiftiFields& f) { f.qformCode = 1; });
    expectVoxels(zeros, "zeros");
    EXPECT_TRUE(zeros->warnings.empty());
}

TEST(NiftiFaults, SizesOf0BeyondSpaceCountAs1) {
    for (const std::vector<std::int64_t>& dim : std::vector<std::vector<std::int64_t>>{{4, 2, 3, 4, 0},
                                                                                       {5, 2, 3, 4, 0, 0},
                                                                                       {7, 2, 3, 4, 1, 0, 0, 0},
                                                                                       {4, 2, 3, 4, 1},
                                                                                       {5, 2, 3, 4, 1, 1},
                                                                                       {3, 2, 3, 4, 0, 0, 0, 0}})
        for (const int version : {1, 2}) {
            const auto study = readChanged([&](NiftiFields& f) {
                f.version = version;
                f.dim = dim;
                f.pixdim = {1, 0.5, 0.25, 2, 0};
            });
            expectVoxels(study, std::to_string(dim[0]));
            EXPECT_EQ(study->phases.size(), 1U);
            const bool hasZero = dim[0] > 3 && std::find(dim.begin(), dim.end(), 0) != dim.end();
            EXPECT_EQ(warnsOf(*study, "is 0, which is taken as 1"), hasZero);
        }
    const auto moving = readChanged([](NiftiFields& f) {
        f.dim = {5, 2, 3, 2, 2, 0};
        f.pixdim = {1, 1, 1, 1, 40};
        f.units = 2 + 16;
    });
    ASSERT_TRUE(moving) << moving.error().sentence();
    EXPECT_EQ(moving->phases.size(), 2U);
    const auto vector = readChanged([](NiftiFields& f) {
        f.dim = {5, 2, 3, 4, 1, 1};
        f.intent = 1007;
    });
    expectVoxels(vector, "a vector of one value");
    EXPECT_TRUE(warnsOf(*vector, "each has one value"));
}

TEST(NiftiFaults, NegativeSizesOfVoxelsAreNotedWithAnyForm) {
    for (const int form : {0, 1, 2}) {
        const auto study = readChanged([&](NiftiFields& f) {
            f.pixdim = {1, 0.5, -0.25, 2};
            f.qformCode = form == 1 ? 1 : 0;
            f.sformCode = form == 2 ? 1 : 0;
            f.srow = {{{0.5, 0, 0, 0}, {0, 0.25, 0, 0}, {0, 0, 2, 0}}};
        });
        expectVoxels(study, "negative");
        EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(0.5, 0.25, 2)) << form;
        EXPECT_TRUE(warnsOf(*study, "pixdim is negative")) << form;
    }
}

TEST(NiftiFaults, UnknownUnitsMakeLengthsAndTimesUnknown) {
    for (const int code : {4, 5, 6, 7}) {
        const auto study = readChanged([&](NiftiFields& f) { f.units = code; });
        expectVoxels(study, "units");
        EXPECT_FALSE(study->phases[0]->geometry().spacingKnown) << code;
        EXPECT_TRUE(warnsOf(*study, "which names no length"));
    }
    const auto moving = readChanged([](NiftiFields& f) {
        f.dim = {4, 2, 3, 2, 2};
        f.pixdim = {1, 1, 1, 1, 40};
        f.units = 2 + 56;
    });
    ASSERT_TRUE(moving) << moving.error().sentence();
    EXPECT_TRUE(moving->phases[0]->geometry().spacingKnown);
    EXPECT_EQ(factOf(*moving, "time between phases"), "unknown");
    EXPECT_TRUE(warnsOf(*moving, "the time between phases is unknown"));
}

TEST(NiftiFaults, ThePlaceOfVoxelsIsWhatTheLengthOfTheFileProves) {
    for (const double offset : {0.0, 348.0, 351.0}) {
        const auto study = readChanged([&](NiftiFields& f) { f.voxOffset = offset; });
        expectVoxels(study, "offset");
        EXPECT_TRUE(warnsOf(*study, "the voxels are read from byte 352 on")) << offset;
        EXPECT_FALSE(readChanged([&](NiftiFields& f) { f.voxOffset = offset; }, countedVoxels + "more"));
    }
    const TemporaryFolder folder;
    NiftiFields fields;
    fields.voxOffset = 348;
    const std::string whole = niftiHeader(fields).substr(0, 348) + countedVoxels;
    expectVoxels(readStudy(folder.write("short.nii", whole), withoutGuess()), "without the extender");
    const auto second = readChanged([](NiftiFields& f) {
        f.version = 2;
        f.voxOffset = 0;
    });
    expectVoxels(second, "NIfTI-2");
}

TEST(NiftiFaults, TheMagicMayBeThatOfTheOtherKind) {
    const TemporaryFolder folder;
    NiftiFields apart;
    apart.apart = true;
    // One file with the magic of a pair.
    for (const double offset : {0.0, 352.0}) {
        apart.voxOffset = offset;
        const std::string whole = niftiHeader(apart) + std::string(4, '\0') + countedVoxels;
        const auto study = readStudy(folder.write("one.nii", whole), withoutGuess());
        expectVoxels(study, "ni1 in one file");
        EXPECT_TRUE(warnsOf(*study, "The magic puts the voxels into a file of their own"));
    }
    // A pair with the magic of one file, whose offset counts from either beginning.
    const std::string header = niftiHeader({});
    folder.write("two.hdr", header);
    for (const std::string& before : {std::string(), std::string(352, 'x')}) {
        const std::string image = folder.write("two.img", before + countedVoxels);
        for (const std::string& opened : {folder.file("two.hdr"), image}) {
            const auto study = readStudy(opened, withoutGuess());
            expectVoxels(study, "n+1 in a pair");
            EXPECT_TRUE(warnsOf(*study, "read from the .img beside it"));
        }
    }
}

TEST(NiftiFaults, LeaveTheVoxelsThatNibabelReads) {
    NiftiFields sform, negative;
    sform.sformCode = 1;
    negative.pixdim = {1, 0.5, -0.25, 2};
    const TemporaryFolder folder;
    const std::string files = folder.write("sform.nii", niftiHeader(sform) + countedVoxels) + " " +
                              folder.write("negative.nii", niftiHeader(negative) + countedVoxels) + " " +
                              // What wrapped_voxels_test.cpp puts behind other headers.
                              folder.write("packed.nii.gz", deflated(niftiHeader({}) + countedVoxels, 31));
    const ToolOutcome read = runScript("nibabel_files.py", "read " + files + " 2>/dev/null");
    if (read.missing) GTEST_SKIP() << "python3 cannot import nibabel";
    ASSERT_EQ(read.status, 0);
    const auto all = nlohmann::json::parse(read.output);
    ASSERT_EQ(all.size(), 3U);
    const std::vector<double> counted = twentyFour<double>();
    for (const auto& facts : all) {
        EXPECT_EQ(facts.at("shape"), nlohmann::json({2, 3, 4}));
        EXPECT_EQ(facts.at("values"), nlohmann::json(counted));
    }
}

}  // namespace
}  // namespace echolucent
