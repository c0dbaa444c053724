// A file opened for reading at any position, and arithmetic on sizes that cannot overflow.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// a * b, or none where it does not fit into 63 bits. Both at least 0.
[[nodiscard]] std::optional<std::int64_t> checkedProduct(std::int64_t a, std::int64_t b);

/// Bytes of main memory in this machine.
[[nodiscard]] std::uint64_t machineMemoryBytes();

/// Fails with a sentence about `file` where `bytes` is more than this machine's memory.
[[nodiscard]] Result<void> requireMemory(const std::string& file, const std::string& element, std::uint64_t bytes);

/// A regular file opened for reading.
class InputFile {
public:
    [[nodiscard]] static Result<InputFile> open(const std::string& path);
    InputFile(InputFile&& other) noexcept;
    InputFile& operator=(InputFile&& other) noexcept;
    InputFile(const InputFile&) = delete;
    InputFile& operator=(const InputFile&) = delete;
    ~InputFile();

    [[nodiscard]] const std::string& path() const { return m_path; }
    [[nodiscard]] std::uint64_t size() const { return m_size; }
    /// Fills `bytes` from `offset` on; fails where the file ends before. Thread-safe.
    [[nodiscard]] Result<void> readAt(std::uint64_t offset, std::span<std::uint8_t> bytes) const;
    /// The first `limit` bytes, or the whole file where it is shorter.
    [[nodiscard]] Result<std::string> beginning(std::size_t limit) const;

private:
    InputFile(std::string path, int descriptor, std::uint64_t size);
    std::string m_path;
    int m_descriptor = -1;
    std::uint64_t m_size = 0;
};

}  // namespace echolucent
