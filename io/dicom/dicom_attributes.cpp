#include "io/dicom/dicom_attributes.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "io/headers/header_text.h"

namespace echolucent {

namespace {

constexpr unsigned long mostValues = 1000000;

DcmElement* elementOf(DcmItem& item, DicomTag tag) {
    DcmElement* element = nullptr;
    if (item.findAndGetElement(DcmTagKey(tag.group, tag.element), element).bad()) return nullptr;
    return element;
}

/// Text without the padding that programs put behind it, zero bytes among it.
std::string unpadded(const OFString& text) {
    const std::string_view whole(text.c_str(), text.length());
    return trimmed(whole.substr(0, whole.find('\0')));
}

DcmSequenceOfItems* sequenceOf(DcmItem& item, DicomTag tag) {
    DcmElement* element = elementOf(item, tag);
    return element != nullptr && element->ident() == EVR_SQ ? static_cast<DcmSequenceOfItems*>(element) : nullptr;
}

}  // namespace

std::string tagText(DicomTag tag) { return fmt::format("({:04x},{:04x})", tag.group, tag.element); }

std::string dicomText(DcmItem& item, DicomTag tag) {
    OFString text;
    if (item.findAndGetOFStringArray(DcmTagKey(tag.group, tag.element), text).bad()) return {};
    return unpadded(text);
}

std::vector<double> dicomNumbers(DcmItem& item, DicomTag tag) {
    DcmElement* element = elementOf(item, tag);
    if (element == nullptr) return {};
    const unsigned long count = element->getVM();
    if (count > mostValues) return {};
    std::vector<double> values;
    for (unsigned long index = 0; index < count; ++index) {
        OFString text;
        if (element->getOFString(text, index).bad()) return {};
        const auto value = realNumber(unpadded(text));
        if (!value || !std::isfinite(*value)) return {};
        values.push_back(*value);
    }
    return values;
}

std::optional<std::int64_t> dicomWholeNumber(DcmItem& item, DicomTag tag) {
    const auto values = dicomNumbers(item, tag);
    if (values.empty() || std::abs(values[0]) > 1e15 || values[0] != std::floor(values[0])) return std::nullopt;
    return static_cast<std::int64_t>(values[0]);
}

bool dicomHas(DcmItem& item, DicomTag tag) { return elementOf(item, tag) != nullptr; }

DcmItem* dicomSequenceItem(DcmItem& item, DicomTag sequence, std::size_t index) {
    DcmSequenceOfItems* items = sequenceOf(item, sequence);
    return items != nullptr && index < items->card() ? items->getItem(static_cast<unsigned long>(index)) : nullptr;
}

std::size_t dicomSequenceLength(DcmItem& item, DicomTag sequence) {
    DcmSequenceOfItems* items = sequenceOf(item, sequence);
    return items != nullptr ? items->card() : 0;
}

std::vector<std::uint16_t> dicomWords(DcmItem& item, DicomTag tag) {
    const Uint16* words = nullptr;
    unsigned long count = 0;
    if (item.findAndGetUint16Array(DcmTagKey(tag.group, tag.element), words, &count).bad() || words == nullptr)
        return {};
    return {words, words + count};
}

}  // namespace echolucent
