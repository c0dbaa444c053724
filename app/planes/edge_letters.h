// What stands at the edges of a plane's picture, so that nobody has to guess which way round it is.
#pragma once

#include <QString>
#include <array>

#include "processing/view_frame.h"
#include "processing/viewpoint.h"

namespace echolucent {

/// Left, right, top and bottom: "probe" at the edge that lies towards the probe, within 30 degrees; the others are
/// empty.
[[nodiscard]] std::array<QString, 4> edgeLetters(const ViewFrame& frame, BeamAxis beam);

}  // namespace echolucent
