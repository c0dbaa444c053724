#include "io/stored_volume.h"

#include <cstring>
#include <filesystem>

#include <fmt/format.h>

#include "io/study_assembly.h"

namespace echolucent {

namespace {

// Deflate cannot shrink data below this: 258 bytes take at least two bits.
constexpr std::uint64_t deflateRatio = 1032;
// Above this ratio the decompressed bytes are counted before memory is taken for them.
constexpr std::uint64_t plausibleRatio = 32;

tl::unexpected<Failure> tooShort(const StoredVolume& stored, std::int64_t declared, const std::string& held) {
    return fail(
        FailureKind::unreadable, stored.path, stored.sizeKey,
        fmt::format("declares {} bytes of voxels ({}, {}{}) where {}", declared, sizeText(stored.geometry.size),
                    nameOf(stored.type), stored.phases > 1 ? fmt::format(", {} phases", stored.phases) : "", held),
        "The file is incomplete or its header is wrong: copy or export it again.");
}

/// Settles where the voxels begin and checks that the file holds all of them.
Result<void> checkStoredExtent(StoredVolume& stored, std::uint64_t fileSize, std::int64_t declared) {
    const auto needed = static_cast<std::uint64_t>(declared);
    if (stored.dataAtEnd) {
        if (needed > fileSize)
            return tooShort(stored, declared, fmt::format("{} holds only {}", nameFromPath(stored.dataPath), fileSize));
        stored.extent.offset = fileSize - needed;
    }
    const std::uint64_t rest = stored.extent.offset <= fileSize ? fileSize - stored.extent.offset : 0;
    if (stored.extent.length == 0) stored.extent.length = rest;
    const std::uint64_t held = std::min(rest, stored.extent.length);
    if (needed > held)
        return tooShort(stored, declared, fmt::format("{} holds only {}", nameFromPath(stored.dataPath), held));
    if (rest > needed)
        stored.warnings.push_back(
            fmt::format("The file holds {} bytes more than the declared voxels; they are ignored.", rest - needed));
    return {};
}

/// Settles how many compressed bytes there are.
Result<void> checkCompressedExtent(StoredVolume& stored, std::uint64_t fileSize, std::int64_t declared) {
    const std::uint64_t rest = stored.extent.offset <= fileSize ? fileSize - stored.extent.offset : 0;
    if (stored.extent.length > rest)
        return fail(FailureKind::unreadable, stored.path, "CompressedDataSize",
                    fmt::format("declares {} bytes where {} holds only {}", stored.extent.length,
                                nameFromPath(stored.dataPath), rest),
                    "The file is incomplete: copy or export it again.");
    if (rest == 0) return tooShort(stored, declared, nameFromPath(stored.dataPath) + " holds none");
    if (stored.extent.length == 0) stored.extent.length = rest;
    return {};
}

/// Whether the compressed bytes can give the declared ones, without trusting the declaration.
Result<void> checkDecompressedSize(const StoredVolume& stored, VoxelSource& source, std::int64_t declared,
                                   const Progress& progress) {
    const auto needed = static_cast<std::uint64_t>(declared) + stored.extent.skipBytes;
    const std::uint64_t held = stored.extent.length;
    if (needed / deflateRatio > held)
        return tooShort(stored, declared,
                        fmt::format("{} compressed bytes hold at most {}", held, held * deflateRatio));
    if (needed / plausibleRatio <= held) return {};
    const auto counted = source.countBytes(needed, progress);
    if (!counted) return tl::unexpected(counted.error());
    if (*counted < needed) return tooShort(stored, declared, fmt::format("the compressed data hold only {}", *counted));
    return {};
}

Result<void> skipDecompressed(VoxelSource& source, std::uint64_t bytes, const Progress& progress) {
    std::vector<std::uint8_t> scratch;
    while (bytes > 0) {
        scratch.resize(static_cast<std::size_t>(std::min<std::uint64_t>(bytes, std::uint64_t{1} << 20)));
        if (const auto read = source.read(scratch, progress, 0, 0); !read) return tl::unexpected(read.error());
        bytes -= scratch.size();
    }
    return {};
}

/// Takes apart phases that are interleaved voxel by voxel.
std::vector<std::vector<std::uint8_t>> splitPhases(const std::vector<std::uint8_t>& all, std::size_t phases,
                                                   std::size_t voxelBytes) {
    std::vector<std::vector<std::uint8_t>> split(phases, std::vector<std::uint8_t>(all.size() / phases));
    const std::size_t voxels = all.size() / phases / voxelBytes;
    for (std::size_t voxel = 0; voxel < voxels; ++voxel)
        for (std::size_t phase = 0; phase < phases; ++phase)
            std::memcpy(split[phase].data() + voxel * voxelBytes, all.data() + (voxel * phases + phase) * voxelBytes,
                        voxelBytes);
    return split;
}

Result<std::vector<std::vector<std::uint8_t>>> readPhases(const StoredVolume& stored, VoxelSource& source,
                                                          const ByteCounts& counts, const Progress& progress) {
    if (stored.phasesFastest) {
        std::vector<std::uint8_t> all(static_cast<std::size_t>(counts.all));
        if (const auto read = source.read(all, progress, 0.0, 0.8); !read) return tl::unexpected(read.error());
        return splitPhases(all, static_cast<std::size_t>(stored.phases),
                           static_cast<std::size_t>(bytesOf(stored.type) * stored.channels));
    }
    std::vector<std::vector<std::uint8_t>> phases;
    for (std::int64_t phase = 0; phase < stored.phases; ++phase) {
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(counts.phase));
        const double share = 0.8 / static_cast<double>(stored.phases);
        const auto read =
            source.read(bytes, progress, share * static_cast<double>(phase), share * static_cast<double>(phase + 1));
        if (!read) return tl::unexpected(read.error());
        phases.push_back(std::move(bytes));
    }
    return phases;
}

void addStorageFacts(const StoredVolume& stored, StudyParts& parts) {
    if (bytesOf(stored.type) > 1)
        parts.facts.push_back({"byte order", stored.bigEndian ? "big endian" : "little endian", ""});
    parts.facts.push_back({"compression", stored.extent.compressed ? "zlib/gzip, lossless" : "none", ""});
    if (stored.channels == 3) {
        parts.facts.push_back({"colour", "reduced to luma", "3 channels"});
        parts.warnings.push_back("The voxels are in colour; they were reduced to luma.");
    }
}

}  // namespace

