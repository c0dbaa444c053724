#include "io/voxels/gzip_file.h"

#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "io/voxels/voxel_source.h"
#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

constexpr std::uint64_t alwaysUnpacked = std::uint64_t{256} << 20;
constexpr std::uint64_t largestUnpackedRatio = 32;
constexpr std::size_t unpackedPieceBytes = std::size_t{1} << 20;

/// A file in memory, written from its beginning on.
class MemoryFile {
public:
    MemoryFile() : m_descriptor(memfd_create("echolucent-unpacked", MFD_CLOEXEC)) {}
    ~MemoryFile() {
        if (m_descriptor >= 0) close(m_descriptor);
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    /// False if there is not enough memory, or if the system gave no file.
    [[nodiscard]] bool write(std::span<const std::uint8_t> bytes) {
        while (m_descriptor >= 0 && !bytes.empty()) {
            const ssize_t written = ::write(m_descriptor, bytes.data(), bytes.size());
            if (written < 0 && errno == EINTR) continue;
            if (written <= 0) return false;
            bytes = bytes.subspan(static_cast<std::size_t>(written));
        }
        return m_descriptor >= 0;
    }
    /// Gives up the descriptor: the caller closes it.
    [[nodiscard]] int release() { return std::exchange(m_descriptor, -1); }

private:
    int m_descriptor;
};

}  // namespace

bool looksLikeGzip(std::string_view beginning) { return beginning.starts_with(gzipSignature); }

std::string withoutGzipEnding(const std::string& path) {
    const std::string lower = lowerCase(path);
    for (const std::string_view ending : {".gz", ".gzip"})
        if (lower.ends_with(ending)) return path.substr(0, path.size() - ending.size());
    return path;
}

std::uint64_t mostUnpackedBytes(std::uint64_t packedBytes) {
    return std::min(machineMemoryBytes() / 2,
                    std::max(alwaysUnpacked, std::min(packedBytes, machineMemoryBytes()) * largestUnpackedRatio));
}

Result<InputFile> unpackGzip(const InputFile& packed, const Progress& progress) {
    const auto wrong = [&](const std::string& problem, const std::string& remedy) {
        return fail(FailureKind::unreadable, packed.path(), "", problem, remedy);
    };
    const std::uint64_t most = mostUnpackedBytes(packed.size());
    VoxelSource source(packed, {.offset = 0, .length = packed.size(), .encoding = VoxelEncoding::zlib, .skipBytes = 0},
                       StoredType::uint8);
    MemoryFile memory;
    // The piece is not cleared first, because most packed files are far smaller.
    const auto memoryOfPiece = std::make_unique_for_overwrite<std::uint8_t[]>(unpackedPieceBytes);
    const std::span piece(memoryOfPiece.get(), unpackedPieceBytes);
    for (std::uint64_t given = 0; true;) {
        if (progress.cancelled()) return fail(FailureKind::cancelled, packed.path(), "", "was not read: cancelled");
        progress.at(source.shareTaken());
        const auto count = source.readSome(piece);
        if (!count) return tl::unexpected(count.error());
        if (*count == 0) break;
        given += *count;
        if (given > most)
            return wrong(
                fmt::format("unpacks to more than {} bytes out of {}, which no volume does", most, packed.size()),
                "Unpack it with gunzip if you trust it, and open what comes out.");
        if (!memory.write(piece.first(*count)))
            return wrong("needs more memory than there is to be unpacked",
                         "Unpack it with gunzip and open what comes out.");
    }
    if (!source.ended())
        return wrong(fmt::format("is gzip that ends too early, after {} bytes", packed.size()),
                     "The file is incomplete: copy it again.");
    if (!memory.write({}))
        return wrong("needs more memory than there is to be unpacked",
                     "Unpack it with gunzip and open what comes out.");
    progress.at(1.0);
    return InputFile::adopt(packed.path(), memory.release());
}

}  // namespace echolucent
