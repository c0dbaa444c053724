#include "io/dicom/pixels/dicom_grey.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include <fmt/format.h>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/files/header_text.h"

namespace echolucent {

namespace {

constexpr DicomTag samplesTag{0x0028, 0x0002};
constexpr DicomTag photometricTag{0x0028, 0x0004};
constexpr DicomTag planarTag{0x0028, 0x0006};
constexpr DicomTag framesTag{0x0028, 0x0008};
constexpr DicomTag rowsTag{0x0028, 0x0010};
constexpr DicomTag columnsTag{0x0028, 0x0011};
constexpr DicomTag bitsAllocatedTag{0x0028, 0x0100};
constexpr DicomTag bitsStoredTag{0x0028, 0x0101};
constexpr DicomTag highBitTag{0x0028, 0x0102};
constexpr DicomTag signTag{0x0028, 0x0103};

constexpr std::int64_t mostOfAnEdge = 65535;  // rows and columns have 16 bits

using FormatProblem = std::optional<PixelFormatProblem>;

FormatProblem formatProblemAt(DicomTag tag, const char* name, std::string text) {
    return PixelFormatProblem{tagText(tag) + " " + name, std::move(text)};
}

/// Takes the only value of an attribute into `value`, which stays if the attribute is missing or empty. Says what is
/// wrong if it is no whole number, or several.
FormatProblem take(DcmItem& item, DicomTag tag, const char* name, std::optional<std::int64_t>& value) {
    const std::string text = dicomText(item, tag);
    if (text.empty()) return std::nullopt;
    value = dicomWholeNumber(item, tag);
    if (value) return std::nullopt;
    if (text.find('\\') != std::string::npos)
        return formatProblemAt(tag, name, "holds several values where it has one: " + quotedText(text));
    return formatProblemAt(tag, name, "is no whole number: " + quotedText(text));
}

/// Takes a switch, false if the attribute is missing. Says what is wrong if the value is neither 0 nor 1.
FormatProblem takeSwitch(DcmItem& item, DicomTag tag, const char* name, bool& value) {
    std::optional<std::int64_t> number;
    if (auto problem = take(item, tag, name, number)) return problem;
    if (number.value_or(0) != 0 && *number != 1)
        return formatProblemAt(tag, name, fmt::format("is {}, where DICOM knows 0 and 1", *number));
    value = number.value_or(0) == 1;
    return std::nullopt;
}

FormatProblem takeEdge(DcmItem& item, DicomTag tag, const char* name, std::int64_t& edge) {
    std::optional<std::int64_t> number;
    if (auto problem = take(item, tag, name, number)) return problem;
    if (!number || *number < 1) return formatProblemAt(tag, name, "is missing or not above 0");
    if (*number > mostOfAnEdge) return formatProblemAt(tag, name, fmt::format("is {}, more than DICOM has", *number));
    edge = *number;
    return std::nullopt;
}

FormatProblem readShape(DcmItem& item, DicomPixelFormat& format) {
    if (auto problem = takeEdge(item, rowsTag, "Rows", format.rows)) return problem;
    if (auto problem = takeEdge(item, columnsTag, "Columns", format.columns)) return problem;
    const std::string text = dicomText(item, framesTag);
    if (text.empty()) return std::nullopt;
    const auto frames = dicomWholeNumber(item, framesTag);
    if (frames == 0) {
        format.notes.emplace_back("(0028,0008) Number of Frames is 0; it was taken as 1.");
        return std::nullopt;
    }
    if (!frames || *frames < 1 || *frames > 100000000)
        return formatProblemAt(framesTag, "Number of Frames", "is not a number above 0: " + quotedText(text));
    format.frames = *frames;
    return std::nullopt;
}

FormatProblem readBits(DcmItem& item, DicomPixelFormat& format) {
    std::optional<std::int64_t> samples, allocated, stored, high;
    if (auto problem = take(item, samplesTag, "Samples per Pixel", samples)) return problem;
    if (samples.value_or(1) != 1 && *samples != 3)
        return formatProblemAt(samplesTag, "Samples per Pixel",
                               fmt::format("is {}; only 1 and 3 can be read", *samples));
    if (auto problem = take(item, bitsAllocatedTag, "Bits Allocated", allocated)) return problem;
    if (!allocated || (*allocated != 8 && *allocated != 16))
        return formatProblemAt(bitsAllocatedTag, "Bits Allocated",
                               allocated ? fmt::format("is {}; only 8 and 16 can be read", *allocated) : "is missing");
    if (auto problem = take(item, bitsStoredTag, "Bits Stored", stored)) return problem;
    const std::int64_t used = stored.value_or(*allocated);
    if (used < 1 || used > *allocated)
        return formatProblemAt(bitsStoredTag, "Bits Stored",
                               fmt::format("is {} where {} are allocated", used, *allocated));
    if (auto problem = take(item, highBitTag, "High Bit", high)) return problem;
    const std::int64_t top = high.value_or(used - 1);
    if (top < used - 1 || top >= *allocated)
        return formatProblemAt(highBitTag, "High Bit",
                               fmt::format("is {} where {} of {} bits are stored", top, used, *allocated));
    if (top != used - 1)
        format.notes.push_back(fmt::format(
            "(0028,0102) High Bit is {}, not one below the {} bits stored: the {} bits below them were left out.", top,
            used, top + 1 - used));
    format.samples = static_cast<int>(samples.value_or(1));
    format.bitsAllocated = static_cast<int>(*allocated);
    format.bitsStored = static_cast<int>(used);
    format.highBit = static_cast<int>(top);
    if (auto problem = takeSwitch(item, signTag, "Pixel Representation", format.isSigned)) return problem;
    if (format.samples == 1) {
        const auto planar = dicomText(item, planarTag);
        if (!planar.empty() && planar != "0" && planar != "1")
            format.notes.push_back("(0028,0006) Planar Configuration is " + quotedText(planar) +
                                   ", which means nothing for one sample per pixel; it was left out.");
        return std::nullopt;
    }
    return takeSwitch(item, planarTag, "Planar Configuration", format.planar);
}

FormatProblem readColours(DcmItem& item, DicomPixelFormat& format) {
    std::string problem = readPalette(item, format.isSigned, format.palette);
    format.notes.insert(format.notes.end(), format.palette.notes.begin(), format.palette.notes.end());
    if (problem.empty()) return std::nullopt;
    return formatProblemAt({0x0028, 0x1101}, "Palette Color Lookup Table", std::move(problem));
}

FormatProblem readColour(DcmItem& item, DicomPixelFormat& format) {
    format.photometric = dicomText(item, photometricTag);
    const std::string& name = format.photometric;
    const int samples = name == "MONOCHROME1" || name == "MONOCHROME2" || name == "PALETTE COLOR" ? 1 : 3;
    if (name == "MONOCHROME1")
        format.model = ColourModel::monochrome1;
    else if (name == "MONOCHROME2" || (name.empty() && format.samples == 1))
        format.model = ColourModel::monochrome2;
    else if (name == "PALETTE COLOR")
        format.model = ColourModel::palette;
    else if (name == "RGB" || name == "YBR_RCT" || name == "YBR_ICT")
        format.model = ColourModel::rgb;
    else if (name == "YBR_FULL" || name == "YBR_FULL_422" || name == "YBR_PARTIAL_422" || name == "YBR_PARTIAL_420")
        format.model = ColourModel::lumaFirst;
    else
        return formatProblemAt(photometricTag, "Photometric Interpretation",
                               "is " + quotedText(name) + ", which cannot be read");
    if (!name.empty() && format.samples != samples)
        return formatProblemAt(samplesTag, "Samples per Pixel",
                               fmt::format("is {} where {} needs {}", format.samples, name, samples));
    if (name == "YBR_FULL_422" || name == "YBR_PARTIAL_422") format.layout = NativeLayout::halved;
    format.narrowRange = name.starts_with("YBR_PARTIAL");
    if (format.model == ColourModel::palette) return readColours(item, format);
    if (auto note = supplementalPalette(item); format.samples == 1 && !note.empty()) format.notes.push_back(note);
    return std::nullopt;
}

/// The place of the luma of pixel `index` among the samples of a frame.
std::size_t lumaIndex(const DicomPixelFormat& format, const DecodedFrame& frame, std::size_t index) {
    const auto columns = static_cast<std::size_t>(format.columns);
    switch (frame.layout) {
        case NativeLayout::halved: return index / 2 * 4 + index % 2;
        case NativeLayout::halvedRows: {
            const std::size_t column = index % columns;
            return index / columns * ((columns + 1) / 2 * 4) + column / 2 * 4 + column % 2;
        }
        default: return frame.planar ? index : index * static_cast<std::size_t>(format.samples);
    }
}

/// Reads sample `index` of the frame, using the bits that the data set names.
class SampleReader {
public:
    SampleReader(const DicomPixelFormat& format, const DecodedFrame& frame)
        : m_bytes(frame.bytes),
          m_wide(format.bytesPerSample() == 2),
          m_shift(frame.rightAligned ? 0 : format.highBit + 1 - format.bitsStored),
          m_mask((1 << format.bitsStored) - 1),
          m_sign(format.isSigned ? 1 << (format.bitsStored - 1) : 0) {}

