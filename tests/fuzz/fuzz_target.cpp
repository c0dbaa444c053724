#include "fuzz_target.h"

#include <algorithm>
#include <array>

namespace echolucent {

std::span<const FuzzTarget* const> fuzzTargets() {
    static constexpr std::array<const FuzzTarget*, 15> all{
        &metaImageTarget,   &nrrdTarget,  &niftiTarget,          &kretzTarget,       &gzipTarget,
        &rawLayoutTarget,   &dicomTarget, &dicomDirectoryTarget, &dicomPixelsTarget, &dicomFolderTarget,
        &dicomSeriesTarget, &curveTarget, &presetsTarget,        &documentTarget,    &sessionTarget};
    return all;
}

const FuzzTarget& fuzzTargetNamed(std::string_view name) {
    const auto all = fuzzTargets();
    const auto found = std::ranges::find(all, name, [](const FuzzTarget* target) { return target->name; });
    if (found == all.end()) throw std::invalid_argument("there is no fuzz target " + std::string(name));
    return **found;
}

}  // namespace echolucent
