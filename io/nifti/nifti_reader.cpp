#include "io/nifti/nifti_reader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "io/files/file_access.h"
#include "io/files/header_text.h"
#include "io/files/input_problems.h"
#include "io/headers/frames_over_time.h"
#include "io/nifti/nifti_geometry.h"
#include "io/nifti/nifti_voxel_place.h"
#include "io/study/study_assembly.h"
#include "io/voxels/gzip_file.h"
#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

struct TypeCode {
    std::int64_t code;
    StoredType type;
};
constexpr std::array<TypeCode, 10> typeCodes{{{2, StoredType::uint8},
                                              {4, StoredType::int16},
                                              {8, StoredType::int32},
                                              {16, StoredType::float32},
                                              {64, StoredType::float64},
                                              {256, StoredType::int8},
                                              {512, StoredType::uint16},
                                              {768, StoredType::uint32},
                                              {1024, StoredType::int64},
                                              {1280, StoredType::uint64}}};
constexpr std::int64_t rgb24 = 128;

/// The code of a kind of data, and what to call it.
struct CodeWords {
    std::int64_t code;
    const char* words;
};
constexpr std::array<CodeWords, 7> refusedTypes{{{1, "single bits"},
                                                 {32, "complex numbers (complex64)"},
                                                 {1792, "complex numbers (complex128)"},
                                                 {2048, "complex numbers (complex256)"},
                                                 {1536, "128-bit floats"},
                                                 {2304, "colours with opacity (RGBA32)"},
                                                 {0, "an unknown type"}}};
constexpr std::array<CodeWords, 10> refusedIntents{{{1004, "matrices"},
                                                    {1005, "symmetric matrices"},
                                                    {1006, "displacements (a deformation)"},
                                                    {1007, "vectors"},
                                                    {1008, "points of a surface"},
                                                    {1009, "triangles of a surface"},
                                                    {1010, "quaternions"},
                                                    {2002, "indices of nodes on a surface"},
                                                    {2003, "colours on a surface"},
                                                    {2004, "colours with opacity on a surface"}}};

template <std::size_t count>
const char* wordsFor(const std::array<CodeWords, count>& table, std::int64_t code) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const CodeWords& row) { return row.code == code; });
    return found == table.end() ? nullptr : found->words;
}

class NiftiReader {
public:
    NiftiReader(const InputFile& file, const NiftiHeader& header) : m_file(file), m_header(header) {
        m_stored.path = file.path();
        m_stored.sizeKey = "dim";
        m_stored.typeKey = "datatype";
        m_stored.byteOrderKey = "sizeof_hdr";
        m_stored.encodingKey = "NIfTI knows no other";
        m_stored.bigEndian = header.bigEndian;
    }
    Result<StoredVolume> read(bool framesAsSlices, const Progress& progress);

private:
    Result<void> readShape();
    Result<void> readIntent();
    Result<void> readType();
    Result<void> readTime();
    Result<void> readScale();
    Result<void> readVoxelPlace(const Progress& progress);
    [[nodiscard]] bool saysWhite() const;
    void readWindow();
    [[nodiscard]] tl::unexpected<Failure> wrong(const std::string& key, const std::string& problem,
                                                const std::string& remedy = correctHeader) const {
        return fail(FailureKind::unreadable, m_stored.path, key, problem, remedy);
    }
    void note(std::string_view sentence) { m_stored.warnings.emplace_back(sentence); }

    const InputFile& m_file;
    NiftiHeader m_header;
    StoredVolume m_stored;
};

