#include "io/wrapped_voxels.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "io/file_formats.h"
#include "io/files/archives.h"
#include "io/files/header_text.h"
#include "io/files/input_problems.h"
#include "io/files/reading_memory.h"
#include "io/nifti/nifti_header.h"
#include "io/stored/stored_bytes.h"
#include "io/study/study_assembly.h"
#include "io/voxels/gzip_file.h"
#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

/// As many bytes tell every format.
constexpr std::size_t bytesThatTell = 4096;

/// A header of another format.
struct ForeignHeader {
    std::string name;                    ///< "a NIfTI header"
    std::optional<std::uint64_t> bytes;  ///< up to its voxels, if they follow it
};

/// The end of the first line from `from` on, behind its line feed; no value if no line ends.
std::optional<std::uint64_t> endOfLine(std::string_view text, std::size_t from) {
    const auto end = text.find('\n', from);
    return end == std::string_view::npos ? std::nullopt : std::optional<std::uint64_t>(end + 1);
}

/// The length of a text header up to its voxels; no value if they do not follow it.
std::optional<std::uint64_t> lengthOfText(std::string_view text, bool isMetaImage) {
    if (isMetaImage) {
        const auto key = text.find("\nElementDataFile");
        if (key == std::string_view::npos) return std::nullopt;
        const auto end = endOfLine(text, key + 1);
        const std::string line = lowerCase(text.substr(key, end.value_or(text.size()) - key));
        return line.find("local") == std::string::npos ? std::nullopt : end;
    }
    for (const std::string_view empty : {"\n\n", "\n\r\n"})
        if (const auto end = text.find(empty); end != std::string_view::npos) return end + empty.size();
    return std::nullopt;
}

/// Whether bytes begin like DICOM without doubt. Files without preamble begin like many voxels.
bool isSurelyDicom(std::string_view beginning) {
    constexpr std::size_t preamble = 128;
    constexpr std::string_view lengthOfMeta("\x02\x00\x00\x00UL\x04\x00", 8);
    return beginning.starts_with(lengthOfMeta) ||
           (beginning.size() >= preamble + 4 && beginning.substr(preamble, 4) == "DICM");
}

std::optional<ForeignHeader> foreignHeaderIn(std::string_view beginning) {
    if (looksLikeAnalyze(beginning)) return ForeignHeader{"an Analyze 7.5 header", std::nullopt};
    if (const auto nifti = niftiHeaderIn(beginning)) {
        ForeignHeader found{"a NIfTI header", std::nullopt};
        constexpr double largest = 1e9;
        if (!nifti->voxelsApart && nifti->voxOffset >= shortestNiftiHeader && nifti->voxOffset < largest)
            found.bytes = static_cast<std::uint64_t>(nifti->voxOffset);
        return found;
    }
    const FileFormat* format = formatFromContent(beginning);
    if (format == nullptr || (format->needsDicomTables && !isSurelyDicom(beginning))) return std::nullopt;
    ForeignHeader found{std::string(format->oneOfThem), std::nullopt};
    const bool isMetaImage = format->name == "MetaImage";
    if (isMetaImage || format->name == "NRRD") found.bytes = lengthOfText(beginning, isMetaImage);
    return found;
}

/// What raw voxels are packed with that a header does not tell of.
struct HiddenPacking {
    VoxelEncoding encoding = VoxelEncoding::zlib;
    std::string_view name;
    bool isSure = false;  ///< whether hardly any voxels begin so by chance
};
constexpr std::size_t longestSignature = 10;

std::optional<HiddenPacking> packingIn(std::string_view beginning) {
    if (looksLikeGzip(beginning)) return HiddenPacking{VoxelEncoding::zlib, "gzip", true};
    if (looksLikeBzip2(beginning)) return HiddenPacking{VoxelEncoding::bzip2, "bzip2", true};
    if (beginning.size() < 2) return std::nullopt;
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(beginning[at]); };
    // A window of 32 KiB or less with deflate, and a checksum of the two bytes.
    const bool isZlib = (byte(0) & 0x0f) == 8 && byte(0) <= 0x78 && (byte(0) * 256 + byte(1)) % 31 == 0;
    return isZlib ? std::optional(HiddenPacking{VoxelEncoding::zlib, "zlib", false}) : std::nullopt;
}

