#include "io/dicom/pixels/compressed_frames.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcfcache.h>
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpls/djdecode.h>
#include <fmt/format.h>

#include <algorithm>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/pixels/dicom_fragments.h"
#include "io/dicom/pixels/dicom_rle.h"
#include "io/dicom/pixels/jpeg.h"
#include "io/dicom/pixels/jpeg2000.h"
#include "io/dicom/pixels/stored_limits.h"

namespace echolucent {

namespace {

/// Compressed frames of more samples are refused. No scanner makes them, and decoders take ten bytes for each sample.
constexpr std::int64_t mostFrameSamples = std::int64_t{1} << 25;

/// Registers DCMTK's JPEG-LS decoder from the first CompressedFrames::open() to the end of the program.
struct JpegLsDecoder {
    JpegLsDecoder() { DJLSDecoderRegistration::registerCodecs(EJLSUC_default, EJLSPC_colorByPixel); }
    ~JpegLsDecoder() { DJLSDecoderRegistration::cleanup(); }
    JpegLsDecoder(const JpegLsDecoder&) = delete;
    JpegLsDecoder& operator=(const JpegLsDecoder&) = delete;
};

void registerJpegLs() { static const JpegLsDecoder decoder; }

Codestream codestreamOf(PixelCoding coding) {
    switch (coding) {
        case PixelCoding::jpeg2000: return Codestream::jpeg2000;
        case PixelCoding::jpeg:
        case PixelCoding::jpegLs: return Codestream::jpeg;
        default: return Codestream::none;
    }
}

}  // namespace

struct CompressedFrames::State {
    DcmDataset* dataset = nullptr;
    DcmPixelData* pixelData = nullptr;
    PixelCoding coding = PixelCoding::unknown;
    DicomPixelFormat format;
    FrameFragments map;  // the fragments of each frame
    DcmFileCache cache;
    std::vector<std::string> notes;

