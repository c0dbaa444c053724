// What a DICOM object's Ultrasound Frame of Reference says of the probe.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/study/study.h"
#include "processing/volume/stated_probe.h"
#include "processing/volume/volume.h"

class DcmItem;

namespace echolucent {

/// The Ultrasound Frame of Reference module (PS3.3 C.8.24.2). Parts that are missing or make no sense are empty.
struct UltrasoundFrame {
    std::string acquisitionGeometry;  ///< APEX, PATIENT, or another text; empty if missing
    std::optional<Vec3> apexMm;       ///< in the volume's frame of reference
    std::optional<cv::Matx44d>
        transducerFromVolume;  ///< rigid; y is normal to the transducer's face, x points to its marker
    std::string relationship;  ///< of the matrix: FIXED, POSITION_VAR, ORIENTATION_VAR, ...; may be empty
    std::vector<ImportFact> facts;
    std::vector<std::string> warnings;  ///< on parts that make no sense and were left out
};
[[nodiscard]] UltrasoundFrame readUltrasoundFrame(DcmItem& dataset);

struct GridInVolumeFrame {
    Vec3 originMm{0, 0, 0};        ///< of the centre of voxel (0,0,0)
    Mat3 direction = Mat3::eye();  ///< columns: unit vectors along the grid's axes
};

/// A probe on the axes of a grid.
struct FoundProbe {
    StatedProbe probe;
    std::string source;  ///< the attributes that state it
};
/// The probe on the grid's axes. Sound runs from the apex to the middle of the grid. If no apex is stated, if the apex
/// lies in the middle of the grid, or if the grid's spacing is unknown, sound runs along the normal of the transducer's
/// face, towards the grid. In the picture along the sound, the transducer's marker is on the right. Without a matrix,
/// or if the marker lies along the sound, that picture is turned as little as possible against the picture along the
/// nearest grid axis. No value if neither apex nor matrix gives a direction. If one was stated, `warnings` says why it
/// gives none.
[[nodiscard]] std::optional<FoundProbe> probeOf(const UltrasoundFrame& frame, const GridInVolumeFrame& grid,
                                                const VolumeGeometry& geometry, std::vector<std::string>& warnings);

}  // namespace echolucent
