// Finds the data files that a header names: one, a list, or a pattern with numbers. All lie in or below the header's
// own folder.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "io/files/input_file.h"
#include "processing/result.h"

namespace echolucent {

/// The most data files of one volume.
constexpr std::size_t mostDataFiles = 10000;

/// One of the files that hold a volume's voxels.
struct DataFile {
    std::string path;
    std::optional<InputFile> opened{};  ///< set if it is open already, such as the header's own file; else open() opens
                                        ///< it only when it is read, because there may be thousands

    /// Fails (unreadable) if it cannot be opened.
    [[nodiscard]] Result<InputFile> open() const;
};

/// The numbers of a pattern such as "slice%03d.raw": `first`, `first` + `step`, and so on up to `last`.
struct FileNumbers {
    std::int64_t first = 1;
    std::int64_t last = 1;
    std::int64_t step = 1;
};

/// The header and its key that name data files, for messages.
struct DataFileKey {
    std::string headerPath;
    std::string key;  ///< "ElementDataFile", "data file"
};

/// Fails (unreadable) if `path`, which was found beside another file, is a link out of its folder.
[[nodiscard]] Result<void> requireInItsFolder(const std::string& path);
/// The data file `name`. Fails (unreadable) if it is the header itself, or if it does not lie in or below the header's
/// folder. Absolute paths, "..", links out of the folder, and names of over 1000 bytes are refused. Backslashes count
/// as slashes, unless a file has that very name.
[[nodiscard]] Result<DataFile> dataFileBeside(const DataFileKey& key, const std::string& name);
/// The data files of these names, in their order. Fails as dataFileBeside(), and if there are none or more than
/// mostDataFiles.
[[nodiscard]] Result<std::vector<DataFile>> dataFilesBeside(const DataFileKey& key,
                                                            const std::vector<std::string>& names);
/// The data file whose name is `name` word for word, per cent signs and blanks included; no value if there is none.
/// Fails as dataFileBeside() if such a file may not be read.
[[nodiscard]] Result<std::optional<DataFile>> dataFileOfThatName(const DataFileKey& key, const std::string& name);

/// A value such as "my slice %03d.raw 1 66 1": a name and the whole numbers behind it.
struct NamePattern {
    std::string name;
    std::vector<std::int64_t> numbers;
    bool isPattern = false;  ///< whether namesOfPattern() takes the name
};
/// The parts of `text`, with at most this many numbers.
[[nodiscard]] NamePattern namePatternIn(const std::string& text, std::size_t mostNumbers);
/// The sentence that a value which is also a pattern was taken as the name of a file.
[[nodiscard]] std::string literalNameNote(const std::string& name);
/// The failure of a value with a per cent sign that is neither the name of a file nor a pattern.
[[nodiscard]] tl::unexpected<Failure> neitherNameNorPattern(const DataFileKey& key, const std::string& text);

/// The names that a pattern stands for. It holds exactly one number: "%d", or "%03d" or "%3d", padded with zeros or
/// spaces; "i" and "u" stand for "d" too. "%%" is a per cent sign. Fails (unreadable) if anything else follows a per
/// cent sign, if there is no number or a second one, if the width is above 20, if a number is beyond 10^9, if the
/// numbers never end, or if they make more than mostDataFiles names.
[[nodiscard]] Result<std::vector<std::string>> namesOfPattern(const DataFileKey& key, const std::string& pattern,
                                                              const FileNumbers& numbers);

}  // namespace echolucent
