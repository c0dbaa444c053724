// The walk over a DICOM file counts elements, and finds those that stand twice.
#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/elements/dicom_names.h"
#include "io/dicom/elements/dicom_scan_result.h"
#include "io/dicom/elements/dicom_walk.h"
#include "io/files/header_text.h"
#include "io/files/input_problems.h"

namespace echolucent {

namespace {

/// Values up to this many bytes are kept, to compare them if the element stands twice.
constexpr std::uint32_t keptValue = 64;

/// "(0028,0030) Pixel Spacing"
std::string tagAndName(std::uint32_t tag) {
    DcmTag named(static_cast<Uint16>(tag >> 16), static_cast<Uint16>(tag & 0xffff));
    return fmt::format("({:04x},{:04x}) {}", tag >> 16, tag & 0xffff, wordsOfName(named.getTagName()));
}

/// Whether an element describes the picture or its place, so that it must not stand twice with different values.
bool describesPicture(std::uint32_t tag) {
    const std::uint32_t group = tag >> 16;
    if (tag == 0x00280120 || tag == 0x00280121) return false;  // padding in doubt is no reason to refuse the picture
    return group == 0x0018 || group == 0x0020 || group == 0x0028 || group == 0x3001 || group == 0x3004 ||
           group == 0x5200 || tag == pixelDataTag;
}

}  // namespace

/// Refuses a directory record's type that is longer than 16 bytes: DCMTK 3.6.7 throws over it and loses what it has
/// read.
void DicomWalk::refuseLongRecordType(std::uint32_t tag, std::uint32_t length) {
    constexpr std::uint32_t recordTypeTag = 0x00041430, longestCodeString = 16;
    if (tag != recordTypeTag || length <= longestCodeString) return;
    m_harm =
        Harm{tagAndName(tag),
             fmt::format("is {} bytes long, and a directory record's type has at most {}", length, longestCodeString),
             doNotOpen};
}

/// Counts an element and the work of DCMTK to sort it in. An element with the tag of the one before adds nothing to its
/// level, because DCMTK drops it.
void DicomWalk::countElement(std::uint32_t tag) {
    Level& level = m_levels.back();
    ++m_elements;
    const bool again = level.elements > 0 && tag == level.previousTag;
    level.ascends = level.elements == 0 || tag > level.lastTag;
    level.previousTag = tag;
    if (level.elements > 0 && tag < level.lastTag) m_disorder += level.elements;
    level.lastTag = std::max(level.lastTag, tag);
    if (!again) ++level.elements;
}

/// Notes decimal commas, and values of a picture's place and size that are no numbers.
void DicomWalk::sayDecimals(std::uint32_t tag, std::string_view value) {
    constexpr std::array places{0x00180088U, 0x00200032U, 0x00200037U, 0x00280030U};
    std::string_view rest = value.substr(0, value.find('\0'));
    bool comma = false, wrong = false;
    while (!trimmed(rest).empty()) {
        const auto end = std::min(rest.find('\\'), rest.size());
        const std::string one = trimmed(rest.substr(0, end));
        const bool isNumber = one.empty() || decimalNumber(one);
        wrong = wrong || !isNumber;
        comma = comma || (isNumber && one.find(',') != std::string::npos);
        rest = rest.substr(std::min(end + 1, rest.size()));
    }
    if (comma && !std::exchange(m_commaSaid, true))
        m_scan.notes.emplace_back(
            "The header holds a decimal comma in numbers, which DICOM does not know; such commas were read as points.");
    if (!wrong || std::ranges::find(places, tag) == places.end()) return;
    if (std::ranges::find(m_noNumbers, tag) != m_noNumbers.end()) return;
    m_noNumbers.push_back(tag);
    m_scan.notes.push_back(fmt::format("{} is {}, which are no numbers; it counts as not stated.", tagAndName(tag),
                                       quotedText(trimmed(value))));
}

/// Keeps short values of elements that describe the picture, and finds those that stand twice. A `plain` value holds no
/// items. Twice with the same kept value is noted. Twice with different values, or with values that were not kept, is
/// harm. `passed` becomes true if the value was read on the way. False if the file ends within the value.
bool DicomWalk::describe(std::uint32_t tag, std::uint32_t length, bool plain, bool& passed) {
    if (!describesPicture(tag)) return true;
    Level& level = m_levels.back();
    Described described{tag, {}, plain && length <= keptValue};
    if (described.isKept) {
        described.value.resize(length);
        if (!m_stream.read(reinterpret_cast<std::uint8_t*>(described.value.data()), length)) return false;
        passed = true;
    }
    if (described.isKept &&
        DcmTag(static_cast<Uint16>(tag >> 16), static_cast<Uint16>(tag & 0xffff)).getEVR() == EVR_DS)
        sayDecimals(tag, described.value);
    const auto before =
        level.ascends ? level.described.end() : std::ranges::find(level.described, tag, &Described::tag);
    if (before == level.described.end()) {
        level.described.push_back(std::move(described));
        return true;
    }
    const std::string name = tagAndName(tag);
    if (!before->isKept || !described.isKept || before->value != described.value)
        m_harm = Harm{name, "stands twice, with different values", "Export it again: it cannot be told which is true."};
    else
        m_scan.notes.push_back(name + " stands twice, with the same value.");
    if (m_scan.notes.size() > mostRepairs) m_harm = Harm{name, "stands twice, as do many others", doNotOpen};
    return true;
}

}  // namespace echolucent
