#include "io/dicom/elements/fragment_coding.h"

#include <algorithm>
#include <initializer_list>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcuid.h>

namespace echolucent {

namespace {

/// The transfer syntax of a JPEG file, by the marker of its first frame. That of baseline JPEG if the bytes hold no
/// frame.
std::string syntaxOfJpeg(std::span<const std::uint8_t> bytes) {
    for (std::size_t at = 2; at + 4 <= bytes.size() && bytes[at] == 0xff;) {
        const std::uint8_t marker = bytes[at + 1];
        if (marker == 0xf7) return UID_JPEGLSLosslessTransferSyntax;
        if (marker == 0xc3) return UID_JPEGProcess14SV1TransferSyntax;
        if (marker == 0xc1) return UID_JPEGProcess2_4TransferSyntax;
        if (marker == 0xc0) return UID_JPEGProcess1TransferSyntax;
        // A marker may be preceded by bytes of 0xff.
        at += marker == 0xff ? 1 : 2 + static_cast<std::size_t>(bytes[at + 2] << 8 | bytes[at + 3]);
    }
    return UID_JPEGProcess1TransferSyntax;
}

}  // namespace

std::uint32_t littleEndian32(std::span<const std::uint8_t> bytes) {
    return bytes[0] | bytes[1] << 8 | bytes[2] << 16 | static_cast<std::uint32_t>(bytes[3]) << 24;
}

bool beginsWithRleHeader(std::span<const std::uint8_t> bytes) {
    constexpr std::size_t header = 64, mostSegments = 15;
    if (bytes.size() <= header) return false;
    const std::uint32_t segments = littleEndian32(bytes);
    if (segments < 1 || segments > mostSegments || littleEndian32(bytes.subspan(4)) != header) return false;
    for (std::size_t segment = 1; segment < mostSegments; ++segment) {
        const std::uint32_t before = littleEndian32(bytes.subspan(4 * segment));
        const std::uint32_t offset = littleEndian32(bytes.subspan(4 + 4 * segment));
        if (segment < segments ? offset <= before : offset != 0) return false;
    }
    return true;
}

std::string syntaxOfFragment(std::span<const std::uint8_t> bytes) {
    const auto begins = [&](std::initializer_list<std::uint8_t> signature) {
        return bytes.size() > signature.size() && std::equal(signature.begin(), signature.end(), bytes.begin());
    };
    if (begins({0xff, 0xd8, 0xff})) return syntaxOfJpeg(bytes);
    if (begins({0xff, 0x4f, 0xff, 0x51}) || begins({0, 0, 0, 12, 'j', 'P', ' ', ' '}))
        return UID_JPEG2000TransferSyntax;
    return beginsWithRleHeader(bytes) ? UID_RLELosslessTransferSyntax : std::string();
}

}  // namespace echolucent
