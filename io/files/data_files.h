// The data files that a header names: one, a list, or a pattern with numbers; all in or below the header's own folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/files/input_file.h"
#include "processing/result.h"

namespace echolucent {

/// No volume lies in more data files than this.
constexpr std::size_t mostDataFiles = 10000;

/// One of the files that hold a volume's voxels.
struct DataFile {
    std::string path;
    std::optional<InputFile> opened{};  ///< where it is open already, such as the header's own file; else it is opened
                                        ///< when it is read, since there may be thousands

    /// The file, opened. Fails (unreadable) where it cannot be opened.
    [[nodiscard]] Result<InputFile> open() const;
};

/// The numbers of a pattern such as "slice%03d.raw": `first`, `first` + `step`, and so on as far as `last`.
struct FileNumbers {
    std::int64_t first = 1;
    std::int64_t last = 1;
    std::int64_t step = 1;
};

/// Where a header names its data files, for sentences about it.
struct DataFileKey {
    std::string headerPath;
    std::string key;  ///< "ElementDataFile", "data file"
};

/// Fails (unreadable) where the file at `path`, which was found beside another one, is a link out of its own folder.
[[nodiscard]] Result<void> requireInItsFolder(const std::string& path);
/// The data file `name`. Fails (unreadable) where it is no name in or below the header's folder (absolute paths, "..",
/// and links that lead out of it are none), or is the header itself.
[[nodiscard]] Result<DataFile> dataFileBeside(const DataFileKey& key, const std::string& name);
/// The data files of these names, in their order. Fails as dataFileBeside(), and where there are none or more than
/// mostDataFiles.
[[nodiscard]] Result<std::vector<DataFile>> dataFilesBeside(const DataFileKey& key,
                                                            const std::vector<std::string>& names);
/// The names that a pattern stands for. It holds one number as "%d" or, filled up with zeros or spaces, "%03d" or
/// "%3d". Fails (unreadable) where it holds anything else after a per cent sign, where the numbers never end, and where
/// they make more than mostDataFiles names.
[[nodiscard]] Result<std::vector<std::string>> namesOfPattern(const DataFileKey& key, const std::string& pattern,
                                                              const FileNumbers& numbers);

}  // namespace echolucent
