// Enhanced US Volumes that contradict themselves, or hold numbers that are none: each ends in its own sentence.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <cmath>
#include <functional>
#include <limits>

#include "enhanced_us_files.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();

void putDoubles(DcmItem& item, const DcmTagKey& tag, const std::vector<double>& values) {
    ASSERT_TRUE(item.putAndInsertFloat64Array(tag, values.data(), values.size()).good());
}

void putText(DcmItem& item, const DcmTagKey& tag, const char* text) {
    ASSERT_TRUE(item.putAndInsertString(tag, text).good());
}

/// Points a dimension (counted from 0) at another attribute.
void pointDimension(const EnhancedUsFile& file, long dimension, const DcmTagKey& attribute) {
    DcmItem* item = nullptr;
    ASSERT_TRUE(file.dataset().findOrCreateSequenceItem(DCM_DimensionIndexSequence, item, dimension).good());
    ASSERT_TRUE(item->putAndInsertTagKey(DCM_DimensionIndexPointer, attribute).good());
}

/// What a test does to a good object: 2 phases of 8 slices, 0.04 s apart, oblique, with places in volume and patient.
struct Change {
    std::string name;
    std::function<void(const EnhancedUsFile&)> change;
    std::vector<std::string> words;  ///< of the sentence
};

class EnhancedUsChanged : public testing::TestWithParam<Change> {
protected:
    Result<Study> readChanged() {
        VolumeGeometry geometry = obliqueGeometry();
        geometry.patientFrameKnown = true;
        const std::string path = m_folder.file("v.dcm");
        EXPECT_TRUE(
            writeEnhancedUs(path, simulatedPhases(geometry, 8, 2), {.phaseSeconds = 0.04, .apexMm = Vec3(1, 2, -9)}));
        {
            const EnhancedUsFile file(path);
            GetParam().change(file);
            file.save();
        }
        return readStudy(path, withoutGuess());
    }

private:
    TemporaryFolder m_folder;
};

class EnhancedUsRefused : public EnhancedUsChanged {};

TEST_P(EnhancedUsRefused, InOneSentence) {
    const auto study = readChanged();
    ASSERT_FALSE(study);
    EXPECT_EQ(study.error().kind, FailureKind::unreadable);
    for (const std::string& words : GetParam().words) EXPECT_THAT(study.error().sentence(), HasSubstr(words));
    EXPECT_FALSE(study.error().remedy.empty());
}

