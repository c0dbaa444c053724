// The lines of the import report that every format has, and the notes that go with them.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "io/study/study_parts.h"

namespace echolucent {

/// Adds to a study with its phases: size, reduction, spacing, type, values, phases and their times, no data, beam, loss
/// and burnt-in text, each with its source in `parts`; and the notes on uneven times, reduction, conversion and unknown
/// spacing. `whiteSource` is the source of the white level.
void addAssembledFacts(const StudyParts& parts, const ReadOptions& options, const std::string& whiteSource,
                       Study& study);

/// The share of no data among the voxels of all phases, [0,1].
[[nodiscard]] double noDataShare(const std::vector<std::shared_ptr<const Volume>>& phases);

/// A size as text, such as "152 x 156 x 110".
[[nodiscard]] std::string sizeText(const std::array<std::int64_t, 3>& size);
/// A spacing as text, such as "0.3 x 0.3 x 0.5 mm".
[[nodiscard]] std::string spacingText(const Vec3& spacing);

}  // namespace echolucent