Result<ByteCounts> countBytes(const StoredVolume& stored) {
    std::optional<std::int64_t> bytes = bytesOf(stored.type) * stored.channels;
    for (const std::int64_t size : stored.geometry.size) bytes = bytes ? checkedProduct(*bytes, size) : bytes;
    const auto all = bytes ? checkedProduct(*bytes, stored.phases) : bytes;
    if (!all)
        return fail(FailureKind::unreadable, stored.path, stored.sizeKey,
                    "declares more voxels than any file can hold (" + sizeText(stored.geometry.size) + ")",
                    "The header is wrong: export the volume again.");
    return ByteCounts{*bytes, *all};
}

Result<Study> readStoredVolume(StoredVolume stored, const ReadOptions& options, const Progress& progress) {
    const auto counts = countBytes(stored);
    if (!counts) return tl::unexpected(counts.error());
    auto file = InputFile::open(stored.dataPath);
    if (!file) return tl::unexpected(file.error());
    const std::uint64_t fileSize = file->size();

    const auto extent = stored.extent.compressed ? checkCompressedExtent(stored, fileSize, counts->all)
                                                 : checkStoredExtent(stored, fileSize, counts->all);
    if (!extent) return tl::unexpected(extent.error());
    VoxelSource source(std::move(*file), stored.extent);
    if (stored.extent.compressed) {
        if (auto checked = checkDecompressedSize(stored, source, counts->all, progress); !checked)
            return tl::unexpected(checked.error());
    }
    if (auto memory = requireMemory(stored.path, stored.sizeKey, static_cast<std::uint64_t>(counts->all)); !memory)
        return tl::unexpected(memory.error());
    if (stored.extent.compressed) {
        if (auto skipped = skipDecompressed(source, stored.extent.skipBytes, progress); !skipped)
            return tl::unexpected(skipped.error());
    }

    auto phases = readPhases(stored, source, *counts, progress);
    if (!phases) return tl::unexpected(phases.error());
    for (auto& bytes : *phases) {
        toMachineByteOrder(bytes, stored.type, stored.bigEndian);
        if (stored.channels == 3) reduceToLuma(bytes, stored.type);
    }

    StudyParts parts;
    parts.path = stored.path;
    parts.files = {stored.path};
    if (stored.dataPath != stored.path) parts.files.push_back(stored.dataPath);
    if (!stored.layoutPath.empty()) parts.files.push_back(stored.layoutPath);
    parts.geometry = stored.geometry;
    parts.spacingSource = stored.spacingSource;
    parts.voxels = convertVoxels(std::move(*phases), stored.type);
    parts.whiteLevel = stored.whiteLevel;
    parts.whiteLevelSource = stored.whiteLevelSource;
    parts.phaseSeconds = stored.phaseSeconds;
    parts.phaseSource = stored.phaseSource;
    parts.facts = stored.facts;
    parts.warnings = stored.warnings;
    addStorageFacts(stored, parts);
    return assembleStudy(std::move(parts), options, progress);
}

Result<std::string> dataFileBeside(const std::string& headerPath, const std::string& key, const std::string& name) {
    std::string plain = name;
    while (plain.starts_with("./")) plain.erase(0, 2);
    if (plain.empty() || plain == "." || plain == ".." || plain.find_first_of("/\\") != std::string::npos)
        return fail(FailureKind::unreadable, headerPath, key,
                    "names \"" + name + "\", which does not lie in the header's own folder",
                    "Put both files into one folder and correct the name in the header.");
    return (std::filesystem::path(headerPath).parent_path() / plain).string();
}

}  // namespace echolucent