Result<StoredVolume> NiftiReader::read(bool framesAsSlices, const Progress& progress) {
    m_stored.facts.push_back(
        {"format",
         fmt::format("NIfTI-{}{}", m_header.version, m_header.voxelsApart ? ", voxels in a file of their own" : ""),
         "sizeof_hdr, magic"});
    if (auto shape = readShape(); !shape) return tl::unexpected(shape.error());
    if (auto intent = readIntent(); !intent) return tl::unexpected(intent.error());
    if (auto type = readType(); !type) return tl::unexpected(type.error());
    if (auto placed = placeNifti(m_header, m_stored); !placed) return tl::unexpected(placed.error());
    if (auto time = readTime(); !time) return tl::unexpected(time.error());
    if (auto settled = settleFrames(m_stored, {}, framesAsSlices); !settled) return tl::unexpected(settled.error());
    if (auto scale = readScale(); !scale) return tl::unexpected(scale.error());
    readWindow();
    if (auto place = readVoxelPlace(progress); !place) return tl::unexpected(place.error());
    return m_stored;
}

Result<void> NiftiReader::readShape() {
    auto& dim = m_header.dim;
    if (dim[0] < 1 || dim[0] > 7) return wrong("dim[0]", fmt::format("must be 1 to 7, not {}", dim[0]));
    // Sizes beyond dim[0] have no meaning. Some programs write 0 for a dimension that they do not use.
    for (std::size_t axis = static_cast<std::size_t>(dim[0]) + 1; axis < dim.size(); ++axis) dim[axis] = 1;
    for (std::size_t axis = 4; axis < dim.size(); ++axis) {
        if (dim[axis] != 0) continue;
        note(fmt::format("dim[{}] is 0, which is taken as 1.", axis));
        dim[axis] = 1;
    }
    for (std::size_t axis = 1; axis < dim.size(); ++axis)
        if (dim[axis] < 1)
            return wrong(fmt::format("dim[{}]", axis), fmt::format("must be above 0, not {}", dim[axis]));
    for (std::size_t axis = 5; axis < dim.size(); ++axis)
        if (dim[axis] > 1)
            return wrong(fmt::format("dim[{}]", axis), fmt::format("is {}: each voxel has several values", dim[axis]),
                         "Save one scalar volume, or one over time.");
    if (dim[0] < 3)
        return wrong("dim[0]", fmt::format("is {}: this is a 2D picture, not a volume", dim[0]),
                     "Open a 3D or 4D volume.");
    m_stored.phases = dim[4];
    return {};
}

Result<void> NiftiReader::readIntent() {
    const std::int64_t code = m_header.intentCode;
    // readShape() has refused vectors of several values.
    constexpr std::int64_t vectors = 1007, valuesOfVectors = 5;
    if (code == vectors && m_header.dim[0] >= valuesOfVectors) {
        note("intent_code says that the voxels are vectors; each has one value, which is shown.");
        return {};
    }
    if (const char* words = wordsFor(refusedIntents, code))
        return wrong("intent_code", fmt::format("is {}: the file holds {}, not a volume of echoes", code, words),
                     "Open a scalar volume.");
    if (code == 1002 || code == 1003)
        note(fmt::format("intent_code {} says that the voxels are labels, not echoes.", code));
    else if (code >= 2 && code <= 24)
        note(fmt::format("intent_code {} says that the voxels are values of a statistic, not echoes.", code));
    return {};
}

Result<void> NiftiReader::readType() {
    const std::int64_t code = m_header.datatype;
    if (const char* words = wordsFor(refusedTypes, code))
        return wrong("datatype", fmt::format("is {}: {}, which cannot be shown", code, words),
                     "Save it as uint8, uint16, int16 or float32.");
    const auto known = std::find_if(typeCodes.begin(), typeCodes.end(),
                                    [&](const TypeCode& candidate) { return candidate.code == code; });
    if (known == typeCodes.end() && code != rgb24)
        return wrong("datatype", fmt::format("is {}, which is not known", code),
                     "Save it as uint8, uint16, int16 or float32.");
    m_stored.type = code == rgb24 ? StoredType::uint8 : known->type;
    m_stored.channels = code == rgb24 ? 3 : 1;
    const std::int64_t bits = 8 * bytesOf(m_stored.type) * m_stored.channels;
    if (m_header.bitpix != bits)
        note(fmt::format("bitpix says {} bits a voxel where datatype {} has {}; datatype counts.", m_header.bitpix,
                         code, bits));
    return {};
}

