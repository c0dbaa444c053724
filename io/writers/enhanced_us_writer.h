// Writes volumes as DICOM Enhanced US Volume.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "processing/result.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Where the transducer was, on the grid's axes (grid mm).
struct TransducerPlace {
    Vec3 faceMm{0, 0, 0};       ///< the centre of its face
    Vec3 alongSound{0, 0, 1};   ///< unit vector, normal to the face, into the volume
    Vec3 alongMarker{1, 0, 0};  ///< unit vector towards the marked side, perpendicular to alongSound
};

/// What an Enhanced US Volume says beside voxels and grid.
struct EnhancedUsDetails {
    std::optional<double> phaseSeconds{};  ///< between phases, above 0; no value: phases are only counted
    /// Where the scan lines meet, grid mm; Ultrasound Acquisition Geometry is APEX then, else PATIENT.
    std::optional<Vec3> apexMm{};
    TransducerPlace transducer{};
};

/// Writes one simulated volume, or the phases of a 4D one, to `path` as one DICOM Enhanced US Volume (uncompressed),
/// whole or not at all. The voxels have 8 or 16 bits; origin and direction of the grid give the planes in the volume's
/// frame of reference, and also those in the patient's where the patient frame is known or nothing but PATIENT is left.
/// The white level is kept as the frames' window. The object is marked as simulated; its identifiers are new with every
/// call, and it holds nothing about a patient. Fails (unwritable) where the voxels are float32, where the spacing is
/// not known, where an edge of the grid or the whole is longer than DICOM can count, or where the file cannot be
/// written. Throws std::invalid_argument where there is no phase or where the phases differ in size or type.
[[nodiscard]] Result<void> writeEnhancedUs(const std::string& path,
                                           const std::vector<std::shared_ptr<const Volume>>& phases,
                                           const EnhancedUsDetails& details);

}  // namespace echolucent
