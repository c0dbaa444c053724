// Documents as JSON.
#pragma once

#include <string>
#include <string_view>

#include "processing/document/document.h"
#include "processing/result.h"

namespace echolucent {

/// The "format" of such a file.
inline constexpr std::string_view documentFormatName = "echolucent-document";
/// Larger files are refused, and not written, bytes.
inline constexpr std::size_t largestDocumentFile = std::size_t{32} << 20;
/// So many measurements, and strokes in each value of a list, a document in a file has at most.
inline constexpr std::size_t mostMeasurements = 1000;
inline constexpr std::size_t mostStrokes = 100'000;

/// {"format": "echolucent-document", "version": 1, ...}: every value of the document, numbers with all their digits.
/// Equal documents give equal bytes.
[[nodiscard]] std::string jsonOf(const Document& document);

/// The document of a text that jsonOf() wrote: an equal one. Parameters of the method and of the look that the text
/// does not hold have their defaults; unknown keys are ignored. Another format or version, a missing key and a value
/// out of range are refused with a sentence that names the key. file: named in that sentence.
[[nodiscard]] Result<Document> documentFromJson(std::string_view text, const std::string& file = {});

[[nodiscard]] Result<Document> readDocument(const std::string& path);
/// Fails (unwritable) where the file cannot be written, or could not be read again.
[[nodiscard]] Result<void> writeDocument(const std::string& path, const Document& document);

}  // namespace echolucent
