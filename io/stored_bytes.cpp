#include "io/stored_bytes.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "io/headers/header_text.h"
#include "io/study_assembly.h"

namespace echolucent {

namespace {

// Deflate cannot shrink data below this: 258 bytes take at least two bits.
constexpr std::uint64_t deflateRatio = 1032;
// Above this ratio the decompressed bytes are counted before memory is taken for them.
constexpr std::uint64_t plausibleRatio = 32;

/// The least encoded bytes that can stand for so many bytes of voxels.
std::uint64_t leastEncoded(const StoredVolume& stored, std::uint64_t bytes) {
    switch (stored.extent.encoding) {
        case VoxelEncoding::raw: return bytes;
        case VoxelEncoding::zlib: return bytes / deflateRatio;
        case VoxelEncoding::bzip2: return 0;  // runs of zeros shrink a million times
        case VoxelEncoding::text: return 2 * (bytes / static_cast<std::uint64_t>(bytesOf(stored.type))) - 1;
        case VoxelEncoding::hex: return 2 * bytes;
    }
    return bytes;
}

}  // namespace

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

Result<std::uint64_t> StoredBytes::skippedLines(const InputFile& file) const {
    if (m_stored.skipLines == 0) return m_stored.extent.offset;
    const auto beginning = file.beginning(static_cast<std::size_t>(m_stored.extent.offset) + headerLimit);
    if (!beginning) return tl::unexpected(beginning.error());
    std::string_view rest = *beginning;
    rest.remove_prefix(std::min(static_cast<std::size_t>(m_stored.extent.offset), rest.size()));
    for (std::int64_t line = 0; line < m_stored.skipLines; ++line) {
        const auto end = rest.find('\n');
        if (end == std::string_view::npos)
            return fail(FailureKind::unreadable, m_stored.path, "line skip",
                        fmt::format("is {}, but the data begin with only {} lines", m_stored.skipLines, line),
                        "Correct the header or export the volume again.");
        rest.remove_prefix(end + 1);
    }
    return beginning->size() - rest.size();
}

Result<VoxelExtent> StoredBytes::extentIn(const InputFile& file) const {
    VoxelExtent extent = m_stored.extent;
    const auto offset = skippedLines(file);
    if (!offset) return tl::unexpected(offset.error());
    extent.offset = *offset;
    // Bytes to skip are skipped before voxels that are written as text, and after decompression of others.
    if (!isCompressed(extent.encoding)) extent.offset += std::exchange(extent.skipBytes, 0);
    return extent.encoding == VoxelEncoding::raw ? extentOfRaw(file, extent) : extentOfEncoded(file, extent);
}

Result<VoxelExtent> StoredBytes::extentOfRaw(const InputFile& file, VoxelExtent extent) const {
    const std::string name = nameFromPath(file.path());
    if (m_stored.dataAtEnd) {
        if (m_part > file.size()) return tooShort(fmt::format("{} holds only {}", name, file.size()));
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
                    fmt::format("declares {} bytes where {} holds only {}", extent.length, name, rest),
                    "The file is incomplete: copy or export it again.");
    if (rest == 0) return tooShort(name + " holds none");
    if (extent.length == 0) extent.length = rest;
    if (leastEncoded(m_stored, m_part + extent.skipBytes) <= extent.length) return extent;
    if (isCompressed(extent.encoding))
        return tooShort(
            fmt::format("{} compressed bytes hold at most {}", extent.length, extent.length * deflateRatio));
    return tooShort(fmt::format("{} has only {} characters for them", name, extent.length));
}

Result<void> StoredBytes::checkDecoded(const InputFile& file, const VoxelExtent& extent,
                                       const Progress& progress) const {
    // Without trusting the declaration: whether the compressed bytes can give the declared ones.
    const std::uint64_t needed = m_part + extent.skipBytes;
    if (!isCompressed(extent.encoding) || needed / plausibleRatio <= extent.length) return {};
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

Result<void> StoredBytes::check(const Progress& progress) {
    for (const DataFile& data : m_stored.data) {
        if (progress.cancelled()) return fail(FailureKind::cancelled, m_stored.path, "", "was not read: cancelled");
        const auto file = data.open();
        if (!file) return tl::unexpected(file.error());
        const auto extent = extentIn(*file);
        if (!extent) return tl::unexpected(extent.error());
        if (auto decoded = checkDecoded(*file, *extent, progress); !decoded) return decoded;
        noteRest(*file, *extent);
    }
    return {};
}

Result<void> StoredBytes::beginNext(const Progress& progress) {
    const auto file = m_stored.data[m_begun++].open();
    if (!file) return tl::unexpected(file.error());
    const auto extent = extentIn(*file);
    if (!extent) return tl::unexpected(extent.error());
    m_source = std::make_unique<VoxelSource>(*file, *extent, m_stored.type);
    m_left = m_part;
    std::vector<std::uint8_t> scratch;
    for (std::uint64_t rest = extent->skipBytes; rest > 0; rest -= scratch.size()) {
        scratch.resize(static_cast<std::size_t>(std::min<std::uint64_t>(rest, std::uint64_t{1} << 20)));
        if (const auto read = m_source->read(scratch, progress, 0, 0); !read) return read;
    }
    return {};
}

Result<void> StoredBytes::endFile() {
    const VoxelEncoding encoding = m_stored.extent.encoding;
    if (encoding == VoxelEncoding::raw) return {};  // check() has said what is left
    const auto more = m_source->hasMore();
    if (!more && isCompressed(encoding)) return tl::unexpected(more.error());
    if (more && !*more) return {};
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
        if (auto ended = endFile(); !ended) return ended;
    }
    return {};
}

}  // namespace echolucent
