#include "tests/fuzz/mutations/zlib_parts.h"

#include <zlib.h>

#include <algorithm>
#include <cstddef>

namespace echolucent {

namespace {

constexpr std::size_t mostUnpacked = std::size_t{4} << 20;

/// Points the stream at both; `out` must not move afterwards.
void point(z_stream& stream, std::string_view bytes, std::string& out) {
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
}

}  // namespace

std::string unpacked(std::string_view bytes, int windowBits) {
    // Most streams hold little: to clear memory for the most would take longer than all else of a mutation.
    for (std::size_t enough = std::size_t{1} << 14; true; enough = std::min(8 * enough, mostUnpacked)) {
        z_stream stream{};
        inflateInit2(&stream, windowBits);
        std::string out(enough, '\0');
        point(stream, bytes, out);
        inflate(&stream, Z_FINISH);
        const bool isFull = stream.avail_out == 0;
        out.resize(out.size() - stream.avail_out);
        inflateEnd(&stream);
        if (!isFull || enough == mostUnpacked) return out;
    }
}

std::string packed(std::string_view bytes, int windowBits) {
    z_stream stream{};
    deflateInit2(&stream, 1, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY);
    std::string out(deflateBound(&stream, bytes.size()) + 64, '\0');
    point(stream, bytes, out);
    deflate(&stream, Z_FINISH);
    out.resize(out.size() - stream.avail_out);
    deflateEnd(&stream);
    return out;
}

}  // namespace echolucent
