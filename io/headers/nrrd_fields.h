// The fields of an NRRD header as text, and the grammars of their values.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "io/files/input_file.h"
#include "io/voxels/voxel_types.h"
#include "processing/result.h"
#include "processing/volume/geometry.h"

namespace echolucent {

/// "field: value" and "key:=value" lines of a header; field names in lower case, each by one of its names ("data file",
/// not "datafile").
struct NrrdFields {
    std::map<std::string, std::string> fields;
    std::map<std::string, std::string> keys;
    std::vector<std::string> dataFiles;  ///< the lines after "data file: LIST", which end the header
    std::size_t headerBytes = 0;         ///< length of the header, including the empty line that ends it
    std::set<std::string> repeated;      ///< fields that stand twice, with the same value
    bool ended = false;                  ///< whether the header has this empty line
};

/// Reads the header of an opened file. Fails (unreadable) if it is no NRRD file of a known version, if a line breaks
/// the grammar, if a field, WhiteLevel or BlackLevel appears twice with different values, or if a list of files goes
/// beyond the first MiB.
[[nodiscard]] Result<NrrdFields> readNrrdFields(const InputFile& file);

/// Whether the field "data file" announces a list of files.
[[nodiscard]] bool isNrrdList(const std::string& dataFile);

/// The type behind any of NRRD's names for it, such as "uchar", "unsigned char" and "uint8"; no value if `text` names
/// no scalar type.
[[nodiscard]] std::optional<StoredType> nrrdType(const std::string& text);

/// A vector of two to four numbers; no value if the file says "none".
using NrrdVector = std::optional<std::vector<double>>;
/// The vectors in `text`, one for each axis; no value if the text breaks NRRD's grammar.
[[nodiscard]] std::optional<std::vector<NrrdVector>> nrrdVectors(const std::string& text);

/// The words of a value, in double quotes or between white space: "mm" "mm" "mm" "s", or mm mm mm s.
[[nodiscard]] std::vector<std::string> nrrdWords(const std::string& text);
}  // namespace echolucent
