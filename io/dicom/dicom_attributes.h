// Attributes of DICOM data sets as plain values. DCMTK's item type is only named here, never seen.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

class DcmItem;

namespace echolucent {

struct DicomTag {
    std::uint16_t group = 0;
    std::uint16_t element = 0;
};

/// "(0018,0088)".
[[nodiscard]] std::string tagText(DicomTag tag);

/// The attribute's text with its values as stored, trimmed; empty where it is missing or empty.
[[nodiscard]] std::string dicomText(DcmItem& item, DicomTag tag);
/// All values as numbers; empty where the attribute is missing or one of them is no finite number.
[[nodiscard]] std::vector<double> dicomNumbers(DcmItem& item, DicomTag tag);
/// The first value as a whole number.
[[nodiscard]] std::optional<std::int64_t> dicomWholeNumber(DcmItem& item, DicomTag tag);
[[nodiscard]] bool dicomHas(DcmItem& item, DicomTag tag);

/// An item of a sequence; null where there is none.
[[nodiscard]] DcmItem* dicomSequenceItem(DcmItem& item, DicomTag sequence, std::size_t index = 0);
[[nodiscard]] std::size_t dicomSequenceLength(DcmItem& item, DicomTag sequence);

/// Unsigned 16-bit words of a binary attribute (palettes); empty where it is missing.
[[nodiscard]] std::vector<std::uint16_t> dicomWords(DcmItem& item, DicomTag tag);

}  // namespace echolucent
