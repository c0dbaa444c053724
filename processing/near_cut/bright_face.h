// How bright the face is that a scan shows from a side: where its data or, behind a cut, its picture begins.
#pragma once

#include <optional>

#include "processing/progress.h"
#include "processing/viewpoint/viewpoint.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The median, over 1024 rays along the view, of the intensity that each shows in the end, with opacity x^2 a unit and
/// without light. What the view's front cuts away is not seen. Rays that end less than half opaque do not count; 0 if
/// there are no others. A ray has at most 4096 steps, of a unit if that is enough. The result is empty only if
/// progress.cancel was raised.
[[nodiscard]] std::optional<double> faceIntensity(const Volume& volume, const Viewpoint& view,
                                                  const Progress& progress = {});

/// The factor on the brightness of pictures with which a face of this intensity is not overexposed: 1 up to
/// `mostFaceIntensity`, else such that the face gets `calmFaceIntensity`. A face is unlit, so it has no shades but its
/// own grey values, and near white they are all alike (docs/picture.md).
[[nodiscard]] double exposureFor(double faceIntensity);

inline constexpr double mostFaceIntensity = 0.8, calmFaceIntensity = 0.6;

}  // namespace echolucent
