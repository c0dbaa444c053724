// Attributes of DICOM data sets as plain values. DCMTK's item type is only named here, never seen.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

class DcmItem;

namespace echolucent {

struct DicomTag {
    std::uint16_t group = 0;
    std::uint16_t element = 0;
    friend bool operator==(const DicomTag&, const DicomTag&) = default;
};

/// The tag as DICOM writes it: "(0018,0088)".
[[nodiscard]] std::string tagText(DicomTag tag);

// Each of these functions takes time in proportion to the attribute's length, however many values it holds: DCMTK's own
// access by index is quadratic. What is stored with a value representation of bytes (UN, OB, OW, ...) although the
// dictionary says that it is text or numbers is read as these.

/// The attribute's text: its values as stored, each trimmed, with backslashes between them. The text is empty where the
/// attribute is missing or empty.
[[nodiscard]] std::string dicomText(DcmItem& item, DicomTag tag);
/// The attribute's values as numbers, where it holds exactly `count` of them and every one is finite; else empty.
[[nodiscard]] std::vector<double> dicomNumbers(DcmItem& item, DicomTag tag, std::size_t count);
/// The only value of the attribute, where it is a whole number of at most 10^15; no value where it is anything else, or
/// where there are several.
[[nodiscard]] std::optional<std::int64_t> dicomWholeNumber(DcmItem& item, DicomTag tag);
/// Whether the attribute is there, empty or not.
[[nodiscard]] bool dicomHas(DcmItem& item, DicomTag tag);

/// The first item of a sequence; null where the sequence is missing or has no item.
[[nodiscard]] DcmItem* dicomFirstItem(DcmItem& item, DicomTag sequence);
/// Hands the items of a sequence to `visit` in their order, until `visit` returns false.
void dicomVisitItems(DcmItem& item, DicomTag sequence, const std::function<bool(DcmItem&)>& visit);
/// How many items a sequence holds; 0 where it is missing.
[[nodiscard]] std::size_t dicomSequenceLength(DcmItem& item, DicomTag sequence);

/// Unsigned 16-bit words of a binary attribute (palettes); empty where the attribute is missing.
[[nodiscard]] std::vector<std::uint16_t> dicomWords(DcmItem& item, DicomTag tag);

/// Unsigned 32-bit words of a binary attribute (indices); empty where the attribute is missing or of another type.
[[nodiscard]] std::vector<std::uint32_t> dicomLongWords(DcmItem& item, DicomTag tag);
/// The first tag that a pointer names; no value where the attribute is missing or no pointer.
[[nodiscard]] std::optional<DicomTag> dicomPointer(DcmItem& item, DicomTag tag);

}  // namespace echolucent
