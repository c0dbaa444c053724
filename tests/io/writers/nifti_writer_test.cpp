#include "io/writers/nifti_writer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>

#include "io/study/study_assembly.h"
#include "processing/phantom/phantom.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using Phases = std::vector<std::shared_ptr<const Volume>>;

/// Phases of a simulated scan with that many bits, or as floats for 32, on an oblique, anisotropic grid.
Phases scan(int bits, int count) {
    Phases phases;
    for (int phase = 0; phase < count; ++phase) {
        PhantomConfig config = defaultPhantom(PhantomScene::fetus);
        config.size = {24, 20, 28};
        config.spacing = {0.4, 0.5, 0.9};
        config.bits = bits == 32 ? 16 : bits;
        config.phase = static_cast<double>(phase) / count;
        const Volume made = *makePhantom(config);
        VolumeGeometry geometry = made.geometry();
        geometry.direction = rotationX(25) * rotationZ(-40);
        geometry.origin = {-31.5, 12.25, 100.125};
        Voxels voxels = made.voxels();
        if (bits == 32) {
            std::vector<float> floats;
            for (std::int64_t i = 0; i < geometry.voxelCount(); ++i)
                floats.push_back(static_cast<float>(std::sqrt(made.storedValue(i))) + 0.1F);
            voxels = std::move(floats);
        }
        phases.push_back(std::make_shared<const Volume>(geometry, std::move(voxels), made.whiteLevel()));
    }
    return phases;
}

class NiftiRoundTrip : public testing::TestWithParam<std::tuple<int, int, const char*>> {};

TEST_P(NiftiRoundTrip, GivesBackEveryBitOfTheVoxels) {
    const auto& [bits, count, name] = GetParam();
    const TemporaryFolder folder;
    const Phases phases = scan(bits, count);
    ASSERT_TRUE(writeNifti(folder.file(name), phases, count > 1 ? std::optional(0.125) : std::nullopt));
    const auto study = readStudy(folder.file(name), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    ASSERT_EQ(study->phases.size(), phases.size());
    for (std::size_t phase = 0; phase < phases.size(); ++phase) {
        EXPECT_EQ(study->phases[phase]->voxels(), phases[phase]->voxels());
        const VolumeGeometry &read = study->phases[phase]->geometry(), &truth = phases[phase]->geometry();
        EXPECT_LT(length(read.spacing - truth.spacing), 1e-7);
        EXPECT_LT(length(read.origin - truth.origin), 1e-5);
        EXPECT_LT(cv::norm(read.direction - truth.direction), 1e-6);
    }
    if (count > 1) {
        EXPECT_EQ(study->phaseTimes.meanSeconds, 0.125);
    }
    if (bits < 32) {
        EXPECT_EQ(study->phases[0]->whiteLevel(), phases[0]->whiteLevel());
    }
}

INSTANTIATE_TEST_SUITE_P(All, NiftiRoundTrip,
                         testing::Combine(testing::Values(8, 12, 16, 32), testing::Values(1, 3),
                                          testing::Values("v.nii", "v.nii.gz")));

// A dim scan reaches an eighth of white and less, which cal_max alone does not outweigh.
TEST(NiftiWriter, WhiteOfADimScanComesBackWithItsSource) {
    const TemporaryFolder folder;
    VolumeGeometry geometry;
    geometry.size = {4, 4, 4};
    std::vector<std::uint16_t> values(64);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<std::uint16_t>(50 * i);
    for (const double white : {65535.0, 4095.0, 12345.678}) {
        ASSERT_TRUE(writeNifti(folder.file("v.nii"), {std::make_shared<const Volume>(geometry, values, white)}));
        const auto study = readStudy(folder.file("v.nii"), withoutGuess());
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_NEAR(study->phases[0]->whiteLevel(), white, 1e-3);
        EXPECT_EQ(sourceOf(*study, "white level"), "descrip, cal_max");
    }
    // What is not word for word what the writer writes is no more than any display range.
    std::ifstream file(folder.file("v.nii"), std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    const std::size_t at = bytes.find("uint16");
    ASSERT_NE(at, std::string::npos);
    for (const char* type : {"uint32", "uint16, edited", "UINT16"}) {
        std::string changed = bytes;
        changed.replace(at, std::strlen(type), type);
        const auto study = readStudy(folder.write("c.nii", changed), withoutGuess());
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_NE(sourceOf(*study, "white level"), "descrip, cal_max") << type;
    }
}

// The axes lean on each other; a quaternion would set them upright.
TEST(NiftiWriter, SkewAxesStandInSformAlone) {
    const TemporaryFolder folder;
    VolumeGeometry geometry;
    geometry.size = {4, 4, 4};
    geometry.direction(0, 1) = 0.2;
    ASSERT_TRUE(normalizeDirection(geometry.direction));
    ASSERT_TRUE(
        writeNifti(folder.file("v.nii"), {std::make_shared<const Volume>(geometry, std::vector<std::uint8_t>(64, 7))}));
    std::ifstream file(folder.file("v.nii"), std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    EXPECT_EQ(bytes.substr(252, 4), std::string("\0\0\1\0", 4));
    const auto study = readStudy(folder.file("v.nii"), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_LT(cv::norm(study->phases[0]->geometry().direction - geometry.direction), 1e-6);
    EXPECT_FALSE(warnsOf(*study, "qform"));
}

TEST(NiftiWriter, KeepsThatTheSpacingIsUnknown) {
    const TemporaryFolder folder;
    VolumeGeometry geometry;
    geometry.size = {2, 1, 1};
    geometry.spacingKnown = false;
    ASSERT_TRUE(writeNifti(folder.file("v.nii"),
                           {std::make_shared<const Volume>(geometry, std::vector<std::uint8_t>{3, 255})}));
    const auto study = readStudy(folder.file("v.nii"), withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_FALSE(study->phases[0]->geometry().spacingKnown);
}

TEST(NiftiWriter, WritesTheSameBytesTwice) {
    const TemporaryFolder folder;
    const auto bytes = [&](const std::string& name) {
        EXPECT_TRUE(writeNifti(folder.file(name), scan(8, 1)));
        std::ifstream file(folder.file(name), std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    EXPECT_EQ(bytes("a.nii.gz"), bytes("b.nii.gz"));
}

TEST(NiftiWriter, SaysWhatItCannotWrite) {
    VolumeGeometry geometry;
    geometry.size = {40000, 1, 1};
    const auto tooLong =
        writeNifti("/tmp/never.nii", {std::make_shared<const Volume>(geometry, std::vector<std::uint8_t>(40000, 1))});
    ASSERT_FALSE(tooLong);
    EXPECT_THAT(tooLong.error().sentence(), testing::HasSubstr("counts to 32767"));
    geometry.size = {1, 1, 1};
    const auto nowhere = writeNifti("/nonexistent-folder/v.nii",
                                    {std::make_shared<const Volume>(geometry, std::vector<std::uint8_t>{1})});
    ASSERT_FALSE(nowhere);
    EXPECT_EQ(nowhere.error().kind, FailureKind::unwritable);
    EXPECT_THROW((void)writeNifti("/tmp/never.nii", {}), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
