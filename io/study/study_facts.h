// The lines of the import report that every format has, and the notes that go with them.
#pragma once

#include <string>

#include "io/study/study_assembly.h"

namespace echolucent {

/// Adds to a study with its phases: size, reduction, spacing, type, values, phases and their times, no data, beam, loss
/// and burnt-in text, each with its source in `parts`; and the notes on uneven times, reduction, conversion and unknown
/// spacing. `whiteSource` is the source of the white level.
void addAssembledFacts(const StudyParts& parts, const ReadOptions& options, const std::string& whiteSource,
                       Study& study);

}  // namespace echolucent
