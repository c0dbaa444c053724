#include "tests/fuzz/mutations/dicom_elements.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "tests/fuzz/mutations/byte_mutation.h"
#include "tests/fuzz/mutations/zlib_parts.h"

namespace echolucent {

namespace {

constexpr std::uint32_t undefined = 0xffffffffU;
constexpr std::uint32_t itemTag = 0xfffee000U, itemEnd = 0xfffee00dU, sequenceEnd = 0xfffee0ddU;
constexpr std::uint32_t transferSyntaxTag = 0x00020010U, pixelDataTag = 0x7fe00010U;
constexpr int deepestItem = 40;

std::uint32_t tagAt(std::string_view bytes, std::size_t offset) {
    return std::uint32_t{valueAt<std::uint16_t>(bytes, offset)} << 16 | valueAt<std::uint16_t>(bytes, offset + 2);
}

std::string tagBytes(std::uint32_t tag) {
    return bytesOfValue(static_cast<std::uint16_t>(tag >> 16)) + bytesOfValue(static_cast<std::uint16_t>(tag));
}

bool hasLongLength(std::string_view vr) {
    static constexpr std::array<std::string_view, 13> those{"OB", "OD", "OF", "OL", "OV", "OW", "SQ",
                                                            "SV", "UC", "UN", "UR", "UT", "UV"};
    return std::ranges::find(those, vr) != those.end();
}

/// Reads elements from bytes, from `at` on, which it moves.
class Parser {
public:
    explicit Parser(std::string_view bytes) : m_bytes(bytes) {}

    std::size_t at = 0;

    /// Elements up to `end` or a delimiter, which stays.
    std::vector<DicomElementBytes> elements(std::size_t end, bool implicit, int depth, bool meta = false) {
        std::vector<DicomElementBytes> found;
        while (at + 8 <= end) {
            const std::uint32_t tag = tagAt(m_bytes, at);
            if (tag >> 16 == 0xfffeU || (meta && tag >> 16 != 2)) break;
            const std::size_t start = at;
            auto one = element(end, implicit, depth);
            if (!one) {
                at = start;
                break;
            }
            found.push_back(std::move(*one));
        }
        return found;
    }

private:
    std::optional<DicomElementBytes> element(std::size_t end, bool implicit, int depth) {
        DicomElementBytes one;
        one.tag = tagAt(m_bytes, at);
        std::uint32_t length = 0;
        if (implicit) {
            length = valueAt<std::uint32_t>(m_bytes, at + 4);
            at += 8;
        } else {
            one.vr = m_bytes.substr(at + 4, 2);
            if (!hasLongLength(one.vr)) {
                length = valueAt<std::uint16_t>(m_bytes, at + 6);
                at += 8;
            } else {
                if (at + 12 > end) return std::nullopt;
                length = valueAt<std::uint32_t>(m_bytes, at + 8);
                at += 12;
            }
        }
        const bool endless = length == undefined;
        const std::size_t held = end - at;
        if (endless && one.tag == pixelDataTag) return withFragments(std::move(one), end);
        const bool items = at + 8 <= end && tagAt(m_bytes, at) == itemTag;
        if ((endless || one.vr == "SQ" || (implicit && items)) && depth < deepestItem)
            return withItems(std::move(one), endless ? end : at + std::min<std::size_t>(length, held), endless,
                             implicit, depth);
        if (endless) return std::nullopt;
        if (length > held) one.falseLength = length;
        one.value = m_bytes.substr(at, std::min<std::size_t>(length, held));
        at += one.value.size();
        return one;
    }

    /// Passes the delimiter `tag`, if it stands here.
    bool passed(std::uint32_t tag, std::size_t end) {
        if (at + 8 > end || tagAt(m_bytes, at) != tag) return false;
        at += 8;
        return true;
    }

    DicomElementBytes withItems(DicomElementBytes one, std::size_t end, bool endless, bool implicit, int depth) {
        one.sequence = true;
        one.delimited = endless;
        while (at + 8 <= end && tagAt(m_bytes, at) == itemTag) {
            const std::uint32_t length = valueAt<std::uint32_t>(m_bytes, at + 4);
            at += 8;
            DicomItemBytes item;
            item.delimited = length == undefined;
            const std::size_t itemsEnd = item.delimited ? end : at + std::min<std::size_t>(length, end - at);
            item.elements = elements(itemsEnd, implicit, depth + 1);
            if (item.delimited)
                item.closed = passed(itemEnd, end);
            else
                at = itemsEnd;
            one.items.push_back(std::move(item));
        }
        if (endless)
            one.closed = passed(sequenceEnd, end);
        else
            at = end;
        return one;
    }

