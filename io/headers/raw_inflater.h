// The bytes behind a raw deflate stream in a file, in order.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "io/input_file.h"

namespace echolucent {

class RawInflater {
public:
    RawInflater(const InputFile& file, std::uint64_t offset);
    ~RawInflater();
    RawInflater(const RawInflater&) = delete;
    RawInflater& operator=(const RawInflater&) = delete;

    /// Fills `bytes` as far as the stream goes; returns how many there were. Damaged data end the stream.
    std::size_t read(std::span<std::uint8_t> bytes);

private:
    struct State;
    const InputFile& m_file;
    std::uint64_t m_position;
    std::unique_ptr<State> m_state;
};

}  // namespace echolucent
