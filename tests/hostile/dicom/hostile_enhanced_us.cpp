// Enhanced US Volumes that contradict themselves, or hold numbers that are none: each ends in its own sentence or note.
#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

#include <cmath>
#include <functional>
#include <stdexcept>

#include "dcmtk_conditions.h"
#include "enhanced_us_files.h"
#include "hostile_file.h"
#include "hostile_numbers.h"

namespace echolucent {

namespace {

void putDoubles(DcmItem& item, const DcmTagKey& tag, const std::vector<double>& values) {
    require(item.putAndInsertFloat64Array(tag, values.data(), values.size()), "a row cannot be written");
}

void putText(DcmItem& item, const DcmTagKey& tag, const char* text) {
    require(item.putAndInsertString(tag, text), "a row cannot be written");
}

/// Points a dimension (counted from 0) at another attribute.
void pointDimension(const EnhancedUsFile& file, long dimension, const DcmTagKey& attribute) {
    DcmItem* item = nullptr;
    require(file.dataset().findOrCreateSequenceItem(DCM_DimensionIndexSequence, item, dimension),
            "a row cannot be written");
    require(item->putAndInsertTagKey(DCM_DimensionIndexPointer, attribute), "a row cannot be written");
}

void putMatrix(const EnhancedUsFile& file, const std::vector<double>& matrix) {
    putDoubles(file.dataset(), DCM_VolumeToTransducerMappingMatrix, matrix);
}

using Change = std::function<void(const EnhancedUsFile&)>;

/// A row that changes a good object: 2 phases of 8 slices, 0.04 s apart, oblique, with places in volume and patient.
HostileFile refused(const std::string& name, Change change, std::vector<std::string> words) {
    HostileFile row;
    row.name = "enhanced-us/" + name;
    row.opened = "v.dcm";
    row.write = [change = std::move(change)](const std::filesystem::path& folder) {
        VolumeGeometry geometry = obliqueGeometry();
        geometry.patientFrameKnown = true;
        const std::string path = folder / "v.dcm";
        if (!writeEnhancedUs(path, simulatedPhases(geometry, 8, 2), {.phaseSeconds = 0.04, .apexMm = Vec3(1, 2, -9)}))
            throw std::runtime_error("a row cannot be written: " + path);
        const EnhancedUsFile file(path);
        change(file);
        file.save();
    };
    row.words = std::move(words);
    row.options.guessNoData = false;
    return row;
}

/// The same of an object that opens all the same, as two phases.
HostileFile noted(const std::string& name, Change change, std::vector<std::string> words) {
    HostileFile row = refused(name, std::move(change), std::move(words));
    row.outcome = HostileOutcome::opensWithNote;
    row.phases = 2;
    return row;
}

std::vector<HostileFile> refusals() {
    return {
        refused("fewer-groups-than-frames",
                [](const EnhancedUsFile& file) {
                    file.dataset().findAndDeleteSequenceItem(DCM_PerFrameFunctionalGroupsSequence, 5);
                },
                {"(5200,9230)", "describes 15 frames where Number of Frames says 16"}),
        refused("fewer-frames-than-groups",
                [](const EnhancedUsFile& file) { putText(file.dataset(), DCM_NumberOfFrames, "14"); },
                {"(7fe0,0010)", "9 x 11 pixels in 14 frame(s)"}),
        refused("huge-frame-count",
                [](const EnhancedUsFile& file) { putText(file.dataset(), DCM_NumberOfFrames, "99999999"); },
                {"(7fe0,0010)", "9 x 11 pixels in 99999999 frame(s)"}),
        refused("frame-count-that-is-none",
                [](const EnhancedUsFile& file) { putText(file.dataset(), DCM_NumberOfFrames, "-4"); },
                {"(0028,0008) Number of Frames", "-4"}),
        refused("index-values-too-few",
                [](const EnhancedUsFile& file) {
                    file.setIndexValues(3, {1, 4});
                },
                {"(0020,9157)", "holds 2 values for frame 4, where 3 dimensions are declared"}),
        refused("index-values-too-many",
                [](const EnhancedUsFile& file) { file.setIndexValues(0, std::vector<unsigned>(2000, 1)); },
                {"(0020,9157)", "holds 2000 values for frame 1"}),
        refused("index-value-of-zero",
                [](const EnhancedUsFile& file) {
                    file.setIndexValues(2, {0, 3, 1});
                },
                {"(0020,9157)", "holds 0 for frame 3"}),
        refused("two-frames-at-one-place-and-time",
                [](const EnhancedUsFile& file) {
                    file.setIndexValues(1, {1, 1, 1});
                },
                {"(0020,9157)", "puts frames 1 and 2 at one place and time"}),
        refused("frame-in-another-phase",
                [](const EnhancedUsFile& file) {
                    file.setIndexValues(1, {2, 9, 1});
                },
                {"gives 7 slices at one time and 9 at another"}),
        refused("places-counted-differently",
                [](const EnhancedUsFile& file) {
                    file.setIndexValues(8, {2, 2, 1});
                    file.setIndexValues(9, {2, 1, 1});
                },
                {"(0020,9157)", "counts frames 1 and 9 as different places", "is the same"}),
        refused("one-index-for-two-data-types",
                [](const EnhancedUsFile& file) {
                    putText(file.groupOfFrame(0, DCM_ImageDataTypeSequence), DCM_DataType, "FLOW_POWER");
                },
                {"(0020,9157)", "gives one index to", "flow power", "tissue intensity"}),
        refused("two-indices-for-one-data-type",
                [](const EnhancedUsFile& file) {
                    file.setIndexValues(4, {1, 5, 2});
                },
                {"(0020,9157)", "gives several indices to tissue intensity"}),
        refused("unknown-dimension", [](const EnhancedUsFile& file) { pointDimension(file, 0, DCM_EchoNumbers); },
                {"(0020,9165)", "(0018,0086)", "not known"}),
        refused("dimension-without-pointer",
                [](const EnhancedUsFile& file) {
                    DcmItem* item = nullptr;
                    require(file.dataset().findAndGetSequenceItem(DCM_DimensionIndexSequence, item, 0),
                            "a row cannot be written");
                    require(item->findAndDeleteElement(DCM_DimensionIndexPointer), "a row cannot be written");
                },
                {"(0020,9165)", "not known"}),
        refused("times-against-the-indices",
                [](const EnhancedUsFile& file) {
                    for (std::size_t frame = 8; frame < 16; ++frame)
                        putDoubles(file.groupOfFrame(frame, DCM_TemporalPositionSequence),
                                   DCM_TemporalPositionTimeOffset, {-0.04});
                },
                {"(0020,930d)", "puts phase 2 at -0.04 s, not after phase 1"}),
        refused("times-that-overlap",
                [](const EnhancedUsFile& file) {
                    putDoubles(file.groupOfFrame(3, DCM_TemporalPositionSequence), DCM_TemporalPositionTimeOffset,
                               {0.05});
                },
                {"(0020,930d)", "not after phase 1"}),
        refused("time-that-is-no-number",
                [](const EnhancedUsFile& file) {
                    putDoubles(file.groupOfFrame(3, DCM_TemporalPositionSequence), DCM_TemporalPositionTimeOffset,
                               {noNumber});
                },
                {"(0020,930d)", "frame 4", "is no number of seconds"}),
        refused("position-that-is-no-number",
                [](const EnhancedUsFile& file) {
                    putDoubles(file.groupOfFrame(6, DCM_PlanePositionVolumeSequence), DCM_ImagePositionVolume,
                               {0, noNumber, 0});
                },
                {"(0020,9301) Image Position (Volume)", "frame 7", "three numbers that are finite"}),
        refused("position-of-two-numbers",
                [](const EnhancedUsFile& file) {
                    putText(file.groupOfFrame(6, DCM_PlanePositionSequence), DCM_ImagePositionPatient, "1\\2");
                },
                {"(0020,0032) Image Position (Patient)", "frame 7"}),
        refused("position-beyond-the-earth",
                [](const EnhancedUsFile& file) {
                    putText(file.groupOfFrame(6, DCM_PlanePositionSequence), DCM_ImagePositionPatient, "1e300\\0\\0");
                },
                {"(0020,0032)", "no scanner"}),
        refused("orientation-that-is-no-number",
                [](const EnhancedUsFile& file) {
                    putDoubles(file.groupOfAll(DCM_PlaneOrientationVolumeSequence), DCM_ImageOrientationVolume,
                               std::vector<double>(6, noNumber));
                },
                {"(0020,9302) Image Orientation (Volume)", "all frames", "perpendicular"}),
        refused("orientation-of-zero",
                [](const EnhancedUsFile& file) {
                    putText(file.groupOfAll(DCM_PlaneOrientationSequence), DCM_ImageOrientationPatient,
                            "0\\0\\0\\0\\0\\0");
                },
                {"(0020,0037) Image Orientation (Patient)", "perpendicular"}),
        refused("pixel-spacing-that-is-none",
                [](const EnhancedUsFile& file) {
                    putText(file.groupOfAll(DCM_PixelMeasuresSequence), DCM_PixelSpacing, "nan\\0.5");
                },
                {"(0028,0030) Pixel Spacing", "is not two numbers above 0"}),
        refused("pixel-spacing-that-changes",
                [](const EnhancedUsFile& file) {
                    putText(file.groupOfFrame(2, DCM_PixelMeasuresSequence), DCM_PixelSpacing, "0.5\\0.5");
                },
                {"(0028,0030) Pixel Spacing", "changes from frame to frame"}),
        refused("mirrored-in-the-volume",
                [](const EnhancedUsFile& file) {
                    putDoubles(file.groupOfAll(DCM_PlaneOrientationVolumeSequence), DCM_ImageOrientationVolume,
                               {0, 1, 0, 1, 0, 0});
                    for (std::size_t frame = 0; frame < 16; ++frame)
                        putDoubles(file.groupOfFrame(frame, DCM_PlanePositionVolumeSequence), DCM_ImagePositionVolume,
                                   {0, 0, 0.7123456789 * static_cast<double>(frame % 8)});
                },
                {"(0020,9301)",
                 "puts frame 2 at another distance from frame 1 than (0020,0032) Image Position (Patient) does"}),
        refused("no-place-for-one-frame",
                [](const EnhancedUsFile& file) {
                    for (const DcmTagKey& group : {DCM_PlanePositionSequence, DCM_PlanePositionVolumeSequence}) {
                        DcmItem* groups = nullptr;
                        require(file.dataset().findAndGetSequenceItem(DCM_PerFrameFunctionalGroupsSequence, groups, 9),
                                "a row cannot be written");
                        require(groups->findAndDeleteElement(group), "a row cannot be written");
                    }
                },
                {"(0020,9301)", "is missing for frame 10"}),
        refused("slices-missing",
                [](const EnhancedUsFile& file) {
                    for (const std::size_t frame : {std::size_t{7}, std::size_t{15}})
                        putText(file.groupOfFrame(frame, DCM_PlanePositionSequence), DCM_ImagePositionPatient,
                                "40\\40\\40");
                },
                {"(0020,0032)", "mm apart"}),
        refused("one-frame-of-tissue",
                [](const EnhancedUsFile& file) {
                    for (std::size_t frame = 1; frame < 16; ++frame) {
                        putText(file.groupOfFrame(frame, DCM_ImageDataTypeSequence), DCM_DataType, "ELASTICITY");
                        file.setIndexValues(frame, {1, static_cast<unsigned>(frame + 1), 2});
                    }
                },
                {"holds a single plane of tissue"}),
        refused("nothing-but-flow",
                [](const EnhancedUsFile& file) {
                    putText(file.groupOfAll(DCM_ImageDataTypeSequence), DCM_DataType, "FLOW_VELOCITY");
                },
                {"(0018,9808) Data Type", "names no frame of tissue", "16 of flow velocity (FLOW_VELOCITY)"})};
}

std::vector<HostileFile> notes() {
    return {noted("apex-that-is-no-number",
                  [](const EnhancedUsFile& file) {
                      putDoubles(file.dataset(), DCM_ApexPosition, {noNumber, 0, 0});
                  },
                  {"(0020,9308) Apex Position is no position"}),
            noted("apex-missing",
                  [](const EnhancedUsFile& file) {
                      require(file.dataset().findAndDeleteElement(DCM_ApexPosition), "a row cannot be written");
                  },
                  {"(0020,9308) Apex Position is missing"}),
            noted("apex-in-the-middle",
                  [](const EnhancedUsFile& file) {
                      const Vec3 centre = obliqueGeometry().patientFromVoxel({4, 5, 3.5});
                      putDoubles(file.dataset(), DCM_ApexPosition, {centre[0], centre[1], centre[2]});
                  },
                  {"lies in the middle of the volume"}),
            noted("matrix-of-no-numbers",
                  [](const EnhancedUsFile& file) { putMatrix(file, std::vector<double>(16, noNumber)); },
                  {"(0020,9309) Volume to Transducer Mapping Matrix is no rigid transformation"}),
            noted("matrix-too-short",
                  [](const EnhancedUsFile& file) {
                      putMatrix(file, {1, 0, 0, 0, 1, 0, 0, 0, 1});
                  },
                  {"(0020,9309) Volume to Transducer Mapping Matrix is no rigid transformation"}),
            noted("matrix-that-stretches",
                  [](const EnhancedUsFile& file) {
                      putMatrix(file, {2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 1});
                  },
                  {"(0020,9309) Volume to Transducer Mapping Matrix is no rigid transformation"}),
            noted("matrix-that-mirrors",
                  [](const EnhancedUsFile& file) {
                      putMatrix(file, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1});
                  },
                  {"(0020,9309) Volume to Transducer Mapping Matrix is no rigid transformation"}),
            noted("spacing-between-slices-that-is-not-that-of-the-positions",
                  [](const EnhancedUsFile& file) {
                      putText(file.groupOfAll(DCM_PixelMeasuresSequence), DCM_SpacingBetweenSlices, "0.3");
                  },
                  {"(0018,0088) Spacing Between Slices is 0.3 mm, but the slices' positions are 0.7123 mm apart"}),
            noted("one-volume-of-two-phases",
                  [](const EnhancedUsFile& file) { putText(file.dataset(), DCM_DimensionOrganizationType, "3D"); },
                  {"calls itself one volume", "2 phases"}),
            noted("patient-without-places",
                  [](const EnhancedUsFile& file) {
                      putText(file.dataset(), DCM_UltrasoundAcquisitionGeometry, "PATIENT");
                      DcmItem* shared = nullptr;
                      require(file.dataset().findAndGetSequenceItem(DCM_SharedFunctionalGroupsSequence, shared),
                              "a row cannot be written");
                      require(shared->findAndDeleteElement(DCM_PlaneOrientationSequence), "a row cannot be written");
                  },
                  {"(0020,9307) is PATIENT"}),
            noted("place-in-the-patient-for-some-frames",
                  [](const EnhancedUsFile& file) {
                      DcmItem* groups = nullptr;
                      require(file.dataset().findAndGetSequenceItem(DCM_PerFrameFunctionalGroupsSequence, groups, 9),
                              "a row cannot be written");
                      require(groups->findAndDeleteElement(DCM_PlanePositionSequence), "a row cannot be written");
                  },
                  {"Only 15 of 16 frames have a place in the patient"})};
}

}  // namespace

std::vector<HostileFile> hostileEnhancedUs() {
    std::vector<HostileFile> rows = refusals();
    for (HostileFile& row : notes()) rows.push_back(std::move(row));
    return rows;
}

}  // namespace echolucent
