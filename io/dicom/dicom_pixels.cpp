#include "io/dicom/dicom_pixels.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcfcache.h>
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dcpixseq.h>
#include <dcmtk/dcmdata/dcpxitem.h>
#include <dcmtk/dcmdata/dctk.h>
#include <dcmtk/dcmjpeg/djdecode.h>
#include <dcmtk/dcmjpls/djdecode.h>
#include <fmt/format.h>

#include <cstring>
#include <mutex>

#include "io/dicom/dicom_attributes.h"
#include "io/dicom/dicom_fragments.h"
#include "io/dicom/dicom_grey.h"
#include "io/dicom/dicom_rle.h"
#include "io/dicom/dicom_window.h"
#include "io/dicom/jpeg2000.h"
#include "io/input_file.h"

namespace echolucent {

namespace {

const std::string copyAgain = "Copy or export it again.";
const std::string saveUncompressed = "Save it uncompressed, or with RLE, JPEG, JPEG-LS or JPEG 2000.";

enum class Coding { native, rle, jpeg, jpegLs, jpeg2000, unknown };

Coding codingOf(E_TransferSyntax syntax) {
    switch (syntax) {
        case EXS_LittleEndianImplicit:
        case EXS_LittleEndianExplicit:
        case EXS_BigEndianExplicit:
        case EXS_DeflatedLittleEndianExplicit: return Coding::native;
        case EXS_RLELossless: return Coding::rle;
        case EXS_JPEGProcess1:
        case EXS_JPEGProcess2_4:
        case EXS_JPEGProcess6_8:
        case EXS_JPEGProcess10_12:
        case EXS_JPEGProcess14:
        case EXS_JPEGProcess14SV1: return Coding::jpeg;
        case EXS_JPEGLSLossless:
        case EXS_JPEGLSLossy: return Coding::jpegLs;
        case EXS_JPEG2000LosslessOnly:
        case EXS_JPEG2000: return Coding::jpeg2000;
        default: return Coding::unknown;
    }
}

void registerDecoders() {
    static std::once_flag once;
    std::call_once(once, [] {
        // Colours are not converted: the first sample of YBR is the luma that is wanted.
        DJDecoderRegistration::registerCodecs(EDC_never, EUC_default, EPC_colorByPixel);
        DJLSDecoderRegistration::registerCodecs(EJLSUC_default, EJLSPC_colorByPixel);
    });
}

}  // namespace

struct DicomFrames::State {
    std::string path;
    DcmDataset* dataset = nullptr;
    DcmPixelData* pixelData = nullptr;
    DcmPixelSequence* fragments = nullptr;
    FragmentMap map;  // which fragments make up which frame
    DcmFileCache cache;
    E_TransferSyntax syntax = EXS_Unknown;
    Coding coding = Coding::unknown;
    DicomPixelFormat format;
    DicomWindow window;

