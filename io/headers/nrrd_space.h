// The frames in which NRRD states positions and directions.
#pragma once

#include <optional>
#include <string>

#include "processing/volume/geometry.h"

namespace echolucent {

struct NrrdSpace {
    std::string name;     ///< in lower case, without "-time"
    Vec3 inLps{1, 1, 1};  ///< 1 or -1 for each coordinate: what turns the frame into LPS, or into a right-handed frame
    Vec3 ownAxes{1, 1, 1};   ///< StoredVolume::ownAxes; a left-handed frame counts as what it is turned into
    bool ofPatient = false;  ///< whether the axes are named after the patient
    [[nodiscard]] bool isLeftHanded() const { return inLps[0] * inLps[1] * inLps[2] < 0.0; }
};

/// The frame that a value of `space` names, however it is written; no value if there is no such frame.
[[nodiscard]] std::optional<NrrdSpace> nrrdSpace(const std::string& text);

}  // namespace echolucent
