#include "app/study/voxels_now.h"

#include <utility>

namespace echolucent {

StudyPhases voxelsNow(const OpenStudy& openStudy) {
    const Study* study = openStudy.study();
    if (study == nullptr) return {};
    const QuietPhases& quiet = openStudy.quietPhases();
    const int phase = openStudy.phase();
    StudyPhases voxels{.scans = {study->phases[static_cast<std::size_t>(phase)]}};
    if (auto made = quiet.of(phase)) {
        voxels.quiet = {std::move(made)};
        voxels.reduction = quiet.reduction();
    }
    return voxels;
}

}  // namespace echolucent
