// Tells one study's bytes from another's by a checksum, and finds a study that is no longer in its place.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "processing/document/study_reference.h"
#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// The checksum of all bytes of some files.
struct StudyChecksum {
    std::string text;  ///< "xxh3-128:" and 32 hexadecimal digits
    std::int64_t bytes = 0;
    std::int64_t files = 0;
    friend bool operator==(const StudyChecksum&, const StudyChecksum&) = default;
};

/// The checksum of files. Of one file it is XXH3-128 of its bytes. Of several it is XXH3-128 of their checksums in
/// rising order, so that names and order of files play no part. Fails (unreadable) if one of them cannot be read,
/// (cancelled) if the person ended it. `progress` is polled every few MB.
[[nodiscard]] Result<StudyChecksum> checksumOf(const std::vector<std::string>& files, const Progress& progress = {});

[[nodiscard]] StudyFile withChecksum(StudyFile study, const StudyChecksum& checksum);

/// The difference between the saved and the present bytes of a study, lower case, no full stop ("has 12 bytes, and had
/// 10 when the session was saved"). Empty if nothing differs, if no checksum was saved, or if the saved one is of
/// another kind and neither the number of bytes nor of files differs.
[[nodiscard]] std::string changeOf(const StudyFile& study, const StudyChecksum& now);

/// Where to look for a study that is no longer in its place.
struct StudySearch {
    std::vector<std::string> folders;  ///< searched with their subfolders, four deep
    std::vector<std::string> paths;    ///< files and folders that may be the study
};

/// Finds the file or folder with the bytes of a study whose checksum is known. It reads only files of the same number
/// of bytes, and looks at no more than 20,000 entries in and below each folder of `search`. A study of several files
/// may be a folder. If StudySearch::folders lead to it, the innermost folder that holds all its files is given. A study
/// of several files may also be a header with its voxels, no folder. It is then found by a file with the header's name.
/// If such a study has two files, the second may be any file beside that header. If it has more, the others are all
/// files beside the header whose names begin with the header's stem. No value if the study is not found, if its
/// checksum is unknown, or if the person ended it.
[[nodiscard]] std::optional<std::string> findStudy(const StudyFile& study, const StudySearch& search,
                                                   const Progress& progress = {});

}  // namespace echolucent
