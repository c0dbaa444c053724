// What tells how a plane's picture lies: letters at its edges, where the probe is, how it lies to the beam.
#pragma once

#include <QPointF>
#include <QString>
#include <array>
#include <optional>

#include "processing/viewpoint/view_frame.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The letters of a direction in the patient: "L" and "R" (the patient's left and right), "A" and "P" (anterior,
/// posterior), "H" and "F" (head, foot). The largest share comes first, and shares below sin 20 degrees are left out:
/// "LA". `towards` is a unit vector in DICOM's LPS.
[[nodiscard]] QString patientLetters(const Vec3& towards);

/// Words at the left, right, top and bottom edge.
struct EdgeLetters {
    std::array<QString, 4> words{};
    bool nameProbe = false;  ///< one of them says where the probe is
};

/// Letters at the left, right, top and bottom edge: the patient's letters, if the geometry knows the patient's frame.
/// The edge within 30 degrees of the direction to the probe also says "probe". Other edges are empty. `beam` has no
/// value if nobody knows it.
[[nodiscard]] EdgeLetters edgeLetters(const ViewFrame& frame, std::optional<BeamAxis> beam,
                                      const VolumeGeometry& geometry);

/// The direction to the probe in the picture, to the right and down: a unit vector. No value if that way lies within 30
/// degrees of the way the picture is looked at.
[[nodiscard]] std::optional<QPointF> towardsProbe(const ViewFrame& frame, BeamAxis beam);

/// How a plane lies, in words: "from the probe" or "towards the probe" if it is looked at along the beam within 30
/// degrees, "along the beam" if it holds the beam within 30 degrees, else "oblique to the beam".
[[nodiscard]] QString lieOf(const ViewFrame& frame, BeamAxis beam);

}  // namespace echolucent
