#include "io/dicom/dicom_attributes.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "io/headers/header_text.h"

namespace echolucent {

namespace {

DcmElement* elementOf(DcmItem& item, DicomTag tag) {
    DcmElement* element = nullptr;
    if (item.findAndGetElement(DcmTagKey(tag.group, tag.element), element).bad()) return nullptr;
    return element;
}

DcmSequenceOfItems* sequenceOf(DcmItem& item, DicomTag tag) {
    DcmElement* element = elementOf(item, tag);
    return element != nullptr && element->ident() == EVR_SQ ? static_cast<DcmSequenceOfItems*>(element) : nullptr;
}

/// The text of an attribute as stored, where it is stored as text. It lives as long as the element is left alone.
std::optional<std::string_view> storedText(DcmElement& element) {
    char* text = nullptr;
    Uint32 length = 0;
    if (element.getString(text, length).bad()) return std::nullopt;
    if (text == nullptr) return std::string_view();
    const std::string_view whole(text, length);
    return whole.substr(0, whole.find('\0'));  // some programs pad with zero bytes
}

/// Cuts one value off the front of `rest`, trimmed; `rest` loses its data pointer with the last one.
std::string nextValue(std::string_view& rest) {
    const auto end = rest.find('\\');
    std::string value = trimmed(rest.substr(0, end));
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    return value;
}

/// Value `index` of an attribute that is stored in binary, or whose text was put together by DCMTK.
std::optional<double> binaryNumber(DcmElement& element, std::size_t index) {
    OFString text;
    if (element.getOFString(text, static_cast<unsigned long>(index)).bad()) return std::nullopt;
    return realNumber(trimmed({text.c_str(), text.length()}));
}

bool isFinite(const std::optional<double>& value) { return value && std::isfinite(*value); }

}  // namespace

std::string tagText(DicomTag tag) { return fmt::format("({:04x},{:04x})", tag.group, tag.element); }

std::string dicomText(DcmItem& item, DicomTag tag) {
    DcmElement* element = elementOf(item, tag);
    if (element == nullptr) return {};
    if (auto stored = storedText(*element)) {
        std::string text;
        text.reserve(stored->size());
        while (stored->data() != nullptr) {
            text += nextValue(*stored);
            if (stored->data() != nullptr) text += '\\';
        }
        return trimmed(text);
    }
    OFString text;
    if (element->getOFStringArray(text).bad()) return {};
    return trimmed({text.c_str(), text.length()});
}

std::vector<double> dicomNumbers(DcmItem& item, DicomTag tag, std::size_t count) {
    DcmElement* element = elementOf(item, tag);
    if (element == nullptr || count == 0) return {};
    std::vector<double> values;
    if (auto stored = storedText(*element)) {
        const auto held = static_cast<std::size_t>(std::count(stored->begin(), stored->end(), '\\')) + 1;
        if (stored->empty() || held != count) return {};
        values.reserve(count);
        while (stored->data() != nullptr) {
            const auto value = realNumber(nextValue(*stored));
            if (!isFinite(value)) return {};
            values.push_back(*value);
        }
        return values;
    }
    if (element->getVM() != count) return {};
    values.reserve(count);
    for (std::size_t index = 0; index < count; ++index) {
        const auto value = binaryNumber(*element, index);
        if (!isFinite(value)) return {};
        values.push_back(*value);
    }
    return values;
}

std::optional<std::int64_t> dicomWholeNumber(DcmItem& item, DicomTag tag) {
    DcmElement* element = elementOf(item, tag);
    if (element == nullptr) return std::nullopt;
    auto stored = storedText(*element);
    const auto value = stored ? realNumber(nextValue(*stored)) : binaryNumber(*element, 0);
    if (!isFinite(value) || std::abs(*value) > 1e15 || *value != std::floor(*value)) return std::nullopt;
    return static_cast<std::int64_t>(*value);
}

bool dicomHas(DcmItem& item, DicomTag tag) { return elementOf(item, tag) != nullptr; }

DcmItem* dicomFirstItem(DcmItem& item, DicomTag sequence) {
    DcmSequenceOfItems* items = sequenceOf(item, sequence);
    return items != nullptr && items->card() > 0 ? items->getItem(0) : nullptr;
}

void dicomVisitItems(DcmItem& item, DicomTag sequence, const std::function<bool(DcmItem&)>& visit) {
    DcmSequenceOfItems* items = sequenceOf(item, sequence);
    if (items == nullptr) return;
    // getItem(index) would count from the first item each time.
    for (DcmObject* one = items->nextInContainer(nullptr); one != nullptr; one = items->nextInContainer(one))
        if (!visit(static_cast<DcmItem&>(*one))) return;
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

std::vector<std::uint32_t> dicomLongWords(DcmItem& item, DicomTag tag) {
    const Uint32* words = nullptr;
    unsigned long count = 0;
    if (item.findAndGetUint32Array(DcmTagKey(tag.group, tag.element), words, &count).bad() || words == nullptr)
        return {};
    return {words, words + count};
}

std::optional<DicomTag> dicomPointer(DcmItem& item, DicomTag tag) {
    DcmElement* element = elementOf(item, tag);
    DcmTagKey named;
    if (element == nullptr || element->ident() != EVR_AT || element->getTagVal(named, 0).bad()) return std::nullopt;
    return DicomTag{named.getGroup(), named.getElement()};
}

}  // namespace echolucent
