// Where an Enhanced US Volume says that the probe was, against closed forms; places in the patient; data types.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include "enhanced_us_files.h"
#include "processing/beam/probe_view.h"
#include "processing/document/opening_finds.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

/// A probe that looks at the middle of the grid under these angles, relative to +z.
struct Angles {
    double azimuth = 0.0, elevation = 0.0, roll = 0.0;
};

/// R_y(azimuth) R_x(elevation) R_z(roll): its columns are right, down and forward.
Mat3 turnOf(const Angles& angles) {
    return rotationY(angles.azimuth) * rotationX(angles.elevation) * rotationZ(angles.roll);
}

Vec3 column(const Mat3& matrix, int index) { return {matrix(0, index), matrix(1, index), matrix(2, index)}; }

EnhancedUsDetails probeDetails(const Angles& angles, const VolumeGeometry& geometry, double distanceMm) {
    EnhancedUsDetails details;
    const Mat3 turn = turnOf(angles);
    details.transducer.alongSound = column(turn, 2);
    details.transducer.alongMarker = column(turn, 0);
    details.transducer.faceMm = geometry.centreMm() - column(turn, 2) * (distanceMm / 2);
    details.apexMm = geometry.centreMm() - column(turn, 2) * distanceMm;
    return details;
}

class EnhancedUsProbe : public testing::Test {
protected:
    /// Writes a volume, changes the file, and reads it.
    Study read(const VolumeGeometry& geometry, const EnhancedUsDetails& details,
               const std::function<void(const EnhancedUsFile&)>& change = {}) {
        EXPECT_TRUE(writeEnhancedUs(m_path, simulatedPhases(geometry, 8, 1), details));
        if (change) {
            const EnhancedUsFile file(m_path);
            change(file);
            file.save();
        }
        auto study = readStudy(m_path, withoutGuess());
        EXPECT_TRUE(study) << study.error().sentence();
        return study ? *study : Study{};
    }
    static void expectView(const Study& study, const Angles& angles) {
        ASSERT_FALSE(study.phases.empty());
        const auto& probe = study.phases[0]->geometry().probe;
        ASSERT_TRUE(probe);
        const Viewpoint view = viewFromProbe(*probe);
        EXPECT_EQ(view.beamAxis, BeamAxis::plusZ);
        EXPECT_NEAR(view.azimuthDegrees, angles.azimuth, 1e-6);
        EXPECT_NEAR(view.elevationDegrees, angles.elevation, 1e-6);
        EXPECT_NEAR(view.rollDegrees, angles.roll, 1e-6);
    }

    TemporaryFolder m_folder;
    std::string m_path = m_folder.file("v.dcm");
};

const std::vector<Angles> someAngles{{0, 0, 0}, {20, -13, 0}, {-31, 8, 40}, {12, 30, -155}, {0, 0, 90}};

TEST_F(EnhancedUsProbe, ApexAndTransducerGiveTheViewFromTheProbe) {
    for (const bool inPatient : {false, true})
        for (const Angles& angles : someAngles) {
            VolumeGeometry geometry = obliqueGeometry();
            geometry.patientFrameKnown = inPatient;
            const EnhancedUsDetails details = probeDetails(angles, geometry, 60);
            const Study study = read(geometry, details);
            expectView(study, angles);
            const StatedProbe& probe = *study.phases[0]->geometry().probe;
            ASSERT_TRUE(probe.apexMm);
            EXPECT_LT(cv::norm(*probe.apexMm - *details.apexMm), 1e-6);
            EXPECT_EQ(factOf(study, "acquisition geometry"), "scan lines from one apex (APEX)");
            EXPECT_THAT(study.warnings, IsEmpty());
        }
}

TEST_F(EnhancedUsProbe, TheTransducerAloneGivesIt) {
    for (const Angles& angles : someAngles) {
        EnhancedUsDetails details = probeDetails(angles, obliqueGeometry(), 60);
        details.apexMm.reset();
        const Study study = read(obliqueGeometry(), details);
        expectView(study, angles);
        EXPECT_FALSE(study.phases[0]->geometry().probe->apexMm);
        EXPECT_EQ(factOf(study, "acquisition geometry"), "relative to the patient (PATIENT)");
    }
}

