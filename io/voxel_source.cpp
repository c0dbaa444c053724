#include "io/voxel_source.h"

#include <zlib.h>

#include <algorithm>
#include <vector>

#include <fmt/format.h>

namespace echolucent {

namespace {
constexpr std::size_t pieceBytes = std::size_t{4} << 20;

tl::unexpected<Failure> cancelled(const std::string& path) {
    return fail(FailureKind::cancelled, path, "", "was not read: cancelled");
}
}  // namespace

struct VoxelSource::Inflater {
    z_stream stream{};
    std::vector<std::uint8_t> input = std::vector<std::uint8_t>(std::size_t{1} << 18);
    bool ended = false;

    // The window has 15 bits; 32 more let zlib tell its own format and gzip apart by the data.
    Inflater() { inflateInit2(&stream, 15 + 32); }
    ~Inflater() { inflateEnd(&stream); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;
};

VoxelSource::VoxelSource(InputFile file, const VoxelExtent& extent) : m_file(std::move(file)), m_extent(extent) {
    rewind();
}

VoxelSource::~VoxelSource() = default;

void VoxelSource::rewind() {
    m_position = 0;
    m_given = 0;
    m_inflater = m_extent.compressed ? std::make_unique<Inflater>() : nullptr;
}

Result<std::size_t> VoxelSource::readSome(std::span<std::uint8_t> bytes) {
    if (m_inflater) return inflateSome(bytes);
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), m_extent.length - m_position));
    const auto read = m_file.readAt(m_extent.offset + m_position, bytes.first(count));
    if (!read) return tl::unexpected(read.error());
    m_position += count;
    return count;
}

Result<std::size_t> VoxelSource::inflateSome(std::span<std::uint8_t> bytes) {
    z_stream& stream = m_inflater->stream;
    stream.next_out = bytes.data();
    stream.avail_out = static_cast<uInt>(bytes.size());
    while (stream.avail_out > 0 && !m_inflater->ended) {
        if (stream.avail_in == 0) {
            const auto count = static_cast<std::size_t>(
                std::min<std::uint64_t>(m_inflater->input.size(), m_extent.length - m_position));
            if (count == 0) break;
            const auto read = m_file.readAt(m_extent.offset + m_position, {m_inflater->input.data(), count});
            if (!read) return tl::unexpected(read.error());
            m_position += count;
            stream.next_in = m_inflater->input.data();
            stream.avail_in = static_cast<uInt>(count);
        }
        const int status = inflate(&stream, Z_NO_FLUSH);
        if (status == Z_STREAM_END)
            m_inflater->ended = true;
        else if (status != Z_OK && status != Z_BUF_ERROR)
            return fail(FailureKind::unreadable, m_file.path(), "",
                        fmt::format("has damaged compressed data near byte {}: {}", m_extent.offset + m_position,
                                    stream.msg != nullptr ? stream.msg : "not zlib or gzip"),
                        "Copy or export it again.");
    }
    return bytes.size() - stream.avail_out;
}

Result<void> VoxelSource::read(std::span<std::uint8_t> bytes, const Progress& progress, double from, double to) {
    std::size_t done = 0;
    while (done < bytes.size()) {
        if (progress.cancelled()) return cancelled(m_file.path());
        progress.at(from + (to - from) * static_cast<double>(done) / static_cast<double>(bytes.size()));
        const auto count = readSome(bytes.subspan(done, std::min(pieceBytes, bytes.size() - done)));
        if (!count) return tl::unexpected(count.error());
        if (*count == 0)
            return fail(FailureKind::unreadable, m_file.path(), "",
                        fmt::format("holds only {} bytes of voxels where {} or more are declared", m_given,
                                    m_given - done + bytes.size()),
                        "Copy or export it again.");
        done += *count;
        m_given += *count;
    }
    return {};
}

Result<std::uint64_t> VoxelSource::countBytes(std::uint64_t limit, const Progress& progress) {
    std::vector<std::uint8_t> scratch(std::size_t{1} << 20);
    std::uint64_t total = 0;
    while (total < limit) {
        if (progress.cancelled()) return cancelled(m_file.path());
        const auto count = readSome(scratch);
        if (!count) return tl::unexpected(count.error());
        if (*count == 0) break;
        total += *count;
    }
    rewind();
    return total;
}

}  // namespace echolucent
