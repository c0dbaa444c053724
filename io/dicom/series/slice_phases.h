// Slices that lie at the same places again and again: the phases of a volume.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/dicom/series/series_traits.h"
#include "io/study/series_list.h"
#include "processing/result.h"

namespace echolucent {

/// Slices in phases.
struct SlicePhases {
    std::vector<std::vector<std::size_t>> slices;  ///< of each phase: indices of the images along the normal
    SeriesPhases phases;
    std::vector<std::string> notes;
};

/// Splits images into phases if several lie at one place: by the first of momentAttributes in which those at one place
/// differ, at every place. If none does, by Instance Number, provided that every place has as many images, all of one
/// kind. A phase that lacks slices is left out, and a note names it. Fails (unreadable, about `folder`) if more
/// than half of the phases lack slices. No value if no two images share a place, if all do, or if nothing tells them
/// apart. All images have planes.
[[nodiscard]] Result<std::optional<SlicePhases>> slicePhasesOf(const std::string& folder, const Images& images);

}  // namespace echolucent
