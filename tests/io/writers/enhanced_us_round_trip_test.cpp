// What is written as Enhanced US Volume is read again: voxels bit for bit, geometry, phases.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <random>
#include <sstream>

#include "enhanced_us_files.h"
#include "io/writers/meta_image_writer.h"
#include "python_script.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::HasSubstr;
using testing::Not;

/// One kind of object.
struct Kind {
    std::string name;
    VolumeGeometry geometry;
    int bits = 8;
    int phases = 1;
    std::optional<double> phaseSeconds{};
    bool apex = true;
};

VolumeGeometry upright(std::array<std::int64_t, 3> size, const Vec3& spacing) {
    VolumeGeometry geometry;
    geometry.size = size;
    geometry.spacing = spacing;
    return geometry;
}

VolumeGeometry inPatient(VolumeGeometry geometry) {
    geometry.patientFrameKnown = true;
    return geometry;
}

std::vector<Kind> kinds() {
    return {{"Bits8", upright({8, 9, 10}, {0.5, 0.5, 0.5})},
            {"Bits16", upright({8, 9, 10}, {0.5, 0.5, 0.5}), 16},
            {"OddBytes", upright({9, 11, 9}, {0.5, 0.25, 1.5})},
            {"Oblique", obliqueGeometry()},
            {"ObliqueInPatient16", inPatient(obliqueGeometry()), 16},
            {"Patient", obliqueGeometry(), 8, 1, {}, false},
            {"Phases", obliqueGeometry(), 8, 3, 0.035},
            {"Phases16OfUnknownTime", inPatient(obliqueGeometry()), 16, 4, {}, false}};
}

EnhancedUsDetails detailsOf(const Kind& kind) {
    EnhancedUsDetails details{.phaseSeconds = kind.phaseSeconds};
    if (kind.apex) details.apexMm = Vec3(1, 2, -30);
    return details;
}

SharedPhases writeKind(const std::string& path, const Kind& kind) {
    auto volumes = simulatedPhases(kind.geometry, kind.bits, kind.phases);
    const auto written = writeEnhancedUs(path, volumes, detailsOf(kind));
    EXPECT_TRUE(written) << written.error().sentence();
    return volumes;
}

void expectSameVolumes(const Study& study, const SharedPhases& written) {
    ASSERT_EQ(study.phases.size(), written.size());
    for (std::size_t phase = 0; phase < written.size(); ++phase) {
        const VolumeGeometry& read = study.phases[phase]->geometry();
        const VolumeGeometry& expected = written[phase]->geometry();
        ASSERT_EQ(read.size, expected.size);
        EXPECT_LT(cv::norm(read.spacing - expected.spacing), 1e-6);
        EXPECT_LT(cv::norm(read.origin - expected.origin), 1e-6);
        EXPECT_LT(cv::norm(read.direction - expected.direction), 1e-6);
        EXPECT_EQ(study.phases[phase]->voxels(), written[phase]->voxels()) << "phase " << phase;
        EXPECT_EQ(study.phases[phase]->whiteLevel(), written[phase]->whiteLevel());
    }
}

class EnhancedUsRoundTrip : public testing::TestWithParam<Kind> {
protected:
    TemporaryFolder m_folder;
    std::string m_path = m_folder.file("v.dcm");
};

