// The bytes of a DICOM file one after the other, stored as they are or deflated.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "io/files/input_file.h"
#include "io/files/raw_inflater.h"
#include "processing/progress.h"

namespace echolucent {

/// A file's bytes in order, from the file or through inflate, with a position that can be moved forward. File and
/// progress must outlive it.
class ByteStream {
public:
    /// `progress` is polled for cancel while bytes are inflated; a cancelled stream has no more of them.
    ByteStream(const InputFile& file, const Progress& progress) : m_file(&file), m_progress(&progress) {}

    /// Bytes that were read or skipped so far, inflated ones where it inflates.
    [[nodiscard]] std::uint64_t position() const { return m_position; }
    [[nodiscard]] bool inflates() const { return m_inflater != nullptr; }
    /// Whether more was inflated than mostUnpackedBytes() lets out of the file; the stream ends there.
    [[nodiscard]] bool inflatesTooMuch() const { return m_inflatesTooMuch; }
    /// How many bytes were inflated so far, those of reads that failed at the end among them.
    [[nodiscard]] std::uint64_t inflated() const { return m_inflated; }
    /// Whether what it inflates came to its own end; it has to be read to its end before.
    [[nodiscard]] bool inflatesToItsEnd() const { return m_inflater != nullptr && m_inflater->isComplete(); }
    /// The position behind the last byte; where it inflates, it has to be read to its end before.
    [[nodiscard]] std::uint64_t end() const { return m_inflater ? m_inflateStart + m_inflated : m_file->size(); }
    /// Takes everything from here on as a raw deflate stream.
    void inflateFromHere();
    /// Reads `count` bytes; false, and the position stays, where there are fewer.
    bool read(std::uint8_t* bytes, std::size_t count);
    /// Moves forward; returns how many bytes there were (fewer than `count` at the end).
    std::uint64_t skip(std::uint64_t count);

private:
    bool buffered(std::uint64_t position);
    std::size_t inflate(std::span<std::uint8_t> bytes);

    const InputFile* m_file;
    const Progress* m_progress;
    bool m_inflatesTooMuch = false;
    std::uint64_t m_inflated = 0;
    std::uint64_t m_inflateStart = 0;
    std::uint64_t m_mostInflated = 0;
    std::uint64_t m_position = 0;
    std::vector<std::uint8_t> m_buffer;
    std::uint64_t m_bufferStart = 0;
    std::unique_ptr<RawInflater> m_inflater;
};

}  // namespace echolucent
