#include "io/dicom/pixels/jpeg.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmjpeg/djcparam.h>
#include <dcmtk/dcmjpeg/djdijg12.h>
#include <dcmtk/dcmjpeg/djdijg16.h>
#include <dcmtk/dcmjpeg/djdijg8.h>
#include <dcmtk/dcmjpeg/djutils.h>
#include <fmt/format.h>

namespace echolucent {

namespace {

constexpr int jpegLsFrame = 0xf7;
constexpr int losslessFrame = 0xc3;
constexpr int mostScans = 100;

bool isFrameHeader(int marker) {
    return (marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc) ||
           marker == jpegLsFrame;
}

class MarkerWalk {
public:
    MarkerWalk(std::span<const std::uint8_t> data, const JpegFrame& expected) : m_data(data), m_expected(expected) {}

    JpegHeader walk() {
        if (m_data.size() < 4 || m_data[0] != 0xff || m_data[1] != 0xd8) return {"has a frame that is not JPEG", 0};
        std::size_t position = 2;
        while (position + 2 <= m_data.size()) {
            if (m_data[position] != 0xff) return {"has a damaged JPEG header", 0};
            const int marker = m_data[position + 1];
            if (marker == 0xff) {
                ++position;
                continue;
            }
            if (marker == 0xd9) return {end(), m_bits};
            if (position + 4 > m_data.size()) break;
            const std::size_t length = std::size_t{m_data[position + 2]} << 8 | m_data[position + 3];
            if (length < 2 || position + 2 + length > m_data.size()) break;
            if (auto problem = segment(marker, position, length); !problem.empty()) return {std::move(problem), 0};
            position += 2 + length;
            if (marker == 0xda) position = behindScan(position);
        }
        return {m_frames == 0 ? "has a JPEG frame without a frame header"
                              : "has a JPEG frame that ends before its picture does",
                0};
    }

private:
    std::string segment(int marker, std::size_t position, std::size_t length) {
        if (marker == 0xda) {
            if (m_frames == 0) return "has a JPEG frame without a frame header";
            if (++m_scans > mostScans)
                return fmt::format("has a JPEG frame of more than {} scans, more than any encoder writes", mostScans);
        }
        if (!isFrameHeader(marker)) return {};
        if (++m_frames > 1) return "has a JPEG frame with two frame headers";
        return length < 8 ? "has a damaged JPEG header" : frameHeader(marker, position);
    }

    std::string frameHeader(int marker, std::size_t position) {
        m_bits = m_data[position + 4];
        m_isJpegLs = marker == jpegLsFrame;
        const std::int64_t rows = m_data[position + 5] << 8 | m_data[position + 6];
        const std::int64_t columns = m_data[position + 7] << 8 | m_data[position + 8];
        const int samples = m_data[position + 9];
        if (rows != m_expected.rows || columns != m_expected.columns || samples != m_expected.samples)
            return fmt::format("has a JPEG frame of {} x {} pixels, {} sample(s), where {} x {}, {} are declared",
                               columns, rows, samples, m_expected.columns, m_expected.rows, m_expected.samples);
        if (m_bits > m_expected.bitsAllocated || (m_bits <= 8) != (m_expected.bitsAllocated == 8))
            return fmt::format("has a JPEG frame of {} bits where {} are allocated", m_bits, m_expected.bitsAllocated);
        // A byte holds at most 1024 pixels of JPEG, even of an empty picture, and a false size keeps decoders busy for
        // nothing. Lossless JPEG takes at least a bit for each pixel. JPEG-LS has no such bound.
        const std::int64_t mostPixels = static_cast<std::int64_t>(m_data.size()) * (marker == losslessFrame ? 8 : 1024);
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
std::string decodeBy(std::vector<std::uint8_t>& data, const JpegFrame& expected, std::span<std::uint8_t> out,
                     bool& lumaFirst) {
    // Colours are not converted: the first sample of YBR is the luma.
    static const DJCodecParameter parameters(ECC_lossyYCbCr, EDC_never, EUC_default, EPC_colorByPixel);
    WarningCounter<Decoder> decoder(parameters, OFFalse);
    OFCondition done = decoder.init();
    if (done.good())
        done = decoder.decode(data.data(), static_cast<Uint32>(data.size()), out.data(),
                              static_cast<Uint32>(out.size()), expected.isSigned);
    if (done == EJ_Suspension) return "has a JPEG frame that ends before its picture does";
    if (done.bad() || decoder.warnings() > 0) return "has a JPEG frame of which a part is missing or damaged";
    const EP_Interpretation model = decoder.getDecompressedColorModel();
    lumaFirst = model == EPI_YBR_Full || model == EPI_YBR_Full_422 || model == EPI_YBR_Partial_422;
    return {};
}

}  // namespace

JpegHeader readJpegHeader(std::span<const std::uint8_t> data, const JpegFrame& expected) {
    return MarkerWalk(data, expected).walk();
}

std::string decodeJpeg(std::vector<std::uint8_t>& data, const JpegFrame& expected, std::span<std::uint8_t> out,
                       bool& lumaFirst) {
    const JpegHeader header = readJpegHeader(data, expected);
    if (!header.problem.empty()) return header.problem;
    if (header.bits > 12) return decodeBy<DJDecompressIJG16Bit>(data, expected, out, lumaFirst);
    if (header.bits > 8) return decodeBy<DJDecompressIJG12Bit>(data, expected, out, lumaFirst);
    return decodeBy<DJDecompressIJG8Bit>(data, expected, out, lumaFirst);
}

}  // namespace echolucent