/// Settles one data file after another.
class Beginnings {
public:
    Beginnings(StoredVolume& stored, const ByteCounts& counts, const Progress& progress)
        : m_stored(stored),
          m_counts(counts),
          m_part(static_cast<std::uint64_t>(counts.all) / stored.data.size()),
          m_progress(progress) {}
    Result<void> settle();

private:
    Result<VoxelExtent> extentIn(const InputFile& file) const;
    Result<std::string> decoded(const InputFile& file, const VoxelExtent& extent, std::size_t most) const;
    Result<void> requireModest(const InputFile& file) const;
    Result<bool> unpacksToVoxels(const InputFile& file, const VoxelExtent& extent) const;
    Result<void> unpackWhatIsPacked();
    Result<std::uint64_t> bytesBefore(const InputFile& file);
    Result<std::uint64_t> countDecoded(const InputFile& file, const VoxelExtent& extent, std::uint64_t limit) const;
    Result<std::uint64_t> bytesOfForeign(const InputFile& file, const VoxelExtent& extent,
                                         const ForeignHeader& foreign) const;
    [[nodiscard]] bool isPacked() const { return isCompressed(m_stored.extent.encoding); }

    StoredVolume& m_stored;
    ByteCounts m_counts;
    std::uint64_t m_part;  // bytes of voxels in each data file
    std::string m_found;   // the foreign header that was found
    const Progress& m_progress;
};

/// From the first byte of the voxels to the end of the file. In compressed bytes, skipBytes stays to be skipped.
Result<VoxelExtent> Beginnings::extentIn(const InputFile& file) const {
    VoxelExtent extent = m_stored.extent;
    const auto offset = offsetAfterLines(m_stored, file);
    if (!offset) return tl::unexpected(offset.error());
    extent.offset = *offset;
    if (!isCompressed(extent.encoding)) extent.offset += std::exchange(extent.skipBytes, 0);
    const std::uint64_t rest = extent.offset <= file.size() ? file.size() - extent.offset : 0;
    extent.length = extent.length == 0 ? rest : std::min(extent.length, rest);
    return extent;
}

Result<void> Beginnings::requireModest(const InputFile& file) const {
    return requireReadingMemory(m_stored.path, m_stored.sizeKey, memoryToRead(m_stored, m_counts),
                                m_stored.packedBytes + file.size() * m_stored.data.size());
}

/// The first decoded bytes behind skipBytes, at most this many.
Result<std::string> Beginnings::decoded(const InputFile& file, const VoxelExtent& extent, std::size_t most) const {
    constexpr std::uint64_t mostSkipped = std::uint64_t{1} << 20;
    // Nobody skips more than a header to reach another.
    if (extent.length == 0 || extent.skipBytes > mostSkipped) return std::string();
    VoxelSource source(file, extent, StoredType::uint8);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(extent.skipBytes) + most);
    std::size_t given = 0;
    while (given < bytes.size()) {
        const auto some = source.readSome(std::span(bytes).subspan(given));
        if (!some) return tl::unexpected(some.error());
        if (*some == 0) break;
        given += *some;
    }
    const auto first = std::min(static_cast<std::size_t>(extent.skipBytes), given);
    return std::string(bytes.begin() + static_cast<std::ptrdiff_t>(first),
                       bytes.begin() + static_cast<std::ptrdiff_t>(given));
}

/// Whether an extent unpacks to exactly the declared bytes, its own end and checksum included.
Result<bool> Beginnings::unpacksToVoxels(const InputFile& file, const VoxelExtent& extent) const {
    // Sizes that reading will refuse are not unpacked for.
    if (!requireModest(file)) return false;
    const std::uint64_t expected = extent.skipBytes + m_part;
    VoxelSource source(file, extent, StoredType::uint8);
    const auto given = source.skipRest(expected, m_progress);
    if (!given && given.error().kind == FailureKind::cancelled) return tl::unexpected(given.error());
    return given && *given == expected && source.ended();
}

/// Takes raw voxels for packed ones if the first data file says so.
Result<void> Beginnings::unpackWhatIsPacked() {
    if (m_stored.extent.encoding != VoxelEncoding::raw) return {};
    const auto file = m_stored.data.front().open();
    if (!file) return tl::unexpected(file.error());
    auto extent = extentIn(*file);
    if (!extent) return tl::unexpected(extent.error());
    const auto beginning = decoded(*file, *extent, longestSignature);
    const auto packing = beginning ? packingIn(*beginning) : std::nullopt;
    if (!packing) return {};
    extent->encoding = packing->encoding;
    // Whatever else begins so by chance does not unpack. Where chance is likely, only the end proves it.
    if (extent->length == m_part || !packing->isSure) {
        const auto proven = unpacksToVoxels(*file, *extent);
        if (!proven) return tl::unexpected(proven.error());
        if (!*proven) return {};
    } else if (const auto unpacked = decoded(*file, *extent, 1); !unpacked || unpacked->empty()) {
        return {};
    }
    m_stored.extent.encoding = packing->encoding;
    m_stored.warnings.push_back(fmt::format("{} holds {}, of which the header says nothing; it is unpacked.",
                                            nameFromPath(file->path()), packing->name));
    m_stored.encodingKey = "the first bytes of the voxels";
    return {};
}

