#include "io/dicom/pixels/jpeg2000_codestream.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

namespace echolucent {

namespace {

using Bytes = std::span<const std::uint8_t>;
using Problem = std::optional<std::string>;

enum Marker : std::uint32_t {
    startOfCodestream = 0xff4f,
    imageSize = 0xff51,
    codingStyle = 0xff52,
    codingStyleOfComponent = 0xff53,
    tilePartLengths = 0xff55,
    packedHeadersMain = 0xff60,
    packedHeadersTile = 0xff61,
    startOfTilePart = 0xff90,
    startOfData = 0xff93,
    endOfCodestream = 0xffd9,
};

constexpr std::uint64_t mostTiles = 4096;
constexpr std::uint64_t mostPieces = 1 << 18;   // code-blocks and precincts together, over all samples
constexpr std::uint64_t mostPackets = 1 << 22;  // one a layer and precinct
constexpr std::size_t sealBytes = 512;

const char* const notJpeg2000 = "has a frame that is not JPEG 2000";
const char* const damagedHeader = "has a JPEG 2000 frame with a damaged header";

/// The big-endian number of `count` bytes at `at`. The caller has checked that they are there.
std::uint32_t number(Bytes data, std::size_t at, std::size_t count) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) value = value << 8 | data[at + i];
    return value;
}

void append(std::vector<std::uint8_t>& out, Bytes bytes) { out.insert(out.end(), bytes.begin(), bytes.end()); }

std::uint64_t ceiledShift(std::uint64_t value, unsigned bits) {
    return (value + (std::uint64_t{1} << bits) - 1) >> bits;
}

struct TilePart {
    std::uint32_t tile = 0;
    std::size_t begin = 0, end = 0;
};

class CodestreamWalk {
public:
    CodestreamWalk(Bytes data, const Jpeg2000Frame& expected) : m_data(data), m_expected(expected) {}

    Problem walk() {
        if (m_data.size() < 4 || number(m_data, 0, 2) != startOfCodestream) return notJpeg2000;
        std::size_t position = 2;
        if (auto problem = readHeader(position, m_data.size(), startOfTilePart)) return problem;
        if (m_tiles == 0) return damagedHeader;
        m_headerEnd = position;
        return readTileParts(position);
    }

    [[nodiscard]] std::vector<std::uint8_t> sealed() const {
        std::vector<std::uint8_t> out;
        out.reserve(m_data.size() + m_tiles * sealBytes);
        append(out, m_data.first(m_withoutLengthsFrom));
        append(out, m_data.subspan(m_withoutLengthsTo, m_headerEnd - m_withoutLengthsTo));
        for (std::size_t i = 0; i < m_parts.size(); ++i) {
            const TilePart& part = m_parts[i];
            const std::size_t begin = out.size();
            append(out, m_data.subspan(part.begin, part.end - part.begin));
            // Only ones: a packet that exists, but whose lengths need more bits than possible.
            if (m_lastPart[part.tile] == i)
                for (std::size_t byte = 0; byte < sealBytes; ++byte) out.push_back(byte % 2 == 0 ? 0xff : 0x7f);
            const std::size_t length = out.size() - begin;
            for (std::size_t byte = 0; byte < 4; ++byte)
                out[begin + 6 + byte] = static_cast<std::uint8_t>(length >> (24 - 8 * byte));
        }
        out.push_back(0xff);
        out.push_back(0xd9);
        return out;
    }
    [[nodiscard]] bool isSigned() const { return m_signed; }
    [[nodiscard]] int bits() const { return m_bits; }
    [[nodiscard]] bool transformsColours() const { return m_transformsColours; }
    [[nodiscard]] unsigned levels() const { return m_levels; }

private:
    /// Reads the marker segments from `position` up to the marker `last`, and leaves `position` there.
    Problem readHeader(std::size_t& position, std::size_t end, std::uint32_t last) {
        while (position + 2 <= end) {
            const std::uint32_t marker = number(m_data, position, 2);
            if (marker == last) return std::nullopt;
            if (position + 4 > end || marker < 0xff00) return damagedHeader;
            const std::size_t length = number(m_data, position + 2, 2);
            if (length < 2 || position + 2 + length > end) return damagedHeader;
            if (auto problem = readSegment(marker, m_data.subspan(position + 4, length - 2))) return problem;
            if (marker == tilePartLengths) leaveOut(position, position + 2 + length);
            position += 2 + length;
        }
        return "has a JPEG 2000 frame that ends within its header";
    }

    /// Leaves out the table of tile lengths in the main header: sealed tiles are longer, and no decoder needs the
    /// table. Only the first table is left out. A second one stays, because decoders do not read it.
    void leaveOut(std::size_t from, std::size_t to) {
        if (m_withoutLengthsTo != 0 || m_headerEnd != 0) return;
        m_withoutLengthsFrom = from;
        m_withoutLengthsTo = to;
    }

