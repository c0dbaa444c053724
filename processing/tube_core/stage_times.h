// Where the time of a run went.
#pragma once

namespace echolucent {

/// Wall time of each stage, milliseconds. The stages are the same for every DetectionRule.
struct StageTimes {
    double sampling = 0.0;   ///< placing the tube cores and reading their voxels into moments of slabs
    double cells = 0.0;      ///< from the slabs to the interface indicating function
    double detection = 0.0;  ///< finding the surfaces, and reading I_L, I_H and slope around them
    double weights = 0.0;    ///< weighing the tube cores
    double curve = 0.0;      ///< from the weights to the curve
    double total = 0.0;      ///< all of the run

    /// Adds the times of a run before.
    StageTimes& operator+=(const StageTimes& before) {
        sampling += before.sampling;
        cells += before.cells;
        detection += before.detection;
        weights += before.weights;
        curve += before.curve;
        total += before.total;
        return *this;
    }
};

}  // namespace echolucent