std::vector<Change> refusals() {
    return {
        {"FewerGroupsThanFrames",
         [](const EnhancedUsFile& file) {
             file.dataset().findAndDeleteSequenceItem(DCM_PerFrameFunctionalGroupsSequence, 5);
         },
         {"(5200,9230)", "describes 15 frames where Number of Frames says 16"}},
        {"FewerFramesThanGroups",
         [](const EnhancedUsFile& file) { putText(file.dataset(), DCM_NumberOfFrames, "14"); },
         {"(7fe0,0010)", "9 x 11 pixels in 14 frame(s)"}},
        {"HugeFrameCount",
         [](const EnhancedUsFile& file) { putText(file.dataset(), DCM_NumberOfFrames, "99999999"); },
         {"(7fe0,0010)", "9 x 11 pixels in 99999999 frame(s)"}},
        {"FrameCountThatIsNone",
         [](const EnhancedUsFile& file) { putText(file.dataset(), DCM_NumberOfFrames, "-4"); },
         {"(0028,0008) Number of Frames", "-4"}},
        {"IndexValuesTooFew",
         [](const EnhancedUsFile& file) {
             file.setIndexValues(3, {1, 4});
         },
         {"(0020,9157)", "holds 2 values for frame 4, where 3 dimensions are declared"}},
        {"IndexValuesTooMany",
         [](const EnhancedUsFile& file) { file.setIndexValues(0, std::vector<unsigned>(2000, 1)); },
         {"(0020,9157)", "holds 2000 values for frame 1"}},
        {"IndexValueOfZero",
         [](const EnhancedUsFile& file) {
             file.setIndexValues(2, {0, 3, 1});
         },
         {"(0020,9157)", "holds 0 for frame 3"}},
        {"TwoFramesAtOnePlaceAndTime",
         [](const EnhancedUsFile& file) {
             file.setIndexValues(1, {1, 1, 1});
         },
         {"(0020,9157)", "puts frames 1 and 2 at one place and time"}},
        {"FrameInAnotherPhase",
         [](const EnhancedUsFile& file) {
             file.setIndexValues(1, {2, 9, 1});
         },
         {"gives 7 slices at one time and 9 at another"}},
        {"PlacesCountedDifferently",
         [](const EnhancedUsFile& file) {
             file.setIndexValues(8, {2, 2, 1});
             file.setIndexValues(9, {2, 1, 1});
         },
         {"(0020,9157)", "counts frames 1 and 9 as different places", "is the same"}},
        {"OneIndexForTwoDataTypes",
         [](const EnhancedUsFile& file) {
             putText(file.groupOfFrame(0, DCM_ImageDataTypeSequence), DCM_DataType, "FLOW_POWER");
         },
         {"(0020,9157)", "gives one index to", "flow power", "tissue intensity"}},
        {"TwoIndicesForOneDataType",
         [](const EnhancedUsFile& file) {
             file.setIndexValues(4, {1, 5, 2});
         },
         {"(0020,9157)", "gives several indices to tissue intensity"}},
        {"UnknownDimension",
         [](const EnhancedUsFile& file) { pointDimension(file, 0, DCM_EchoNumbers); },
         {"(0020,9165)", "(0018,0086)", "not known"}},
        {"DimensionWithoutPointer",
         [](const EnhancedUsFile& file) {
             DcmItem* item = nullptr;
             ASSERT_TRUE(file.dataset().findAndGetSequenceItem(DCM_DimensionIndexSequence, item, 0).good());
             ASSERT_TRUE(item->findAndDeleteElement(DCM_DimensionIndexPointer).good());
         },
         {"(0020,9165)", "not known"}},
        {"TimesAgainstTheIndices",
         [](const EnhancedUsFile& file) {
             for (std::size_t frame = 8; frame < 16; ++frame)
                 putDoubles(file.groupOfFrame(frame, DCM_TemporalPositionSequence), DCM_TemporalPositionTimeOffset,
                            {-0.04});
         },
         {"(0020,930d)", "puts phase 2 at -0.04 s, not after phase 1"}},
        {"TimesThatOverlap",
         [](const EnhancedUsFile& file) {
             putDoubles(file.groupOfFrame(3, DCM_TemporalPositionSequence), DCM_TemporalPositionTimeOffset, {0.05});
         },
         {"(0020,930d)", "not after phase 1"}},
        {"TimeThatIsNoNumber",
         [](const EnhancedUsFile& file) {
             putDoubles(file.groupOfFrame(3, DCM_TemporalPositionSequence), DCM_TemporalPositionTimeOffset, {noNumber});
         },
         {"(0020,930d)", "frame 4", "is no number of seconds"}},
        {"PositionThatIsNoNumber",
         [](const EnhancedUsFile& file) {
             putDoubles(file.groupOfFrame(6, DCM_PlanePositionVolumeSequence), DCM_ImagePositionVolume,
                        {0, noNumber, 0});
         },
         {"(0020,9301) Image Position (Volume)", "frame 7", "three numbers that are finite"}},
        {"PositionOfTwoNumbers",
         [](const EnhancedUsFile& file) {
             putText(file.groupOfFrame(6, DCM_PlanePositionSequence), DCM_ImagePositionPatient, "1\\2");
         },
         {"(0020,0032) Image Position (Patient)", "frame 7"}},
        {"PositionBeyondTheEarth",
         [](const EnhancedUsFile& file) {
             putText(file.groupOfFrame(6, DCM_PlanePositionSequence), DCM_ImagePositionPatient, "1e300\\0\\0");
         },
         {"(0020,0032)", "no scanner"}},
        {"OrientationThatIsNoNumber",
         [](const EnhancedUsFile& file) {
             putDoubles(file.groupOfAll(DCM_PlaneOrientationVolumeSequence), DCM_ImageOrientationVolume,
                        std::vector<double>(6, noNumber));
         },
         {"(0020,9302) Image Orientation (Volume)", "all frames", "perpendicular"}},
        {"OrientationOfZero",
         [](const EnhancedUsFile& file) {
             putText(file.groupOfAll(DCM_PlaneOrientationSequence), DCM_ImageOrientationPatient, "0\\0\\0\\0\\0\\0");
         },
         {"(0020,0037) Image Orientation (Patient)", "perpendicular"}},
        {"PixelSpacingThatIsNone",
         [](const EnhancedUsFile& file) {
             putText(file.groupOfAll(DCM_PixelMeasuresSequence), DCM_PixelSpacing, "nan\\0.5");
         },
         {"(0028,0030) Pixel Spacing", "is not two numbers above 0"}},
        {"PixelSpacingThatChanges",
         [](const EnhancedUsFile& file) {
             putText(file.groupOfFrame(2, DCM_PixelMeasuresSequence), DCM_PixelSpacing, "0.5\\0.5");
         },
         {"(0028,0030) Pixel Spacing", "changes from frame to frame"}},
        {"MirroredInTheVolume",
         [](const EnhancedUsFile& file) {
             putDoubles(file.groupOfAll(DCM_PlaneOrientationVolumeSequence), DCM_ImageOrientationVolume,
                        {0, 1, 0, 1, 0, 0});
             for (std::size_t frame = 0; frame < 16; ++frame)
                 putDoubles(file.groupOfFrame(frame, DCM_PlanePositionVolumeSequence), DCM_ImagePositionVolume,
                            {0, 0, 0.7123456789 * static_cast<double>(frame % 8)});
         },
         {"(0020,9301)",
          "puts frame 2 at another distance from frame 1 than (0020,0032) Image Position (Patient) does"}},
        {"NoPlaceForOneFrame",
         [](const EnhancedUsFile& file) {
             for (const DcmTagKey& group : {DCM_PlanePositionSequence, DCM_PlanePositionVolumeSequence}) {
                 DcmItem* groups = nullptr;
                 ASSERT_TRUE(
                     file.dataset().findAndGetSequenceItem(DCM_PerFrameFunctionalGroupsSequence, groups, 9).good());
                 ASSERT_TRUE(groups->findAndDeleteElement(group).good());
             }
         },
         {"(0020,9301)", "is missing for frame 10"}},
        {"SlicesMissing",
         [](const EnhancedUsFile& file) {
             for (const std::size_t frame : {std::size_t{7}, std::size_t{15}})
                 putText(file.groupOfFrame(frame, DCM_PlanePositionSequence), DCM_ImagePositionPatient, "40\\40\\40");
         },
         {"(0020,0032)", "mm apart"}},
        {"OneFrameOfTissue",
         [](const EnhancedUsFile& file) {
             for (std::size_t frame = 1; frame < 16; ++frame) {
                 putText(file.groupOfFrame(frame, DCM_ImageDataTypeSequence), DCM_DataType, "ELASTICITY");
                 file.setIndexValues(frame, {1, static_cast<unsigned>(frame + 1), 2});
             }
         },
         {"holds a single plane of tissue"}},
        {"NothingButFlow",
         [](const EnhancedUsFile& file) {
             putText(file.groupOfAll(DCM_ImageDataTypeSequence), DCM_DataType, "FLOW_VELOCITY");
         },
         {"(0018,9808) Data Type", "names no frame of tissue", "16 of flow velocity (FLOW_VELOCITY)"}},
    };
}

