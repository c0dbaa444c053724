#include "io/dicom/dicom_fragments.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

namespace echolucent {

namespace {

tl::expected<FragmentMap, std::string> mapByOffsets(DcmPixelSequence& fragments, std::int64_t frames) {
    const auto table = fragmentBytes(fragments, {0, 1});
    const std::size_t count = static_cast<std::size_t>(frames);
    if (!table || table->size() < 4 * count)
        return tl::unexpected(fmt::format("holds {} fragments for {} frames and no offset table that tells them apart",
                                          fragments.card() - 1, frames));
    FragmentMap map;
    std::uint64_t offset = 0;
    // getItem(index) would count from the first fragment each time. Fragment 0 is the offset table.
    DcmObject* item = fragments.nextInContainer(fragments.nextInContainer(nullptr));
    for (std::size_t fragment = 1; item != nullptr; ++fragment, item = fragments.nextInContainer(item)) {
        const std::uint8_t* entry = table->data() + 4 * map.size();
        const bool more = map.size() < count;
        const std::uint32_t start =
            more ? entry[0] | entry[1] << 8 | entry[2] << 16 | static_cast<std::uint32_t>(entry[3]) << 24 : 0;
        if (more && start == offset)
            map.push_back({fragment, 1});
        else if (map.empty())
            break;
        else
            ++map.back().count;
        offset += 8 + std::uint64_t{item->getLength()};
    }
    if (map.size() != count)
        return tl::unexpected(std::string("has an offset table that does not match its fragments"));
    return map;
}

}  // namespace

tl::expected<FragmentMap, std::string> mapFragments(DcmPixelSequence& fragments, std::int64_t frames) {
    const std::size_t held = fragments.card() > 0 ? fragments.card() - 1 : 0;
    if (held < static_cast<std::size_t>(frames))
        return tl::unexpected(fmt::format("holds {} fragments where {} frames need at least as many", held, frames));
    FragmentMap map;
    if (frames == 1)
        map.push_back({1, held});
    else if (held == static_cast<std::size_t>(frames))
        for (std::size_t fragment = 1; fragment <= held; ++fragment) map.push_back({fragment, 1});
    else
        return mapByOffsets(fragments, frames);
    return map;
}

std::optional<std::vector<std::uint8_t>> fragmentBytes(DcmPixelSequence& fragments, const FragmentRange& range) {
    std::vector<std::uint8_t> bytes;
    for (std::size_t index = range.first; index < range.first + range.count; ++index) {
        DcmPixelItem* item = nullptr;
        Uint8* data = nullptr;
        if (fragments.getItem(item, static_cast<unsigned long>(index)).bad() || item == nullptr) return std::nullopt;
        const std::size_t length = item->getLength();
        if (length == 0) continue;
        if (item->getUint8Array(data).bad() || data == nullptr) return std::nullopt;
        bytes.insert(bytes.end(), data, data + length);
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
