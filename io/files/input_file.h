// A file opened for reading at any position, and arithmetic on sizes that cannot overflow.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

class Descriptor;

/// a * b, or no value if the product does not fit into 63 bits. Both factors are at least 0.
[[nodiscard]] std::optional<std::int64_t> checkedProduct(std::int64_t a, std::int64_t b);

/// This machine's main memory in bytes; 2^40 if the system does not tell.
[[nodiscard]] std::uint64_t machineMemoryBytes();

/// Fails (unreadable) if `bytes` is more than this machine's memory. The message names `file` and its `element`, a
/// header key or a tag, which may be empty.
[[nodiscard]] Result<void> requireMemory(const std::string& file, const std::string& element, std::uint64_t bytes);

/// A regular file, open for reading. Copies share the open file.
class InputFile {
public:
    /// Fails (unreadable) if the file cannot be opened or is no regular file.
    [[nodiscard]] static Result<InputFile> open(const std::string& path);
    /// Takes over an open descriptor and closes it with the last copy. Messages name the file `path`. Fails
    /// (unreadable) if it is no regular file.
    [[nodiscard]] static Result<InputFile> adopt(const std::string& path, int descriptor);
    [[nodiscard]] const std::string& path() const { return m_path; }
    [[nodiscard]] std::uint64_t size() const { return m_size; }
    /// Fills `bytes` from byte `offset` of the file on. Fails (unreadable) if the file ends before or cannot be read.
    /// Several threads may call it at once.
    [[nodiscard]] Result<void> readAt(std::uint64_t offset, std::span<std::uint8_t> bytes) const;
    /// The first `limit` bytes of the file, or all of a shorter one.
    [[nodiscard]] Result<std::string> beginning(std::size_t limit) const;

private:
    InputFile(std::string path, std::shared_ptr<const Descriptor> descriptor, std::uint64_t size);
    std::string m_path;
    std::shared_ptr<const Descriptor> m_descriptor;
    std::uint64_t m_size = 0;
};

/// All bytes of the file at `path`. Fails (unreadable) if it cannot be read, is no regular file, or holds more than
/// `limit` bytes.
[[nodiscard]] Result<std::string> readWholeFile(const std::string& path, std::size_t limit);

}  // namespace echolucent
