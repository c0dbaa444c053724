#include "io/voxels/voxel_source.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "io/files/input_problems.h"

namespace echolucent {

namespace {
constexpr std::size_t voxelPieceBytes = std::size_t{4} << 20;
constexpr std::size_t inputBytes = std::size_t{1} << 18;

tl::unexpected<Failure> cancelled(const std::string& path) {
    return fail(FailureKind::cancelled, path, "", "was not read: cancelled");
}
}  // namespace

VoxelSource::VoxelSource(InputFile file, const VoxelExtent& extent, StoredType type)
    : m_file(std::move(file)), m_extent(extent), m_type(type) {
    rewind();
}

VoxelSource::~VoxelSource() = default;

void VoxelSource::rewind() {
    m_position = 0;
    m_given = 0;
    m_decoder = makeVoxelDecoder(m_extent.encoding, m_type, m_extent.decimalCommas);
    m_input.resize(m_decoder ? inputBytes : 0);
    m_waiting = {};
    m_ended = false;
}

Result<std::size_t> VoxelSource::readSome(std::span<std::uint8_t> bytes) {
    if (m_decoder) return decodeSome(bytes);
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), m_extent.length - m_position));
    const auto read = m_file.readAt(m_extent.offset + m_position, bytes.first(count));
    if (!read) return tl::unexpected(read.error());
    m_position += count;
    return count;
}

double VoxelSource::shareTaken() const {
    return m_extent.length > 0 ? static_cast<double>(m_position) / static_cast<double>(m_extent.length) : 1.0;
}

Result<void> VoxelSource::refill() {
    if (!m_waiting.empty()) std::memmove(m_input.data(), m_waiting.data(), m_waiting.size());
    const auto count = static_cast<std::size_t>(
        std::min<std::uint64_t>(m_input.size() - m_waiting.size(), m_extent.length - m_position));
    const auto read = m_file.readAt(m_extent.offset + m_position, {m_input.data() + m_waiting.size(), count});
    if (!read) return tl::unexpected(read.error());
    m_position += count;
    m_waiting = {m_input.data(), m_waiting.size() + count};
    return {};
}

Result<std::size_t> VoxelSource::decodeSome(std::span<std::uint8_t> bytes) {
    std::size_t given = 0;
    while (given < bytes.size() && !m_ended) {
        const bool isLast = m_position == m_extent.length;
        const auto step = m_decoder->decode(m_waiting, isLast, bytes.subspan(given));
        if (!step)
            return fail(FailureKind::unreadable, m_file.path(), "",
                        fmt::format("{} near byte {}: {}", step.error().what,
                                    m_extent.offset + m_position - m_waiting.size(), step.error().detail),
                        copyAgain);
        m_waiting = m_waiting.subspan(step->taken);
        given += step->given;
        m_ended = step->ended;
        if (m_ended || step->given > 0) continue;
        if (isLast) break;
        if (auto refilled = refill(); !refilled) return tl::unexpected(refilled.error());
    }
    return given;
}

Result<void> VoxelSource::read(std::span<std::uint8_t> bytes, const Progress& progress, double from, double to) {
    std::size_t done = 0;
    while (done < bytes.size()) {
        if (progress.cancelled()) return cancelled(m_file.path());
        progress.at(from + (to - from) * static_cast<double>(done) / static_cast<double>(bytes.size()));
        const auto count = readSome(bytes.subspan(done, std::min(voxelPieceBytes, bytes.size() - done)));
        if (!count) return tl::unexpected(count.error());
        if (*count == 0)
            return fail(FailureKind::unreadable, m_file.path(), "",
                        fmt::format("holds only {} bytes of voxels where {} or more are declared", m_given,
                                    m_given - done + bytes.size()),
                        damagedFile);
        done += *count;
        m_given += *count;
    }
    return {};
}

Result<std::uint64_t> VoxelSource::skipRest(std::uint64_t most, const Progress& progress) {
    // Mostly nothing comes, so the memory is not cleared.
    constexpr std::size_t scratchBytes = std::size_t{1} << 20;
    const auto memory = std::make_unique_for_overwrite<std::uint8_t[]>(scratchBytes);
    const std::span scratch(memory.get(), scratchBytes);
    std::uint64_t total = 0;
    while (total <= most) {
        if (progress.cancelled()) return cancelled(m_file.path());
        // A multiple of 8 holds whole values of any type. One value is enough to show that there is more.
        const auto piece = std::min<std::uint64_t>(scratch.size(), std::max<std::uint64_t>(most / 8 * 8, 8));
        const auto count = readSome(scratch.first(static_cast<std::size_t>(piece)));
        if (!count) return tl::unexpected(count.error());
        if (*count == 0) break;
        total += *count;
    }
    return total;
}

Result<std::uint64_t> VoxelSource::countBytes(std::uint64_t limit, const Progress& progress) {
    const auto total = skipRest(limit, progress);
    rewind();
    return total;
}

}  // namespace echolucent