INSTANTIATE_TEST_SUITE_P(Objects, EnhancedUsRefused, testing::ValuesIn(refusals()),
                         [](const auto& row) { return row.param.name; });

class EnhancedUsSaid : public EnhancedUsChanged {};

TEST_P(EnhancedUsSaid, AsANoteOfTheReport) {
    const auto study = readChanged();
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases.size(), 2U);
    for (const std::string& words : GetParam().words) EXPECT_THAT(study->warnings, Contains(HasSubstr(words)));
}

void putMatrix(const EnhancedUsFile& file, const std::vector<double>& matrix) {
    putDoubles(file.dataset(), DCM_VolumeToTransducerMappingMatrix, matrix);
}

std::vector<Change> notes() {
    return {
        {"ApexThatIsNoNumber",
         [](const EnhancedUsFile& file) {
             putDoubles(file.dataset(), DCM_ApexPosition, {noNumber, 0, 0});
         },
         {"(0020,9308) Apex Position is no position"}},
        {"ApexMissing",
         [](const EnhancedUsFile& file) { ASSERT_TRUE(file.dataset().findAndDeleteElement(DCM_ApexPosition).good()); },
         {"(0020,9308) Apex Position is missing"}},
        {"ApexInTheMiddle",
         [](const EnhancedUsFile& file) {
             const Vec3 centre = obliqueGeometry().patientFromVoxel({4, 5, 3.5});
             putDoubles(file.dataset(), DCM_ApexPosition, {centre[0], centre[1], centre[2]});
         },
         {"lies in the middle of the volume"}},
        {"MatrixOfNoNumbers",
         [](const EnhancedUsFile& file) { putMatrix(file, std::vector<double>(16, noNumber)); },
         {"(0020,9309) Volume to Transducer Mapping Matrix is no rigid transformation"}},
        {"MatrixTooShort",
         [](const EnhancedUsFile& file) {
             putMatrix(file, {1, 0, 0, 0, 1, 0, 0, 0, 1});
         },
         {"(0020,9309) Volume to Transducer Mapping Matrix is no rigid transformation"}},
        {"MatrixThatStretches",
         [](const EnhancedUsFile& file) {
             putMatrix(file, {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1});
         },
         {"(0020,9309) Volume to Transducer Mapping Matrix is no rigid transformation"}},
        {"MatrixThatMirrors",
         [](const EnhancedUsFile& file) {
             putMatrix(file, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1});
         },
         {"(0020,9309) Volume to Transducer Mapping Matrix is no rigid transformation"}},
        {"SpacingBetweenSlicesThatIsNotThatOfThePositions",
         [](const EnhancedUsFile& file) {
             putText(file.groupOfAll(DCM_PixelMeasuresSequence), DCM_SpacingBetweenSlices, "0.3");
         },
         {"(0018,0088) Spacing Between Slices is 0.3 mm, but the slices' positions are 0.7123 mm apart"}},
        {"OneVolumeOfTwoPhases",
         [](const EnhancedUsFile& file) { putText(file.dataset(), DCM_DimensionOrganizationType, "3D"); },
         {"calls itself one volume", "2 phases"}},
        {"PatientWithoutPlaces",
         [](const EnhancedUsFile& file) {
             putText(file.dataset(), DCM_UltrasoundAcquisitionGeometry, "PATIENT");
             DcmItem* shared = nullptr;
             ASSERT_TRUE(file.dataset().findAndGetSequenceItem(DCM_SharedFunctionalGroupsSequence, shared).good());
             ASSERT_TRUE(shared->findAndDeleteElement(DCM_PlaneOrientationSequence).good());
         },
         {"(0020,9307) is PATIENT"}},
        {"PlaceInThePatientForSomeFrames",
         [](const EnhancedUsFile& file) {
             DcmItem* groups = nullptr;
             ASSERT_TRUE(file.dataset().findAndGetSequenceItem(DCM_PerFrameFunctionalGroupsSequence, groups, 9).good());
             ASSERT_TRUE(groups->findAndDeleteElement(DCM_PlanePositionSequence).good());
         },
         {"Only 15 of 16 frames have a place in the patient"}},
    };
}

INSTANTIATE_TEST_SUITE_P(Objects, EnhancedUsSaid, testing::ValuesIn(notes()),
                         [](const auto& row) { return row.param.name; });

}  // namespace
}  // namespace echolucent
