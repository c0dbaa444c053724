// Writes volumes as DICOM Enhanced US Volume.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "processing/result.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Where the transducer was, in grid mm.
struct TransducerPlace {
    Vec3 faceMm{0, 0, 0};       ///< the centre of its face
    Vec3 alongSound{0, 0, 1};   ///< unit vector, normal to the face, into the volume
    Vec3 alongMarker{1, 0, 0};  ///< unit vector towards the marked side, across alongSound
};

/// Details of an Enhanced US Volume beside voxels and grid.
struct EnhancedUsDetails {
    std::optional<double> phaseSeconds{};  ///< between phases, above 0; without a value, phases are only counted
    /// Where the scan lines meet, grid mm. If set, Ultrasound Acquisition Geometry is APEX, else PATIENT.
    std::optional<Vec3> apexMm{};
    TransducerPlace transducer{};
};

/// Writes one simulated volume, or the phases of a 4D one, to `path` as one uncompressed DICOM Enhanced US Volume,
/// whole or not at all. The voxels have 8 or 16 bits. The grid's origin and direction give the planes in the volume's
/// frame of reference; if the patient frame is known, or there is no apex, also in the patient's. The frames' window
/// keeps the white level. All phases get the geometry and the white level of the first one. The object is marked as
/// simulated and holds nothing about a patient; every call makes new identifiers. Fails (unwritable) if the voxels are
/// float32, if the spacing is not known, or if the file cannot be written. It also fails if a slice has an edge above
/// 65535 pixels, or if all voxels take more than 4 GB, as DICOM counts no further. Throws std::invalid_argument if
/// there is no phase, or if phases differ in size or type.
[[nodiscard]] Result<void> writeEnhancedUs(const std::string& path,
                                           const std::vector<std::shared_ptr<const Volume>>& phases,
                                           const EnhancedUsDetails& details);

}  // namespace echolucent
