#include "io/dicom/pixels/dicom_fragments.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>

namespace echolucent {

namespace {

/// Which fragments begin at these offsets, counted from the first fragment's own tag; no value where an offset is not
/// where a fragment begins.
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

std::span<const std::uint8_t> bytesOf(DcmPixelItem& item) {
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

/// Which fragments begin a picture of their own by what they hold.
FragmentMap mapByCodestreams(const std::vector<DcmPixelItem*>& items, Codestream kind) {
    FragmentMap map;
    bool ended = true;
    for (std::size_t fragment = 0; fragment < items.size(); ++fragment) {
        const auto bytes = bytesOf(*items[fragment]);
        if (ended && beginsPicture(bytes, kind))
            map.push_back({fragment, 1});
        else if (!map.empty())
            ++map.back().count;
        ended = endsPicture(bytes);
    }
    return map;
}

/// The numbers of a basic offset table: 32 bits each, little endian.
std::vector<std::uint64_t> basicOffsets(DcmPixelItem& item) {
    const auto bytes = bytesOf(item);
    std::vector<std::uint64_t> offsets(bytes.size() / 4);
    for (std::size_t i = 0; i < offsets.size(); ++i)
        for (std::size_t byte = 0; byte < 4; ++byte)
            offsets[i] |= static_cast<std::uint64_t>(bytes[4 * i + byte]) << (8 * byte);
    return offsets;
}

}  // namespace

tl::expected<FrameFragments, std::string> mapFragments(DcmPixelSequence& fragments, std::int64_t frames,
                                                       Codestream kind, std::vector<std::uint64_t> extendedOffsets) {
    FrameFragments found;
    // getItem(index) would count from the first fragment each time. The first of all is the offset table.
    DcmObject* table = fragments.nextInContainer(nullptr);
    for (DcmObject* item = table; item != nullptr && (item = fragments.nextInContainer(item)) != nullptr;)
        found.items.push_back(static_cast<DcmPixelItem*>(item));
    const auto count = static_cast<std::size_t>(frames);
    const std::size_t held = found.items.size();
    if (held < count)
        return tl::unexpected(fmt::format("holds {} fragments where {} frames need at least as many", held, frames));
    if (frames == 1) {
        found.frames.push_back({0, held});
        return found;
    }
    if (held == count) {
        for (std::size_t fragment = 0; fragment < held; ++fragment) found.frames.push_back({fragment, 1});
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
        const auto piece = bytesOf(item);
        if (piece.empty() && item.getLength() > 0) return std::nullopt;
        bytes.insert(bytes.end(), piece.begin(), piece.end());
    }
    return bytes;
}

std::string jpegDisagreement(std::span<const std::uint8_t> data, const JpegFrame& expected) {
    if (data.size() < 4 || data[0] != 0xff || data[1] != 0xd8) return "has a frame that is not JPEG";
    std::size_t position = 2;
    while (position + 4 <= data.size()) {
        if (data[position] != 0xff) return "has a damaged JPEG header";
        const int marker = data[position + 1];
        if (marker == 0xff) {
            ++position;
            continue;
        }
        const bool frameHeader =
            (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc) || marker == 0xf7;
        const std::size_t length = static_cast<std::size_t>(data[position + 2] << 8 | data[position + 3]);
        if (!frameHeader) {
            if (marker == 0xda || marker == 0xd9 || length < 2) break;
            position += 2 + length;
            continue;
        }
        if (position + 10 > data.size()) break;
        const int bits = data[position + 4];
        const std::int64_t rows = data[position + 5] << 8 | data[position + 6];
        const std::int64_t columns = data[position + 7] << 8 | data[position + 8];
        const int samples = data[position + 9];
        if (rows != expected.rows || columns != expected.columns || samples != expected.samples)
            return fmt::format("has a JPEG frame of {} x {} pixels, {} sample(s), where {} x {}, {} are declared",
                               columns, rows, samples, expected.columns, expected.rows, expected.samples);
        if (bits > expected.bitsAllocated)
            return fmt::format("has a JPEG frame of {} bits where {} are allocated", bits, expected.bitsAllocated);
        // Not even an empty picture becomes smaller than this; a frame that claims to keeps decoders busy for nothing.
        if (marker != 0xf7 && rows * columns > static_cast<std::int64_t>(data.size()) * 1024)
            return fmt::format("has a JPEG frame of {} bytes for {} x {} pixels, which cannot be", data.size(), columns,
                               rows);
        return {};
    }
    return "has a JPEG frame without a frame header";
}

}  // namespace echolucent
