// Pictures that the graphics card and the processor both draw.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "processing/classification.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/volume/volume.h"

namespace echolucent::bench {

/// One look at one volume. Its camera is set for each view.
struct CardCase {
    std::string volume, look;
    std::shared_ptr<const Volume> voxels;
    Classification classification;
    RayCastSettings settings;
};

/// A simulated scan of edge^3 voxels; every second one has data in a ball only if `masked`.
[[nodiscard]] std::shared_ptr<const Volume> simulated(bool fetus, int edge, int bits = 8);

/// All modes, lights, cuts and classifications on a volume, at a step of 0.75 and this size.
[[nodiscard]] std::vector<CardCase> casesOf(const std::string& name, const std::shared_ptr<const Volume>& volume,
                                            int pixels);
/// The cases of the two phantoms: bytes, words, floats, with holes and without.
[[nodiscard]] std::vector<CardCase> casesOfPhantoms(int edge, int pixels);

/// Camera k of `count` around a volume, evenly over the sphere; every third one in perspective.
[[nodiscard]] Camera cameraAround(const Volume& volume, int k, int count, double aspect);

/// The bowed front of a case: a paraboloid across a view, through about the middle of the volume.
[[nodiscard]] CutSurface bowedFront(const Volume& volume, const ViewFrame& frame);

}  // namespace echolucent::bench
