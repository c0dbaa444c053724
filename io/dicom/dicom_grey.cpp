#include "io/dicom/dicom_grey.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/format.h>

#include "io/dicom/dicom_attributes.h"
#include "io/headers/header_text.h"
#include "io/input_file.h"

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

constexpr std::int64_t mostPixels = 65535;  // rows and columns have 16 bits

using Problem = std::optional<PixelFormatProblem>;

Problem problemAt(DicomTag tag, const char* name, std::string text) {
    return PixelFormatProblem{tagText(tag) + " " + name, std::move(text)};
}

Problem readShape(DcmItem& item, DicomPixelFormat& format) {
    const auto rows = dicomWholeNumber(item, rowsTag);
    const auto columns = dicomWholeNumber(item, columnsTag);
    if (!rows || *rows < 1) return problemAt(rowsTag, "Rows", "is missing or not above 0");
    if (!columns || *columns < 1) return problemAt(columnsTag, "Columns", "is missing or not above 0");
    if (*rows > mostPixels) return problemAt(rowsTag, "Rows", fmt::format("is {}, more than DICOM has", *rows));
    if (*columns > mostPixels)
        return problemAt(columnsTag, "Columns", fmt::format("is {}, more than DICOM has", *columns));
    format.rows = *rows;
    format.columns = *columns;
    if (!dicomText(item, framesTag).empty()) {
        const auto frames = dicomWholeNumber(item, framesTag);
        const bool several = dicomText(item, framesTag).find('\\') != std::string::npos;
        if (!frames || several || *frames < 1 || *frames > 100000000)
            return problemAt(framesTag, "Number of Frames",
                             "is not a number above 0: " + quotedText(dicomText(item, framesTag)));
        format.frames = *frames;
    }
    return std::nullopt;
}

Problem readBits(DcmItem& item, DicomPixelFormat& format) {
    const auto samples = dicomWholeNumber(item, samplesTag).value_or(1);
    if (samples != 1 && samples != 3)
        return problemAt(samplesTag, "Samples per Pixel", fmt::format("is {}; only 1 and 3 can be read", samples));
    const auto allocated = dicomWholeNumber(item, bitsAllocatedTag);
    if (!allocated || (*allocated != 8 && *allocated != 16))
        return problemAt(bitsAllocatedTag, "Bits Allocated",
                         allocated ? fmt::format("is {}; only 8 and 16 can be read", *allocated) : "is missing");
    const auto stored = dicomWholeNumber(item, bitsStoredTag).value_or(*allocated);
    if (stored < 1 || stored > *allocated)
        return problemAt(bitsStoredTag, "Bits Stored", fmt::format("is {} where {} are allocated", stored, *allocated));
    const auto high = dicomWholeNumber(item, highBitTag).value_or(stored - 1);
    if (high < stored - 1 || high >= *allocated)
        return problemAt(highBitTag, "High Bit",
                         fmt::format("is {} where {} of {} bits are stored", high, stored, *allocated));
    format.samples = static_cast<int>(samples);
    format.bitsAllocated = static_cast<int>(*allocated);
    format.bitsStored = static_cast<int>(stored);
    format.highBit = static_cast<int>(high);
    const auto sign = dicomWholeNumber(item, signTag).value_or(0);
    if (sign != 0 && sign != 1)
        return problemAt(signTag, "Pixel Representation", fmt::format("is {}; only 0 and 1 mean something", sign));
    const auto planar = samples == 3 ? dicomWholeNumber(item, planarTag).value_or(0) : 0;
    if (planar != 0 && planar != 1)
        return problemAt(planarTag, "Planar Configuration", fmt::format("is {}; only 0 and 1 mean something", planar));
    format.isSigned = sign == 1;
    format.planar = planar == 1;
    return std::nullopt;
}

Problem readColours(DcmItem& item, DicomPixelFormat& format) {
    std::string problem = readPalette(item, format.palette);
    if (problem.empty()) return std::nullopt;
    return problemAt({0x0028, 0x1101}, "Palette Color Lookup Table", std::move(problem));
}

Problem readColour(DcmItem& item, DicomPixelFormat& format) {
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
        return problemAt(photometricTag, "Photometric Interpretation",
                         "is " + quotedText(name) + ", which cannot be read");
    if (!name.empty() && format.samples != samples)
        return problemAt(samplesTag, "Samples per Pixel",
                         fmt::format("is {} where {} needs {}", format.samples, name, samples));
    format.halved = name == "YBR_FULL_422" || name == "YBR_PARTIAL_422";
    return format.model == ColourModel::palette ? readColours(item, format) : std::nullopt;
}

/// Sample `index` of the frame with the bits the data set says are in use.
class SampleReader {
public:
    SampleReader(const DicomPixelFormat& format, const DecodedFrame& frame)
        : m_bytes(frame.bytes),
          m_wide(format.bytesPerSample() == 2),
          m_shift(frame.rightAligned ? 0 : format.highBit + 1 - format.bitsStored),
          m_mask((1 << format.bitsStored) - 1),
          m_sign(format.isSigned ? 1 << (format.bitsStored - 1) : 0) {}

    [[nodiscard]] int at(std::size_t index) const {
        int raw = 0;
        if (m_wide) {
            std::uint16_t word = 0;
            std::memcpy(&word, m_bytes.data() + 2 * index, 2);
            raw = word;
        } else {
            raw = m_bytes[index];
        }
        const int value = (raw >> m_shift) & m_mask;
        return (value ^ m_sign) - m_sign;
    }

private:
    const std::vector<std::uint8_t>& m_bytes;
    bool m_wide;
    int m_shift;
    int m_mask;
    int m_sign;
};

}  // namespace

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
        return problemAt(bitsStoredTag, "Bits Stored", "is 1 for signed values");
    return std::nullopt;
}

std::optional<PixelFormatProblem> missingPixels(const DicomPixelFormat& format, std::uint64_t held) {
    if (held == 0) return PixelFormatProblem{"(7fe0,0010) Pixel Data", "is there but empty"};
    const auto needed = checkedProduct(format.storedFrameBytes(), format.frames);
    // DICOM counts in 32 bits: no file can hold more.
    if (needed && static_cast<std::uint64_t>(*needed) <= held && *needed <= 0xfffffffeLL) return std::nullopt;
    return PixelFormatProblem{
        "(7fe0,0010) Pixel Data",
        fmt::format("holds {} bytes where {} x {} pixels in {} frame(s) need {}", held, format.columns, format.rows,
                    format.frames, needed ? std::to_string(*needed) : "more than can be counted")};
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
    const ColourModel model = frame.lumaFirst && format.samples == 3 ? ColourModel::lumaFirst : format.model;
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
            case ColourModel::lumaFirst: value = sample.at(frame.halved ? i / 2 * 4 + i % 2 : i * step); break;
        }
        if (wide) {
            const auto word = static_cast<std::uint16_t>(value);
            std::memcpy(out.data() + 2 * i, &word, 2);
        } else {
            out[i] = static_cast<std::uint8_t>(value);
        }
    }
}

}  // namespace echolucent
