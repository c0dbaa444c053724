// The walk over a DICOM file reads its meta header and finds out how the data set behind it is written.
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include "io/dicom/elements/dicom_names.h"
#include "io/dicom/elements/dicom_walk.h"
#include "io/dicom/elements/dicom_writing.h"
#include "io/files/header_text.h"
#include "io/files/input_problems.h"

namespace echolucent {

/// Reads preamble and meta header, which say how the data set is written. False if the file is too short. True with
/// `m_harm` set if the meta header holds a sequence.
bool DicomWalk::readMeta() {
    const auto beginning = m_file.beginning(132);
    if (!beginning || beginning->size() < 8) return false;
    const bool preamble = beginning->size() == 132 && beginning->substr(128) == "DICM";
    m_stream.skip(preamble ? 132 : 0);
    std::optional<std::uint32_t> tag;
    std::optional<std::uint64_t> statedEnd;  // of the meta header, as its own length says
    while ((tag = readTag()) && *tag >> 16 == 0x0002) {
        std::array<std::uint8_t, 2> vr{};
        if (!m_stream.read(vr.data(), 2)) return false;
        const DcmVR kind(std::string(vr.begin(), vr.end()).c_str());
        const bool isLong = kind.usesExtendedLengthEncoding();
        if (isLong) m_stream.skip(2);
        const auto length = isLong ? read32() : read16();
        if (!length) return false;
        if (kind.getEVR() == EVR_SQ || *length == undefinedLength) {
            m_harm = Harm{fmt::format("(0002,{:04x})", *tag & 0xffff),
                          "stands in the meta header with a sequence, which no true DICOM object has there", doNotOpen};
            return true;
        }
        const bool wanted = *tag == 0x00020010 || *tag == 0x00020002;
        if (wanted && *length <= 128) {
            std::string value(*length, '\0');
            if (!m_stream.read(reinterpret_cast<std::uint8_t*>(value.data()), value.size())) return false;
            value = trimmed(value.substr(0, value.find('\0')));
            (*tag == 0x00020010 ? m_scan.transferSyntax : m_scan.sopClass) = value;
        } else if (*tag == 0x00020000 && *length == 4) {
            const auto bytes = read32();
            if (!bytes) return false;
            statedEnd = m_stream.position() + *bytes;
        } else if (m_stream.skip(*length) != *length) {
            return false;
        }
    }
    if (!tag) return false;
    m_scan.datasetStart = m_stream.position() - 4;
    if (statedEnd && *statedEnd != m_scan.datasetStart)
        m_scan.notes.emplace_back(
            "(0002,0000) File Meta Information Group Length is false; the meta header was read to its last element.");
    return readWriting(*tag);
}

/// Enters the data set, whose first tag was read as little endian. False if the file ends there.
bool DicomWalk::readWriting(std::uint32_t tag) {
    std::array<std::uint8_t, 2> letters{};
    if (!m_file.readAt(m_stream.position(), letters)) return false;
    m_statedSyntax = m_scan.transferSyntax;
    const auto stated = statedWriting(m_statedSyntax);
    DicomWriting writing =
        stated ? *stated : guessedWriting(tag, {reinterpret_cast<const char*>(letters.data()), letters.size()});
    const std::string other = stated ? contradictingSyntax(m_file, m_scan.datasetStart, *stated) : std::string();
    if (!other.empty()) {
        m_scan.transferSyntax = other;
        writing = *statedWriting(other);
        m_scan.notes.push_back(
            fmt::format("(0002,0010) Transfer Syntax is {}, but the elements are written as {} has them; they were "
                        "read so.",
                        transferSyntaxName(m_statedSyntax), transferSyntaxName(other)));
    }
    m_scan.elementSyntax = m_scan.transferSyntax;
    if (writing.deflated) {
        // The tag just read was already deflated: go back to it.
        ByteStream again(m_file, m_progress);
        again.skip(m_scan.datasetStart);
        m_stream = std::move(again);
        m_stream.inflateFromHere();
    } else {
        m_pendingTag = writing.bigEndian ? swappedTag(tag) : tag;
    }
    m_bigEndian = writing.bigEndian;
    Level dataset;
    dataset.implicitVr = writing.implicitVr;
    dataset.bigEndian = writing.bigEndian;
    m_levels.push_back(dataset);
    return true;
}

}  // namespace echolucent
