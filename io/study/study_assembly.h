// The last step of every reader: voxels and geometry in, a study with its import report out.
#pragma once

#include <cstdint>
#include <string>

#include "io/study/study.h"
#include "io/study/study_facts.h"
#include "io/study/study_parts.h"

namespace echolucent {

/// The most phases that a reader takes. No scanner writes more.
constexpr std::int64_t mostPhases = 4096;
/// Fails (unreadable) if there are more than mostPhases. The sentence names `file` and the key, tag or option `element`
/// of the number. Call it before taking memory for the phases.
[[nodiscard]] Result<void> requirePhases(const std::string& file, const std::string& element, std::int64_t phases);

/// Builds the volumes (one white level for all phases), guesses where there is no data, and completes the report.
/// Values of the reader's facts are cut to 300 bytes. Fails (unreadable) if spacing, origin or white level is one that
/// no scanner makes, such as NaN, if there are too many phases, or if the volume is longer than 100,000 times its
/// smallest spacing; (cancelled) if the person ended it. Throws std::invalid_argument for a left-handed
/// grid.
[[nodiscard]] Result<Study> assembleStudy(StudyParts parts, const ReadOptions& options, const Progress& progress);

/// The name of the file or folder at `path`, without the folders above it.
[[nodiscard]] std::string nameFromPath(const std::string& path);

/// Whether a position in the patient is plausible: its coordinates (mm) are finite and at most 10 km from 0, where
/// doubles still tell nanometres apart.
[[nodiscard]] bool isPosition(const Vec3& position);

/// Whether a spacing (mm) is plausible for a scanner. False for NaN, for a slip of units, and for voxels a thousand
/// times as long as wide. Tube cores and rays in such voxels would have millions of samples.
[[nodiscard]] bool isSensibleSpacing(const Vec3& spacing);
/// Whether float32, in which voxels are shown, can hold a white level: above 0 and finite there.
[[nodiscard]] bool isSensibleWhite(double level);

/// Makes the columns of `direction` unit vectors. False if one has no length or if the three do not span space.
[[nodiscard]] bool normalizeDirection(Mat3& direction);
/// Whether directions (LPS) of MetaImage and NRRD say anything of the patient. Programs that know no directions write
/// the axes of LPS or of RAS.
[[nodiscard]] bool saysMoreThanItsAxes(const Mat3& direction);
/// A note on `count` of all `parts` of a study, which are `partsInWords` ("slices"): the sentence, and how many it is
/// said of if these are not all.
[[nodiscard]] std::string saidOf(const std::string& sentence, std::size_t count, std::size_t parts,
                                 const char* partsInWords);
/// A sentence if the columns of `direction` (unit vectors) are not perpendicular to each other; else empty.
[[nodiscard]] std::string skewWarning(const Mat3& direction);

}  // namespace echolucent
