// Paths into a document (docs/document.md#paths): one grammar for lessons, scripts and --set.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "processing/document/document.h"
#include "processing/document/document_value.h"
#include "processing/result.h"

namespace echolucent {

/// Longer paths, in bytes, name nothing.
inline constexpr std::size_t longestDocumentPath = 200;
/// Longer texts of a value or a part, in bytes, are refused.
inline constexpr std::size_t longestDocumentPart = std::size_t{1} << 20;

// A path is the keys of the document's JSON with points between them; an entry of a list has its number, counted from
// 0, in brackets: `scene.front.depth_mm`, `panes[1].designer.designer`, `scene.pose.offset_mm[2]`. Keys that a file
// holds only if they are needed are always there: `scene.exposure` is 1 then, and `panes[0].designer` is null. `format`
// and `version` are no part of a document.

/// The value at a path; of a list or an object the number of its entries. Fails (wrong usage) if the path names
/// nothing: the message names the path.
[[nodiscard]] Result<DocumentValue> valueAt(const Document& document, std::string_view path);
/// The values at several paths; none for a path that names nothing. Quicker than valueAt() for each.
[[nodiscard]] std::vector<std::optional<DocumentValue>> valuesAt(const Document& document,
                                                                 const std::vector<std::string>& paths);
/// The value at a path as JSON in one line. Fails as valueAt().
[[nodiscard]] Result<std::string> textAt(const Document& document, std::string_view path);

/// The document with another value at a path. `value` is JSON; a text that is no JSON, such as `adaptive`, stands for
/// itself. The rules are those of documentFromJson(): a wrong value is refused with its sentence, which names the path.
/// Parameters that lose their meaning by a choice are dropped, and those that get one have their defaults. Fails (wrong
/// usage) too if the path names nothing, or if the document would not hold the value.
[[nodiscard]] Result<Document> withValueAt(const Document& document, std::string_view path, std::string_view value);

/// The document with a part of it as a JSON object: its values take the place of the document's, and what it does not
/// name stays. A list replaces the whole list. Fails as withValueAt(), and if `part` is no JSON object. The message
/// names `file` and the key, behind `place` ("steps[2].set").
[[nodiscard]] Result<Document> withPart(const Document& document, std::string_view part, const std::string& file = {},
                                        const std::string& place = {});
/// The smallest part with which withPart() makes `to` of `from`, as JSON in one line; "{}" if they are equal.
[[nodiscard]] std::string partBetween(const Document& from, const Document& to);

/// The paths of all values of a document, in the order of its JSON. Of a list of numbers only the list is named.
[[nodiscard]] std::vector<std::string> pathsOf(const Document& document);

}  // namespace echolucent
