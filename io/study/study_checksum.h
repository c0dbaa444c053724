// What tells one study's bytes from another's: their checksum, and where a study went that is no longer in its place.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "processing/document/study_reference.h"
#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// Of all bytes of some files.
struct StudyChecksum {
    std::string text;  ///< "xxh3-128:" and 32 hexadecimal digits
    std::int64_t bytes = 0;
    std::int64_t files = 0;
    friend bool operator==(const StudyChecksum&, const StudyChecksum&) = default;
};

/// The checksum of files: of one file XXH3-128 of its bytes, of several XXH3-128 of theirs in rising order, so that
/// neither their names nor their order play a part. Fails (unreadable) where one of them cannot be read, (cancelled)
/// where the person ended it; `progress` is asked every few MB.
[[nodiscard]] Result<StudyChecksum> checksumOf(const std::vector<std::string>& files, const Progress& progress = {});

/// The study with what is known of its bytes.
[[nodiscard]] StudyFile withChecksum(StudyFile study, const StudyChecksum& checksum);

/// What differs between the bytes that a study had when its checksum was taken and those that were read now, lower
/// case, no full stop ("has 12 bytes, and had 10 when the session was saved"); an empty text where nothing differs, or
/// where its checksum is not known.
[[nodiscard]] std::string changeOf(const StudyFile& study, const StudyChecksum& now);

/// Where to look for a study that is no longer in its place.
struct StudySearch {
    std::vector<std::string> folders;  ///< looked through with the folders in them, four deep
    std::vector<std::string> paths;    ///< files and folders that may be the study themselves
};

/// A file or folder with the bytes of a study whose checksum is known. Only what has its number of bytes is read, and
/// of one folder at most 20,000 entries are looked at. A study of several files that is no folder (a header with its
/// voxels) is found where a file of its header's name is: with one other file of that folder or, where it was read from
/// more than two, with all those that begin with the header's stem. No value where it is not found, where its checksum
/// is not known, or where the person ended it.
[[nodiscard]] std::optional<std::string> findStudy(const StudyFile& study, const StudySearch& search,
                                                   const Progress& progress = {});

}  // namespace echolucent
