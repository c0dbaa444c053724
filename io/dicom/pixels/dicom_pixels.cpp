#include "io/dicom/pixels/dicom_pixels.h"

#include <dcmtk/config/osconfig.h>
#include <dcmtk/dcmdata/dcfcache.h>
#include <dcmtk/dcmdata/dcpixel.h>
#include <dcmtk/dcmdata/dctk.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "io/dicom/elements/dicom_attributes.h"
#include "io/dicom/elements/dicom_names.h"
#include "io/dicom/pixels/compressed_frames.h"
#include "io/dicom/pixels/dicom_grey.h"
#include "io/dicom/pixels/dicom_rescale.h"
#include "io/dicom/pixels/dicom_window.h"
#include "io/dicom/pixels/native_pixels.h"
#include "io/dicom/pixels/pixel_statements.h"
#include "io/files/input_file.h"
#include "io/files/input_problems.h"
#include "io/voxels/gzip_file.h"

namespace echolucent {

namespace {

const std::string pixelDataName = "(7fe0,0010) Pixel Data";
const std::string saveUncompressed = "Save it uncompressed, or with RLE, JPEG, JPEG-LS or JPEG 2000.";

PixelCoding codingOf(E_TransferSyntax syntax) {
    switch (syntax) {
        case EXS_LittleEndianImplicit:
        case EXS_LittleEndianExplicit:
        case EXS_BigEndianExplicit:
        case EXS_DeflatedLittleEndianExplicit: return PixelCoding::native;
        case EXS_RLELossless: return PixelCoding::rle;
        case EXS_JPEGProcess1:
        case EXS_JPEGProcess2_4:
        case EXS_JPEGProcess6_8:
        case EXS_JPEGProcess10_12:
        case EXS_JPEGProcess14:
        case EXS_JPEGProcess14SV1: return PixelCoding::jpeg;
        case EXS_JPEGLSLossless:
        case EXS_JPEGLSLossy: return PixelCoding::jpegLs;
        case EXS_JPEG2000LosslessOnly:
        case EXS_JPEG2000: return PixelCoding::jpeg2000;
        default: return PixelCoding::unknown;
    }
}

std::string syntaxNameOf(E_TransferSyntax syntax) { return transferSyntaxName(DcmXfer(syntax).getXferID()); }

}  // namespace

struct DicomFrames::State {
    std::string path;
    DcmDataset* dataset = nullptr;
    DcmPixelData* pixelData = nullptr;
    std::optional<CompressedFrames> compressed;  // no value if uncompressed
    DcmFileCache cache;
    E_TransferSyntax syntax = EXS_Unknown;
    PixelCoding coding = PixelCoding::unknown;
    DicomPixelFormat format;
    FrameRescales rescales;
    std::vector<std::size_t> shown;  // the frames of the volume; empty: all of them
    OfSeries series;                 // what other slices need
    bool rescaled = false;           // whether grey values are rescaled, here or in another slice
    bool paddingFound = false;       // whether a pixel that was read holds padding
    DicomWindow window;
    std::vector<std::string> notes;  // on errors that were accepted