TEST_F(EnhancedUsProbe, AnApexAloneTurnsThePictureLeast) {
    for (const Angles& angles : someAngles) {
        const Study study =
            read(obliqueGeometry(), probeDetails(angles, obliqueGeometry(), 60), [](const EnhancedUsFile& file) {
                file.dataset().findAndDeleteElement(DCM_VolumeToTransducerMappingMatrix);
            });
        const auto& probe = study.phases[0]->geometry().probe;
        ASSERT_TRUE(probe);
        EXPECT_LT(cv::norm(probe->forward - column(turnOf(angles), 2)), 1e-6);
        // Down is what is left of the grid's +y across the view.
        const Vec3 left = Vec3(0, 1, 0) - probe->forward * probe->forward[1];
        EXPECT_LT(cv::norm(probe->down - normalized(left)), 1e-6);
    }
}

TEST_F(EnhancedUsProbe, AFaceThatLooksAwayIsTurnedAndSaid) {
    EnhancedUsDetails details = probeDetails({20, -13, 0}, obliqueGeometry(), 60);
    details.apexMm.reset();
    details.transducer.alongSound *= -1.0;
    const Study study = read(obliqueGeometry(), details);
    EXPECT_LT(cv::norm(study.phases[0]->geometry().probe->forward - column(turnOf({20, -13, 0}), 2)), 1e-6);
    EXPECT_THAT(study.warnings, Contains(HasSubstr("puts the volume behind the transducer's face")));
}

TEST_F(EnhancedUsProbe, ANominalPlaceOfTheTransducerIsUsedAndCalledSo) {
    const Study study =
        read(obliqueGeometry(), probeDetails({20, -13, 0}, obliqueGeometry(), 60), [](const EnhancedUsFile& file) {
            file.dataset().putAndInsertString(DCM_VolumeToTransducerRelationship, "ORIENTATION_VAR");
        });
    expectView(study, {20, -13, 0});
    EXPECT_EQ(factOf(study, "transducer's place"), "nominal: \"ORIENTATION_VAR\"");
}

TEST_F(EnhancedUsProbe, NothingIsStatedWhereTheFileStatesNothing) {
    const Study study = read(obliqueGeometry(), {}, [](const EnhancedUsFile& file) {
        file.dataset().findAndDeleteElement(DCM_VolumeToTransducerMappingMatrix);
        file.dataset().findAndDeleteElement(DCM_VolumeToTransducerRelationship);
    });
    EXPECT_FALSE(study.phases[0]->geometry().probe);
    EXPECT_THAT(study.warnings, IsEmpty());
}

TEST_F(EnhancedUsProbe, OpeningTakesTheBeamFromTheFile) {
    const Study study = read(obliqueGeometry(), probeDetails({20, -13, 35}, obliqueGeometry(), 60));
    const auto finds = findOnOpening(*study.phases[0]);
    ASSERT_TRUE(finds);
    const Document document = withFinds(Document{}, *finds);
    EXPECT_EQ(document.beam.source, BeamSource::file);
    EXPECT_EQ(document.beam.axis, BeamAxis::plusZ);
    EXPECT_NEAR(document.beam.lean.azimuth, 20, 1e-6);
    EXPECT_NEAR(document.beam.lean.elevation, -13, 1e-6);
    EXPECT_NEAR(document.beam.lean.roll, 35, 1e-6);
    EXPECT_EQ(document.scene.side, document.beam.lean);
}

