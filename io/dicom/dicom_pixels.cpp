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

#include <algorithm>
#include <cmath>
#include <cstring>
#include <mutex>

#include "io/dicom/dicom_attributes.h"
#include "io/dicom/dicom_grey.h"
#include "io/dicom/dicom_names.h"
#include "io/dicom/dicom_window.h"
#include "io/dicom/pixels/dicom_fragments.h"
#include "io/dicom/pixels/dicom_rescale.h"
#include "io/dicom/pixels/dicom_rle.h"
#include "io/dicom/pixels/jpeg2000.h"
#include "io/dicom/pixels/pixel_statements.h"
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

std::string syntaxNameOf(E_TransferSyntax syntax) { return transferSyntaxName(DcmXfer(syntax).getXferID()); }

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
    FrameFragments map;  // which fragments make up which frame
    DcmFileCache cache;
    E_TransferSyntax syntax = EXS_Unknown;
    Coding coding = Coding::unknown;
    DicomPixelFormat format;
    FrameRescales rescales;
    std::vector<std::size_t> shown;    // the frames that are part of the volume; empty: all of them
    bool rescaledAmongOthers = false;  // whether grey values are float32 in any case
    bool rescaled = false;             // whether they are
    DicomWindow window;
    std::vector<std::string> notes;  // on what was wrong with the file and read all the same

    [[nodiscard]] tl::unexpected<Failure> wrong(const std::string& problem, const std::string& element = "",
                                                const std::string& remedy = copyAgain) const {
        return fail(FailureKind::unreadable, path, element, problem, remedy);
    }
    [[nodiscard]] bool isGrey() const {
        return format.model == ColourModel::monochrome1 || format.model == ColourModel::monochrome2;
    }
    /// The different rescalings of the frames that are shown; the first frame's comes first.
    [[nodiscard]] std::vector<Rescale> rescalesShown() const;
    /// Finds out what depends on the frames that are shown.
    void askShown();
    /// The largest (sign 1) or smallest (sign -1) value that the stored bits of any frame shown can mean.
    [[nodiscard]] double extreme(double sign) const;
    Result<void> readDescription();
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

Result<DicomFrames> DicomFrames::open(DcmDataset& dataset, const std::string& path, const DicomScan& scan,
                                      bool rescaled) {
    registerDecoders();
    auto state = std::make_unique<State>();
    state->path = path;
    state->dataset = &dataset;
    state->notes = scan.notes;
    state->rescaledAmongOthers = rescaled;
    DcmElement* element = nullptr;
    if (dataset.findAndGetElement(DCM_PixelData, element).bad() || element == nullptr ||
        element->ident() != EVR_PixelData) {
        const bool floats = dicomHas(dataset, {0x7fe0, 0x0008}) || dicomHas(dataset, {0x7fe0, 0x0009});
        return state->wrong(fmt::format("is {}, and {}", objectName(scan.sopClass),
                                        floats ? "keeps its pixels as floating-point numbers, which cannot be read"
                                               : "(7fe0,0010) Pixel Data is absent"),
                            "", "Open an ultrasound volume.");
    }
    state->pixelData = static_cast<DcmPixelData*>(element);
    if (const auto described = state->readDescription(); !described) return tl::unexpected(described.error());
    state->syntax = dataset.getOriginalXfer();
    state->coding = codingOf(state->syntax);
    if (state->coding == Coding::unknown)
        return state->wrong(fmt::format("is {}, which cannot be read", syntaxNameOf(state->syntax)),
                            "(0002,0010) Transfer Syntax", saveUncompressed);
    const auto checked = state->coding == Coding::native ? state->checkNative(scan) : state->checkEncapsulated();
    if (!checked) return tl::unexpected(checked.error());
    return DicomFrames(std::move(state));
}

Result<void> DicomFrames::State::readDescription() {
    const std::string remedy = "Export it again as 8- or 16-bit grey or colour.";
    if (const auto problem = readPixelFormat(*dataset, format)) return wrong(problem->text, problem->element, remedy);
    auto read = readRescales(*dataset, format);
    if (!read) return wrong(read.error().text, read.error().element, "Export it again with a true rescaling.");
    rescales = std::move(*read);
    if (isGrey() && dicomHas(*dataset, {0x0028, 0x3000}))
        notes.emplace_back("The Modality LUT of the file is not applied.");
    askShown();
    return {};
}

std::vector<Rescale> DicomFrames::State::rescalesShown() const {
    std::vector<Rescale> different;
    const auto add = [&](const Rescale& one) {
        if (different.empty() || one != different.back()) different.push_back(one);
    };
    for (const std::size_t frame : shown) add(rescales.of(frame));
    if (!shown.empty()) return different;
    for (const Rescale& one : rescales.single) add(one);
    if (rescales.single.size() < static_cast<std::size_t>(format.frames)) add(rescales.all);
    return different;
}

void DicomFrames::State::askShown() {
    const std::vector<Rescale> different = rescalesShown();
    rescaled = isGrey() && (rescaledAmongOthers || std::ranges::any_of(different, [](const Rescale& rescale) {
                                return !rescale.isIdentity();
                            }));
    const std::size_t first = shown.empty() ? 0 : shown.front();
    window = readWindow(*dataset, format, first, rescales.of(first));
}

double DicomFrames::State::extreme(double sign) const {
    double found = -HUGE_VAL;
    for (const Rescale& rescale : rescalesShown())
        found = std::max({found, sign * rescale.of(format.smallestValue()), sign * rescale.of(format.largestValue())});
    return sign * found;
}

Result<void> DicomFrames::State::checkNative(const DicomScan& scan) {
    const std::uint64_t declared = pixelData->getLength(syntax);
    const std::uint64_t held = scan.pixelBytesDeclared > 0 ? std::min(declared, scan.pixelBytesHeld) : declared;
    if (const auto problem = missingPixels(format, held)) return wrong(problem->text, problem->element);
    return {};
}