Result<void> NiftiReader::readTime() {
    if (m_stored.phases < 2) return {};
    const double step = m_header.pixdim[4];
    constexpr int timeBits = 0x38;
    double seconds = 1.0;
    std::string source = "pixdim[4], s by xyzt_units";
    switch (m_header.xyztUnits & timeBits) {
        case 0: source = "pixdim[4], assumed to be seconds"; break;
        case 8: break;
        case 16:
            seconds = 1e-3;
            source = "pixdim[4], ms by xyzt_units";
            break;
        case 24:
            seconds = 1e-6;
            source = "pixdim[4], us by xyzt_units";
            break;
        case 32:
        case 40:
        case 48:
            return wrong("xyzt_units", "says that the fourth dimension is a frequency, not time",
                         "Save one volume, or one over time.");
        default:
            note(fmt::format("xyzt_units is {}, which names no time: the time between phases is unknown.",
                             m_header.xyztUnits));
            return {};
    }
    const bool unitGiven = (m_header.xyztUnits & timeBits) != 0;
    if (unitGiven && std::isfinite(m_header.toffset) && m_header.toffset != 0)
        m_stored.facts.push_back(
            {"time of the first phase", fmt::format("{:.9g} s", m_header.toffset * seconds), "toffset"});
    // Without a unit, programs that know no time write 1.
    if (!std::isfinite(step) || step <= 0 || (!unitGiven && step == 1.0)) return {};
    m_stored.phaseTimes = PhaseTimes::every(step * seconds);
    m_stored.phaseSource = source;
    return {};
}

Result<void> NiftiReader::readScale() {
    const double slope = m_header.sclSlope, intercept = m_header.sclInter;
    if (slope == 0.0) return {};
    if (!std::isfinite(slope)) {
        note("scl_slope is no number: the values are taken as they are stored.");
        return {};
    }
    if (!std::isfinite(intercept)) return wrong("scl_inter", "is no number beside a scl_slope that is one");
    if (slope == 1.0 && intercept == 0.0) return {};
    if (m_stored.channels == 3) return wrong("scl_slope", "rescales colours, which NIfTI does not allow");
    const auto [smallest, largest] = rangeOf(m_stored.type);
    if (const auto problem = problemInDouble(Rescale{slope, intercept}, smallest, largest))
        return wrong("scl_slope", *problem);
    m_stored.rescale = Rescale{slope, intercept};
    m_stored.rescaleSource = "scl_slope, scl_inter";
    if (slope < 0) note("scl_slope is negative: what is stored as dark becomes bright.");
    return {};
}

/// Whether the description states that calMin and calMax are black and white of voxels of this type that are not
/// rescaled. If another program changed the type, the rescaling or the range, the description does not fit.
bool NiftiReader::saysWhite() const {
    return m_header.calMax > m_header.calMin && !m_stored.rescale &&
           m_header.descrip == niftiWhiteText(m_header.calMin, m_header.calMax, nameOf(m_stored.type));
}

void NiftiReader::readWindow() {
    if (saysWhite()) {
        m_stored.whiteLevel = m_header.calMax;
        m_stored.whiteLevelSource = "descrip, cal_max";
        if (m_header.calMin == 0) return;
        m_stored.blackLevel = m_header.calMin;
        m_stored.blackLevelSource = "descrip, cal_min";
        return;
    }
    if (std::isfinite(m_header.calMax) && std::isfinite(m_header.calMin) && m_header.calMax > m_header.calMin) {
        m_stored.window =
            DisplayWindow{m_header.calMax, m_header.calMin,
                          fmt::format("from {:.9g} to {:.9g}", m_header.calMin, m_header.calMax), "cal_min, cal_max"};
        return;
    }
    // Voxels of 8 bits are white where 255 is stored, also if the file rescales them.
    if (!m_stored.rescale || m_stored.type != StoredType::uint8) return;
    const double white = m_stored.rescale->of(255.0);
    if (m_stored.rescale->slope < 0) return;
    m_stored.lowestLevel = m_stored.rescale->of(0.0);
    m_stored.whiteLevel = white;
    m_stored.whiteLevelSource = "255 of 8 bits, by scl_slope and scl_inter";
}

