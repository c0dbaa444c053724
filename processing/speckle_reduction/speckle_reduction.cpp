#include "processing/speckle_reduction/speckle_reduction.h"

#include <stdexcept>

#include "processing/speckle_reduction/gaussian_filter.h"

namespace echolucent {

std::optional<Volume> quietVolume(const Volume& volume, SpeckleReduction reduction, const Progress& progress) {
    switch (reduction) {
        case SpeckleReduction::off:
            if (progress.cancelled()) return std::nullopt;
            progress.at(1.0);
            return volume;
        case SpeckleReduction::light: return gaussianFiltered(volume, 0.7, progress);
        case SpeckleReduction::medium: return gaussianFiltered(volume, 1.0, progress);
        case SpeckleReduction::strong: return gaussianFiltered(volume, 1.6, progress);
    }
    throw std::invalid_argument("quietVolume: no such reduction");
}

}  // namespace echolucent
