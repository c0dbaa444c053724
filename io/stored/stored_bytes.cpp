#include "io/stored/stored_bytes.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "io/files/header_text.h"
#include "io/files/input_problems.h"
#include "io/files/reading_memory.h"
#include "io/stored/decimal_commas.h"
#include "io/study/study_assembly.h"

namespace echolucent {

namespace {

// Deflate shrinks at most this many times: 258 bytes take at least two bits.
constexpr std::uint64_t deflateRatio = 1032;
// Above this ratio the decompressed bytes are counted before memory is taken for them.
constexpr std::uint64_t plausibleRatio = 32;
// Compressed bytes are decoded to their end, which verifies their checksum, but for no more bytes than this.
constexpr std::uint64_t mostBeyond = std::uint64_t{256} << 20;

/// The fewest encoded bytes that can stand for this many bytes of voxels.
std::uint64_t leastEncoded(const StoredVolume& stored, std::uint64_t bytes) {
    switch (stored.extent.encoding) {
        case VoxelEncoding::raw: return bytes;
        case VoxelEncoding::zlib: return bytes / deflateRatio;
        case VoxelEncoding::bzip2: return 0;  // it shrinks zeros a million times
        case VoxelEncoding::text: return 2 * (bytes / static_cast<std::uint64_t>(bytesOf(stored.type))) - 1;
        case VoxelEncoding::hex: return 2 * bytes;
    }
    return bytes;
}

}  // namespace

Result<std::uint64_t> offsetAfterLines(const StoredVolume& stored, const InputFile& file) {
    if (stored.skipLines == 0) return stored.extent.offset;
    const auto beginning = file.beginning(static_cast<std::size_t>(stored.extent.offset) + headerLimit);
    if (!beginning) return tl::unexpected(beginning.error());
    std::string_view rest = *beginning;
    rest.remove_prefix(std::min(static_cast<std::size_t>(stored.extent.offset), rest.size()));
    for (std::int64_t line = 0; line < stored.skipLines; ++line) {
        const auto end = rest.find('\n');
        if (end == std::string_view::npos)
            return fail(FailureKind::unreadable, stored.path, "line skip",
                        fmt::format("is {}, but the data begin with only {} lines", stored.skipLines, line),
                        correctHeader);
        rest.remove_prefix(end + 1);
    }
    return beginning->size() - rest.size();
}

StoredBytes::StoredBytes(const StoredVolume& stored, const ByteCounts& counts)
    : m_stored(stored), m_counts(counts), m_part(static_cast<std::uint64_t>(counts.all) / stored.data.size()) {}

tl::unexpected<Failure> StoredBytes::tooShort(const std::string& held) const {
    const std::string phases = m_stored.phases > 1 ? fmt::format(", {} phases", m_stored.phases) : "";
    const std::string each =
        m_stored.data.size() > 1 ? fmt::format(", {} in each of {} files", m_part, m_stored.data.size()) : "";
    return fail(FailureKind::unreadable, m_stored.path, m_stored.sizeKey,
                fmt::format("declares {} bytes of voxels ({}, {}{}{}) where {}", m_counts.all,
                            sizeText(m_stored.geometry.size), nameOf(m_stored.type), phases, each, held),
                m_stored.sizeRemedy);
}

Result<VoxelExtent> StoredBytes::extentIn(const InputFile& file) const {
    VoxelExtent extent = m_stored.extent;
    const auto offset = offsetAfterLines(m_stored, file);
    if (!offset) return tl::unexpected(offset.error());
    extent.offset = *offset;
    extent.decimalCommas = m_decimalCommas;
    // In compressed data, bytes are skipped after unpacking; in all others, here.
    if (!isCompressed(extent.encoding)) extent.offset += std::exchange(extent.skipBytes, 0);
    return extent.encoding == VoxelEncoding::raw ? extentOfRaw(file, extent) : extentOfEncoded(file, extent);
}

Result<VoxelExtent> StoredBytes::extentOfRaw(const InputFile& file, VoxelExtent extent) const {
    const std::string name = nameFromPath(file.path());
    if (m_stored.dataAtEnd) {
        // Bytes before the offset are header or skipped lines, never voxels.
        const std::uint64_t left = file.size() - std::min(extent.offset, file.size());
        if (m_part > left)
            return tooShort(
                fmt::format("{} holds only {}{}", name, left, extent.offset > 0 ? " after its header" : ""));
        extent.offset = file.size() - m_part;
    }
    const std::uint64_t rest = extent.offset <= file.size() ? file.size() - extent.offset : 0;
    if (extent.length == 0) extent.length = rest;
    const std::uint64_t held = std::min(rest, extent.length);
    if (m_part > held) return tooShort(fmt::format("{} holds only {}", name, held));
    return extent;
}

Result<VoxelExtent> StoredBytes::extentOfEncoded(const InputFile& file, VoxelExtent extent) const {
    const std::string name = nameFromPath(file.path());
    const std::uint64_t rest = extent.offset <= file.size() ? file.size() - extent.offset : 0;
    if (extent.length > rest)
        return fail(FailureKind::unreadable, m_stored.path, "CompressedDataSize",
                    fmt::format("declares {} bytes where {} holds only {}", extent.length, name, rest), incompleteFile);
    if (rest == 0) return tooShort(name + " holds none");
    if (extent.length == 0) extent.length = rest;
    if (isCompressed(extent.encoding) && extent.skipBytes > mostBeyond)
        return fail(FailureKind::unreadable, m_stored.path, "byte skip",
                    fmt::format("is {}, more than the {} bytes that are unpacked and skipped before voxels",
                                extent.skipBytes, mostBeyond),
                    correctHeader);
    if (leastEncoded(m_stored, m_part + extent.skipBytes) <= extent.length) return extent;
    if (isCompressed(extent.encoding))
        return tooShort(
            fmt::format("{} compressed bytes hold at most {}", extent.length, extent.length * deflateRatio));
    return tooShort(fmt::format("{} has only {} characters for them", name, extent.length));
}

Result<void> StoredBytes::checkDecoded(const InputFile& file, const VoxelExtent& extent,
                                       const Progress& progress) const {
    // The declaration may lie: count whether the compressed bytes give as many as declared.
    const std::uint64_t needed = m_part + extent.skipBytes;
    if (needed / plausibleRatio <= extent.length) return {};
    const auto counted = VoxelSource(file, extent, m_stored.type).countBytes(needed, progress);
    if (!counted) return tl::unexpected(counted.error());
    if (*counted < needed) return tooShort(fmt::format("the compressed data hold only {}", *counted));
    return {};
}

void StoredBytes::noteRest(const InputFile& file, const VoxelExtent& extent) {
    if (extent.encoding != VoxelEncoding::raw || file.size() - extent.offset == m_part || !m_warnings.empty()) return;
    const std::string which = m_stored.data.size() > 1 ? nameFromPath(file.path()) : "The file";
    m_warnings.push_back(fmt::format("{} holds {} bytes more than the declared voxels; they are ignored.", which,
                                     file.size() - extent.offset - m_part));
}

template <typename Visit>
Result<void> StoredBytes::forEachFile(const Visit& visit) const {
    for (const DataFile& data : m_stored.data) {
        const auto file = data.open();
        if (!file) return tl::unexpected(file.error());
        const auto extent = extentIn(*file);
        if (!extent) return tl::unexpected(extent.error());
        if (auto visited = visit(*file, *extent); !visited) return visited;
    }
    return {};
}

Result<void> StoredBytes::check(const Progress& progress) {
    std::uint64_t storedBytes = m_stored.packedBytes;
    for (const DataFile& data : m_stored.data) {
        if (progress.cancelled()) return fail(FailureKind::cancelled, m_stored.path, "", "was not read: cancelled");
        const auto file = data.open();
        if (!file) return tl::unexpected(file.error());
        const auto extent = extentIn(*file);
        if (!extent) return tl::unexpected(extent.error());
        const bool unpacked = data.opened && m_stored.packedBytes > 0;
        if (!unpacked) storedBytes += file->size();
        noteRest(*file, *extent);
    }
    if (auto modest =
            requireReadingMemory(m_stored.path, m_stored.sizeKey, memoryToRead(m_stored, m_counts), storedBytes);
        !modest)
        return modest;
    if (m_stored.extent.encoding == VoxelEncoding::text) return settleCommas(progress);
    if (!isCompressed(m_stored.extent.encoding)) return {};
    return forEachFile(
        [&](const InputFile& file, const VoxelExtent& extent) { return checkDecoded(file, extent, progress); });
}

Result<void> StoredBytes::settleCommas(const Progress& progress) {
    bool hasCommas = false;
    const auto looked = forEachFile([&](const InputFile& file, const VoxelExtent& extent) -> Result<void> {
        if (hasCommas) return {};
        const auto found = holdsComma(file, extent, progress);
        if (!found) return tl::unexpected(found.error());
        hasCommas = *found;
        return {};
    });
    if (!looked || !hasCommas) return looked;

    const std::uint64_t values = m_part / static_cast<std::uint64_t>(bytesOf(m_stored.type));
    std::uint64_t commas = 0;
    bool fitAsWords = true, seemSplit = false;
    const auto counted = forEachFile([&](const InputFile& file, const VoxelExtent& extent) -> Result<void> {
        const auto found = countNumbers(file, extent, progress);
        if (!found) return tl::unexpected(found.error());
        commas += found->commasWithin;
        fitAsWords = fitAsWords && found->fitAsWords(values);
        seemSplit = seemSplit || found->seemSplit(values);
        return {};
    });
    if (!counted) return counted;
    m_decimalCommas = commas > 0 && fitAsWords;
    if (m_decimalCommas)
        m_warnings.emplace_back("The voxels are text with decimal commas, which are read as points.");
    else if (seemSplit)
        return fail(FailureKind::unreadable, m_stored.path, m_stored.encodingKey,
                    "is text with more numbers than voxels, and with commas within them that may be decimal commas",
                    "Save it with decimal points, or as binary.");
    return {};
}

Result<bool> StoredBytes::endsWithinNumber(const InputFile& file, const VoxelExtent& extent) const {
    if (extent.encoding != VoxelEncoding::text) return false;
    std::uint8_t last = 0;
    if (const auto read = file.readAt(extent.offset + extent.length - 1, {&last, 1}); !read)
        return tl::unexpected(read.error());
    return !separatesNumbers(last);
}

Result<void> StoredBytes::beginNext(const Progress& progress) {
    const auto file = m_stored.data[m_begun++].open();
    if (!file) return tl::unexpected(file.error());
    const auto extent = extentIn(*file);
    if (!extent) return tl::unexpected(extent.error());
    const auto mayBeCut = endsWithinNumber(*file, *extent);
    if (!mayBeCut) return tl::unexpected(mayBeCut.error());
    m_mayBeCut = *mayBeCut;
    m_file = file->path();
    m_source = std::make_unique<VoxelSource>(*file, *extent, m_stored.type);
    m_left = m_part;
    std::vector<std::uint8_t> scratch;
    for (std::uint64_t rest = extent->skipBytes; rest > 0; rest -= scratch.size()) {
        scratch.resize(static_cast<std::size_t>(std::min<std::uint64_t>(rest, std::uint64_t{1} << 20)));
        if (const auto read = m_source->read(scratch, progress, 0, 0); !read) return read;
    }
    return {};
}

Result<void> StoredBytes::endFile(const Progress& progress) {
    const VoxelEncoding encoding = m_stored.extent.encoding;
    if (encoding == VoxelEncoding::raw) return {};  // check() has told of the rest
    const bool compressed = isCompressed(encoding);
    const auto more = m_source->skipRest(compressed ? mostBeyond : 0, progress);
    if (!more && (compressed || more.error().kind == FailureKind::cancelled)) return tl::unexpected(more.error());
    if (compressed && *more > mostBeyond)
        return fail(FailureKind::unreadable, m_file, "",
                    fmt::format("holds compressed data that go on for more than {} bytes after the declared voxels",
                                mostBeyond),
                    "The file is damaged, or its header belongs to another one: export it again.");
    if (compressed && !m_source->ended())
        return fail(FailureKind::unreadable, m_file, "",
                    "ends within its compressed data, so that their checksum cannot be verified", damagedFile);
    if (more && *more == 0) {
        // A file that was cut within its last number looks like one that its writer ended there.
        if (m_mayBeCut)
            m_warnings.push_back(nameFromPath(m_file) +
                                 " ends directly after its last number, which may have been cut: compare its last "
                                 "voxel with the original.");
        return {};
    }
    if (m_warnings.empty())
        m_warnings.emplace_back("The file holds more than the declared voxels; what follows them is ignored.");
    return {};
}

Result<void> StoredBytes::read(std::span<std::uint8_t> bytes, const Progress& progress, double from, double to) {
    const double share = (to - from) / static_cast<double>(bytes.size());
    for (std::size_t done = 0; done < bytes.size();) {
        if (m_left == 0)
            if (auto begun = beginNext(progress); !begun) return begun;
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(m_left, bytes.size() - done));
        const double begin = from + share * static_cast<double>(done);
        const auto read =
            m_source->read(bytes.subspan(done, count), progress, begin, begin + share * static_cast<double>(count));
        if (!read) return read;
        done += count;
        m_left -= count;
        if (m_left > 0) continue;
        if (auto ended = endFile(progress); !ended) return ended;
    }
    return {};
}

Result<void> StoredBytes::readRaw(std::uint64_t position, std::span<std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const auto number = static_cast<std::size_t>(position / m_part);
        if (!m_openPart || m_openPart->number != number) {
            const auto file = m_stored.data.at(number).open();
            if (!file) return tl::unexpected(file.error());
            const auto extent = extentIn(*file);
            if (!extent) return tl::unexpected(extent.error());
            m_openPart = OpenPart{number, *file, extent->offset};
        }
        const std::uint64_t within = position % m_part;
        const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(m_part - within, bytes.size()));
        if (auto read = m_openPart->file.readAt(m_openPart->offset + within, bytes.first(count)); !read) return read;
        position += count;
        bytes = bytes.subspan(count);
    }
    return {};
}

}  // namespace echolucent
