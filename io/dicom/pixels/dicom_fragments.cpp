#include "io/dicom/pixels/dicom_fragments.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

#include "io/dicom/elements/fragment_coding.h"

namespace echolucent {

namespace {

/// The fragments of the frames that begin at `offsets`, counted from the first fragment's own tag. No value unless each
/// offset meets the beginning of a fragment, and the first one that of the first fragment.
std::optional<FragmentMap> mapByOffsets(const std::vector<DcmPixelItem*>& items,
                                        const std::vector<std::uint64_t>& offsets) {
    FragmentMap map;
    std::uint64_t offset = 0;
    for (std::size_t fragment = 0; fragment < items.size(); ++fragment) {
        if (map.size() < offsets.size() && offsets[map.size()] == offset)
            map.push_back({fragment, 1});
        else if (map.empty())
            return std::nullopt;
        else
            ++map.back().count;
        offset += 8 + std::uint64_t{items[fragment]->getLength()};
    }
    if (map.size() != offsets.size()) return std::nullopt;
    return map;
}

std::span<const std::uint8_t> bytesOfItem(DcmPixelItem& item) {
    Uint8* data = nullptr;
    if (item.getLength() == 0 || item.getUint8Array(data).bad() || data == nullptr) return {};
    return {data, item.getLength()};
}

bool beginsPicture(std::span<const std::uint8_t> bytes, Codestream kind) {
    const auto begins = [&](std::initializer_list<std::uint8_t> signature) {
        return bytes.size() > signature.size() && std::equal(signature.begin(), signature.end(), bytes.begin());
    };
    if (kind == Codestream::jpeg) return begins({0xff, 0xd8, 0xff});
    if (kind == Codestream::jpeg2000)
        return begins({0xff, 0x4f, 0xff, 0x51}) || begins({0, 0, 0, 12, 'j', 'P', ' ', ' '});
    if (kind == Codestream::rle) return beginsWithRleHeader(bytes);
    return false;
}

/// Whether a fragment ends with the end marker that JPEG, JPEG-LS and JPEG 2000 share, with up to two bytes of padding.
bool endsPicture(std::span<const std::uint8_t> bytes) {
    for (std::size_t padding = 0; padding <= 2 && padding + 2 <= bytes.size(); ++padding) {
        const std::size_t end = bytes.size() - padding;
        if (bytes[end - 2] == 0xff && bytes[end - 1] == 0xd9) return true;
    }
    return false;
}

/// The fragments of each picture, by their content.
FragmentMap mapByCodestreams(const std::vector<DcmPixelItem*>& items, Codestream kind) {
    FragmentMap map;
    bool ended = true;
    for (std::size_t fragment = 0; fragment < items.size(); ++fragment) {
        const auto bytes = bytesOfItem(*items[fragment]);
        if (ended && beginsPicture(bytes, kind))
            map.push_back({fragment, 1});
        else if (!map.empty())
            ++map.back().count;
        if (!bytes.empty()) ended = kind == Codestream::rle || endsPicture(bytes);
    }
    return map;
}

/// The numbers of a basic offset table: 32 bits each, little endian.
std::vector<std::uint64_t> basicOffsets(DcmPixelItem& item) {
    const auto bytes = bytesOfItem(item);
    std::vector<std::uint64_t> offsets(bytes.size() / 4);
    for (std::size_t i = 0; i < offsets.size(); ++i) offsets[i] = littleEndian32(bytes.subspan(4 * i, 4));
    return offsets;
}

}  // namespace

tl::expected<FrameFragments, std::string> mapFragments(DcmPixelSequence& fragments, std::int64_t frames,
                                                       Codestream kind, std::vector<std::uint64_t> extendedOffsets) {
    FrameFragments found;
    // getItem(index) would count from the first fragment each time. The first item is the offset table.
    DcmObject* table = fragments.nextInContainer(nullptr);
    for (DcmObject* item = table; item != nullptr && (item = fragments.nextInContainer(item)) != nullptr;)
        found.items.push_back(static_cast<DcmPixelItem*>(item));
    const auto count = static_cast<std::size_t>(frames);
    const std::size_t held = found.items.size();
    if (held < count)
        return tl::unexpected(fmt::format("holds {} fragments where {} frames need at least as many", held, frames));
    if (frames == 1) {
        if (const std::size_t pictures = mapByCodestreams(found.items, kind).size(); pictures > 1)
            return tl::unexpected(fmt::format("holds {} pictures where one is declared", pictures));
        found.frames.push_back({0, held});
        return found;
    }
    std::vector<std::size_t> filled;
    for (std::size_t fragment = 0; fragment < held; ++fragment)
        if (held == count || found.items[fragment]->getLength() > 0) filled.push_back(fragment);
    if (filled.size() == count) {
        for (const std::size_t fragment : filled) found.frames.push_back({fragment, 1});
        if (held > count) found.warning = "Empty fragments among those of the pixels are left out.";
        return found;
    }
    std::vector<std::uint64_t> offsets = basicOffsets(static_cast<DcmPixelItem&>(*table));
    if (offsets.empty()) offsets = std::move(extendedOffsets);
    if (offsets.size() == count)
        if (auto map = mapByOffsets(found.items, offsets)) {
            found.frames = std::move(*map);
            return found;
        }
    found.frames = mapByCodestreams(found.items, kind);
    if (found.frames.size() == count) {
        if (!offsets.empty())
            found.warning =
                "The offset table of the pixels does not match them; the codestreams tell the frames apart.";
        return found;
    }
    if (!offsets.empty()) return tl::unexpected(std::string("has an offset table that does not match its fragments"));
    return tl::unexpected(fmt::format(
        "holds {} fragments for {} frames and no offset table that tells them apart; {} of them begin a picture", held,
        frames, found.frames.size()));
}

std::optional<std::vector<std::uint8_t>> fragmentBytes(const FrameFragments& fragments, std::size_t frame) {
    std::vector<std::uint8_t> bytes;
    const FragmentRange& range = fragments.frames[frame];
    for (std::size_t index = range.first; index < range.first + range.count; ++index) {
        DcmPixelItem& item = *fragments.items[index];
        const auto piece = bytesOfItem(item);
        if (piece.empty() && item.getLength() > 0) return std::nullopt;
        bytes.insert(bytes.end(), piece.begin(), piece.end());
    }
    return bytes;
}

}  // namespace echolucent
