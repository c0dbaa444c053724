#include "io/dicom/elements/dicom_walk.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include "io/dicom/elements/dicom_names.h"
#include "io/files/header_text.h"
#include "io/files/input_problems.h"
#include "io/voxels/gzip_file.h"

namespace echolucent {

namespace {

constexpr std::uint32_t itemTag = 0xfffee000U;
constexpr std::uint32_t sopClassTag = 0x00080016U;

constexpr std::uint32_t itemTags[] = {itemTag, 0xfffee00dU, 0xfffee0ddU};
/// The most steps that DCMTK may take to sort in elements that are out of order. Each such element counts as one step
/// for every element that stands before it in its data set or item.
constexpr std::uint64_t mostDisorder = 10000000;
/// The value representation that DCMTK sees in two letters; it decides how a length is read.
DcmVR vrOf(std::string_view letters) { return DcmVR(std::string(letters.substr(0, 2)).c_str()); }

/// Whether DCMTK reads a value of undefined length as fragments, by its value representation.
bool hasFragments(std::string_view vr) {
    const DcmEVR kind = vrOf(vr).getEVR();
    return kind != EVR_SQ && kind != EVR_UN && kind != EVR_UNKNOWN && kind != EVR_UNKNOWN2B;
}

DcmTag tagOf(std::uint32_t tag) { return {static_cast<Uint16>(tag >> 16), static_cast<Uint16>(tag & 0xffff)}; }

}  // namespace

void DicomWalk::run(bool headerOnly) {
    m_scan.fileBytes = m_file.size();
    if (!readMeta()) {
        m_scan.end = DicomScanEnd::inMeta;
        m_scan.endPosition = m_stream.position();
        return;
    }
    const auto goesOn = [&] { return !m_progress.cancelled() && !harm(); };
    // The lengths that QLAB declares are often false, so what follows the pixel data may be voxels.
    const auto enough = [&] {
        return (headerOnly && m_behindKretz) || (m_scan.hasPixelData && m_scan.sopClass == qlabSopClass);
    };
    while (goesOn() && !enough() && step()) {
    }
    // Inflate the rest too: unpackedBytes must cover all that DCMTK could be given.
    if (goesOn() && m_stream.inflates()) m_stream.skip(endless);
    if (goesOn()) measureEnd(enough());
}

void DicomWalk::measureEnd(bool enough) {
    m_scan.unpackedBytes = m_stream.inflated();
    m_scan.endPosition = m_stepStart;
    if (m_stream.inflates() && !m_stream.inflatesToItsEnd()) {
        m_scan.end = DicomScanEnd::deflate;
        m_scan.endPosition = m_stream.inflated();
        measureWhatLacks();
        return;
    }
    if (enough) return;
    const bool cut = !m_lost && (m_stepStart != m_stream.end() || !closeAtEnd());
    // DCMTK gets a DICOMDIR that is cut, unless it is deflated or the last element runs out of an item that ends
    // before: DCMTK might read as records what the walk took for a part of this element.
    const bool runsOver = cut && m_scan.sopClass == directorySopClass && !m_stream.inflates() &&
                          std::ranges::any_of(m_levels, [&](const Level& one) { return one.end < m_stream.end(); });
    if (m_lost || runsOver)
        m_scan.end = DicomScanEnd::damaged;
    else if (cut)
        m_scan.end = DicomScanEnd::cut;
    if (m_scan.end == DicomScanEnd::whole) return;
    // Bytes behind the pixels that are no DICOM may look like an element of any length. GE's volume stands there too.
    const bool kretz = m_kretzBlock != 0 && m_lastTag >> 16 == kretzGroup;
    const bool behindPixels = m_scan.pixelsEnd && m_topStart > m_pixelsElement;
    if (behindPixels && !m_stream.inflates() && !kretz)
        m_scan.usedBytes = m_topStart;
    else if (cut)
        measureWhatLacks();
}

/// Notes the last element if the file lacks more than `little` of it: DCMTK would take memory for bytes that are not
/// there.
void DicomWalk::measureWhatLacks() {
    constexpr std::uint64_t little = std::uint64_t{1} << 20;
    const std::uint64_t held = m_stream.position() - m_lastStart;
    if (m_lastIsPixels || m_lastLength == undefinedLength || m_lastLength <= held + little) return;
    const DicomTag tag{static_cast<std::uint16_t>(m_lastTag >> 16), static_cast<std::uint16_t>(m_lastTag & 0xffff)};
    m_scan.lacking = LackingElement{tag, m_lastLength, held};
}

std::optional<DicomWalk::Harm> DicomWalk::harm() const {
    if (m_harm) return m_harm;
    const auto harmful = [](std::string problem) { return Harm{"", std::move(problem), doNotOpen}; };
    if (m_sequences > deepestSequence) return harmful(nestedTooDeep());
    if (m_elements > mostElements) return harmful(tooManyElements());
    if (!m_levels.empty() && m_levels.back().elements > mostElementsOfOne)
        return harmful(fmt::format(
            "holds more than {} elements in one data set or item, which no true DICOM object does", mostElementsOfOne));
    if (m_disorder > mostDisorder)
        return harmful("holds too many elements that are out of order, which no true DICOM object does");
    if (m_scan.repairs.size() > mostRepairs)
        return harmful(
            fmt::format("holds more than {} items outside sequences, which no true DICOM object does", mostRepairs));
    if (m_stream.inflatesTooMuch())
        return harmful(fmt::format("unpacks to more than {} bytes out of {}, which no volume does",
                                   mostUnpackedBytes(m_file.size()), m_file.size()));
    return std::nullopt;
}

std::optional<std::uint32_t> DicomWalk::read16() {
    std::array<std::uint8_t, 2> b{};
    if (!m_stream.read(b.data(), b.size())) return std::nullopt;
    return isBigEndian() ? b[0] << 8 | b[1] : b[1] << 8 | b[0];
}

std::optional<std::uint32_t> DicomWalk::read32() {
    const auto first = read16();
    const auto second = read16();
    if (!first || !second) return std::nullopt;
    return isBigEndian() ? *first << 16 | *second : *second << 16 | *first;
}

std::optional<std::uint32_t> DicomWalk::readTag() {
    if (m_pendingTag) return std::exchange(m_pendingTag, std::nullopt);
    const auto group = read16();
    const auto element = read16();
    if (!group || !element) return std::nullopt;
    return *group << 16 | *element;
}

void DicomWalk::push(LevelKind kind, std::uint32_t length, bool implicitVr) {
    const std::uint64_t start = m_stream.position() - (m_pendingTag ? 4 : 0);
    Level level;
    level.kind = kind;
    level.start = start;
    level.end = length == undefinedLength ? endless : start + length;
    level.implicitVr = implicitVr;
    // A value of VR UN is little endian, whatever the data set is.
    level.bigEndian = m_levels.back().bigEndian && !(implicitVr && !m_levels.back().implicitVr);
    m_levels.push_back(std::move(level));
    m_sequences += kind == LevelKind::sequence ? 1 : 0;
}

void DicomWalk::pop() {
    m_scan.pixelsEnd = m_scan.pixelsEnd || m_levels.back().pixels;
    m_sequences -= m_levels.back().kind == LevelKind::sequence ? 1 : 0;
    m_levels.pop_back();
}

/// Leaves data that make no sense and goes on at the nearest known end of a level. False if no end is known, or if the
/// file ends before.
bool DicomWalk::recover() {
    m_pendingTag.reset();
    while (m_levels.size() > 1) {
        const std::uint64_t end = m_levels.back().end;
        pop();
        if (end == endless || end < m_stream.position()) continue;
        const std::uint64_t rest = end - m_stream.position();
        return m_stream.skip(rest) == rest;
    }
    m_lost = true;
    return false;
}

bool DicomWalk::step() {
    const std::uint64_t position = m_stream.position() - (m_pendingTag ? 4 : 0);
    m_stepStart = position;
    if (m_levels.size() == 1) m_topStart = position;
    if (m_levels.size() > 1 && position >= m_levels.back().end) {
        pop();
        return true;
    }
    const auto tag = readTag();
    if (!tag) return false;
    // Zeros that fill a file up behind its pixels: no data set has group 0.
    m_lost = m_scan.pixelsEnd && m_levels.size() == 1 && *tag >> 16 == 0 && !m_stream.inflates();
    if (m_lost) return false;
    if (std::ranges::find(itemTags, *tag) != std::end(itemTags)) return readDelimiter(*tag);
    const LevelKind kind = m_levels.back().kind;
    if (m_levels.back().falseLength) {
        m_pendingTag = tag;
        writeLength();
        return true;
    }
    if (kind == LevelKind::sequence || kind == LevelKind::fragments) return recover();
    return readElement(*tag);
}

bool DicomWalk::readDelimiter(std::uint32_t tag) {
    const auto length = read32();
    if (!length) return false;
    const LevelKind kind = m_levels.back().kind;
    if (tag == itemTag) {
        if (kind == LevelKind::fragments) {
            ++m_elements;
            if (m_levels.back().pixels) noteFragment(*length);
        }
        if (kind == LevelKind::fragments) return *length != undefinedLength && m_stream.skip(*length) == *length;
        if (kind != LevelKind::sequence && !m_stream.inflates() && m_levels.size() == 1 &&
            m_stream.position() - 8 == m_emptySequenceEnd) {
            // The items of a sequence follow although its length is declared as 0.
            push(LevelKind::sequence, undefinedLength, false);
            m_levels.back().start = m_emptySequenceEnd;
            m_levels.back().falseLength = m_emptySequenceEnd - 4;
        } else if (kind != LevelKind::sequence) {
            return leaveOutItem(*length) || recover();
        }
        ++m_elements;
        push(LevelKind::item, *length, m_levels.back().implicitVr);
        return true;
    }
    if (tag == itemEndTag && kind == LevelKind::item) {
        pop();
        return true;
    }
    if (tag == sequenceEndTag && (kind == LevelKind::sequence || kind == LevelKind::fragments)) {
        if (m_levels.back().falseLength) repairLength(m_levels.back(), undefinedLength);
        pop();
        return true;
    }
    return recover();
}

bool DicomWalk::readElement(std::uint32_t tag) {
    countElement(tag);
    if (m_levels.back().implicitVr) {
        const auto length = read32();
        return length && enterValue(tag, "", *length);
    }
    std::array<std::uint8_t, 2> bytes{};
    if (!m_stream.read(bytes.data(), 2)) return false;
    const std::string_view vr(reinterpret_cast<const char*>(bytes.data()), 2);
    const bool isLong = vrOf(vr).usesExtendedLengthEncoding();
    if (isLong && m_stream.skip(2) != 2) return false;
    const auto length = isLong ? read32() : read16();
    return length && enterValue(tag, vr, *length);
}

bool DicomWalk::enterValue(std::uint32_t tag, std::string_view vr, std::uint32_t length) {
    const bool pixels = tag == pixelDataTag && m_levels.size() == 1;
    m_lastTag = tag;
    m_lastLength = length;
    m_lastStart = m_stream.position();
    m_lastIsPixels = pixels;
    refuseLongRecordType(tag, length);
    if (m_harm) return true;
    m_behindKretz = m_behindKretz || (m_levels.size() == 1 && tag >> 16 > kretzGroup);
    if (m_levels.size() == 1 && tag >> 16 == kretzGroup && readKretz(tag, vr, length)) return true;
    if (pixels) notePixelData(vr, length, m_levels.back().implicitVr || hasFragments(vr));
    const DcmEVR stated = m_levels.back().implicitVr || vr == "UN" ? tagOf(tag).getEVR() : vrOf(vr).getEVR();
    const bool plain =
        stated != EVR_SQ && stated != EVR_UNKNOWN && stated != EVR_UNKNOWN2B && stated != EVR_UN && !pixels;
    bool passed = false;
    if (!describe(tag, length, plain, passed)) return false;
    if (passed || m_harm) return true;
    if (tag == sopClassTag && m_levels.size() == 1 && m_scan.sopClass.empty() && length <= 64) {
        std::string value(length, '\0');
        if (!m_stream.read(reinterpret_cast<std::uint8_t*>(value.data()), value.size())) return false;
        m_scan.sopClass = trimmed(value.substr(0, value.find('\0')));
        return true;
    }
    const bool implicitVr = m_levels.back().implicitVr;
    if (length == undefinedLength) {
        const bool fragments = pixels ? m_scan.pixelsInFragments : !implicitVr && hasFragments(vr);
        push(fragments ? LevelKind::fragments : LevelKind::sequence, length, implicitVr || vr == "UN");
        m_levels.back().pixels = pixels;
        return true;
    }
    if (vr == "SQ") {
        if (length == 0) m_emptySequenceEnd = m_stream.position();
        push(LevelKind::sequence, length, false);
        return true;
    }
    const bool unknown = implicitVr || vr == "UN";
    if (unknown && tagOf(tag).getEVR() == EVR_SQ) {
        push(LevelKind::sequence, length, true);
        return true;
    }
    if (unknown && !pixels) return enterIfItem(length);
    const std::uint64_t skipped = m_stream.skip(length);
    if (pixels && m_stream.inflates()) m_scan.pixelBytesHeld = skipped;
    m_scan.pixelsEnd = m_scan.pixelsEnd || (pixels && skipped == length);
    return skipped == length;
}

/// Enters a value of unknown kind as a sequence if it begins with an item; else passes it.
bool DicomWalk::enterIfItem(std::uint32_t length) {
    if (length < 8) return m_stream.skip(length) == length;
    const auto tag = readTag();
    if (!tag) return false;
    if (*tag != itemTag) return m_stream.skip(length - 4) == length - 4;
    m_pendingTag = tag;
    push(LevelKind::sequence, length, true);
    return true;
}

}  // namespace echolucent
