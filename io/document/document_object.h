// A document as a JSON object, for what reads and writes files that hold documents.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "io/document/document_file.h"

namespace echolucent {

/// What jsonOf() writes. Throws as jsonOf().
[[nodiscard]] nlohmann::ordered_json documentJson(const Document& document);
/// As documentFromJson(). `place` is where the object stands in the file; it is empty for the root. An object without a
/// version has that of the file around it.
[[nodiscard]] Result<Document> documentOf(const nlohmann::json& object, const std::string& place,
                                          const std::string& file, int versionOfFile = documentVersion);

}  // namespace echolucent
