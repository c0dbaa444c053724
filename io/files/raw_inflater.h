// Unpacks a raw deflate stream in a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "io/files/input_file.h"

namespace echolucent {

/// Unpacks a raw deflate stream (no zlib or gzip header), as in deflated DICOM files.
class RawInflater {
public:
    /// The stream begins at byte `offset` of `file`, which must outlive this object.
    RawInflater(const InputFile& file, std::uint64_t offset);
    ~RawInflater();
    RawInflater(const RawInflater&) = delete;
    RawInflater& operator=(const RawInflater&) = delete;

    /// Fills `bytes` with the next bytes and returns how many came: fewer if the stream or the file ends. Damaged data
    /// end the stream.
    std::size_t read(std::span<std::uint8_t> bytes);
    /// Whether the stream's own end was reached. A cut or damaged stream never reaches it.
    [[nodiscard]] bool isComplete() const;

private:
    struct State;
    const InputFile& m_file;
    std::uint64_t m_position;
    std::unique_ptr<State> m_state;
};

}  // namespace echolucent
