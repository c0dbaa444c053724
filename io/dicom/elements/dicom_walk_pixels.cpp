// The walk over a DICOM file looks at the values that hold pixels: Pixel Data, and GE's volumes.
#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <string_view>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include "io/dicom/elements/dicom_names.h"
#include "io/dicom/elements/dicom_walk.h"
#include "io/dicom/elements/fragment_coding.h"
#include "io/files/header_text.h"
#include "io/kretz/kretz_items.h"
#include "io/kretz/kretz_reader.h"

namespace echolucent {

namespace {

constexpr std::string_view kretzCreator = "KRETZ_US";

}  // namespace

void DicomWalk::notePixelData(std::string_view vr, std::uint32_t length, bool fragments) {
    m_scan.hasPixelData = true;
    m_pixelsElement = m_stepStart;
    m_scan.pixelStart = m_stream.inflates() ? 0 : m_stream.position();
    if (length == undefinedLength) {
        // DCMTK would read items of elements behind UN.
        const bool unknown = vr == "UN" && !m_stream.inflates();
        if (unknown)
            repair(m_stepStart + 4, "OB",
                   "(7fe0,0010) Pixel Data has the value representation UN; its fragments were read as OB.");
        if (!fragments && !unknown) return;
        m_scan.pixelsInFragments = true;
        if (DcmXfer(m_statedSyntax.c_str()).isEncapsulated()) m_scan.transferSyntax = m_statedSyntax;
        return;
    }
    m_scan.pixelBytesDeclared = length;
    // The size of deflated data is known once they are passed.
    m_scan.pixelBytesHeld =
        m_stream.inflates() ? length : std::min<std::uint64_t>(length, m_file.size() - m_stream.position());
}

/// Passes an element that may name a private creator, until GE's is found; or the element of GE's block that may hold a
/// volume. This is a volume if it begins like one of Kretz. False for other elements, and if the file ends before;
/// these are not passed.
bool DicomWalk::readKretz(std::uint32_t tag, std::string_view vr, std::uint32_t length) {
    const std::uint32_t element = tag & 0xffff;
    std::string value;
    const auto readValue = [&](std::size_t count) {
        value.resize(count);
        return m_stream.read(reinterpret_cast<std::uint8_t*>(value.data()), count);
    };
    // Items of a sequence are walked through, whatever its tag: DCMTK reads them.
    const bool creator =
        element >= 0x10 && element <= 0xff && vr != "SQ" && length >= kretzCreator.size() && length <= 64;
    if (creator && m_kretzBlock == 0) {
        if (!readValue(length)) return false;
        if (trimmed(value.substr(0, value.find('\0'))) == kretzCreator) m_kretzBlock = element;
        return true;
    }
    const bool bytes = vr.empty() || vr == "OB" || vr == "OW" || vr == "UN";
    const bool volume = m_kretzBlock != 0 && element == (m_kretzBlock << 8 | 0x01) && bytes;
    if (!volume || length == undefinedLength || length < kretzSignature.size()) return false;
    if (!readValue(kretzSignature.size())) return false;
    m_scan.holdsKretz = looksLikeKretz(value);
    const std::uint64_t skipped = m_stream.skip(length - value.size());
    if (m_scan.holdsKretz) m_scan.kretzBytesHeld = value.size() + skipped;
    return true;
}

/// Takes the coding of the pixels from their first fragment that holds bytes if the transfer syntax has no fragments.
/// The bytes of a fragment of this `length` follow. The first fragment is the offset table.
void DicomWalk::noteFragment(std::uint32_t length) {
    if (m_fragments++ == 0 || length == 0 || m_codingSought || m_stream.inflates()) return;
    m_codingSought = true;
    if (DcmXfer(m_scan.transferSyntax.c_str()).isEncapsulated()) return;
    std::array<std::uint8_t, fragmentBeginning> bytes{};
    const auto held = m_file.size() - std::min<std::uint64_t>(m_stream.position(), m_file.size());
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>({bytes.size(), length, held}));
    if (!m_file.readAt(m_stream.position(), std::span(bytes).first(count))) return;
    const std::string found = syntaxOfFragment(std::span(bytes).first(count));
    if (found.empty()) return;
    m_scan.transferSyntax = found;
    if (!m_levels.front().implicitVr && !m_bigEndian) m_scan.elementSyntax = found;
    m_scan.notes.push_back(fmt::format(
        "(0002,0010) Transfer Syntax is {}, but (7fe0,0010) Pixel Data is split into fragments that begin like {}; "
        "they were read so.",
        m_statedSyntax.empty() ? "missing" : transferSyntaxName(m_statedSyntax), transferSyntaxName(found)));
}

}  // namespace echolucent
