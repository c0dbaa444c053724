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

/// The entries of one colour.
struct Entries {
    std::vector<std::uint16_t> values;
    bool packed = false;  ///< whether a word held two of them, so that each has 8 bits
};

/// The three numbers of a descriptor; empty if they are not there. The number of entries has 16 bits without a sign,
/// although DICOM lets it be stored with one beside signed pixels.
std::vector<double> descriptorOf(DcmItem& item, const Colour& colour) {
    auto descriptor = dicomNumbers(item, colour.descriptor, 3);
    if (!descriptor.empty() && descriptor[0] < 0) descriptor[0] += 65536;
    return descriptor;
}

/// One colour's entries; none if `problem` says why.
Entries entriesOf(DcmItem& item, const Colour& colour, std::string& problem) {
    const auto descriptor = descriptorOf(item, colour);
    const bool segmented = !dicomHas(item, colour.plain) && dicomHas(item, colour.segmented);
    Entries entries{dicomWords(item, segmented ? colour.segmented : colour.plain)};
    problem = "is missing or too short";
    if (descriptor.empty() || entries.values.empty() || descriptor[0] < 0) return {};
    const std::size_t count =
        descriptor[0] == 0 ? mostEntries : static_cast<std::size_t>(std::min<double>(descriptor[0], mostEntries));
    if (segmented) {
        entries.packed = descriptor[2] == 8;
        auto expanded =
            expandSegments(entries.packed ? splitWords(entries.values) : entries.values, entries.packed, count);
        problem = "is stored in segments that do not give its " + std::to_string(count) + " entries";
        if (!expanded) return {};
        entries.values = std::move(*expanded);
    } else if (entries.values.size() < count) {
        entries = {splitWords(entries.values), true};
    }
    if (entries.values.size() < count) return {};
    problem.clear();
    entries.values.resize(count);
    return entries;
}

/// By how many bits words are shifted to have 8 bits. Some programs declare 16 bits and store 8, in the lower or in the
/// upper byte, others store what they declare. A single dark colour must not be taken for one of 8 bits, so all three
/// are asked.
int shiftOf(const std::array<Entries, 3>& entries, double declaredBits) {
    std::uint16_t largest = 0;
    for (const Entries& one : entries)
        if (!one.packed) largest = std::max(largest, *std::max_element(one.values.begin(), one.values.end()));
    if (largest <= 255) return 0;
    for (int bits = 9; bits < 16; ++bits)
        if (declaredBits == bits && largest < 1 << bits) return bits - 8;
    return 8;
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

std::string readPalette(DcmItem& item, bool isSigned, DicomPalette& palette) {
    std::array<Entries, 3> entries;
    std::string problem;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        entries[i] = entriesOf(item, colours[i], problem);
        if (!problem.empty()) return problem;
    }
    const auto& [red, green, blue] = entries;
    const std::size_t count = red.values.size();
    if (green.values.size() != count || blue.values.size() != count) return "has colours of different lengths";
    palette.segmented = !dicomHas(item, colours[0].plain);
    const auto descriptor = descriptorOf(item, colours[0]);
    const bool wraps = isSigned ? descriptor[1] > 32767 : descriptor[1] < 0;
    const double first = descriptor[1] + (wraps ? (isSigned ? -65536 : 65536) : 0);
    palette.first = static_cast<std::int64_t>(std::clamp(first, -65536.0, 65536.0));
    const int shift = shiftOf(entries, descriptor[2]);
    const bool allPacked = red.packed && green.packed && blue.packed;
    if (shift == 0 && !allPacked && descriptor[2] > 8)
        palette.notes.push_back("The palette declares " + std::to_string(static_cast<int>(descriptor[2])) +
                                " bits, but none of its colours exceeds 255: they were taken as 8 bits.");
    const auto valueOf = [&](const Entries& one, std::size_t i) {
        return static_cast<double>(one.packed ? one.values[i] : one.values[i] >> shift);
    };
    palette.luma.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        palette.luma[i] = lumaOf(valueOf(red, i), valueOf(green, i), valueOf(blue, i));
    return {};
}

std::string supplementalPalette(DcmItem& item) {
    if (!dicomHas(item, colours[0].plain) && !dicomHas(item, colours[0].segmented)) return {};
    const auto descriptor = dicomNumbers(item, colours[0].descriptor, 3);
    if (descriptor.empty()) return {};
    return "A supplemental palette gives colours to the pixels from " +
           std::to_string(static_cast<std::int64_t>(descriptor[1])) + " on; they are shown as grey values.";
}

}  // namespace echolucent