    [[nodiscard]] int at(std::size_t index) const {
        const int value = (rawAt(index) >> m_shift) & m_mask;
        return (value ^ m_sign) - m_sign;
    }

    /// The sample with all its allocated bits.
    [[nodiscard]] int wholeAt(std::size_t index) const {
        const int raw = rawAt(index);
        const int sign = m_sign == 0 ? 0 : (m_wide ? 0x8000 : 0x80);
        return (raw ^ sign) - sign;
    }

private:
    [[nodiscard]] int rawAt(std::size_t index) const {
        if (!m_wide) return m_bytes[index];
        std::uint16_t word = 0;
        std::memcpy(&word, m_bytes.data() + 2 * index, 2);
        return word;
    }

    const std::vector<std::uint8_t>& m_bytes;
    bool m_wide;
    int m_shift;
    int m_mask;
    int m_sign;
};

}  // namespace

std::int64_t DicomPixelFormat::storedFrameBytes() const {
    switch (layout) {
        case NativeLayout::halved: return pixels() * 2 * bytesPerSample();
        case NativeLayout::halvedRows: return rows * ((columns + 1) / 2) * 4 * bytesPerSample();
        default: return pixels() * samples * bytesPerSample();
    }
}

StoredType DicomPixelFormat::greyType() const {
    if (model == ColourModel::palette) return StoredType::uint8;
    if (bitsAllocated == 8) return isSigned ? StoredType::int8 : StoredType::uint8;
    return isSigned ? StoredType::int16 : StoredType::uint16;
}

double DicomPixelFormat::smallestValue() const {
    const bool negative = isSigned && model != ColourModel::palette;
    return negative ? -static_cast<double>(1 << (bitsStored - 1)) : 0.0;
}

double DicomPixelFormat::largestValue() const {
    if (model == ColourModel::palette) return 255.0;
    return static_cast<double>((1 << (isSigned ? bitsStored - 1 : bitsStored)) - 1);
}

std::optional<PixelFormatProblem> readPixelFormat(DcmItem& item, DicomPixelFormat& format) {
    if (auto problem = readShape(item, format)) return problem;
    if (auto problem = readBits(item, format)) return problem;
    if (auto problem = readColour(item, format)) return problem;
    if (format.isSigned && format.bitsStored < 2)
        return formatProblemAt(bitsStoredTag, "Bits Stored", "is 1 for signed values");
    const bool dark = format.model == ColourModel::monochrome1;
    if (dark || format.model == ColourModel::monochrome2)
        format.padding = readPadding(item,
                                     {.dark = dark,
                                      .isSigned = format.isSigned,
                                      .bitsAllocated = format.bitsAllocated,
                                      .smallest = static_cast<int>(format.smallestValue()),
                                      .largest = static_cast<int>(format.largestValue())},
                                     format.notes);
    return std::nullopt;
}

void toGrey(const DicomPixelFormat& format, const DecodedFrame& frame, std::span<std::uint8_t> out) {
    const SampleReader sample(format, frame);
    const auto pixels = static_cast<std::size_t>(format.pixels());
    const std::size_t step = frame.planar ? 1 : static_cast<std::size_t>(format.samples);
    const std::size_t plane = frame.planar ? pixels : 1;
    const int low = format.isSigned ? -(1 << (format.bitsStored - 1)) : 0;
    const int high =
        static_cast<int>(format.isSigned ? (1 << (format.bitsStored - 1)) - 1 : (1 << format.bitsStored) - 1);
    const bool wide = bytesOf(format.greyType()) == 2;
    const ColourModel model = frame.model.value_or(format.model);
    const bool stretched = frame.narrowRange && format.bitsStored == 8 && !format.isSigned;
    for (std::size_t i = 0; i < pixels; ++i) {
        int value = 0;
        switch (model) {
            case ColourModel::monochrome2: value = sample.at(i); break;
            case ColourModel::monochrome1: value = low + high - sample.at(i); break;
            case ColourModel::palette: {
                const auto entry = std::clamp<std::int64_t>(sample.at(i) - format.palette.first, 0,
                                                            static_cast<std::int64_t>(format.palette.luma.size()) - 1);
                value = format.palette.luma[static_cast<std::size_t>(entry)];
                break;
            }
            case ColourModel::rgb:
                value = static_cast<int>(std::lround(0.299 * sample.at(i * step) + 0.587 * sample.at(i * step + plane) +
                                                     0.114 * sample.at(i * step + 2 * plane)));
                break;
            case ColourModel::lumaFirst:
                value = sample.at(lumaIndex(format, frame, i));
                if (stretched) value = std::clamp(((value - 16) * 255 + 109) / 219, 0, 255);
                break;
        }
        if (wide) {
            const auto word = static_cast<std::uint16_t>(value);
            std::memcpy(out.data() + 2 * i, &word, 2);
        } else {
            out[i] = static_cast<std::uint8_t>(value);
        }
    }
}

bool blankPadding(const DicomPixelFormat& format, const DecodedFrame& frame, std::span<std::uint8_t> out) {
    if (!format.padding) return false;
    const PixelPadding& padding = *format.padding;
    const SampleReader sample(format, frame);
    // Padding beyond the stored bits stands in all bits that are allocated.
    const bool isWide = padding.low < format.smallestValue() || padding.high > format.largestValue();
    const float none = std::numeric_limits<float>::quiet_NaN();
    bool found = false;
    for (std::size_t i = 0; i < static_cast<std::size_t>(format.pixels()); ++i) {
        if (!padding.holds(sample.at(i)) && !(isWide && padding.holds(sample.wholeAt(i)))) continue;
        std::memcpy(out.data() + i * sizeof(float), &none, sizeof(float));
        found = true;
    }
    return found;
}

}  // namespace echolucent
