// The keys of a MetaImage header as text.
#pragma once

#include <cstddef>
#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "io/files/input_file.h"
#include "io/files/input_problems.h"
#include "processing/result.h"

namespace echolucent {

/// The "Key = Value" lines of a header. Keys that decide how voxels are read stand here as MetaImage spells them,
/// whatever their case in the file.
struct MetaImageKeys {
    std::string path;  ///< of the file, for messages
    std::map<std::string, std::string> values;
    std::vector<std::string> listed;  ///< the lines after "ElementDataFile = LIST", which end the header
    std::set<std::string> repeated;   ///< keys that stand twice, with the same value
    std::size_t headerBytes = 0;      ///< length of the header, including the line of ElementDataFile

    /// The value of a key; null if the header does not hold it.
    [[nodiscard]] const std::string* find(const std::string& key) const;
    /// The first of `keys`, which mean the same thing, that the header holds; empty if it holds none.
    [[nodiscard]] std::string firstOf(std::initializer_list<const char*> keys) const;
    /// As firstOf(), but fails (unreadable) if another of `keys` in the header disagrees with it.
    [[nodiscard]] Result<std::string> onlyOf(std::initializer_list<const char*> keys) const;
    /// The numbers of a key that the header holds. Decimal commas are read, and a note is added. Fails (unreadable) if
    /// a word is no number, or if there are fewer than `least` or more than `most`.
    [[nodiscard]] Result<std::vector<double>> numbers(const std::string& key, std::size_t least, std::size_t most,
                                                      std::vector<std::string>& notes) const;
    /// "True" or "False", also "T", "1" or "yes" and so on, in any case; false if the key is missing. Fails
    /// (unreadable) for other values.
    [[nodiscard]] Result<bool> flag(const std::string& key) const;
    /// A failure (unreadable) about one key.
    [[nodiscard]] tl::unexpected<Failure> wrong(const std::string& key, const std::string& problem,
                                                const std::string& remedy = correctHeader) const;
};

/// Whether the value of ElementDataFile announces a list of files.
[[nodiscard]] bool isMetaImageList(const std::string& dataFile);

/// Reads the lines up to ElementDataFile, and the list after it. Fails (unreadable) if a line is no "Key = Value", or
/// if the file is seen to end within a line. It also fails if ElementDataFile is missing from the first MiB, if the
/// list is longer than that, or if a key that decides how voxels are read appears twice
/// with different values.
[[nodiscard]] Result<MetaImageKeys> readMetaImageKeys(const InputFile& file);

}  // namespace echolucent
