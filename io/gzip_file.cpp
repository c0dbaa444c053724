#include "io/gzip_file.h"

#include <sys/mman.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "io/headers/header_text.h"

namespace echolucent {

namespace {

constexpr std::uint64_t alwaysUnpacked = std::uint64_t{256} << 20;
constexpr std::uint64_t largestRatio = 32;
constexpr std::size_t pieceBytes = std::size_t{1} << 20;

class GzipUnpacker {
public:
    explicit GzipUnpacker(const InputFile& packed)
        : m_packed(packed), m_most(mostUnpackedBytes(packed.size())), m_input(pieceBytes), m_output(pieceBytes) {
        // 16 more than the window's 15 bits take gzip and nothing else; zlib then verifies checksum and length.
        if (inflateInit2(&m_stream, 15 + 16) != Z_OK) throw std::bad_alloc();
    }
    ~GzipUnpacker() {
        inflateEnd(&m_stream);
        if (m_memory >= 0) close(m_memory);
    }
    GzipUnpacker(const GzipUnpacker&) = delete;
    GzipUnpacker& operator=(const GzipUnpacker&) = delete;

    Result<InputFile> unpack(const Progress& progress);

private:
    /// Reads more of the packed file where none is left; false at its end.
    Result<bool> refill();
    /// Whether another member follows the one that ended. Bytes that begin no member are padding.
    Result<bool> beginsAnother();
    Result<void> store(std::size_t count);
    [[nodiscard]] tl::unexpected<Failure> wrong(const std::string& problem, const std::string& remedy) const {
        return fail(FailureKind::unreadable, m_packed.path(), "", problem, remedy);
    }

    const InputFile& m_packed;
    std::uint64_t m_most;
    std::vector<std::uint8_t> m_input, m_output;
    z_stream m_stream{};
    std::uint64_t m_taken = 0, m_given = 0;
    int m_memory = -1;
};

Result<bool> GzipUnpacker::refill() {
    if (m_stream.avail_in > 0) return true;
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(m_input.size(), m_packed.size() - m_taken));
    if (count == 0) return false;
    if (const auto read = m_packed.readAt(m_taken, {m_input.data(), count}); !read) return tl::unexpected(read.error());
    m_taken += count;
    m_stream.next_in = m_input.data();
    m_stream.avail_in = static_cast<uInt>(count);
    return true;
}

Result<bool> GzipUnpacker::beginsAnother() {
    const auto more = refill();
    if (!more || !*more || *m_stream.next_in != 0x1f) return more ? Result<bool>(false) : more;
    inflateReset(&m_stream);
    return true;
}

Result<void> GzipUnpacker::store(std::size_t count) {
    m_given += count;
    if (m_given > m_most)
        return wrong(
            fmt::format("unpacks to more than {} bytes out of {}, which no volume does", m_most, m_packed.size()),
            "Unpack it with gunzip if you trust it, and open what comes out.");
    for (std::size_t done = 0; done < count;) {
        const ssize_t written = write(m_memory, m_output.data() + done, count - done);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0)
            return wrong(fmt::format("needs more memory than there is to be unpacked ({})", std::strerror(errno)),
                         "Unpack it with gunzip and open what comes out.");
        done += static_cast<std::size_t>(written);
    }
    return {};
}

Result<InputFile> GzipUnpacker::unpack(const Progress& progress) {
    m_memory = memfd_create("echolucent-unpacked", MFD_CLOEXEC);
    if (m_memory < 0)
        return wrong(std::string("cannot be unpacked in memory: ") + std::strerror(errno),
                     "Unpack it with gunzip and open what comes out.");
    for (bool ended = false; !ended;) {
        if (progress.cancelled()) return fail(FailureKind::cancelled, m_packed.path(), "", "was not read: cancelled");
        progress.at(static_cast<double>(m_taken - m_stream.avail_in) / static_cast<double>(m_packed.size()));
        const auto more = refill();
        if (!more) return tl::unexpected(more.error());
        m_stream.next_out = m_output.data();
        m_stream.avail_out = static_cast<uInt>(m_output.size());
        const int status = inflate(&m_stream, Z_NO_FLUSH);
        const std::size_t count = m_output.size() - m_stream.avail_out;
        if (status != Z_OK && status != Z_STREAM_END && status != Z_BUF_ERROR)
            return wrong(fmt::format("is damaged gzip near byte {}: {}", m_taken - m_stream.avail_in,
                                     m_stream.msg != nullptr ? m_stream.msg : "no gzip data"),
                         "Copy or export it again.");
        if (auto stored = store(count); !stored) return tl::unexpected(stored.error());
        if (status == Z_STREAM_END) {
            const auto another = beginsAnother();
            if (!another) return tl::unexpected(another.error());
            ended = !*another;
        } else if (count == 0 && !*more) {
            return wrong(fmt::format("is gzip that ends too early, after {} bytes", m_packed.size()),
                         "The file is incomplete: copy it again.");
        }
    }
    auto unpacked = InputFile::adopt(m_packed.path(), std::exchange(m_memory, -1));
    progress.at(1.0);
    return unpacked;
}

}  // namespace

bool looksLikeGzip(std::string_view beginning) { return beginning.starts_with("\x1f\x8b\x08"); }

std::string withoutGzipEnding(const std::string& path) {
    const std::string lower = lowerCase(path);
    for (const std::string_view ending : {".gz", ".gzip"})
        if (lower.ends_with(ending)) return path.substr(0, path.size() - ending.size());
    return path;
}

std::uint64_t mostUnpackedBytes(std::uint64_t packedBytes) {
    return std::min(machineMemoryBytes() / 2,
                    std::max(alwaysUnpacked, std::min(packedBytes, machineMemoryBytes()) * largestRatio));
}

Result<InputFile> unpackGzip(const InputFile& packed, const Progress& progress) {
    return GzipUnpacker(packed).unpack(progress);
}

}  // namespace echolucent
