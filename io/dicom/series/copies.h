// Copies of one DICOM picture among the files of a folder.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "io/dicom/series/series_traits.h"
#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// Paths of copies that were taken out.
struct LeftOutCopies {
    std::vector<std::string> same;    ///< they show the same as the ones that stay
    std::vector<std::string> broken;  ///< they cannot be decoded, unlike the ones that stay

    void add(const LeftOutCopies& more) {
        same.insert(same.end(), more.same.begin(), more.same.end());
        broken.insert(broken.end(), more.broken.begin(), more.broken.end());
    }
};

/// What dropCopies() found.
struct FoundCopies {
    LeftOutCopies dropped;
    std::optional<Failure>
        contradiction;          ///< two files of one identity that differ at one place; about the second of them
    std::string contradicting;  ///< their SOP Instance UID
    /// Whether all images, at least three different ones, have one identity, which then is none.
    bool identityIsShared = false;
    /// Else paths of single pictures that have one identity, but lie at several places or moments.
    std::vector<std::string> elsewhere;
};

/// Takes copies out of `images`: files of one SOP Instance UID (and, of a concatenation, of one part) that show the
/// same at the same place and time, and single pictures of other identities that agree in place, time, Instance Number
/// and content. The bytes of their data sets are compared, and if these differ, for example because one is compressed,
/// what they say of place and time and their decoded pixels. Of copies, the file with the shortest name stays, or the
/// one that can be decoded. Only files that share identity or place are read. Call it in a thread with a large stack.
/// If `progress` is cancelled, the result makes no sense.
[[nodiscard]] FoundCopies dropCopies(Images& images, const Progress& progress);

}  // namespace echolucent