/// The name of the voxels' file beside a header: "a.img" for "a.hdr", and "A.IMG" for "A.HDR".
std::string imageBeside(const std::string& header) {
    const std::filesystem::path plain = withoutGzipEnding(header);
    const std::string ending = plain.extension().string();
    const bool capitals = !ending.empty() && ending != lowerCase(ending);
    return plain.stem().string() + (capitals ? ".IMG" : ".img");
}

Result<void> NiftiReader::readVoxelPlace(const Progress& progress) {
    const std::string name = imageBeside(m_stored.path);
    NiftiVoxelPlace place(m_file, m_header, m_stored);
    // Headers of pairs whose magic is that of one file, as some programs write them.
    const bool isHeaderAlone = !m_header.voxelsApart && lowerCase(name).ends_with(".img") && place.isHeaderAlone() &&
                               lowerCase(withoutGzipEnding(m_stored.path)).ends_with(".hdr");
    if (!m_header.voxelsApart && !isHeaderAlone) return place.inHeader();
    for (const std::string& candidate : {name, name + ".gz"}) {
        auto beside = dataFileBeside({m_stored.path, "the magic \"ni\""}, candidate);
        if (!beside) return tl::unexpected(beside.error());
        if (fileAccess().kindOf(beside->path) == FileKind::missing) continue;
        auto file = beside->open();
        if (!file) return tl::unexpected(file.error());
        const auto beginning = file->beginning(3);
        if (beginning && looksLikeGzip(*beginning) && candidate.ends_with(".gz")) {
            m_stored.packedBytes = file->size();
            file = unpackGzip(*file, progress);
            if (!file) return tl::unexpected(file.error());
            m_stored.unpackedBytes = file->size();
        }
        m_stored.data = {{beside->path, *file}};
        return place.apart(*file);
    }
    if (place.goesOnForItsVoxels() || isHeaderAlone) return place.inHeader();
    return wrong("", "is a NIfTI header whose voxels are missing: there is no " + quotedText(name) + " beside it",
                 "Put both files into one folder.");
}

}  // namespace

Result<StoredVolume> readNiftiHeader(const InputFile& file, bool framesAsSlices, const Progress& progress) {
    const auto beginning = file.beginning(niftiHeaderBytes);
    if (!beginning) return tl::unexpected(beginning.error());
    const auto header = niftiHeaderIn(*beginning);
    if (!header && (beginning->size() < sizeof(std::int32_t) || beginsLikeNifti(*beginning)))
        return fail(FailureKind::unreadable, file.path(), "",
                    fmt::format("ends after {} bytes, within its NIfTI header", beginning->size()), damagedFile);
    if (!header)
        return fail(FailureKind::unreadable, file.path(), "", "does not begin with a NIfTI header",
                    "It is incomplete or damaged, or of another kind than its name says.");
    return NiftiReader(file, *header).read(framesAsSlices, progress);
}

std::optional<std::string> niftiHeaderBeside(const std::string& path) {
    const std::filesystem::path plain = withoutGzipEnding(path);
    if (lowerCase(plain.extension().string()) != ".img") return std::nullopt;
    for (const char* ending : {".hdr", ".HDR", ".hdr.gz"}) {
        std::filesystem::path header = plain;
        header.replace_extension();
        header += ending;
        if (fileAccess().kindOf(header.string()) == FileKind::file) return header.string();
    }
    return std::nullopt;
}

}  // namespace echolucent
