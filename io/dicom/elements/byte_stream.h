// The bytes of a DICOM file in order, stored as they are or deflated.
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

/// The bytes of a file in order, as stored or inflated. The position only moves forward. `file` and `progress` must
/// outlive the stream.
class ByteStream {
public:
    /// `progress` is polled for cancel while bytes are inflated: an inflating stream ends at a cancel. A stream that
    /// does not inflate ignores it.
    ByteStream(const InputFile& file, const Progress& progress) : m_file(&file), m_progress(&progress) {}

    /// How many bytes were read or skipped so far. Of deflated data, the inflated bytes count.
    [[nodiscard]] std::uint64_t position() const { return m_position; }
    [[nodiscard]] bool inflates() const { return m_inflater != nullptr; }
    /// Whether the file inflates to more than mostUnpackedBytes(). The stream ends there.
    [[nodiscard]] bool inflatesTooMuch() const { return m_inflatesTooMuch; }
    /// How many bytes were inflated so far. Reads that failed at the end count too.
    [[nodiscard]] std::uint64_t inflated() const { return m_inflated; }
    /// Whether the deflated data are complete. Read them to their end first.
    [[nodiscard]] bool inflatesToItsEnd() const { return m_inflater != nullptr && m_inflater->isComplete(); }
    /// The position behind the last byte. Read deflated data to their end first.
    [[nodiscard]] std::uint64_t end() const { return m_inflater ? m_inflateStart + m_inflated : m_file->size(); }
    /// Inflates everything from here on as a raw deflate stream.
    void inflateFromHere();
    /// Reads `count` bytes. If there are fewer or they cannot be read, it gives false and position() stays. Deflated
    /// bytes that such a read has taken are lost.
    bool read(std::uint8_t* bytes, std::size_t count);
    /// Moves forward and returns by how many bytes: fewer than `count` if the stream ends before.
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
