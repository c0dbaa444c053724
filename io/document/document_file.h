// Documents as JSON.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "processing/document/document.h"
#include "processing/result.h"

namespace echolucent {

/// The "format" of a document file.
inline constexpr std::string_view documentFormatName = "echolucent-document";
/// The "version" of the files that are written; version 1 is read too.
inline constexpr int documentVersion = 2;
/// Larger files, in bytes, are neither read nor written.
inline constexpr std::size_t largestDocumentFile = std::size_t{32} << 20;
/// The most measurements of a document in a file, and the most strokes in each of its lists of strokes.
inline constexpr std::size_t mostMeasurements = 1000;
inline constexpr std::size_t mostStrokes = 100'000;

/// {"format": "echolucent-document", "version": 2, ...}, with every value of the document, and numbers with all their
/// digits. Equal documents give equal bytes. Throws nlohmann::json::exception if the path of the study, or another
/// text, is not UTF-8.
[[nodiscard]] std::string jsonOf(const Document& document);

/// The document that jsonOf() wrote as a text. Missing parameters of the method and the look have their defaults;
/// unknown keys are ignored. Another format or version, a missing key or a value out of range is refused with a
/// sentence that names the key and `file`. Of a version 1 text, only what the window showed is read: view 1 (the first
/// view if there is no view 1), and the views compared with it.
[[nodiscard]] Result<Document> documentFromJson(std::string_view text, const std::string& file = {});

[[nodiscard]] Result<Document> readDocument(const std::string& path);

struct DocumentPane {
    Document document;
    std::size_t pane = firstPane;
};
/// The pane with a number from 1 on; without a number, the first pane. Of version 1 the number is the id of a view, and
/// the first view of the list comes without a number. Views compared with that view become panes of the same document.
/// Fails as documentFromJson(), and (wrong usage) if there is no such number.
[[nodiscard]] Result<DocumentPane> documentPaneFromJson(std::string_view text, std::optional<int> number,
                                                        const std::string& file = {});
[[nodiscard]] Result<DocumentPane> readDocumentPane(const std::string& path, std::optional<int> number);
/// Fails (unwritable) if the file cannot be written, if it could not be read again, or if a text in it is not UTF-8.
[[nodiscard]] Result<void> writeDocument(const std::string& path, const Document& document);

}  // namespace echolucent
