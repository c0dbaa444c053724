// The bytes behind a raw deflate stream in a file, in order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "io/files/input_file.h"

namespace echolucent {

/// Inflates a raw deflate stream (no zlib or gzip header), as deflated DICOM files hold it.
class RawInflater {
public:
    /// The stream begins at byte `offset` of `file`, which must outlive this object.
    RawInflater(const InputFile& file, std::uint64_t offset);
    ~RawInflater();
    RawInflater(const RawInflater&) = delete;
    RawInflater& operator=(const RawInflater&) = delete;

    /// Fills `bytes` as far as the stream goes and returns how many bytes that were. Damaged data end the stream.
    std::size_t read(std::span<std::uint8_t> bytes);
    /// Whether the stream came to the end that it states itself; one that is cut or damaged never does.
    [[nodiscard]] bool isComplete() const;

private:
    struct State;
    const InputFile& m_file;
    std::uint64_t m_position;
    std::unique_ptr<State> m_state;
};

}  // namespace echolucent
