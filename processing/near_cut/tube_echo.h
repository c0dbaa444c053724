// The smooth echo along a dense grid of tube cores.
#pragma once

#include <cstddef>
#include <vector>

#include "processing/near_cut/smooth_echo.h"
#include "processing/viewpoint/viewpoint.h"

namespace echolucent {

/// The smooth echo, read along tube cores that lie a cell apart across a view and cover its data. Their samples lie a
/// cell apart too, in planes across the view; the grid passes through the middle of the data.
struct TubeEcho {
    ViewFrame frame;
    double stepMm = 1.0;                           ///< between samples, and between tube cores
    double firstRightMm = 0.0, firstDownMm = 0.0;  ///< place of tube core (0,0) along right and down
    double firstDepthMm = 0.0;                     ///< of the first plane, from the grid origin
    int columns = 0, rows = 0, samples = 0;        ///< tube cores along right and down; samples in each
    std::vector<float> echo;                       ///< sample after sample of a tube core; below 0: no data

    [[nodiscard]] const float* tube(std::size_t index) const {
        return echo.data() + index * static_cast<std::size_t>(samples);
    }
    [[nodiscard]] std::size_t tubes() const {
        return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    }
    [[nodiscard]] double depthMm(double sample) const { return firstDepthMm + sample * stepMm; }
};

/// Reads the tube cores of a view. The view's cuts and box are ignored.
[[nodiscard]] TubeEcho readTubeEcho(const SmoothEcho& coarse, const VolumeGeometry& geometry, const Viewpoint& view);

}  // namespace echolucent
