// What stands at the edges of a plane's picture, so that nobody has to guess which way round it is.
#pragma once

#include <QString>
#include <array>

#include "processing/viewpoint/view_frame.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// Where a direction points in a patient: "L" and "R" (the patient's left and right), "A" and "P" (anterior,
/// posterior), "H" and "F" (head, foot), the largest share first, and shares below sin 20 degrees left out: "LA".
/// `towards` is a unit vector in DICOM's LPS.
[[nodiscard]] QString patientLetters(const Vec3& towards);

/// Left, right, top and bottom: the patient's letters where the geometry knows the patient's frame, and "probe" at the
/// edge that lies towards the probe, within 30 degrees. The others are empty.
[[nodiscard]] std::array<QString, 4> edgeLetters(const ViewFrame& frame, BeamAxis beam, const VolumeGeometry& geometry);

}  // namespace echolucent