/// How many bytes a data file unpacks to, up to about `limit`.
Result<std::uint64_t> Beginnings::countDecoded(const InputFile& file, const VoxelExtent& extent,
                                               std::uint64_t limit) const {
    // Sizes that reading will refuse are not unpacked for.
    if (auto modest = requireModest(file); !modest) return tl::unexpected(modest.error());
    return VoxelSource(file, extent, StoredType::uint8).countBytes(limit, m_progress);
}

Result<std::uint64_t> Beginnings::bytesOfForeign(const InputFile& file, const VoxelExtent& extent,
                                                 const ForeignHeader& foreign) const {
    std::uint64_t held = extent.length;
    if (foreign.bytes && isPacked()) {
        const auto counted = countDecoded(file, extent, extent.skipBytes + *foreign.bytes + m_part);
        if (!counted) return tl::unexpected(counted.error());
        held = *counted - std::min(*counted, extent.skipBytes);
    }
    if (foreign.bytes && held == *foreign.bytes + m_part) return *foreign.bytes;
    const std::string name = nameFromPath(file.path());
    return fail(
        FailureKind::unreadable, m_stored.path, "",
        fmt::format("takes {} for voxels, where {} stands", quotedText(name), foreign.name),
        fmt::format("Open {} itself, or correct the header so that the voxels begin behind it.", quotedText(name)));
}

/// How many bytes before the voxels are none.
Result<std::uint64_t> Beginnings::bytesBefore(const InputFile& file) {
    const auto extent = extentIn(file);
    if (!extent) return tl::unexpected(extent.error());
    if (m_stored.dataAtEnd) {
        constexpr std::uint64_t mostBefore = std::uint64_t{256} << 20;
        const auto counted = countDecoded(file, *extent, m_part + mostBefore);
        if (!counted) return tl::unexpected(counted.error());
        // If there are too few or far too many, reading says so.
        return *counted > m_part ? std::min(*counted - m_part, mostBefore + 1) : 0;
    }
    auto beginning = decoded(file, *extent, bytesThatTell);
    // Damaged bytes are told of by the full reading.
    if (!beginning) return std::uint64_t{0};
    auto foreign = foreignHeaderIn(*beginning);
    if (!foreign) return std::uint64_t{0};
    if (!foreign->bytes && beginning->size() == bytesThatTell) {
        beginning = decoded(file, *extent, headerLimit);
        if (!beginning) return tl::unexpected(beginning.error());
        foreign = foreignHeaderIn(*beginning);
    }
    m_found = foreign->name;
    return bytesOfForeign(file, *extent, *foreign);
}

Result<void> Beginnings::settle() {
    const VoxelEncoding encoding = m_stored.extent.encoding;
    if (encoding != VoxelEncoding::raw && !isCompressed(encoding)) return {};
    if (auto unpacked = unpackWhatIsPacked(); !unpacked) return unpacked;
    if (m_stored.dataAtEnd && !isPacked()) return {};
    std::optional<std::uint64_t> before;
    for (const DataFile& data : m_stored.data) {
        if (m_progress.cancelled()) return fail(FailureKind::cancelled, m_stored.path, "", "was not read: cancelled");
        const auto file = data.open();
        if (!file) return tl::unexpected(file.error());
        const auto bytes = bytesBefore(*file);
        if (!bytes) return tl::unexpected(bytes.error());
        if (before && *bytes != *before)
            return fail(FailureKind::unreadable, m_stored.path, "",
                        fmt::format("names data files in which the voxels do not begin at one place ({} and {} bytes "
                                    "stand before them)",
                                    *before, *bytes),
                        "Save the volume as one file.");
        before = *bytes;
    }
    m_stored.extent.skipBytes += *before;
    if (*before > 0 && !m_stored.dataAtEnd)
        m_stored.warnings.push_back(
            fmt::format("{} stands where the voxels of {} should begin, and is skipped: exactly their {} bytes follow. "
                        "What it says plays no part.",
                        "A" + m_found.substr(1), nameFromPath(m_stored.data.front().path), m_part));
    m_stored.dataAtEnd = false;
    return {};
}

}  // namespace

Result<void> settleBeginnings(StoredVolume& stored, const Progress& progress) {
    const auto counts = countBytes(stored);
    if (!counts) return tl::unexpected(counts.error());
    return Beginnings(stored, *counts, progress).settle();
}

}  // namespace echolucent
