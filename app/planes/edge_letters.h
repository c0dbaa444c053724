// The letters at the edges of a plane's picture, which tell which way round it is.
#pragma once

#include <QString>
#include <array>

#include "processing/viewpoint/view_frame.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The letters of a direction in the patient: "L" and "R" (the patient's left and right), "A" and "P" (anterior,
/// posterior), "H" and "F" (head, foot). The largest share comes first, and shares below sin 20 degrees are left out:
/// "LA". `towards` is a unit vector in DICOM's LPS.
[[nodiscard]] QString patientLetters(const Vec3& towards);

/// Letters at the left, right, top and bottom edge: the patient's letters, if the geometry knows the patient's frame.
/// The edge within 30 degrees of the direction to the probe also says "probe". Other edges are empty.
[[nodiscard]] std::array<QString, 4> edgeLetters(const ViewFrame& frame, BeamAxis beam, const VolumeGeometry& geometry);

}  // namespace echolucent
