#include "io/dicom/pixels/jpeg.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmjpeg/djcparam.h>
#include <dcmtk/dcmjpeg/djdijg12.h>
#include <dcmtk/dcmjpeg/djdijg16.h>
#include <dcmtk/dcmjpeg/djdijg8.h>
#include <dcmtk/dcmjpeg/djutils.h>
#include <fmt/format.h>

#include <array>
#include <cstring>

namespace echolucent {

namespace {

constexpr int jpegLsFrame = 0xf7;
constexpr int mostScans = 100;

bool isLossless(int marker) { return marker == 0xc3 || marker == 0xc7 || marker == 0xcb || marker == 0xcf; }

bool isFrameHeader(int marker) {
    return (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc) ||
           marker == jpegLsFrame;
}

class MarkerWalk {
public:
    MarkerWalk(std::span<const std::uint8_t> data, const JpegFrame& expected) : m_data(data), m_expected(expected) {}

    JpegHeader walk() {
        if (m_data.size() < 4 || m_data[0] != 0xff || m_data[1] != 0xd8) return wrong("has a frame that is not JPEG");
        std::size_t position = 2;
        while (position + 2 <= m_data.size()) {
            if (m_data[position] != 0xff) return wrong("has a damaged JPEG header");
            const int marker = m_data[position + 1];
            if (marker == 0xff) {
                ++position;
                continue;
            }
            if (marker == 0xd9) return {end(), m_bits, colours()};
            if (position + 4 > m_data.size()) break;
            const std::size_t length = std::size_t{m_data[position + 2]} << 8 | m_data[position + 3];
            if (length < 2 || position + 2 + length > m_data.size()) break;
            if (auto problem = segment(marker, position, length); !problem.empty()) return wrong(std::move(problem));
            position += 2 + length;
            if (marker == 0xda) position = behindScan(position);
        }
        return wrong(m_frames == 0 ? "has a JPEG frame without a frame header"
                                   : "has a JPEG frame that ends before its picture does");
    }

private:
    static JpegHeader wrong(std::string problem) { return {std::move(problem), 0, {}}; }

    std::string segment(int marker, std::size_t position, std::size_t length) {
        if (marker == 0xda) {
            if (m_frames == 0) return "has a JPEG frame without a frame header";
            if (++m_scans > mostScans)
                return fmt::format("has a JPEG frame of more than {} scans, more than any encoder writes", mostScans);
        }
        if (marker == 0xe0 || marker == 0xee) application(marker, m_data.subspan(position + 4, length - 2));
        if (!isFrameHeader(marker)) return {};
        if (++m_frames > 1) return "has a JPEG frame with two frame headers";
        if (length < 8) return "has a damaged JPEG header";
        if (auto problem = frameHeader(marker, position); !problem.empty()) return problem;
        return components(m_data.subspan(position + 10, length - 8));
    }

    /// Takes what the marker of an application says of colours.
    void application(int marker, std::span<const std::uint8_t> content) {
        const auto begins = [&](const char* name) {
            return content.size() >= 5 && std::memcmp(content.data(), name, 5) == 0;
        };
        if (marker == 0xe0 && begins("JFIF")) m_jfif = true;  // with the zero byte behind it
        if (marker == 0xee && begins("Adobe") && content.size() >= 12) m_adobeTransform = content[11];
    }

    /// Takes names and sampling of the components; each has three bytes.
    std::string components(std::span<const std::uint8_t> content) {
        const auto count = static_cast<std::size_t>(m_expected.samples);
        if (content.size() < 3 * count) return "has a damaged JPEG header";
        if (count != 3) return {};
        for (std::size_t i = 0; i < count; ++i) m_names[i] = content[3 * i];
        m_subsampled = content[1] != content[4] || content[1] != content[7];
        if (m_isJpegLs && m_subsampled) return "has a JPEG-LS frame whose samples differ in size, which cannot be read";
        return {};
    }

    [[nodiscard]] StreamColours colours() const {
        if (m_expected.samples != 3 || m_isJpegLs) return {};
        const char* rgb = nullptr;
        const char* luma = nullptr;
        if (m_names == std::array<std::uint8_t, 3>{'R', 'G', 'B'}) rgb = "components called R, G and B";
        if (m_adobeTransform == 0) rgb = "APP14, colour transform 0";
        if (!m_lossless && m_subsampled) luma = "chroma of fewer samples";
        if (!m_lossless && m_jfif) luma = "the JFIF marker";
        if (m_adobeTransform == 1) luma = "APP14, colour transform 1";
        const bool numbered = m_names == std::array<std::uint8_t, 3>{1, 2, 3};
        if (rgb == nullptr && luma == nullptr && numbered && !m_lossless && m_adobeTransform < 0)
            luma = "components called 1, 2 and 3";
        if ((rgb == nullptr) == (luma == nullptr)) return {};
        return rgb != nullptr ? StreamColours{StreamColours::Kind::rgb, rgb}
                              : StreamColours{StreamColours::Kind::lumaFirst, luma};
    }