    [[nodiscard]] tl::unexpected<Failure> wrong(const std::string& problem, const std::string& element = "",
                                                const std::string& remedy = copyAgain) const {
        return fail(FailureKind::unreadable, path, element, problem, remedy);
    }
    Result<void> checkNative(const DicomScan& scan);
    Result<void> checkEncapsulated();
    Result<std::vector<std::uint8_t>> codestream(std::int64_t index);
    Result<void> decode(std::int64_t index, DecodedFrame& frame);
    Result<void> decodeNative(std::int64_t index, DecodedFrame& frame);
    Result<void> decodeJpeg2000Frame(std::int64_t index, DecodedFrame& frame);
    Result<void> decodeByLibrary(std::int64_t index, DecodedFrame& frame);
};

DicomFrames::DicomFrames(std::unique_ptr<State> state) : m_state(std::move(state)) {}
DicomFrames::DicomFrames(DicomFrames&&) noexcept = default;
DicomFrames::~DicomFrames() = default;

Result<DicomFrames> DicomFrames::open(DcmDataset& dataset, const std::string& path, const DicomScan& scan) {
    registerDecoders();
    auto state = std::make_unique<State>();
    state->path = path;
    state->dataset = &dataset;
    DcmElement* element = nullptr;
    if (dataset.findAndGetElement(DCM_PixelData, element).bad() || element == nullptr ||
        element->ident() != EVR_PixelData)
        return state->wrong("holds no pixels: it is no image", "(7fe0,0010) Pixel Data", "Open an ultrasound volume.");
    state->pixelData = static_cast<DcmPixelData*>(element);
    if (const auto problem = readPixelFormat(dataset, state->format))
        return state->wrong(problem->text, problem->element, "Export it again as 8- or 16-bit grey or colour.");
    state->window = readWindow(dataset, state->format);
    state->syntax = dataset.getOriginalXfer();
    state->coding = codingOf(state->syntax);
    if (state->coding == Coding::unknown)
        return state->wrong(fmt::format("is stored as {}, which cannot be read", DcmXfer(state->syntax).getXferName()),
                            "", saveUncompressed);
    const auto checked = state->coding == Coding::native ? state->checkNative(scan) : state->checkEncapsulated();
    if (!checked) return tl::unexpected(checked.error());
    return DicomFrames(std::move(state));
}

Result<void> DicomFrames::State::checkNative(const DicomScan& scan) {
    const auto needed = checkedProduct(format.storedFrameBytes(), format.frames);
    const std::uint64_t declared = pixelData->getLength(syntax);
    const std::uint64_t held = scan.pixelBytesDeclared > 0 ? std::min(declared, scan.pixelBytesHeld) : declared;
    // DICOM counts in 32 bits: no file can hold more.
    if (!needed || static_cast<std::uint64_t>(*needed) > held || *needed > 0xfffffffeLL)
        return wrong(
            fmt::format("holds {} bytes where {} x {} pixels in {} frame(s) need {}", held, format.columns, format.rows,
                        format.frames, needed ? std::to_string(*needed) : "more than can be counted"),
            "(7fe0,0010) Pixel Data");
    return {};
}

Result<void> DicomFrames::State::checkEncapsulated() {
    if (pixelData->getEncapsulatedRepresentation(syntax, nullptr, fragments).bad() || fragments == nullptr)
        return wrong("is not split into fragments, as its transfer syntax needs", "(7fe0,0010) Pixel Data");
    auto mapped = mapFragments(*fragments, format.frames);
    if (!mapped) return wrong(mapped.error(), "(7fe0,0010) Pixel Data");
    map = std::move(*mapped);
    return requireMemory(path, "(7fe0,0010) Pixel Data",
                         static_cast<std::uint64_t>(format.pixels() * format.bytesPerSample() * format.samples));
}

Result<std::vector<std::uint8_t>> DicomFrames::State::codestream(std::int64_t index) {
    auto bytes = fragmentBytes(*fragments, map[static_cast<std::size_t>(index)]);
    if (!bytes) return wrong(fmt::format("has no readable data for frame {}", index + 1), "(7fe0,0010) Pixel Data");
    return *bytes;
}

Result<void> DicomFrames::State::decodeNative(std::int64_t index, DecodedFrame& frame) {
    frame.halved = format.halved;
    frame.planar = format.planar;
    const std::int64_t bytes = format.storedFrameBytes();
    frame.bytes.resize(static_cast<std::size_t>(bytes));
    const OFCondition done = pixelData->getPartialValue(frame.bytes.data(), static_cast<Uint32>(index * bytes),
                                                        static_cast<Uint32>(bytes), &cache, EBO_LittleEndian);
    if (done.bad()) return wrong(fmt::format("could not be read at frame {}: {}", index + 1, done.text()));
    return {};
}

Result<void> DicomFrames::State::decodeJpeg2000Frame(std::int64_t index, DecodedFrame& frame) {
    const auto data = codestream(index);
    if (!data) return tl::unexpected(data.error());
    std::vector<std::int32_t> values;
    const Jpeg2000Frame expected{static_cast<std::uint32_t>(format.columns), static_cast<std::uint32_t>(format.rows),
                                 static_cast<std::uint32_t>(format.samples)};
    if (const auto problem = decodeJpeg2000(*data, expected, values, frame.lumaFirst); !problem.empty())
        return wrong(fmt::format("{} (frame {})", problem, index + 1), "(7fe0,0010) Pixel Data");
    frame.planar = true;
    frame.rightAligned = true;
    const auto width = static_cast<std::size_t>(format.bytesPerSample());
    frame.bytes.resize(values.size() * width);
    for (std::size_t i = 0; i < values.size(); ++i) std::memcpy(frame.bytes.data() + i * width, &values[i], width);
    return {};
}

Result<void> DicomFrames::State::decodeByLibrary(std::int64_t index, DecodedFrame& frame) {
    const auto data = codestream(index);
    if (!data) return tl::unexpected(data.error());
    const JpegFrame expected{format.columns, format.rows, format.samples, format.bitsAllocated};
    if (const auto problem = jpegDisagreement(*data, expected); !problem.empty())
        return wrong(fmt::format("{} (frame {})", problem, index + 1), "(7fe0,0010) Pixel Data");
    const std::int64_t bytes = format.pixels() * format.bytesPerSample() * format.samples;
    if (bytes > 0x7ffffffeLL) return wrong("has frames of more than 2 GB", "(7fe0,0010) Pixel Data");
    frame.bytes.resize(static_cast<std::size_t>(bytes + bytes % 2));
    frame.rightAligned = true;
    Uint32 first = static_cast<Uint32>(map[static_cast<std::size_t>(index)].first);
    OFString model;
    const OFCondition done =
        pixelData->getUncompressedFrame(dataset, static_cast<Uint32>(index), first, frame.bytes.data(),
                                        static_cast<Uint32>(frame.bytes.size()), model, &cache);
    if (done.bad()) return wrong(fmt::format("could not be decoded at frame {}: {}", index + 1, done.text()));
    frame.lumaFirst = model.find("YBR") == 0;
    return {};
}

Result<void> DicomFrames::State::decode(std::int64_t index, DecodedFrame& frame) {
    switch (coding) {
        case Coding::native: return decodeNative(index, frame);
        case Coding::jpeg2000: return decodeJpeg2000Frame(index, frame);
        case Coding::rle: {
            const auto data = codestream(index);
            if (!data) return tl::unexpected(data.error());
            frame.planar = true;
            frame.bytes.resize(static_cast<std::size_t>(format.pixels() * format.bytesPerSample() * format.samples));
            const auto problem = decodeRle(*data, static_cast<std::size_t>(format.pixels()), format.samples,
                                           format.bytesPerSample(), frame.bytes);
            if (!problem.empty())
                return wrong(fmt::format("{} (frame {})", problem, index + 1), "(7fe0,0010) Pixel Data");
            return {};
        }
        default: return decodeByLibrary(index, frame);
    }
}

std::int64_t DicomFrames::columns() const { return m_state->format.columns; }
std::int64_t DicomFrames::rows() const { return m_state->format.rows; }
std::int64_t DicomFrames::frames() const { return m_state->format.frames; }
StoredType DicomFrames::type() const { return m_state->format.greyType(); }
std::int64_t DicomFrames::frameBytes() const { return m_state->format.pixels() * bytesOf(type()); }
double DicomFrames::largestValue() const { return m_state->format.largestValue(); }

void DicomFrames::sayWhite(StudyParts& parts) const {
    parts.window = m_state->window.white;
    const bool palette = m_state->format.model == ColourModel::palette;
    if (!palette && m_state->format.bitsStored > 8) return;
    parts.whiteLevel = largestValue();
    parts.whiteLevelSource = palette ? "(0028,1101) Palette Color" : "(0028,0101) Bits Stored";
}

bool DicomFrames::lossyCompressed() const {
    const E_TransferSyntax syntax = m_state->syntax;
    const bool lossySyntax = syntax == EXS_JPEGProcess1 || syntax == EXS_JPEGProcess2_4 ||
                             syntax == EXS_JPEGProcess6_8 || syntax == EXS_JPEGProcess10_12 ||
                             syntax == EXS_JPEGLSLossy;
    return lossySyntax || dicomText(*m_state->dataset, {0x0028, 0x2110}) == "01";
}

std::vector<ImportFact> DicomFrames::facts() const {
    return {{"transfer syntax", DcmXfer(m_state->syntax).getXferName(), "(0002,0010)"},
            {"photometric interpretation", m_state->format.photometric, "(0028,0004)"},
            {"lossy compression", lossyCompressed() ? "yes" : "no", "(0028,2110), transfer syntax"}};
}

std::vector<std::string> DicomFrames::warnings() const {
    std::vector<std::string> sentences;
    const ColourModel model = m_state->format.model;
    if (model == ColourModel::palette || model == ColourModel::rgb || model == ColourModel::lumaFirst)
        sentences.push_back("The pixels are in colour (" + m_state->format.photometric +
                            "); they were reduced to luma.");
    if (model == ColourModel::monochrome1) sentences.emplace_back("MONOCHROME1: the grey values were inverted.");
    if (lossyCompressed())
        sentences.emplace_back(
            "The pixels were compressed with loss, which changes their distribution and so the OTF.");
    for (const std::string& warning : m_state->window.warnings) sentences.push_back(warning);
    return sentences;
}

Result<void> DicomFrames::readGrey(std::int64_t index, std::span<std::uint8_t> out) {
    DecodedFrame frame;
    if (const auto decoded = m_state->decode(index, frame); !decoded) return tl::unexpected(decoded.error());
    toGrey(m_state->format, frame, out);
    return {};
}

}  // namespace echolucent