    Problem readSegment(std::uint32_t marker, Bytes segment) {
        switch (marker) {
            case imageSize: return readSize(segment);
            case codingStyle: return readCoding(segment);
            case codingStyleOfComponent:
                // The component (one byte, as there are few) and its style precede what both markers share.
                return segment.size() < 7 ? Problem(damagedHeader) : readBlocks(segment, 2, (segment[1] & 1) != 0);
            case packedHeadersMain:
            case packedHeadersTile:
                return "has a JPEG 2000 frame that keeps the headers of its packets apart, which cannot be read";
            default: return std::nullopt;
        }
    }

    Problem readSize(Bytes segment) {
        if (segment.size() < 36 || m_tiles != 0) return damagedHeader;
        const std::uint32_t right = number(segment, 2, 4), bottom = number(segment, 6, 4);
        const std::uint32_t left = number(segment, 10, 4), top = number(segment, 14, 4);
        const std::uint32_t tileWidth = number(segment, 18, 4), tileHeight = number(segment, 22, 4);
        const std::uint32_t tileLeft = number(segment, 26, 4), tileTop = number(segment, 30, 4);
        const std::uint32_t samples = number(segment, 34, 2);
        if (right <= left || bottom <= top || tileWidth == 0 || tileHeight == 0 || tileLeft > left || tileTop > top)
            return damagedHeader;
        if (right - left != m_expected.columns || bottom - top != m_expected.rows)
            return fmt::format("has a JPEG 2000 frame of {} x {} pixels where {} x {} are declared", right - left,
                               bottom - top, m_expected.columns, m_expected.rows);
        if (samples != m_expected.samples)
            return fmt::format("has a JPEG 2000 frame of {} samples where {} are declared", samples,
                               m_expected.samples);
        if (segment.size() < 36 + 3 * std::size_t{samples}) return damagedHeader;
        for (std::size_t sample = 0; sample < samples; ++sample) {
            const Bytes component = segment.subspan(36 + 3 * sample, 3);
            const int bits = (component[0] & 0x7f) + 1;
            if (bits > m_expected.bitsAllocated)
                return fmt::format("has a JPEG 2000 frame of {} bits where {} are allocated", bits,
                                   m_expected.bitsAllocated);
            if (component[1] != 1 || component[2] != 1)
                return "has a JPEG 2000 frame with subsampled or missing planes";
            m_bits = std::max(m_bits, bits);
            m_signed = m_signed || (component[0] & 0x80) != 0;
        }
        m_tilesAcross = (std::uint64_t{right} - tileLeft + tileWidth - 1) / tileWidth;
        m_tilesDown = (std::uint64_t{bottom} - tileTop + tileHeight - 1) / tileHeight;
        if (m_tilesAcross > mostTiles || m_tilesDown > mostTiles || m_tilesAcross * m_tilesDown > mostTiles)
            return fmt::format("has a JPEG 2000 frame of {} x {} tiles, more than any encoder writes", m_tilesAcross,
                               m_tilesDown);
        m_tiles = static_cast<std::size_t>(m_tilesAcross * m_tilesDown);
        return std::nullopt;
    }

    Problem readCoding(Bytes segment) {
        if (segment.size() < 10) return damagedHeader;
        m_layers = std::max<std::uint64_t>(number(segment, 2, 2), 1);
        m_transformsColours = segment[4] != 0 && m_expected.samples == 3;
        return readBlocks(segment, 5, (segment[0] & 1) != 0);
    }

    /// Counts the pieces of a component and refuses too many. Its levels, code-blocks and precincts stand in `segment`
    /// from `at` on.
    Problem readBlocks(Bytes segment, std::size_t at, bool hasPrecincts) {
        const unsigned levels = segment[at];
        const unsigned blockWidth = segment[at + 1] + 2U, blockHeight = segment[at + 2] + 2U;
        if (levels > 32 || blockWidth > 10 || blockHeight > 10 || m_tiles == 0) return damagedHeader;
        if (hasPrecincts && segment.size() < at + 5 + levels + 1) return damagedHeader;
        m_levels = std::min(m_levels, levels);
        std::uint64_t pieces = 0, precincts = 0;
        for (unsigned level = 0; level <= levels; ++level) {
            const unsigned sizes = hasPrecincts ? segment[at + 5 + level] : 0xff;
            const unsigned width = sizes & 0xf, height = sizes >> 4;
            const unsigned smaller = levels - level;
            const auto cover = [&](unsigned across, unsigned down) {
                return (ceiledShift(m_expected.columns, smaller + across) + m_tilesAcross) *
                       (ceiledShift(m_expected.rows, smaller + down) + m_tilesDown);
            };
            const unsigned halved = level > 0 ? 1 : 0;
            const auto within = [&](unsigned block, unsigned precinct) {
                return std::min(block, precinct > halved ? precinct - halved : 0U) + halved;
            };
            precincts += cover(width, height);
            pieces += cover(width, height) + cover(within(blockWidth, width), within(blockHeight, height));
        }
        if (pieces * m_expected.samples > mostPieces)
            return fmt::format("has a JPEG 2000 frame that falls into {} pieces, more than any encoder makes",
                               pieces * m_expected.samples);
        if (precincts * m_expected.samples * m_layers > mostPackets)
            return fmt::format("has a JPEG 2000 frame of {} layers in {} pieces, more than any encoder makes", m_layers,
                               precincts * m_expected.samples);
        return std::nullopt;
    }

