#include "io/writers/deflate_stream.h"

#include <zlib.h>

#include <algorithm>
#include <new>
#include <utility>
#include <vector>

namespace echolucent {

namespace {
// Speckle hardly compresses: higher levels cost much time and gain little.
constexpr int compressionLevel = 3;
// The window has 15 bits; 16 more make zlib write gzip.
constexpr int zlibWindow = 15, gzipWindow = 15 + 16, memoryLevel = 8;
}  // namespace

struct DeflateStream::State {
    z_stream stream{};
    std::vector<std::uint8_t> buffer = std::vector<std::uint8_t>(std::size_t{1} << 18);

    explicit State(DeflateFormat format) {
        const int window = format == DeflateFormat::gzip ? gzipWindow : zlibWindow;
        if (deflateInit2(&stream, compressionLevel, Z_DEFLATED, window, memoryLevel, Z_DEFAULT_STRATEGY) != Z_OK)
            throw std::bad_alloc();
    }
    ~State() { deflateEnd(&stream); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
};

DeflateStream::DeflateStream(DeflateFormat format) : m_state(std::make_unique<State>(format)) {}

DeflateStream::~DeflateStream() = default;

void DeflateStream::add(const std::uint8_t* bytes, std::size_t count) {
    constexpr std::size_t piece = std::size_t{1} << 30;  // zlib counts in 32 bits
    for (std::size_t done = 0; done < count;) {
        const std::size_t next = std::min(piece, count - done);
        m_state->stream.next_in = const_cast<Bytef*>(bytes + done);
        m_state->stream.avail_in = static_cast<uInt>(next);
        drain(Z_NO_FLUSH);
        done += next;
    }
}

std::string DeflateStream::finish() {
    m_state->stream.avail_in = 0;
    drain(Z_FINISH);
    return std::move(m_output);
}

void DeflateStream::drain(int flush) {
    z_stream& stream = m_state->stream;
    std::vector<std::uint8_t>& buffer = m_state->buffer;
    do {
        stream.next_out = buffer.data();
        stream.avail_out = static_cast<uInt>(buffer.size());
        deflate(&stream, flush);
        m_output.append(reinterpret_cast<const char*>(buffer.data()), buffer.size() - stream.avail_out);
    } while (stream.avail_out == 0);
}

}  // namespace echolucent
