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
#include <set>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/pixels/dicom_fragments.h"
#include "io/dicom/pixels/dicom_rle.h"
#include "io/dicom/pixels/jpeg.h"
#include "io/dicom/pixels/jpeg2000.h"
#include "io/dicom/pixels/jpeg_ls_bytes.h"
#include "io/dicom/pixels/stored_limits.h"
#include "io/study/study_assembly.h"

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
        case PixelCoding::rle: return Codestream::rle;
        case PixelCoding::jpeg:
        case PixelCoding::jpegLs: return Codestream::jpeg;
        default: return Codestream::none;
    }
}

/// A sentence, and the frames that it is true of.
struct FrameNote {
    std::string sentence;
    std::set<std::size_t> frames{};
};

}  // namespace

struct CompressedFrames::State {
    DcmDataset* dataset = nullptr;
    DcmPixelData* pixelData = nullptr;
    PixelCoding coding = PixelCoding::unknown;
    DicomPixelFormat format;
    FrameFragments map;  // the fragments of each frame
    DcmFileCache cache;
    std::vector<FrameNote> notes;
    std::size_t decoding = 0;       // the frame that is decoded
    std::vector<bool> decodedOnce;  // of each frame

    [[nodiscard]] JpegFrame jpegFrame() const {
        return {format.columns, format.rows, format.samples, format.bitsAllocated, format.isSigned};
    }
    [[nodiscard]] Jpeg2000Frame jpeg2000Frame() const {
        return {static_cast<std::uint32_t>(format.columns), static_cast<std::uint32_t>(format.rows),
                static_cast<std::uint32_t>(format.samples), format.bitsAllocated};
    }
    [[nodiscard]] std::size_t samples() const { return static_cast<std::size_t>(format.pixels() * format.samples); }
    /// Notes something of the frame that is decoded.
    void note(const std::string& sentence) {
        auto known = std::ranges::find(notes, sentence, &FrameNote::sentence);
        if (known == notes.end()) known = notes.insert(notes.end(), {sentence, {}});
        known->frames.insert(decoding);
    }
    void takeColours(const StreamColours& said, const char* what, DecodedFrame& frame);
    /// Notes that frames have another number of bits than Bits Stored.
    void sayBits(const char* what, int bits);
    std::string decodeFrame(std::vector<std::uint8_t>& data, DecodedFrame& frame);
    std::string sayLimited(std::size_t limited);
    std::string decodeRleFrame(const std::vector<std::uint8_t>& data, DecodedFrame& frame);
    std::string decodeJpeg2000Frame(const std::vector<std::uint8_t>& data, DecodedFrame& frame);
    std::string decodeJpegFrame(std::vector<std::uint8_t>& data, DecodedFrame& frame);
    std::string decodeJpegLsFrame(const std::vector<std::uint8_t>& data, const JpegHeader& header, DecodedFrame& frame);
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
    state->decodedOnce.resize(static_cast<std::size_t>(format.frames));
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

std::vector<std::string> CompressedFrames::notes() const {
    std::vector<std::string> sentences;
    if (!m_state->map.warning.empty()) sentences.push_back(m_state->map.warning);
    const auto decoded = static_cast<std::size_t>(std::ranges::count(m_state->decodedOnce, true));
    for (const FrameNote& note : m_state->notes)
        sentences.push_back(saidOf(note.sentence, note.frames.size(), decoded, "frames"));
    return sentences;
}

std::string CompressedFrames::check(std::size_t index) const {
    const auto data = fragmentBytes(m_state->map, index);
    if (!data || data->empty()) return "holds no bytes for a frame";
    const DicomPixelFormat& format = m_state->format;
    switch (m_state->coding) {
        case PixelCoding::rle:
            return rleTooShort(data->size(), static_cast<std::size_t>(format.pixels()), format.samples,
                               rleBytesPerSample(*data, format.samples, format.bytesPerSample()));
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
    m_state->decoding = index;
    m_state->decodedOnce[index] = true;
    return m_state->decodeFrame(*data, frame);
}

std::string CompressedFrames::State::decodeFrame(std::vector<std::uint8_t>& data, DecodedFrame& frame) {
    switch (coding) {
        case PixelCoding::rle: return decodeRleFrame(data, frame);
        case PixelCoding::jpeg2000: return decodeJpeg2000Frame(data, frame);
        default: return decodeJpegFrame(data, frame);
    }
}

/// Takes the colours that a codestream states, and notes if the data set states others.
void CompressedFrames::State::takeColours(const StreamColours& said, const char* what, DecodedFrame& frame) {
    if (said.kind == StreamColours::Kind::unsaid || format.samples != 3) return;
    const bool rgb = said.kind == StreamColours::Kind::rgb;
    frame.model = rgb ? ColourModel::rgb : ColourModel::lumaFirst;
    if (frame.model == format.model) return;
    note(fmt::format(
        "(0028,0004) Photometric Interpretation is {}, but the {} frames hold {} ({}): they were read as that.",
        format.photometric, what, rgb ? "red, green and blue" : "luma and colour differences", said.source));
}

void CompressedFrames::State::sayBits(const char* what, int bits) {
    note(fmt::format("The {} frames hold {} bits where (0028,0101) Bits Stored says {}.", what, bits,
                     format.bitsStored));
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

std::string CompressedFrames::State::decodeRleFrame(const std::vector<std::uint8_t>& data, DecodedFrame& frame) {
    const auto pixels = static_cast<std::size_t>(format.pixels());
    const int width = rleBytesPerSample(data, format.samples, format.bytesPerSample());
    if (auto problem = rleTooShort(data.size(), pixels, format.samples, width); !problem.empty()) return problem;
    frame.planar = true;
    frame.bytes.resize(samples() * static_cast<std::size_t>(std::max(width, format.bytesPerSample())));
    const auto coded = std::span(frame.bytes).first(samples() * static_cast<std::size_t>(width));
    if (auto problem = decodeRle(data, pixels, format.samples, width, coded); !problem.empty()) return problem;
    if (width == format.bytesPerSample()) return {};
    frame.rightAligned = true;
    if (width < format.bytesPerSample()) {
        widenBytes(frame.bytes);
        note("The RLE frames hold 8 bits where (0028,0100) Bits Allocated says 16.");
        return {};
    }
    for (std::size_t i = 0; i < samples(); ++i) {
        if (frame.bytes[2 * i + 1] != 0) return "has an RLE frame of 16 bits where 8 are allocated";
        frame.bytes[i] = frame.bytes[2 * i];
    }
    note("The RLE frames hold 16 bits where (0028,0100) Bits Allocated says 8; the upper ones are 0.");
    return {};
}

std::string CompressedFrames::State::decodeJpeg2000Frame(const std::vector<std::uint8_t>& data, DecodedFrame& frame) {
    Jpeg2000Samples decoded;
    if (auto problem = decodeJpeg2000(data, jpeg2000Frame(), decoded); !problem.empty()) return problem;
    if (format.isSigned && !decoded.isSigned)
        note(
            "The JPEG 2000 frames hold unsigned values where (0028,0103) Pixel Representation declares signed ones; "
            "their bits are taken as signed.");
    if (!format.isSigned && decoded.isSigned)
        note(
            "The JPEG 2000 frames hold signed values where (0028,0103) Pixel Representation declares unsigned ones; "
            "what lies below 0 was raised to it.");
    if (decoded.bits != format.bitsStored) sayBits("JPEG 2000", decoded.bits);
    if (decoded.colours.kind == StreamColours::Kind::unsaid &&
        (format.photometric == "YBR_RCT" || format.photometric == "YBR_ICT"))
        note(
            fmt::format("(0028,0004) Photometric Interpretation is {}, but the JPEG 2000 frames have no component "
                        "transform: they were read as red, green and blue.",
                        format.photometric));
    frame.planar = true;
    frame.rightAligned = true;
    takeColours(decoded.colours, "JPEG 2000", frame);
    return sayLimited(storeLimited(format, decoded, frame.bytes));
}

std::string CompressedFrames::State::decodeJpegFrame(std::vector<std::uint8_t>& data, DecodedFrame& frame) {
    const JpegHeader header = readJpegHeader(data, jpegFrame());
    if (!header.problem.empty()) return header.problem;
    const std::size_t bytes = samples() * static_cast<std::size_t>(format.bytesPerSample());
    frame.bytes.resize(bytes + bytes % 2);
    frame.rightAligned = true;
    const bool isJpegLs = coding == PixelCoding::jpegLs;
    auto problem =
        isJpegLs ? decodeJpegLsFrame(data, header, frame) : decodeJpeg(data, header, jpegFrame(), frame.bytes);
    if (!problem.empty()) return problem;
    const char* const what = isJpegLs ? "JPEG-LS" : "JPEG";
    takeColours(header.colours, what, frame);
    if (header.bits < format.bitsStored) sayBits(what, header.bits);
    // Old overlays use the bits above those of the pixels, so no value is limited then.
    if (dicomWholeNumber(*dataset, {0x6000, 0x0102}).value_or(0) > 0) return {};
    return sayLimited(limitToStoredBits(format, frame.bytes, header.bits));
}

std::string CompressedFrames::State::decodeJpegLsFrame(const std::vector<std::uint8_t>& data, const JpegHeader& header,
                                                       DecodedFrame& frame) {
    const std::string damaged = "has a JPEG-LS frame of which a part is missing or damaged";
    if (header.bits <= 8 && format.bitsAllocated == 16) {
        if (!decodeJpegLsBytes(*dataset, format, data, std::span(frame.bytes).first(samples()))) return damaged;
        widenBytes(frame.bytes);
        return {};
    }
    // The library counts the offset table as a fragment.
    Uint32 first = static_cast<Uint32>(map.frames[decoding].first + 1);
    OFString model;
    const OFCondition done =
        pixelData->getUncompressedFrame(dataset, static_cast<Uint32>(decoding), first, frame.bytes.data(),
                                        static_cast<Uint32>(frame.bytes.size()), model, &cache);
    return done.bad() ? damaged : std::string();
}

}  // namespace echolucent