TEST_F(EnhancedUsProbe, PlacesInThePatientGiveTheGeometryAndThoseInTheVolumeTheProbe) {
    const Mat3 turn = rotationX(40) * rotationZ(-70);
    const Vec3 shift(100, -20, 33);
    const VolumeGeometry geometry = obliqueGeometry();
    const Angles angles{-31, 8, 40};
    const auto movePatient = [&](const EnhancedUsFile& file) {
        const auto text = [](const Vec3& v) { return fmt::format("{:.10f}\\{:.10f}\\{:.10f}", v[0], v[1], v[2]); };
        const Mat3 direction = turn * geometry.direction;
        const std::string both = text(column(direction, 0)) + "\\" + text(column(direction, 1));
        file.groupOfAll(DCM_PlaneOrientationSequence).putAndInsertString(DCM_ImageOrientationPatient, both.c_str());
        for (std::size_t frame = 0; frame < file.frames(); ++frame) {
            const Vec3 position = turn * geometry.patientFromVoxel({0, 0, static_cast<double>(frame)}) + shift;
            file.groupOfFrame(frame, DCM_PlanePositionSequence)
                .putAndInsertString(DCM_ImagePositionPatient, text(position).c_str());
        }
    };
    const Study study = read(geometry, probeDetails(angles, geometry, 60), movePatient);
    const VolumeGeometry& found = study.phases[0]->geometry();
    EXPECT_TRUE(found.patientFrameKnown);
    EXPECT_LT(cv::norm(found.origin - (turn * geometry.origin + shift)), 1e-6);
    EXPECT_LT(cv::norm(found.direction - turn * geometry.direction), 1e-6);
    expectView(study, angles);
}

TEST_F(EnhancedUsProbe, WithoutPlacesInTheVolumeTheProbeIsLeftOutAndSaid) {
    VolumeGeometry geometry = obliqueGeometry();
    geometry.patientFrameKnown = true;
    const Study study = read(geometry, probeDetails({}, geometry, 60), [](const EnhancedUsFile& file) {
        DcmItem* shared = nullptr;
        ASSERT_TRUE(file.dataset().findAndGetSequenceItem(DCM_SharedFunctionalGroupsSequence, shared).good());
        ASSERT_TRUE(shared->findAndDeleteElement(DCM_PlaneOrientationVolumeSequence).good());
    });
    EXPECT_FALSE(study.phases[0]->geometry().probe);
    EXPECT_THAT(study.warnings, Contains(HasSubstr("The place of the probe was left out")));
}

TEST_F(EnhancedUsProbe, FlowIsNamedAndLeftOut) {
    VolumeGeometry geometry = obliqueGeometry();
    geometry.size[2] = 16;
    // The frames of odd numbers become the flow of the slices before them.
    const auto mix = [](const EnhancedUsFile& file) {
        for (std::size_t frame = 0; frame < file.frames(); ++frame) {
            const auto slice = static_cast<unsigned>(frame / 2);
            const Vec3 position = obliqueGeometry().patientFromVoxel({0, 0, static_cast<double>(slice)});
            file.groupOfFrame(frame, DCM_PlanePositionVolumeSequence)
                .putAndInsertFloat64Array(DCM_ImagePositionVolume, position.val, 3);
            file.setIndexValues(frame, {1, slice + 1, frame % 2 == 0 ? 1U : 2U});
            file.groupOfFrame(frame, DCM_ImageDataTypeSequence)
                .putAndInsertString(DCM_DataType, frame % 2 == 0 ? "TISSUE_INTENSITY" : "FLOW_VELOCITY");
        }
    };
    const auto written = simulatedPhases(geometry, 8, 1);
    EnhancedUsDetails details;
    details.apexMm = Vec3(0, 0, -30);  // so that there are no places in the patient
    const Study study = read(geometry, details, mix);
    const Volume& volume = *study.phases[0];
    EXPECT_EQ(volume.geometry().size, obliqueGeometry().size);
    const auto& slice = volume.geometry().size;
    for (std::int64_t z = 0; z < slice[2]; ++z)
        for (std::int64_t pixel = 0; pixel < slice[0] * slice[1]; ++pixel)
            ASSERT_EQ(volume.storedValue(volume.geometry().offset(0, 0, z) + pixel),
                      written[0]->storedValue(geometry.offset(0, 0, 2 * z) + pixel));
    EXPECT_EQ(factOf(study, "data type"),
              "tissue intensity (TISSUE_INTENSITY); left out: 8 of flow velocity (FLOW_VELOCITY)");
    EXPECT_THAT(study.warnings, Contains(HasSubstr("8 of 16 frames show tissue intensity (TISSUE_INTENSITY) and were "
                                                   "read; left out were 8 of flow velocity (FLOW_VELOCITY).")));
}

}  // namespace
}  // namespace echolucent
