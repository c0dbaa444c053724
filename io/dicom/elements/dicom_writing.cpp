#include "io/dicom/elements/dicom_writing.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <span>
#include <utility>

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dctk.h>

namespace echolucent {

namespace {

bool isKnown(std::uint32_t tag) {
    return DcmTag(static_cast<Uint16>(tag >> 16), static_cast<Uint16>(tag & 0xffff)).error().good();
}

bool isRepresentation(std::string_view letters) {
    return std::isalpha(static_cast<unsigned char>(letters[0])) != 0 &&
           std::isalpha(static_cast<unsigned char>(letters[1])) != 0 &&
           DcmVR(std::string(letters.substr(0, 2)).c_str()).isStandard();
}

struct ElementHeader {
    std::uint32_t tag = 0;
    std::uint64_t end = 0;  ///< the position behind the value
    bool endless = false;   ///< whether the length is undefined
};

/// The element that is so written at `position`; no value if none can be.
std::optional<ElementHeader> headerAt(const InputFile& file, std::uint64_t position, const DicomWriting& writing) {
    std::array<std::uint8_t, 12> bytes{};
    if (position > file.size() || file.size() - position < 8) return std::nullopt;
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), file.size() - position));
    if (!file.readAt(position, std::span(bytes).first(count))) return std::nullopt;
    const auto word = [&](std::size_t at) -> std::uint32_t {
        return writing.bigEndian ? bytes[at] << 8 | bytes[at + 1] : bytes[at + 1] << 8 | bytes[at];
    };
    const auto longWord = [&](std::size_t at) {
        return writing.bigEndian ? word(at) << 16 | word(at + 2) : word(at + 2) << 16 | word(at);
    };
    const std::string_view letters(reinterpret_cast<const char*>(bytes.data()) + 4, 2);
    // No true value that stands first is as long as two letters would say.
    if (isRepresentation(letters) == writing.implicitVr) return std::nullopt;
    ElementHeader header{word(0) << 16 | word(2)};
    std::uint32_t length = 0;
    std::uint64_t value = position + 8;
    if (writing.implicitVr) {
        length = longWord(4);
    } else if (!DcmVR(std::string(letters).c_str()).usesExtendedLengthEncoding()) {
        length = word(6);
    } else {
        if (count < bytes.size()) return std::nullopt;
        length = longWord(8);
        value += 4;
    }
    header.endless = length == 0xffffffffU;
    header.end = value + length;
    if (!header.endless && header.end > file.size()) return std::nullopt;
    return header;
}

/// Whether a data set that begins at `start` may be so written, as far as two elements tell.
bool fits(const InputFile& file, std::uint64_t start, const DicomWriting& writing) {
    const auto first = headerAt(file, start, writing);
    if (!first || !isKnown(first->tag) || first->tag >> 16 == 0 || first->tag >> 16 > 0xff) return false;
    if (first->endless || first->end == file.size()) return true;
    const auto second = headerAt(file, first->end, writing);
    return second && second->tag > first->tag && (isKnown(second->tag) || second->tag >> 16 <= 0xff);
}

/// Whether deflated data may begin at `start`. What begins like a tag would be a block of stored bytes, whose length
/// stands there twice.
bool mayBeDeflated(const InputFile& file, std::uint64_t start) {
    std::array<std::uint8_t, 5> bytes{};
    if (!file.readAt(start, bytes)) return true;
    const bool stored = (bytes[0] & 6) == 0;
    return !stored || ((bytes[1] ^ bytes[3]) == 0xff && (bytes[2] ^ bytes[4]) == 0xff);
}

}  // namespace

std::uint32_t swappedTag(std::uint32_t tag) {
    return (tag >> 16 & 0xff) << 24 | (tag >> 24 & 0xff) << 16 | (tag & 0xff) << 8 | (tag >> 8 & 0xff);
}

std::optional<DicomWriting> statedWriting(const std::string& transferSyntax) {
    const DcmXfer syntax(transferSyntax.c_str());
    // DCMTK knows a syntax with an empty identifier.
    if (transferSyntax.empty() || syntax.getXfer() == EXS_Unknown) return std::nullopt;
    return DicomWriting{syntax.isImplicitVR() != OFFalse, syntax.isBigEndian() != OFFalse,
                        syntax.getStreamCompression() == ESC_zlib};
}

DicomWriting guessedWriting(std::uint32_t tag, std::string_view letters) {
    DicomWriting writing;
    writing.implicitVr = !isRepresentation(letters);
    const std::uint32_t big = swappedTag(tag);
    const bool knownAsLittle = isKnown(tag), knownAsBig = isKnown(big);
    if (knownAsLittle != knownAsBig)
        writing.bigEndian = knownAsBig;
    else
        writing.bigEndian = tag >> 16 > 0xff && big >> 16 <= 0xff;
    return writing;
}

std::string contradictingSyntax(const InputFile& file, std::uint64_t start, const DicomWriting& stated) {
    if (stated.deflated ? mayBeDeflated(file, start) : fits(file, start, stated)) return {};
    static const std::array<std::pair<DicomWriting, const char*>, 3> writings{{
        {{false, false, false}, UID_LittleEndianExplicitTransferSyntax},
        {{true, false, false}, UID_LittleEndianImplicitTransferSyntax},
        {{false, true, false}, UID_BigEndianExplicitTransferSyntax},
    }};
    for (const auto& [writing, syntax] : writings)
        if (writing != stated && fits(file, start, writing)) return syntax;
    return {};
}

}  // namespace echolucent