    Problem readTileParts(std::size_t position) {
        m_lastPart.assign(m_tiles, 0);
        std::vector<bool> seen(m_tiles);
        while (position + 12 <= m_data.size() && number(m_data, position, 2) == startOfTilePart) {
            const std::uint32_t tile = number(m_data, position + 4, 2);
            std::size_t length = number(m_data, position + 6, 4);
            if (length == 0) length = m_data.size() - position - trailingBytes();
            if (number(m_data, position + 2, 2) != 10 || tile >= m_tiles || length < 14)
                return "has a JPEG 2000 frame with a damaged tile";
            if (length > m_data.size() - position)
                return fmt::format("has a JPEG 2000 frame that ends in the middle of tile {} of {}", tile + 1, m_tiles);
            std::size_t header = position + 12;
            if (auto problem = readHeader(header, position + length, startOfData)) return problem;
            m_lastPart[tile] = m_parts.size();
            m_parts.push_back({tile, position, position + length});
            seen[tile] = true;
            position += length;
        }
        const auto held = static_cast<std::size_t>(std::count(seen.begin(), seen.end(), true));
        if (held < m_tiles) return fmt::format("has a JPEG 2000 frame that holds {} of its {} tiles", held, m_tiles);
        return std::nullopt;
    }

    /// How many bytes the end marker and the padding behind it take; 0 if there is no end marker.
    [[nodiscard]] std::size_t trailingBytes() const {
        for (const std::size_t padding : {0, 1}) {
            if (m_data.size() >= padding + 2 && number(m_data, m_data.size() - padding - 2, 2) == endOfCodestream)
                return padding + 2;
        }
        return 0;
    }

    Bytes m_data;
    const Jpeg2000Frame& m_expected;
    bool m_signed = false;
    bool m_transformsColours = false;
    int m_bits = 0;
    unsigned m_levels = 32;
    std::uint64_t m_tilesAcross = 0, m_tilesDown = 0, m_layers = 1;
    std::size_t m_tiles = 0;
    std::size_t m_headerEnd = 0;
    std::size_t m_withoutLengthsFrom = 0, m_withoutLengthsTo = 0;
    std::vector<TilePart> m_parts;
    std::vector<std::size_t> m_lastPart;  // of each tile
};

/// The begin and end of the codestream in a .jp2; no value if there is none. `box` becomes the place of the box that
/// holds it.
std::optional<std::pair<std::size_t, std::size_t>> codestreamIn(Bytes jp2, std::size_t& box) {
    for (box = 0; box + 8 <= jp2.size();) {
        std::uint64_t length = number(jp2, box, 4);
        std::size_t head = 8;
        if (length == 1 && box + 16 <= jp2.size()) {
            length = std::uint64_t{number(jp2, box + 8, 4)} << 32 | number(jp2, box + 12, 4);
            head = 16;
        }
        if (length == 0 || length > jp2.size() - box) length = jp2.size() - box;
        if (length < head) return std::nullopt;
        if (number(jp2, box + 4, 4) == 0x6a703263) return std::pair{box + head, box + static_cast<std::size_t>(length)};
        box += static_cast<std::size_t>(length);
    }
    return std::nullopt;
}

}  // namespace

tl::expected<SealedCodestream, std::string> sealCodestream(Bytes data, const Jpeg2000Frame& expected) {
    constexpr std::uint8_t jp2Signature[] = {0, 0, 0, 12, 'j', 'P', ' ', ' '};
    SealedCodestream sealed;
    sealed.isJp2 = data.size() > sizeof(jp2Signature) &&
                   std::equal(std::begin(jp2Signature), std::end(jp2Signature), data.begin());
    Bytes codestream = data;
    std::size_t box = 0;
    if (sealed.isJp2) {
        const auto place = codestreamIn(data, box);
        if (!place) return tl::unexpected(std::string("has a JPEG 2000 frame without a codestream"));
        codestream = data.subspan(place->first, place->second - place->first);
    }
    CodestreamWalk walk(codestream, expected);
    if (auto problem = walk.walk()) return tl::unexpected(*std::move(problem));
    sealed.isSigned = walk.isSigned();
    sealed.bits = walk.bits();
    sealed.transformsColours = walk.transformsColours();
    sealed.levels = walk.levels();
    if (sealed.isJp2) {
        append(sealed.bytes, data.first(box));
        // A box of length 0 extends to the end.
        constexpr std::uint8_t lastBox[] = {0, 0, 0, 0, 'j', 'p', '2', 'c'};
        append(sealed.bytes, lastBox);
    }
    append(sealed.bytes, walk.sealed());
    return sealed;
}

}  // namespace echolucent
