// Repairs of the walk over a DICOM file, so that a reader as strict as the standard can read it.
#include <algorithm>
#include <array>
#include <utility>

#include "io/dicom/elements/dicom_walk.h"

namespace echolucent {

/// Turns an item outside any sequence into an element that nobody reads. False if that cannot be done: below top level,
/// in deflated, big endian or implicit data, for an item of undefined length or above 65534 bytes, or if the file ends
/// within it.
bool DicomWalk::leaveOutItem(std::uint32_t length) {
    const Level& level = m_levels.back();
    if (m_stream.inflates() || m_levels.size() > 1 || level.implicitVr || m_bigEndian || length > 0xfffe) return false;
    const std::uint64_t start = m_stream.position() - 8;
    if (m_stream.skip(length) != length) return false;
    std::string header("\x08\x00\xff\xffST", 6);
    header += static_cast<char>(length & 0xff);
    header += static_cast<char>(length >> 8);
    repair(start, header, "An item that belongs to no sequence is left out.");
    return true;
}

/// Notes the bytes to read in place of those at `offset`. Adds `note` to the scan's notes unless it stands there.
void DicomWalk::repair(std::uint64_t offset, std::string bytes, const char* note) {
    m_scan.repairs.push_back({offset, std::move(bytes)});
    if (std::find(m_scan.notes.begin(), m_scan.notes.end(), note) == m_scan.notes.end())
        m_scan.notes.emplace_back(note);
}

/// Notes the true length of a sequence that is falsely declared empty.
void DicomWalk::repairLength(const Level& level, std::uint32_t length) {
    std::string bytes;
    for (int byte = 0; byte < 4; ++byte)
        bytes += static_cast<char>(length >> 8 * (level.bigEndian ? 3 - byte : byte) & 0xff);
    repair(*level.falseLength, std::move(bytes),
           "A sequence is declared to be empty although items follow; they are read as its own.");
}

/// Ends a sequence that is falsely declared empty behind its last item.
void DicomWalk::writeLength() {
    const std::uint64_t position = m_stream.position() - (m_pendingTag ? 4 : 0);
    const Level level = m_levels.back();
    pop();
    repairLength(level, static_cast<std::uint32_t>(position - level.start));
}

/// If the file ends between elements and only lacks delimiters, notes these. False if more is missing, or if they
/// cannot be added.
bool DicomWalk::closeAtEnd() {
    while (m_levels.size() > 1 && m_levels.back().end == m_stepStart) pop();
    if (m_levels.size() == 1) return true;
    if (m_stream.inflates()) return false;
    if (m_levels.back().falseLength) writeLength();
    std::string delimiters;
    for (std::size_t i = m_levels.size(); i-- > 1;) {
        if (m_levels[i].end != endless || m_levels[i].falseLength) return false;
        const std::uint32_t tag = m_levels[i].kind == LevelKind::item ? itemEndTag : sequenceEndTag;
        for (const int shift : m_levels[i].bigEndian ? std::array{24, 16, 8, 0} : std::array{16, 24, 0, 8})
            delimiters += static_cast<char>(tag >> shift & 0xff);
        delimiters.append(4, '\0');
    }
    if (delimiters.empty()) return true;
    m_scan.pixelsEnd = m_scan.pixelsEnd ||
                       std::any_of(m_levels.begin(), m_levels.end(), [](const Level& level) { return level.pixels; });
    repair(m_file.size(), std::move(delimiters), "The file ends without the delimiter that closes its last sequence.");
    return true;
}

}  // namespace echolucent
