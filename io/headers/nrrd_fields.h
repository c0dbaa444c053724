// The fields of an NRRD header as text, and the small grammars in them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "io/voxel_types.h"
#include "processing/result.h"
#include "processing/volume/geometry.h"

namespace echolucent {

/// "field: value" and "key:=value" lines of a header; field names in lower case.
struct NrrdFields {
    std::map<std::string, std::string> fields;
    std::map<std::string, std::string> keys;
    std::size_t headerBytes = 0;  ///< up to and with the empty line that ends the header
    bool ended = false;           ///< whether that empty line was there
};

[[nodiscard]] Result<NrrdFields> readNrrdFields(const std::string& path);

/// The type behind any of NRRD's names for it ("uchar", "unsigned char", "uint8", ...); none where it is not scalar.
[[nodiscard]] std::optional<StoredType> nrrdType(const std::string& text);

/// "none" or a vector of two to four numbers, one for each axis; none where the text does not follow that grammar.
using NrrdVector = std::optional<std::vector<double>>;
[[nodiscard]] std::optional<std::vector<NrrdVector>> nrrdVectors(const std::string& text);

/// Words in double quotes, as in: units: "mm" "mm" "mm" "s".
[[nodiscard]] std::vector<std::string> nrrdQuotedWords(const std::string& text);

/// How many mm one unit of that name is; none where the name is not known. No name means mm.
[[nodiscard]] std::optional<double> mmOfUnit(const std::string& unit);
/// How many seconds one unit of that name is; none where the name is not known.
[[nodiscard]] std::optional<double> secondsOfUnit(const std::string& unit);

}  // namespace echolucent
