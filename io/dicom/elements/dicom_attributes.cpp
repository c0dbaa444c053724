#include "io/dicom/elements/dicom_attributes.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcistrmb.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "io/files/header_text.h"

namespace echolucent {

namespace {

/// A value of bytes up to this length is read anew as the dictionary says. A longer one stays as it is and counts as
/// missing: no attribute that is read here is so long.
constexpr Uint32 longestReadAnew = 1 << 20;

bool holdsBytes(DcmEVR vr) {
    constexpr std::array those{EVR_OB, EVR_OW, EVR_OF, EVR_OD, EVR_OL, EVR_OV, EVR_UN, EVR_UNKNOWN, EVR_UNKNOWN2B};
    return std::ranges::find(those, vr) != those.end();
}

bool isReadAsText(DcmEVR vr) { return DcmVR(vr).isaString(); }

bool isReadAsNumber(DcmEVR vr) {
    constexpr std::array those{EVR_US, EVR_SS, EVR_xs, EVR_UL, EVR_SL, EVR_FL, EVR_FD, EVR_AT, EVR_SV, EVR_UV};
    return std::ranges::find(those, vr) != those.end();
}

/// The bytes of an element as a little endian file holds them; empty if DCMTK gives them neither as bytes nor as words
/// of 16 bits.
std::string bytesOfElement(DcmElement& element) {
    Uint8* bytes = nullptr;
    Uint16* words = nullptr;
    const Uint32 length = element.getLength();
    if (element.ident() == EVR_OW) {
        if (element.getUint16Array(words).bad() || words == nullptr) return {};
        return {reinterpret_cast<const char*>(words), length};
    }
    if (element.getUint8Array(bytes).bad() || bytes == nullptr) return {};
    return {reinterpret_cast<const char*>(bytes), length};
}

/// Whether the dictionary calls an attribute text or numbers.
bool isReadAsValues(DicomTag tag) {
    const DcmEVR vr = DcmTag(tag.group, tag.element).getEVR();
    return isReadAsText(vr) || isReadAsNumber(vr);
}

/// Reads a value of bytes as the dictionary says, because DCMTK would give hexadecimal digits for text. Puts the
/// element so read into `item` in place of `element`. Null if the dictionary calls it neither text nor numbers, or if
/// it cannot be read so.
DcmElement* readAnew(DcmItem& item, DcmElement& element, DicomTag tag) {
    if (!isReadAsValues(tag) || element.getLength() > longestReadAnew) return nullptr;
    std::string bytes = bytesOfElement(element);
    if (bytes.size() != element.getLength()) return nullptr;
    std::array<std::uint16_t, 4> header{tag.group, tag.element, static_cast<std::uint16_t>(bytes.size() & 0xffff),
                                        static_cast<std::uint16_t>(bytes.size() >> 16)};
    bytes.insert(0, reinterpret_cast<const char*>(header.data()), sizeof(header));
    DcmInputBufferStream stream;
    stream.setBuffer(bytes.data(), static_cast<offile_off_t>(bytes.size()));
    stream.setEos();
    DcmDataset read;
    read.transferInit();
    (void)read.read(stream, EXS_LittleEndianImplicit);
    read.transferEnd();
    DcmElement* anew = read.remove(DcmTagKey(tag.group, tag.element));
    if (anew == nullptr || item.insert(anew, OFTrue).bad()) {
        delete anew;
        return nullptr;
    }
    return anew;
}

DcmElement* elementOf(DcmItem& item, DicomTag tag) {
    DcmElement* element = nullptr;
    if (item.findAndGetElement(DcmTagKey(tag.group, tag.element), element).bad() || element == nullptr) return nullptr;
    if (!holdsBytes(element->getVR())) return element;
    DcmElement* const anew = readAnew(item, *element, tag);
    return anew != nullptr ? anew : element;
}

/// An element with a value. Null if it is missing, if it is a sequence, or if its declared length is above `longest`.
/// DCMTK would take memory for the declared length (4 GiB for an undefined one), even if a damaged file holds less.
DcmElement* valueOf(DcmItem& item, DicomTag tag) {
    constexpr Uint32 longest = Uint32{1} << 22;
    DcmElement* element = elementOf(item, tag);
    if (element == nullptr || !element->isLeaf() || element->getLengthField() > longest) return nullptr;
    // What could not be read anew would come as hexadecimal digits.
    return holdsBytes(element->getVR()) && isReadAsValues(tag) ? nullptr : element;
}

DcmSequenceOfItems* sequenceOf(DcmItem& item, DicomTag tag) {
    DcmElement* element = elementOf(item, tag);
    return element != nullptr && element->ident() == EVR_SQ ? static_cast<DcmSequenceOfItems*>(element) : nullptr;
}

/// The text of an attribute as stored, up to the first zero byte; no value if the attribute is not stored as text. The
/// view is valid until the element changes.
std::optional<std::string_view> storedText(DcmElement& element) {
    char* text = nullptr;
    Uint32 length = 0;
    if (element.getString(text, length).bad()) return std::nullopt;
    if (text == nullptr) return std::string_view();
    const std::string_view whole(text, length);
    return whole.substr(0, whole.find('\0'));  // some programs pad with zero bytes
}

/// Cuts one value off the front of `rest`, trimmed. After the last value, `rest` has no data pointer.
std::string nextValue(std::string_view& rest) {
    const auto end = rest.find('\\');
    std::string value = trimmed(rest.substr(0, end));
    rest = end == std::string_view::npos ? std::string_view() : rest.substr(end + 1);
    return value;
}

/// Value `index` of an attribute for which storedText() has nothing; no value if DCMTK's text of it is no number.
std::optional<double> binaryNumber(DcmElement& element, std::size_t index) {
    OFString text;
    if (element.getOFString(text, static_cast<unsigned long>(index)).bad()) return std::nullopt;
    return realNumber(trimmed({text.c_str(), text.length()}));
}

bool isFinite(const std::optional<double>& value) { return value && std::isfinite(*value); }

}  // namespace

std::string tagText(DicomTag tag) { return fmt::format("({:04x},{:04x})", tag.group, tag.element); }

std::optional<double> decimalNumber(std::string text) {
    const auto comma = text.find(',');
    if (comma != std::string::npos && text.find('.') == std::string::npos) text[comma] = '.';
    return realNumber(text);
}

std::string dicomText(DcmItem& item, DicomTag tag) {
    DcmElement* element = valueOf(item, tag);
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
    DcmElement* element = valueOf(item, tag);
    if (element == nullptr || count == 0) return {};
    std::vector<double> values;
    if (auto stored = storedText(*element)) {
        const auto held = static_cast<std::size_t>(std::count(stored->begin(), stored->end(), '\\')) + 1;
        if (stored->empty() || held != count) return {};
        const bool decimal = element->ident() == EVR_DS || DcmTag(tag.group, tag.element).getEVR() == EVR_DS;
        values.reserve(count);
        while (stored->data() != nullptr) {
            const auto value = decimal ? decimalNumber(nextValue(*stored)) : realNumber(nextValue(*stored));
            if (!isFinite(value)) return {};
            values.push_back(*value);
        }
        return values;
    }
    if (holdsBytes(element->getVR()) || element->getVM() != count) return {};
    values.reserve(count);
    for (std::size_t index = 0; index < count; ++index) {
        const auto value = binaryNumber(*element, index);
        if (!isFinite(value)) return {};
        values.push_back(*value);
    }
    return values;
}

std::optional<double> dicomNumber(DcmItem& item, DicomTag tag) {
    const auto values = dicomNumbers(item, tag, 1);
    return values.empty() ? std::nullopt : std::optional(values[0]);
}

std::optional<std::int64_t> dicomWholeNumber(DcmItem& item, DicomTag tag) {
    DcmElement* element = valueOf(item, tag);
    if (element == nullptr) return std::nullopt;
    if (holdsBytes(element->getVR()) || element->getVM() != 1) return std::nullopt;
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

std::int64_t dicomFrameCount(DcmItem& item) {
    constexpr std::int64_t mostFrames = std::int64_t{1} << 31;
    return std::clamp<std::int64_t>(dicomWholeNumber(item, {0x0028, 0x0008}).value_or(1), 1, mostFrames);
}

std::size_t dicomSequenceLength(DcmItem& item, DicomTag sequence) {
    DcmSequenceOfItems* items = sequenceOf(item, sequence);
    return items != nullptr ? items->card() : 0;
}

std::vector<std::uint16_t> dicomWords(DcmItem& item, DicomTag tag) {
    const Uint16* words = nullptr;
    unsigned long count = 0;
    if (item.findAndGetUint16Array(DcmTagKey(tag.group, tag.element), words, &count).good() && words != nullptr)
        return {words, words + count};
    DcmElement* const element = valueOf(item, tag);
    const bool bytes = element != nullptr && (element->getVR() == EVR_OB || element->getVR() == EVR_UN);
    const std::string held = bytes ? bytesOfElement(*element) : std::string();
    std::vector<std::uint16_t> read(held.size() / 2);
    for (std::size_t i = 0; i < read.size(); ++i)
        read[i] = static_cast<std::uint16_t>(static_cast<std::uint8_t>(held[2 * i]) |
                                             static_cast<std::uint8_t>(held[2 * i + 1]) << 8);
    return read;
}

std::vector<std::uint32_t> dicomLongWords(DcmItem& item, DicomTag tag) {
    const Uint32* words = nullptr;
    unsigned long count = 0;
    if (item.findAndGetUint32Array(DcmTagKey(tag.group, tag.element), words, &count).bad() || words == nullptr)
        return {};
    return {words, words + count};
}

std::optional<DicomTag> dicomPointer(DcmItem& item, DicomTag tag) {
    DcmElement* element = valueOf(item, tag);
    DcmTagKey named;
    if (element == nullptr || element->ident() != EVR_AT || element->getTagVal(named, 0).bad()) return std::nullopt;
    return DicomTag{named.getGroup(), named.getElement()};
}

}  // namespace echolucent
