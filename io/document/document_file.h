// Documents as JSON.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "processing/document/document.h"
#include "processing/result.h"

namespace echolucent {

/// The "format" of such a file.
inline constexpr std::string_view documentFormatName = "echolucent-document";
/// The "version" that is written; version 1 is read too.
inline constexpr int documentVersion = 2;
/// Larger files are refused, and not written, bytes.
inline constexpr std::size_t largestDocumentFile = std::size_t{32} << 20;
/// So many measurements, and strokes in each value of a list, a document in a file has at most.
inline constexpr std::size_t mostMeasurements = 1000;
inline constexpr std::size_t mostStrokes = 100'000;

/// {"format": "echolucent-document", "version": 2, ...}: every value of the document, numbers with all their digits.
/// Equal documents give equal bytes.
[[nodiscard]] std::string jsonOf(const Document& document);

/// The document of a text that jsonOf() wrote: an equal one. Parameters of the method and of the look that the text
/// does not hold have their defaults; unknown keys are ignored. Another format or version, a missing key and a value
/// out of range are refused with a sentence that names the key. file: named in that sentence. A text of version 1 gives
/// what the window showed of it: its view 1, and what that is compared with.
[[nodiscard]] Result<Document> documentFromJson(std::string_view text, const std::string& file = {});

[[nodiscard]] Result<Document> readDocument(const std::string& path);

/// A pane of a document.
struct DocumentPane {
    Document document;
    std::size_t pane = firstPane;
};
/// The pane of a number from 1 on, the first one where none is given; of version 1 the view of that id, or else the
/// first one of its list. A view that is compared with others comes with these as its document's panes. A number that
/// is not there is refused (wrong usage).
[[nodiscard]] Result<DocumentPane> documentPaneFromJson(std::string_view text, std::optional<int> number,
                                                        const std::string& file = {});
[[nodiscard]] Result<DocumentPane> readDocumentPane(const std::string& path, std::optional<int> number);
/// Fails (unwritable) where the file cannot be written, or could not be read again.
[[nodiscard]] Result<void> writeDocument(const std::string& path, const Document& document);

}  // namespace echolucent
