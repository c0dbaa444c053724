// A small simulated scan, its quiet voxels, and runs of the method on it.
#pragma once

#include "processing/adaptive/adaptive_otf.h"
#include "processing/adaptive/method_reading.h"
#include "processing/explanation/tube_explanation.h"
#include "processing/phantom/phantom.h"

namespace echolucent {

inline const Volume& explainedScan() {
    static const Volume volume = [] {
        PhantomConfig config = defaultPhantom(PhantomScene::shapes);
        config.size = {72, 68, 72};
        config.seed = 11;
        return *makePhantom(config);
    }();
    return volume;
}

inline const QuietVoxels& explainedQuiet() {
    static const Volume volume = *quietVolume(explainedScan(), SpeckleReduction::medium);
    static const QuietVoxels quiet{&volume, SpeckleReduction::medium};
    return quiet;
}

/// One run and the voxels that it was made for.
struct ExplainedRun {
    QuietVoxels shown;
    AdaptiveOtf otf;
    explicit ExplainedRun(AdaptiveOtfConfig config, const QuietVoxels& voxels = {}, const Viewpoint& view = {})
        : shown(voxels) {
        config.grid.columns = 9;
        config.grid.rows = 8;
        otf = *adaptOpacity(explainedScan(), view, config, {}, shown);
    }
    [[nodiscard]] TubeExplanation explained(int number) const {
        return *explainTube(explainedScan(), shown, otf, number);
    }
};

/// The paper's reading in the voxels read, the default in quiet voxels seen obliquely.
inline const ExplainedRun& publishedRun() {
    static const ExplainedRun run(configOf(MethodReading::asPublished));
    return run;
}
inline const ExplainedRun& defaultRun() {
    static const ExplainedRun run({}, explainedQuiet(), {.azimuthDegrees = 9, .rollDegrees = 4});
    return run;
}

}  // namespace echolucent
