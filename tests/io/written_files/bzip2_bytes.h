// Bytes that bzip2 compressed, for test files.
#pragma once

#include <bzlib.h>

#include <stdexcept>
#include <string>

namespace echolucent {

/// Compresses bytes in blocks of `blockSize` times 100,000 bytes, 1 to 9. Throws std::runtime_error if that fails.
inline std::string bzipped(const std::string& bytes, int blockSize = 1) {
    std::string out(bytes.size() + bytes.size() / 100 + 700, '\0');
    auto length = static_cast<unsigned>(out.size());
    if (BZ2_bzBuffToBuffCompress(out.data(), &length, const_cast<char*>(bytes.data()),
                                 static_cast<unsigned>(bytes.size()), blockSize, 0, 0) != BZ_OK)
        throw std::runtime_error("bytes could not be compressed");
    out.resize(length);
    return out;
}

}  // namespace echolucent