    DicomElementBytes withFragments(DicomElementBytes one, std::size_t end) {
        one.encapsulated = true;
        while (at + 8 <= end && tagAt(m_bytes, at) == itemTag) {
            const std::size_t length = std::min<std::size_t>(valueAt<std::uint32_t>(m_bytes, at + 4), end - at - 8);
            one.fragments.emplace_back(m_bytes.substr(at + 8, length));
            at += 8 + length;
        }
        one.closed = passed(sequenceEnd, end);
        return one;
    }

    std::string_view m_bytes;
};

std::string lengthBytes(std::size_t size, std::optional<std::uint32_t> falseLength, bool endless) {
    return bytesOfValue(falseLength.value_or(endless ? undefined : static_cast<std::uint32_t>(size)));
}

std::string bytesOf(const std::vector<DicomElementBytes>& elements, bool implicit);

std::string bytesOf(const DicomItemBytes& item, bool implicit) {
    const std::string inside = bytesOf(item.elements, implicit);
    std::string bytes = tagBytes(itemTag) + lengthBytes(inside.size(), item.falseLength, item.delimited) + inside;
    if (item.delimited && item.closed) bytes += tagBytes(itemEnd) + bytesOfValue(std::uint32_t{0});
    return bytes;
}

std::string bytesOf(const DicomElementBytes& element, bool implicit) {
    std::string inside = element.value;
    if (element.sequence) {
        inside.clear();
        for (const DicomItemBytes& item : element.items) inside += bytesOf(item, implicit);
    } else if (element.encapsulated) {
        inside.clear();
        for (const std::string& fragment : element.fragments)
            inside += tagBytes(itemTag) + bytesOfValue(static_cast<std::uint32_t>(fragment.size())) + fragment;
    }
    const bool endless = element.encapsulated || (element.sequence && element.delimited);
    const std::string length = lengthBytes(inside.size(), element.falseLength, endless);
    std::string bytes = tagBytes(element.tag);
    if (implicit)
        bytes += length;
    else if (hasLongLength(element.vr))
        bytes += element.vr + std::string(2, '\0') + length;
    else
        bytes += (element.vr + "UN").substr(0, 2) + length.substr(0, 2);
    bytes += inside;
    if (endless && element.closed) bytes += tagBytes(sequenceEnd) + bytesOfValue(std::uint32_t{0});
    return bytes;
}

std::string bytesOf(const std::vector<DicomElementBytes>& elements, bool implicit) {
    std::string bytes;
    for (const DicomElementBytes& element : elements) bytes += bytesOf(element, implicit);
    return bytes;
}

}  // namespace

DicomFileBytes dicomParts(const std::string& bytes) {
    DicomFileBytes file;
    const std::string_view all(bytes);
    if (all.substr(std::min<std::size_t>(128, all.size())).starts_with("DICM")) file.preamble = all.substr(0, 132);
    Parser head(all);
    head.at = file.preamble.size();
    file.meta = head.elements(all.size(), false, 0, true);
    std::string syntax;
    for (const DicomElementBytes& element : file.meta)
        if (element.tag == transferSyntaxTag) syntax = element.value;
    while (!syntax.empty() && (syntax.back() == '\0' || syntax.back() == ' ')) syntax.pop_back();
    const std::string_view behind = all.substr(head.at);
    if (syntax == "1.2.840.10008.1.2.2") {
        file.rest = behind;
        return file;
    }
    file.implicit = syntax == "1.2.840.10008.1.2";
    file.deflated = syntax == "1.2.840.10008.1.2.1.99";
    const std::string dataset = file.deflated ? unpacked(behind, rawWindow) : std::string(behind);
    Parser parser(dataset);
    file.elements = parser.elements(dataset.size(), file.implicit, 0);
    if (!file.deflated) file.rest = dataset.substr(parser.at);
    return file;
}

std::string dicomBytes(const DicomFileBytes& file) {
    const std::string dataset = bytesOf(file.elements, file.implicit);
    return file.preamble + bytesOf(file.meta, false) + (file.deflated ? packed(dataset, rawWindow) : dataset) +
           file.rest;
}

}  // namespace echolucent