    [[nodiscard]] JpegFrame jpegFrame() const {
        return {format.columns, format.rows, format.samples, format.bitsAllocated, format.isSigned};
    }
    [[nodiscard]] Jpeg2000Frame jpeg2000Frame() const {
        return {static_cast<std::uint32_t>(format.columns), static_cast<std::uint32_t>(format.rows),
                static_cast<std::uint32_t>(format.samples), format.bitsAllocated};
    }
    [[nodiscard]] std::size_t samples() const { return static_cast<std::size_t>(format.pixels() * format.samples); }
    void note(const std::string& sentence) {
        if (std::ranges::find(notes, sentence) == notes.end()) notes.push_back(sentence);
    }
    std::string sayLimited(std::size_t limited);
    std::string decodeRleFrame(const std::vector<std::uint8_t>& data, DecodedFrame& frame) const;
    std::string decodeJpeg2000Frame(const std::vector<std::uint8_t>& data, DecodedFrame& frame);
    std::string decodeJpegFrame(std::size_t index, std::vector<std::uint8_t>& data, DecodedFrame& frame);
    std::string decodeJpegLsFrame(std::size_t index, const std::vector<std::uint8_t>& data, DecodedFrame& frame);
};

CompressedFrames::CompressedFrames(std::unique_ptr<State> state) : m_state(std::move(state)) {}
CompressedFrames::CompressedFrames(CompressedFrames&&) noexcept = default;
CompressedFrames& CompressedFrames::operator=(CompressedFrames&&) noexcept = default;
CompressedFrames::~CompressedFrames() = default;

tl::expected<CompressedFrames, std::string> CompressedFrames::open(DcmDataset& dataset, DcmPixelData& pixels,
                                                                   const DicomPixelFormat& format, PixelCoding coding) {
    registerJpegLs();
    auto state = std::make_unique<State>();
    state->dataset = &dataset;
    state->pixelData = &pixels;
    state->coding = coding;
    state->format = format;
    DcmPixelSequence* fragments = nullptr;
    if (pixels.getEncapsulatedRepresentation(dataset.getOriginalXfer(), nullptr, fragments).bad() ||
        fragments == nullptr)
        return tl::unexpected(std::string("is not split into fragments, as its transfer syntax needs"));
    std::vector<std::uint64_t> extendedOffsets;
    const Uint64* offsets = nullptr;
    unsigned long count = 0;
    if (dataset.findAndGetUint64Array(DcmTagKey(0x7fe0, 0x0001), offsets, &count).good() && offsets != nullptr)
        extendedOffsets.assign(offsets, offsets + count);
    auto mapped = mapFragments(*fragments, format.frames, codestreamOf(coding), std::move(extendedOffsets));
    if (!mapped) return tl::unexpected(mapped.error());
    state->map = std::move(*mapped);
    if (!state->map.warning.empty()) state->note(state->map.warning);
    if (format.pixels() * format.samples > mostFrameSamples)
        return tl::unexpected(fmt::format("has compressed frames of {} x {} pixels, more than any scanner makes",
                                          format.columns, format.rows));
    return CompressedFrames(std::move(state));
}

std::uint64_t CompressedFrames::heldBytes() const {
    std::uint64_t held = 0;
    for (DcmPixelItem* item : m_state->map.items) held += item->getLength();
    return held;
}

const std::vector<std::string>& CompressedFrames::notes() const { return m_state->notes; }

std::string CompressedFrames::check(std::size_t index) const {
    const auto data = fragmentBytes(m_state->map, index);
    if (!data || data->empty()) return "holds no bytes for a frame";
    const DicomPixelFormat& format = m_state->format;
    switch (m_state->coding) {
        case PixelCoding::rle:
            return rleTooShort(data->size(), static_cast<std::size_t>(format.pixels()), format.samples,
                               format.bytesPerSample());
        case PixelCoding::jpeg2000: {
            const auto sealed = sealCodestream(*data, m_state->jpeg2000Frame());
            return sealed ? std::string() : sealed.error();
        }
        default: return readJpegHeader(*data, m_state->jpegFrame()).problem;
    }
}

std::string CompressedFrames::decode(std::size_t index, DecodedFrame& frame) {
    auto data = fragmentBytes(m_state->map, index);
    if (!data || data->empty()) return "holds no bytes for a frame";
    switch (m_state->coding) {
        case PixelCoding::rle: return m_state->decodeRleFrame(*data, frame);
        case PixelCoding::jpeg2000: return m_state->decodeJpeg2000Frame(*data, frame);
        default: return m_state->decodeJpegFrame(index, *data, frame);
    }
}

/// Notes that `limited` values of a frame were limited. Says what is wrong if they are more than a hundredth of the
/// frame.
std::string CompressedFrames::State::sayLimited(std::size_t limited) {
    if (limited == 0) return {};
    const std::string bits = fmt::format("{} {} bits", format.bitsStored, format.isSigned ? "signed" : "unsigned");
    // Compression with loss overshoots at a few edges.
    if (limited > samples() / 100)
        return fmt::format("has a frame of which {} of {} values do not fit into the {} that are declared", limited,
                           samples(), bits);
    note(fmt::format("A few pixels do not fit into the {} that are declared; they hold the nearest value that does.",
                     bits));
    return {};
}

std::string CompressedFrames::State::decodeRleFrame(const std::vector<std::uint8_t>& data, DecodedFrame& frame) const {
    const auto pixels = static_cast<std::size_t>(format.pixels());
    if (auto problem = rleTooShort(data.size(), pixels, format.samples, format.bytesPerSample()); !problem.empty())
        return problem;
    frame.planar = true;
    frame.bytes.resize(samples() * static_cast<std::size_t>(format.bytesPerSample()));
    return decodeRle(data, pixels, format.samples, format.bytesPerSample(), frame.bytes);
}

std::string CompressedFrames::State::decodeJpeg2000Frame(const std::vector<std::uint8_t>& data, DecodedFrame& frame) {
    Jpeg2000Samples decoded;
    if (auto problem = decodeJpeg2000(data, jpeg2000Frame(), decoded); !problem.empty()) return problem;
    if (format.isSigned && !decoded.isSigned)
        note(
            "The JPEG 2000 frames hold unsigned values where (0028,0103) Pixel Representation declares signed ones; "
            "their bits are taken as signed.");
    frame.planar = true;
    frame.rightAligned = true;
    frame.lumaFirst = decoded.lumaFirst;
    return sayLimited(storeLimited(format, decoded, frame.bytes));
}

std::string CompressedFrames::State::decodeJpegFrame(std::size_t index, std::vector<std::uint8_t>& data,
                                                     DecodedFrame& frame) {
    const std::size_t bytes = samples() * static_cast<std::size_t>(format.bytesPerSample());
    frame.bytes.resize(bytes + bytes % 2);
    frame.rightAligned = true;
    auto problem = coding == PixelCoding::jpegLs ? decodeJpegLsFrame(index, data, frame)
                                                 : decodeJpeg(data, jpegFrame(), frame.bytes, frame.lumaFirst);
    if (!problem.empty()) return problem;
    // Old overlays use the bits above those of the pixels, so no value is limited then.
    if (dicomWholeNumber(*dataset, {0x6000, 0x0102}).value_or(0) > 0) return {};
    return sayLimited(limitToStoredBits(format, frame.bytes));
}

std::string CompressedFrames::State::decodeJpegLsFrame(std::size_t index, const std::vector<std::uint8_t>& data,
                                                       DecodedFrame& frame) {
    if (auto header = readJpegHeader(data, jpegFrame()); !header.problem.empty()) return header.problem;
    // The library counts the offset table as a fragment.
    Uint32 first = static_cast<Uint32>(map.frames[index].first + 1);
    OFString model;
    const OFCondition done =
        pixelData->getUncompressedFrame(dataset, static_cast<Uint32>(index), first, frame.bytes.data(),
                                        static_cast<Uint32>(frame.bytes.size()), model, &cache);
    if (done.bad()) return "has a JPEG-LS frame of which a part is missing or damaged";
    frame.lumaFirst = model.find("YBR") == 0;
    return {};
}

}  // namespace echolucent