    [[nodiscard]] tl::unexpected<Failure> wrong(const std::string& problem, const std::string& element = "",
                                                const std::string& remedy = copyAgain) const {
        return fail(FailureKind::unreadable, path, element, problem, remedy);
    }
    [[nodiscard]] bool isGrey() const {
        return format.model == ColourModel::monochrome1 || format.model == ColourModel::monochrome2;
    }
    [[nodiscard]] StoredType type() const {
        const bool padded = isGrey() && (series.padded || format.padding);
        return rescaled || padded ? StoredType::float32 : format.greyType();
    }
    /// The rescalings of the shown frames in their order, each left out if it equals the one before.
    [[nodiscard]] std::vector<Rescale> rescalesShown() const;
    /// Sets `rescaled` and `window`, which depend on the shown frames.
    void askShown();
    /// The largest (sign 1) or smallest (sign -1) value that the stored bits of any shown frame can mean.
    [[nodiscard]] double extreme(double sign) const;
    Result<void> readDescription();
    Result<void> checkNative(const DicomScan& scan);
    Result<void> checkEncapsulated();
    Result<void> checkFrame(std::int64_t index) const;
    /// The failure of frame `index`, which counts from 0; the sentence counts from 1.
    [[nodiscard]] tl::unexpected<Failure> wrongFrame(const std::string& problem, std::int64_t index) const {
        return wrong(fmt::format("{} (frame {})", problem, index + 1), pixelDataName);
    }
    void note(const std::string& sentence) {
        if (std::ranges::find(notes, sentence) == notes.end()) notes.push_back(sentence);
    }
    Result<void> decode(std::int64_t index, DecodedFrame& frame);
    Result<void> decodeNative(std::int64_t index, DecodedFrame& frame);
};

DicomFrames::DicomFrames(std::unique_ptr<State> state) : m_state(std::move(state)) {}
DicomFrames::DicomFrames(DicomFrames&&) noexcept = default;
DicomFrames::~DicomFrames() = default;

Result<DicomFrames> DicomFrames::open(DcmDataset& dataset, const std::string& path, const DicomScan& scan,
                                      OfSeries series) {
    auto state = std::make_unique<State>();
    state->path = path;
    state->dataset = &dataset;
    state->notes = scan.notes;
    state->series = series;
    DcmElement* element = nullptr;
    if (dataset.findAndGetElement(DCM_PixelData, element).bad() || element == nullptr ||
        element->ident() != EVR_PixelData) {
        const bool floats = dicomHas(dataset, {0x7fe0, 0x0008}) || dicomHas(dataset, {0x7fe0, 0x0009});
        return state->wrong(fmt::format("is {}, and {}", objectName(scan.sopClass),
                                        floats ? "keeps its pixels as floating-point numbers, which cannot be read"
                                               : "(7fe0,0010) Pixel Data is absent"),
                            "",
                            !floats && holdsPicture(scan.sopClass)
                                ? "The file is incomplete, or was saved without its picture: copy or export it again."
                                : "Open an ultrasound volume.");
    }
    state->pixelData = static_cast<DcmPixelData*>(element);
    if (const auto described = state->readDescription(); !described) return tl::unexpected(described.error());
    state->syntax = dataset.getOriginalXfer();
    state->coding = codingOf(state->syntax);
    if (state->coding == PixelCoding::unknown)
        return state->wrong(fmt::format("is {}, which cannot be read", syntaxNameOf(state->syntax)),
                            "(0002,0010) Transfer Syntax", saveUncompressed);
    const auto checked = state->coding == PixelCoding::native ? state->checkNative(scan) : state->checkEncapsulated();
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
    rescaled = isGrey() && (series.rescaled || std::ranges::any_of(different, [](const Rescale& rescale) {
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
    const auto read = [this](std::uint64_t from, std::span<std::uint8_t> bytes) {
        return pixelData
            ->getPartialValue(bytes.data(), static_cast<Uint32>(from), static_cast<Uint32>(bytes.size()), &cache,
                              EBO_LittleEndian)
            .good();
    };
    if (const auto problem = wrongPixelBytes(format, held, read)) return wrong(problem->text, problem->element);
    return {};
}

Result<void> DicomFrames::State::checkEncapsulated() {
    auto found = CompressedFrames::open(*dataset, *pixelData, format, coding);
    if (!found) return wrong(found.error(), pixelDataName);
    compressed = std::move(*found);
    // Few bytes may unpack to gigabytes, because an empty picture may be packed into hardly any.
    const std::uint64_t held = compressed->heldBytes();
    const std::int64_t voxelBytes = bytesOf(type());
    const auto unpacked = checkedProduct(format.pixels() * voxelBytes, format.frames);
    if (!unpacked || static_cast<std::uint64_t>(*unpacked) > mostUnpackedBytes(held))
        return wrong(fmt::format("holds {} bytes for {} frames of {} x {} pixels, which no picture packs into so few",
                                 held, format.frames, format.columns, format.rows),
                     pixelDataName);
    return {};
}

Result<void> DicomFrames::State::checkFrame(std::int64_t index) const {
    if (!compressed) return {};
    const std::string problem = compressed->check(static_cast<std::size_t>(index));
    if (!problem.empty()) return wrongFrame(problem, index);
    return {};
}

Result<void> DicomFrames::State::decodeNative(std::int64_t index, DecodedFrame& frame) {
    frame.layout = format.layout;
    frame.narrowRange = format.narrowRange;
    frame.planar = format.planar;
    const std::int64_t bytes = format.storedFrameBytes();
    frame.bytes.resize(static_cast<std::size_t>(bytes));
    const OFCondition done = pixelData->getPartialValue(frame.bytes.data(), static_cast<Uint32>(index * bytes),
                                                        static_cast<Uint32>(bytes), &cache, EBO_LittleEndian);
    if (done.bad()) return wrongFrame("could not be read", index);
    return {};
}

Result<void> DicomFrames::State::decode(std::int64_t index, DecodedFrame& frame) {
    if (!compressed) return decodeNative(index, frame);
    const std::string problem = compressed->decode(static_cast<std::size_t>(index), frame);
    if (!problem.empty()) return wrongFrame(problem, index);
    return {};
}

void DicomFrames::keep(std::vector<std::size_t> shown) {
    m_state->shown = std::move(shown);
    m_state->askShown();
}

Result<void> DicomFrames::check(const Progress& progress) const {
    const bool all = m_state->shown.empty();
    const std::size_t count = all ? static_cast<std::size_t>(frames()) : m_state->shown.size();
    for (std::size_t i = 0; i < count; ++i) {
        if (progress.cancelled()) return fail(FailureKind::cancelled, m_state->path, "", "was not read: cancelled");
        const auto index = static_cast<std::int64_t>(all ? i : m_state->shown[i]);
        if (auto checked = m_state->checkFrame(index); !checked) return checked;
    }
    return {};
}

std::int64_t DicomFrames::columns() const { return m_state->format.columns; }
std::int64_t DicomFrames::rows() const { return m_state->format.rows; }
std::int64_t DicomFrames::frames() const { return m_state->format.frames; }
StoredType DicomFrames::type() const { return m_state->type(); }
int DicomFrames::bitsStored() const { return m_state->format.bitsStored; }
std::int64_t DicomFrames::frameBytes() const { return m_state->format.pixels() * bytesOf(type()); }
double DicomFrames::largestValue() const { return m_state->extreme(1); }

void DicomFrames::sayWhite(StudyParts& parts) const {
    parts.window = m_state->window.white;
    const bool palette = m_state->format.model == ColourModel::palette;
    if (!palette && m_state->format.bitsStored > 8) return;
    if (!(largestValue() > 0) && !m_state->rescaled && !(m_state->extreme(-1) < 0)) return;
    parts.whiteLevel = largestValue();
    if (m_state->rescaled || m_state->extreme(-1) < 0) parts.lowestLevel = m_state->extreme(-1);
    parts.whiteLevelSource = palette ? "(0028,1101) Palette Color" : "(0028,0101) Bits Stored";
    if (m_state->rescaled) parts.whiteLevelSource += ", (0028,1053) Rescale Slope";
}

void widenLevels(StudyParts& parts, const StudyParts& said) {
    if (!parts.whiteLevel || !said.whiteLevel) return;
    parts.whiteLevel = std::max(*parts.whiteLevel, *said.whiteLevel);
    if (parts.lowestLevel || said.lowestLevel)
        parts.lowestLevel = std::min(parts.lowestLevel.value_or(0.0), said.lowestLevel.value_or(0.0));
}

std::vector<ImportFact> DicomFrames::facts() const {
    const std::string& photometric = m_state->format.photometric;
    std::vector<ImportFact> facts{
        {"transfer syntax", syntaxNameOf(m_state->syntax), "(0002,0010)"},
        {"photometric interpretation", photometric.empty() ? "not given" : photometric, "(0028,0004)"}};
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
    for (const std::string& warning : m_state->window.warnings) sentences.push_back(warning);
    for (const std::string& note : m_state->format.notes) sentences.push_back(note);
    for (const std::string& note : m_state->notes) sentences.push_back(note);
    if (m_state->paddingFound)
        sentences.push_back("Pixels that hold " + m_state->format.padding->words + " are no data.");
    if (m_state->compressed)
        for (const std::string& note : m_state->compressed->notes()) sentences.push_back(note);
    return sentences;
}

Result<void> DicomFrames::readGrey(std::int64_t index, std::span<std::uint8_t> out) {
    DecodedFrame frame;
    if (const auto decoded = m_state->decode(index, frame); !decoded) return tl::unexpected(decoded.error());
    if (type() != StoredType::float32) {
        toGrey(m_state->format, frame, out);
        return {};
    }
    const StoredType stored = m_state->format.greyType();
    std::vector<std::uint8_t> grey(static_cast<std::size_t>(m_state->format.pixels() * bytesOf(stored)));
    toGrey(m_state->format, frame, grey);
    applyRescale(m_state->rescales.of(static_cast<std::size_t>(index)), grey, stored, out);
    if (blankPadding(m_state->format, frame, out)) m_state->paddingFound = true;
    return {};
}

}  // namespace echolucent