Result<void> DicomFrames::State::checkEncapsulated() {
    if (pixelData->getEncapsulatedRepresentation(syntax, nullptr, fragments).bad() || fragments == nullptr)
        return wrong("is not split into fragments, as its transfer syntax needs", "(7fe0,0010) Pixel Data");
    std::vector<std::uint64_t> extendedOffsets;
    const Uint64* offsets = nullptr;
    unsigned long count = 0;
    if (dataset->findAndGetUint64Array(DcmTagKey(0x7fe0, 0x0001), offsets, &count).good() && offsets != nullptr)
        extendedOffsets.assign(offsets, offsets + count);
    const Codestream kind = coding == Coding::jpeg2000                           ? Codestream::jpeg2000
                            : coding == Coding::jpeg || coding == Coding::jpegLs ? Codestream::jpeg
                                                                                 : Codestream::none;
    auto mapped = mapFragments(*fragments, format.frames, kind, std::move(extendedOffsets));
    if (!mapped) return wrong(mapped.error(), "(7fe0,0010) Pixel Data");
    map = std::move(*mapped);
    if (!map.warning.empty()) notes.push_back(map.warning);
    return requireMemory(path, "(7fe0,0010) Pixel Data",
                         static_cast<std::uint64_t>(format.pixels() * format.bytesPerSample() * format.samples));
}

Result<std::vector<std::uint8_t>> DicomFrames::State::codestream(std::int64_t index) {
    auto bytes = fragmentBytes(map, static_cast<std::size_t>(index));
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
    // The library counts the offset table as a fragment.
    Uint32 first = static_cast<Uint32>(map.frames[static_cast<std::size_t>(index)].first + 1);
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

void DicomFrames::keep(std::vector<std::size_t> shown) {
    m_state->shown = std::move(shown);
    m_state->askShown();
}

std::int64_t DicomFrames::columns() const { return m_state->format.columns; }
std::int64_t DicomFrames::rows() const { return m_state->format.rows; }
std::int64_t DicomFrames::frames() const { return m_state->format.frames; }
StoredType DicomFrames::type() const { return m_state->rescaled ? StoredType::float32 : m_state->format.greyType(); }
int DicomFrames::bitsStored() const { return m_state->format.bitsStored; }
std::int64_t DicomFrames::frameBytes() const { return m_state->format.pixels() * bytesOf(type()); }
double DicomFrames::largestValue() const { return m_state->extreme(1); }

void DicomFrames::sayWhite(StudyParts& parts) const {
    parts.window = m_state->window.white;
    const bool palette = m_state->format.model == ColourModel::palette;
    if (!palette && m_state->format.bitsStored > 8) return;
    if (!(largestValue() > 0)) return;
    parts.whiteLevel = largestValue();
    parts.whiteLevelSource = palette ? "(0028,1101) Palette Color" : "(0028,0101) Bits Stored";
    if (m_state->rescaled) parts.whiteLevelSource += ", (0028,1053) Rescale Slope";
}

std::vector<ImportFact> DicomFrames::facts() const {
    std::vector<ImportFact> facts{{"transfer syntax", syntaxNameOf(m_state->syntax), "(0002,0010)"},
                                  {"photometric interpretation", m_state->format.photometric, "(0028,0004)"}};
    if (m_state->rescaled) {
        const std::vector<Rescale> different = m_state->rescalesShown();
        const Rescale& first = different.front();
        facts.push_back({"rescaling",
                         fmt::format("slope {:.6g}, intercept {:.6g}{}", first.slope, first.intercept,
                                     different.size() > 1 ? " in the first frame; each frame has its own" : ""),
                         "(0028,1053), (0028,1052)"});
    }
    if (m_state->format.palette.segmented)
        facts.push_back({"palette", "stored in segments", "(0028,1221), (0028,1222), (0028,1223)"});
    return facts;
}

std::vector<std::string> DicomFrames::warnings() const {
    std::vector<std::string> sentences;
    const ColourModel model = m_state->format.model;
    if (model == ColourModel::palette || model == ColourModel::rgb || model == ColourModel::lumaFirst)
        sentences.push_back("The pixels are in colour (" + m_state->format.photometric +
                            "); they were reduced to luma.");
    if (model == ColourModel::monochrome1) sentences.emplace_back("MONOCHROME1: the grey values were inverted.");
    if (statedLoss(*m_state->dataset).compression == LossyCompression::yes)
        sentences.emplace_back(
            "The pixels were compressed with loss, which changes their distribution and so the OTF.");
    if (m_state->rescaled && m_state->extreme(-1) < 0)
        sentences.push_back(fmt::format(
            "Rescaled values may lie below 0 (down to {:.6g}); what does is shown as black.", m_state->extreme(-1)));
    for (const std::string& warning : m_state->window.warnings) sentences.push_back(warning);
    for (const std::string& note : m_state->notes) sentences.push_back(note);
    return sentences;
}

Result<void> DicomFrames::readGrey(std::int64_t index, std::span<std::uint8_t> out) {
    DecodedFrame frame;
    if (const auto decoded = m_state->decode(index, frame); !decoded) return tl::unexpected(decoded.error());
    if (!m_state->rescaled) {
        toGrey(m_state->format, frame, out);
        return {};
    }
    const StoredType stored = m_state->format.greyType();
    std::vector<std::uint8_t> grey(static_cast<std::size_t>(m_state->format.pixels() * bytesOf(stored)));
    toGrey(m_state->format, frame, grey);
    applyRescale(m_state->rescales.of(static_cast<std::size_t>(index)), grey, stored, out);
    return {};
}

}  // namespace echolucent