TEST_P(EnhancedUsRoundTrip, VolumesAreReadAsTheyWereWritten) {
    const auto written = writeKind(m_path, GetParam());
    const auto study = readStudy(m_path, withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    expectSameVolumes(*study, written);
    EXPECT_EQ(study->phases[0]->geometry().patientFrameKnown,
              GetParam().geometry.patientFrameKnown || !GetParam().apex);
    EXPECT_EQ(study->phaseTimes.meanSeconds.has_value(), GetParam().phaseSeconds.has_value());
    EXPECT_NEAR(study->phaseTimes.meanSeconds.value_or(0), GetParam().phaseSeconds.value_or(0), 1e-12);
    const auto slices = GetParam().geometry.size[2];
    EXPECT_EQ(factOf(*study, "format"), GetParam().phases == 1
                                            ? fmt::format("DICOM Enhanced US Volume, one file, {} frames", slices)
                                            : fmt::format("DICOM Enhanced US Volume, one file, {} phases of {} frames",
                                                          GetParam().phases, slices));
    EXPECT_THAT(study->warnings, testing::IsEmpty());
}

TEST_P(EnhancedUsRoundTrip, TheOrderOfTheFramesInTheFileDoesNotMatter) {
    const auto written = writeKind(m_path, GetParam());
    const EnhancedUsFile file(m_path);
    std::vector<std::size_t> order(file.frames());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::shuffle(order.begin(), order.end(), std::mt19937(11));
    file.reorderFrames(order);
    file.save();
    const auto study = readStudy(m_path, withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    expectSameVolumes(*study, written);
}

TEST_P(EnhancedUsRoundTrip, WithoutDimensionsTimesTellThePhases) {
    const auto written = writeKind(m_path, GetParam());
    const EnhancedUsFile file(m_path);
    ASSERT_TRUE(file.dataset().findAndDeleteElement(DCM_DimensionIndexSequence).good());
    std::vector<std::size_t> backwards(file.frames());
    for (std::size_t i = 0; i < backwards.size(); ++i) backwards[i] = backwards.size() - 1 - i;
    file.reorderFrames(backwards);
    file.save();
    const auto study = readStudy(m_path, withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    expectSameVolumes(*study, written);
}

TEST(EnhancedUsDimensions, AnyAttributeThatNamesATimeSplitsThePhases) {
    const TemporaryFolder folder;
    const auto written = writeKind(folder.file("v.dcm"), kinds().back());
    for (const DcmTagKey& time : {DCM_TemporalPositionTimeOffset, DCM_NominalCardiacTriggerDelayTime,
                                  DCM_NominalPercentageOfCardiacPhase, DCM_FrameReferenceDateTime}) {
        const EnhancedUsFile file(folder.file("v.dcm"));
        DcmItem* item = nullptr;
        ASSERT_TRUE(file.dataset().findAndGetSequenceItem(DCM_DimensionIndexSequence, item, 0).good());
        ASSERT_TRUE(item->putAndInsertTagKey(DCM_DimensionIndexPointer, time).good());
        for (std::size_t frame = 0; frame < file.frames(); ++frame)
            file.groupOfFrame(frame, DCM_FrameContentSequence).findAndDeleteElement(DCM_TemporalPositionIndex);
        file.save();
        const auto study = readStudy(folder.file("v.dcm"), withoutGuess());
        ASSERT_TRUE(study) << study.error().sentence();
        expectSameVolumes(*study, written);
    }
}

TEST_P(EnhancedUsRoundTrip, DciodvfyFindsNoError) {
    if (runTool("command -v dciodvfy 2>&1").status != 0) GTEST_SKIP() << "dciodvfy (package dicom3tools) is not there";
    writeKind(m_path, GetParam());
    const ToolOutcome outcome = runTool("dciodvfy '" + m_path + "' 2>&1");
    EXPECT_THAT(outcome.output, HasSubstr("EnhancedUltrasoundVolume"));
    EXPECT_THAT(outcome.output, Not(HasSubstr("Error"))) << outcome.output;
}

std::uint32_t checksumOfSlice(const Volume& volume, std::int64_t slice) {
    const auto& size = volume.geometry().size;
    const auto pixels = static_cast<std::size_t>(size[0] * size[1]);
    std::uint32_t crc = 0;
    std::visit(
        [&](const auto& voxels) {
            const auto* bytes = reinterpret_cast<const unsigned char*>(voxels.data() + slice * size[0] * size[1]);
            crc = static_cast<std::uint32_t>(::crc32(0, bytes, static_cast<unsigned>(pixels * sizeof(voxels[0]))));
        },
        volume.voxels());
    return crc;
}

TEST_P(EnhancedUsRoundTrip, PydicomAgreesOnPixelsAndGeometry) {
    const auto written = writeKind(m_path, GetParam());
    const ToolOutcome outcome = runScript("pydicom_files.py", "'" + m_path + "'");
    if (outcome.missing) GTEST_SKIP() << "python3 cannot import pydicom";
    ASSERT_EQ(outcome.status, 0) << outcome.output;
    std::istringstream lines(outcome.output);
    const VolumeGeometry& geometry = GetParam().geometry;
    Vec3 spacing, row, column;
    lines >> spacing[0] >> spacing[1];
    for (double& value : row.val) lines >> value;
    for (double& value : column.val) lines >> value;
    EXPECT_NEAR(spacing[0], geometry.spacing[0], 1e-6);
    EXPECT_NEAR(spacing[1], geometry.spacing[1], 1e-6);
    EXPECT_LT(cv::norm(row - Vec3(geometry.direction.col(0).val)), 1e-6);
    EXPECT_LT(cv::norm(column - Vec3(geometry.direction.col(1).val)), 1e-6);
    for (const auto& phase : written)
        for (std::int64_t slice = 0; slice < geometry.size[2]; ++slice) {
            std::size_t time = 0;
            Vec3 position;
            std::uint32_t checksum = 0;
            lines >> time;
            for (double& value : position.val) lines >> value;
            lines >> checksum;
            ASSERT_TRUE(lines) << outcome.output;
            EXPECT_EQ(written[time - 1], phase);
            const Vec3 voxel(0, 0, static_cast<double>(slice));
            EXPECT_LT(cv::norm(position - geometry.patientFromVoxel(voxel)), 1e-6);
            EXPECT_EQ(checksum, checksumOfSlice(*phase, slice));
        }
}

INSTANTIATE_TEST_SUITE_P(Kinds, EnhancedUsRoundTrip, testing::ValuesIn(kinds()),
                         [](const auto& kind) { return kind.param.name; });

/// The positions in the patient of the voxels that hold these values.
std::vector<Vec3> placesOf(const Volume& volume, const std::vector<int>& values) {
    std::vector<Vec3> places;
    const auto& size = volume.geometry().size;
    for (const int value : values)
        for (std::int64_t z = 0; z < size[2]; ++z)
            for (std::int64_t y = 0; y < size[1]; ++y)
                for (std::int64_t x = 0; x < size[0]; ++x)
                    if (volume.storedValue(volume.geometry().offset(x, y, z)) == value)
                        places.push_back(volume.geometry().patientFromVoxel(
                            Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z))));
    return places;
}

TEST(EnhancedUsHandedness, MarkedCornersLieWhereAMetaImageHasThem) {
    std::vector<Mat3> directions;
    for (const double x : {0.0, 90.0, 180.0, 33.0})
        for (const double y : {0.0, 90.0, -90.0, -48.0})
            for (const double z : {0.0, 90.0, 121.0}) directions.push_back(rotationX(x) * rotationY(y) * rotationZ(z));
    directions.push_back(directions.back() * Mat3::diag({1, 1, -1}));  // a left-handed grid is turned round on reading
    const TemporaryFolder folder;
    for (const Mat3& direction : directions) {
        VolumeGeometry geometry = obliqueGeometry();
        geometry.direction = direction;
        geometry.patientFrameKnown = true;
        const auto [nx, ny, nz] = geometry.size;
        std::vector<std::uint8_t> voxels(static_cast<std::size_t>(geometry.voxelCount()), 0);
        const std::vector<std::array<std::int64_t, 3>> corners{
            {0, 0, 0}, {nx - 1, 0, 0}, {0, ny - 1, 0}, {0, 0, nz - 1}, {nx - 1, ny - 1, nz - 1}};
        std::vector<int> marks;
        for (const auto& [x, y, z] : corners) {
            marks.push_back(100 + static_cast<int>(marks.size()));
            voxels[static_cast<std::size_t>(geometry.offset(x, y, z))] = static_cast<std::uint8_t>(marks.back());
        }
        const SharedPhases volume{std::make_shared<const Volume>(geometry, voxels)};
        ASSERT_TRUE(writeEnhancedUs(folder.file("v.dcm"), volume, {}));
        ASSERT_TRUE(writeMetaImage(folder.file("v.mha"), volume));
        const auto dicom = readStudy(folder.file("v.dcm"), withoutGuess());
        const auto metaImage = readStudy(folder.file("v.mha"), withoutGuess());
        ASSERT_TRUE(dicom) << dicom.error().sentence();
        ASSERT_TRUE(metaImage) << metaImage.error().sentence();
        EXPECT_GT(cv::determinant(dicom->phases[0]->geometry().direction), 0);
        const auto there = placesOf(*dicom->phases[0], marks);
        const auto expected = placesOf(*metaImage->phases[0], marks);
        ASSERT_EQ(there.size(), marks.size());
        ASSERT_EQ(expected.size(), marks.size());
        for (std::size_t mark = 0; mark < marks.size(); ++mark)
            EXPECT_LT(cv::norm(there[mark] - expected[mark]), 1e-6) << "mark " << mark;
    }
}

TEST(EnhancedUsWriter, NothingOfAPatientIsWrittenAndTheObjectSaysThatItIsSimulated) {
    const TemporaryFolder folder;
    writeKind(folder.file("v.dcm"), kinds().front());
    const EnhancedUsFile file(folder.file("v.dcm"));
    for (const DcmTagKey& tag : {DCM_PatientName, DCM_PatientID, DCM_PatientBirthDate, DCM_ReferringPhysicianName}) {
        OFString text = "missing";
        EXPECT_TRUE(file.dataset().findAndGetOFString(tag, text).good());
        EXPECT_EQ(text, "");
    }
    OFString text;
    EXPECT_TRUE(file.dataset().findAndGetOFString(DCM_SeriesDescription, text).good());
    EXPECT_EQ(text, "SIMULATED");
    EXPECT_TRUE(file.dataset().findAndGetOFString(DCM_PatientIdentityRemoved, text).good());
    EXPECT_EQ(text, "YES");
}

TEST(EnhancedUsWriter, WhatTheObjectCannotHoldIsRefusedAndNothingIsLeft) {
    const TemporaryFolder folder;
    const VolumeGeometry geometry = upright({2, 2, 2}, {1, 1, 1});
    const SharedPhases floats{std::make_shared<const Volume>(geometry, std::vector<float>(8, 1.5F))};
    const auto refused = writeEnhancedUs(folder.file("v.dcm"), floats, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().kind, FailureKind::unwritable);
    EXPECT_THAT(refused.error().sentence(), HasSubstr("float32"));
    VolumeGeometry unknown = geometry;
    unknown.spacingKnown = false;
    const SharedPhases unscaled{std::make_shared<const Volume>(unknown, std::vector<std::uint8_t>(8, 1))};
    EXPECT_THAT(writeEnhancedUs(folder.file("v.dcm"), unscaled, {}).error().sentence(), HasSubstr("unknown spacing"));
    const VolumeGeometry wide = upright({65536, 1, 2}, {1, 1, 1});
    const SharedPhases tooWide{std::make_shared<const Volume>(wide, std::vector<std::uint8_t>(131072, 1))};
    EXPECT_THAT(writeEnhancedUs(folder.file("v.dcm"), tooWide, {}).error().sentence(), HasSubstr("65536 x 1 pixels"));
    EXPECT_FALSE(std::filesystem::exists(folder.file("v.dcm")));
    EXPECT_THROW((void)writeEnhancedUs(folder.file("v.dcm"), {}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace echolucent
