#include "io/dicom/pixels/dicom_palette.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "io/dicom/elements/dicom_attributes.h"

namespace echolucent {

namespace {

constexpr std::size_t mostEntries = 65536;

/// Writes the segments of a palette one after the other.
class Segments {
public:
    Segments(std::span<const std::uint16_t> data, bool bytes, std::size_t count)
        : m_data(data), m_bytes(bytes), m_count(count), m_begins(data.size()) {
        m_entries.reserve(count);
    }

    /// False if a segment is malformed.
    bool expandAll() {
        std::size_t position = 0;
        // Data behind the last entry are padding.
        while (m_entries.size() < m_count)
            if (!expandOne(position, true)) return false;
        return true;
    }
    std::vector<std::uint16_t> takeEntries() { return std::move(m_entries); }

private:
    /// Expands the segment at `position`, and moves `position` behind it. False if the segment is malformed.
    bool expandOne(std::size_t& position, bool copiesAllowed) {
        if (position + 2 > m_data.size()) return false;
        const std::uint16_t kind = m_data[position];
        const std::size_t length = m_data[position + 1];
        if (length == 0) return false;
        m_begins[position] = true;
        position += 2;
        switch (kind) {
            case 0: return discrete(position, length);
            case 1: return line(position, length);
            case 2: return copiesAllowed && copy(position, length);
            default: return false;
        }
    }

    bool discrete(std::size_t& position, std::size_t length) {
        if (position + length > m_data.size() || m_entries.size() + length > m_count) return false;
        for (std::size_t i = 0; i < length; ++i) m_entries.push_back(m_data[position++]);
        return true;
    }

    /// Expands a straight line from the entry before it to its own last value.
    bool line(std::size_t& position, std::size_t length) {
        if (position + 1 > m_data.size() || m_entries.empty() || m_entries.size() + length > m_count) return false;
        const double from = m_entries.back();
        const double to = m_data[position++];
        for (std::size_t i = 1; i <= length; ++i)
            m_entries.push_back(static_cast<std::uint16_t>(
                std::lround(from + (to - from) * static_cast<double>(i) / static_cast<double>(length))));
        return true;
    }

    /// Expands `segments` segments again, from a byte offset on. These segments must not be copies themselves, so each
    /// gives at least one entry and copying ends.
    bool copy(std::size_t& position, std::size_t segments) {
        const std::size_t words = m_bytes ? 4 : 2;
        if (position + words > m_data.size()) return false;
        std::size_t offset = 0;
        for (std::size_t i = 0; i < words; ++i)
            offset |= static_cast<std::size_t>(m_data[position + i]) << (m_bytes ? 8 : 16) * i;
        const std::size_t here = position - 2;
        position += words;
        if (!m_bytes && offset % 2 != 0) return false;
        std::size_t from = m_bytes ? offset : offset / 2;
        for (std::size_t i = 0; i < segments; ++i) {
            const bool segmentThere = from < here && m_begins[from];
            if (!segmentThere || !expandOne(from, false)) return false;
        }
        return true;
    }

    std::span<const std::uint16_t> m_data;
    bool m_bytes;
    std::size_t m_count;
    std::vector<std::uint16_t> m_entries;
    std::vector<bool> m_begins;  // the places where expanded segments begin
};

/// A word holds two values of 8 bits, the lower one first.
std::vector<std::uint16_t> splitWords(const std::vector<std::uint16_t>& words) {
    std::vector<std::uint16_t> split;
    split.reserve(words.size() * 2);
    for (const std::uint16_t word : words) {
        split.push_back(word & 0xff);
        split.push_back(word >> 8);
    }
    return split;
}

struct Colour {
    DicomTag descriptor, plain, segmented;
};
constexpr std::array<Colour, 3> colours{Colour{{0x0028, 0x1101}, {0x0028, 0x1201}, {0x0028, 0x1221}},
                                        Colour{{0x0028, 0x1102}, {0x0028, 0x1202}, {0x0028, 0x1222}},
                                        Colour{{0x0028, 0x1103}, {0x0028, 0x1203}, {0x0028, 0x1223}}};

/// One colour's entries as 8-bit values; empty if `problem` says why there are none.
std::vector<std::uint8_t> entriesOf(DcmItem& item, const Colour& colour, std::string& problem) {
    const auto descriptor = dicomNumbers(item, colour.descriptor, 3);
    const bool segmented = !dicomHas(item, colour.plain) && dicomHas(item, colour.segmented);
    auto words = dicomWords(item, segmented ? colour.segmented : colour.plain);
    problem = "is missing or too short";
    if (descriptor.empty() || words.empty() || descriptor[0] < 0) return {};
    const std::size_t count =
        descriptor[0] == 0 ? mostEntries : static_cast<std::size_t>(std::min<double>(descriptor[0], mostEntries));
    if (segmented) {
        const bool bytes = descriptor[2] == 8;
        auto expanded = expandSegments(bytes ? splitWords(words) : words, bytes, count);
        problem = "is stored in segments that do not give its " + std::to_string(count) + " entries";
        if (!expanded) return {};
        words = std::move(*expanded);
    } else if (words.size() < count) {
        words = splitWords(words);
    }
    if (words.size() < count) return {};
    problem.clear();
    // Some programs declare 16 bits and store 8.
    const bool high = std::any_of(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(count),
                                  [](std::uint16_t word) { return word > 255; });
    std::vector<std::uint8_t> entries(count);
    std::transform(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(count), entries.begin(),
                   [high](std::uint16_t word) { return static_cast<std::uint8_t>(high ? word >> 8 : word); });
    return entries;
}

std::uint8_t lumaOf(double red, double green, double blue) {
    return static_cast<std::uint8_t>(std::lround(0.299 * red + 0.587 * green + 0.114 * blue));
}

}  // namespace

std::optional<std::vector<std::uint16_t>> expandSegments(std::span<const std::uint16_t> data, bool bytes,
                                                         std::size_t count) {
    Segments segments(data, bytes, count);
    if (!segments.expandAll()) return std::nullopt;
    return segments.takeEntries();
}

std::string readPalette(DcmItem& item, DicomPalette& palette) {
    std::array<std::vector<std::uint8_t>, 3> entries;
    std::string problem;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        entries[i] = entriesOf(item, colours[i], problem);
        if (!problem.empty()) return problem;
    }
    const auto& [red, green, blue] = entries;
    if (green.size() != red.size() || blue.size() != red.size()) return "has colours of different lengths";
    palette.segmented = !dicomHas(item, colours[0].plain);
    palette.first =
        static_cast<std::int64_t>(std::clamp(dicomNumbers(item, colours[0].descriptor, 3)[1], -65536.0, 65536.0));
    palette.luma.resize(red.size());
    for (std::size_t i = 0; i < red.size(); ++i) palette.luma[i] = lumaOf(red[i], green[i], blue[i]);
    return {};
}

}  // namespace echolucent