    std::string frameHeader(int marker, std::size_t position) {
        m_bits = m_data[position + 4];
        m_isJpegLs = marker == jpegLsFrame;
        m_lossless = isLossless(marker);
        const std::int64_t rows = m_data[position + 5] << 8 | m_data[position + 6];
        const std::int64_t columns = m_data[position + 7] << 8 | m_data[position + 8];
        const int samples = m_data[position + 9];
        if (rows != m_expected.rows || columns != m_expected.columns || samples != m_expected.samples)
            return fmt::format("has a JPEG frame of {} x {} pixels, {} sample(s), where {} x {}, {} are declared",
                               columns, rows, samples, m_expected.columns, m_expected.rows, m_expected.samples);
        if (m_bits > m_expected.bitsAllocated)
            return fmt::format("has a JPEG frame of {} bits where {} are allocated", m_bits, m_expected.bitsAllocated);
        // A byte holds at most 1024 pixels of JPEG, even of an empty picture, and a false size keeps decoders busy for
        // nothing. Lossless JPEG takes at least a bit for each pixel. JPEG-LS has no such bound.
        const std::int64_t mostPixels = static_cast<std::int64_t>(m_data.size()) * (isLossless(marker) ? 8 : 1024);
        if (!m_isJpegLs && rows * columns > mostPixels)
            return fmt::format("has a JPEG frame of {} bytes for {} x {} pixels, which cannot be", m_data.size(),
                               columns, rows);
        return {};
    }

    /// The place of the next marker behind coded data. Behind a data byte 0xff, JPEG has a 0, and JPEG-LS a byte whose
    /// highest bit is 0.
    [[nodiscard]] std::size_t behindScan(std::size_t position) const {
        for (; position + 2 <= m_data.size(); ++position) {
            const int next = m_data[position + 1];
            const bool restart = next >= 0xd0 && next <= 0xd7;
            const bool marker = m_isJpegLs ? next >= 0x80 : next != 0;
            if (m_data[position] == 0xff && marker && !restart && next != 0xff) return position;
        }
        return m_data.size();
    }

    [[nodiscard]] std::string end() const {
        if (m_frames == 0) return "has a JPEG frame without a frame header";
        return m_scans == 0 ? "has a JPEG frame that ends before its picture does" : "";
    }

    std::span<const std::uint8_t> m_data;
    const JpegFrame& m_expected;
    int m_bits = 0;
    int m_frames = 0;
    int m_scans = 0;
    bool m_isJpegLs = false;
    bool m_lossless = false;
    bool m_jfif = false;
    bool m_subsampled = false;
    int m_adobeTransform = -1;  // -1 if there is no such marker
    std::array<std::uint8_t, 3> m_names{};
};

/// A decoder of DCMTK that counts its warnings. DCMTK makes up missing or damaged data, goes on, and only warns.
template <typename Decoder>
class WarningCounter : public Decoder {
public:
    using Decoder::Decoder;
    void emitMessage(int level) const override {
        if (level < 0) ++m_warnings;
    }
    [[nodiscard]] int warnings() const { return m_warnings; }

private:
    mutable int m_warnings = 0;
};

template <typename Decoder>
std::string decodeBy(std::vector<std::uint8_t>& data, const JpegFrame& expected, std::span<std::uint8_t> out) {
    // Colours are not converted: the first sample of YBR is the luma.
    static const DJCodecParameter parameters(ECC_lossyYCbCr, EDC_never, EUC_default, EPC_colorByPixel);
    WarningCounter<Decoder> decoder(parameters, OFFalse);
    OFCondition done = decoder.init();
    if (done.good())
        done = decoder.decode(data.data(), static_cast<Uint32>(data.size()), out.data(),
                              static_cast<Uint32>(out.size()), expected.isSigned);
    if (done == EJ_Suspension) return "has a JPEG frame that ends before its picture does";
    if (done.bad() || decoder.warnings() > 0) return "has a JPEG frame of which a part is missing or damaged";
    return {};
}

}  // namespace

JpegHeader readJpegHeader(std::span<const std::uint8_t> data, const JpegFrame& expected) {
    return MarkerWalk(data, expected).walk();
}

std::string decodeJpeg(std::vector<std::uint8_t>& data, const JpegHeader& header, const JpegFrame& expected,
                       std::span<std::uint8_t> out) {
    if (header.bits > 12) return decodeBy<DJDecompressIJG16Bit>(data, expected, out);
    if (header.bits > 8) return decodeBy<DJDecompressIJG12Bit>(data, expected, out);
    auto problem = decodeBy<DJDecompressIJG8Bit>(data, expected, out);
    if (problem.empty() && expected.bitsAllocated == 16) widenBytes(out);
    return problem;
}

void widenBytes(std::span<std::uint8_t> values) {
    for (std::size_t i = values.size() / 2; i-- > 0;) {
        const std::uint16_t word = values[i];
        std::memcpy(values.data() + 2 * i, &word, 2);
    }
}

}  // namespace echolucent
