// Attributes of DICOM data sets as plain values. This header names DCMTK's item type, but does not include it.
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

// Each of these functions takes time in proportion to the attribute's length, however many values it holds. DCMTK's own
// access by index is quadratic. A value may be stored as bytes (UN, OB, OW, ...) although the dictionary calls it text
// or numbers. All but dicomWords() and dicomLongWords() then read it as the dictionary says, or as missing if it is
// longer than 1 MiB. A text, a number or a pointer longer than 4 MiB counts as missing.

/// The number that a text holds; no value if it holds none. A comma stands for the point if it is the only one and no
/// point stands beside it: DICOM's decimal strings know no comma, but some programs write them as their language does.
[[nodiscard]] std::optional<double> decimalNumber(std::string text);

/// Number of Frames (0028,0008); 1 if it is missing or below 1. At most 2^31: DICOM's texts hold no larger integers.
[[nodiscard]] std::int64_t dicomFrameCount(DcmItem& item);

/// The attribute's text: its values as stored up to the first zero byte, each trimmed, with backslashes between them.
/// Values stored in binary are written as numbers. Empty if the attribute is missing or empty.
[[nodiscard]] std::string dicomText(DcmItem& item, DicomTag tag);
/// The attribute's values as numbers; empty unless it holds exactly `count` values and all are finite. Decimal strings
/// are read by decimalNumber().
[[nodiscard]] std::vector<double> dicomNumbers(DcmItem& item, DicomTag tag, std::size_t count);
/// The only value of the attribute if it is a finite number; else no value.
[[nodiscard]] std::optional<double> dicomNumber(DcmItem& item, DicomTag tag);
/// The only value of the attribute if it is a whole number from -10^15 to 10^15. Else no value, also if the attribute
/// holds several values.
[[nodiscard]] std::optional<std::int64_t> dicomWholeNumber(DcmItem& item, DicomTag tag);
/// Whether the attribute is there, empty or not.
[[nodiscard]] bool dicomHas(DcmItem& item, DicomTag tag);

/// The first item of a sequence; null if the sequence is missing or empty.
[[nodiscard]] DcmItem* dicomFirstItem(DcmItem& item, DicomTag sequence);
/// Calls `visit` with each item of a sequence in order, until `visit` returns false.
void dicomVisitItems(DcmItem& item, DicomTag sequence, const std::function<bool(DcmItem&)>& visit);
/// The number of items in a sequence; 0 if it is missing.
[[nodiscard]] std::size_t dicomSequenceLength(DcmItem& item, DicomTag sequence);

/// Unsigned 16-bit words of a binary attribute (palettes), which may be stored as bytes, the lower one first; empty if
/// the attribute is missing or of another type.
[[nodiscard]] std::vector<std::uint16_t> dicomWords(DcmItem& item, DicomTag tag);

/// Unsigned 32-bit words of a binary attribute (indices); empty if the attribute is missing or of another type.
[[nodiscard]] std::vector<std::uint32_t> dicomLongWords(DcmItem& item, DicomTag tag);
/// The first tag that a pointer names; no value if the attribute is missing or no pointer.
[[nodiscard]] std::optional<DicomTag> dicomPointer(DcmItem& item, DicomTag tag);

}  // namespace echolucent
