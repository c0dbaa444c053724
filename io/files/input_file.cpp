#include "io/files/input_file.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <utility>

#include <fmt/format.h>

#include "io/files/descriptor.h"
#include "io/files/file_access.h"
#include "io/files/input_problems.h"

namespace echolucent {

std::optional<std::int64_t> checkedProduct(std::int64_t a, std::int64_t b) {
    std::int64_t product = 0;
    if (__builtin_mul_overflow(a, b, &product)) return std::nullopt;
    return product;
}

std::uint64_t machineMemoryBytes() {
    const long pages = sysconf(_SC_PHYS_PAGES);
    const long pageBytes = sysconf(_SC_PAGESIZE);
    return pages > 0 && pageBytes > 0 ? static_cast<std::uint64_t>(pages) * static_cast<std::uint64_t>(pageBytes)
                                      : std::uint64_t{1} << 40;
}

Result<void> requireMemory(const std::string& file, const std::string& element, std::uint64_t bytes) {
    const std::uint64_t available = machineMemoryBytes();
    if (bytes <= available) return {};
    return fail(FailureKind::unreadable, file, element,
                fmt::format("needs {} bytes of memory, this machine has {}", bytes, available),
                "Open it on a larger machine, or a smaller part of it.");
}

InputFile::InputFile(std::string path, std::shared_ptr<const Descriptor> descriptor, std::uint64_t size)
    : m_path(std::move(path)), m_descriptor(std::move(descriptor)), m_size(size) {}

Result<InputFile> InputFile::open(const std::string& path) {
    const auto number = fileAccess().open(path);
    if (!number) return tl::unexpected(number.error());
    return adopt(path, *number);
}

Result<InputFile> InputFile::adopt(const std::string& path, int number) {
    auto descriptor = std::make_shared<const Descriptor>(number);
    struct stat status {};
    if (fstat(number, &status) != 0 || !S_ISREG(status.st_mode))
        return fail(FailureKind::unreadable, path, "", "is not a file that can be read", "Check the name.");
    return InputFile(path, std::move(descriptor), static_cast<std::uint64_t>(status.st_size));
}

Result<void> InputFile::readAt(std::uint64_t offset, std::span<std::uint8_t> bytes) const {
    std::size_t done = 0;
    while (done < bytes.size()) {
        const ssize_t count =
            pread(m_descriptor->number(), bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0)
            return fail(FailureKind::unreadable, m_path, "", "could not be read: " + inputProblem(errno),
                        "Check the disc and the connection to it.");
        if (count == 0)
            return fail(FailureKind::unreadable, m_path, "",
                        fmt::format("ends after {} bytes where {} are needed", offset + done, offset + bytes.size()),
                        incompleteFile);
        done += static_cast<std::size_t>(count);
    }
    return {};
}

Result<std::string> InputFile::beginning(std::size_t limit) const {
    std::string bytes(static_cast<std::size_t>(std::min<std::uint64_t>(limit, m_size)), '\0');
    const auto read = readAt(0, {reinterpret_cast<std::uint8_t*>(bytes.data()), bytes.size()});
    if (!read) return tl::unexpected(read.error());
    return bytes;
}

Result<std::string> readWholeFile(const std::string& path, std::size_t limit) {
    const auto file = InputFile::open(path);
    if (!file) return tl::unexpected(file.error());
    if (file->size() > limit)
        return fail(
            FailureKind::unreadable, path, "",
            fmt::format("holds {} bytes, more than the {} that a file of this kind can have", file->size(), limit),
            "Choose another file, or have this one written again.");
    return file->beginning(limit);
}

}  // namespace echolucent
