#include "io/dicom/elements/byte_stream.h"

#include <algorithm>
#include <array>

#include "io/voxels/gzip_file.h"

namespace echolucent {

void ByteStream::inflateFromHere() {
    m_inflater = std::make_unique<RawInflater>(*m_file, m_position);
    m_inflateStart = m_position;
    // mostUnpackedBytes() asks the system for its memory: once here, not at every read of two bytes.
    m_mostInflated = mostUnpackedBytes(m_file->size());
}

bool ByteStream::read(std::uint8_t* bytes, std::size_t count) {
    if (m_inflater) {
        if (inflate({bytes, count}) != count) return false;
    } else {
        for (std::size_t done = 0; done < count; ++done) {
            if (m_position + done >= m_file->size()) return false;
            if (!buffered(m_position + done)) return false;
            bytes[done] = m_buffer[static_cast<std::size_t>(m_position + done - m_bufferStart)];
        }
    }
    m_position += count;
    return true;
}

std::uint64_t ByteStream::skip(std::uint64_t count) {
    std::uint64_t skipped = 0;
    if (!m_inflater) {
        skipped = std::min(count, m_file->size() - std::min(m_position, m_file->size()));
    } else {
        std::array<std::uint8_t, 65536> scratch{};
        while (skipped < count) {
            const auto want = static_cast<std::size_t>(std::min<std::uint64_t>(scratch.size(), count - skipped));
            const std::size_t got = inflate({scratch.data(), want});
            skipped += got;
            if (got < want) break;
        }
    }
    m_position += skipped;
    return skipped;
}

std::size_t ByteStream::inflate(std::span<std::uint8_t> bytes) {
    if (m_inflatesTooMuch || m_progress->cancelled()) return 0;
    const std::size_t count = m_inflater->read(bytes);
    m_inflated += count;
    m_inflatesTooMuch = m_inflated > m_mostInflated;
    return m_inflatesTooMuch ? 0 : count;
}

bool ByteStream::buffered(std::uint64_t position) {
    if (position >= m_bufferStart && position < m_bufferStart + m_buffer.size()) return true;
    m_buffer.resize(static_cast<std::size_t>(std::min<std::uint64_t>(4096, m_file->size() - position)));
    m_bufferStart = position;
    return static_cast<bool>(m_file->readAt(position, m_buffer));
}

}  // namespace echolucent
