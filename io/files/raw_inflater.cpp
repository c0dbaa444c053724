#include "io/files/raw_inflater.h"

#include <zlib.h>

#include <algorithm>
#include <vector>

namespace echolucent {

struct RawInflater::State {
    z_stream stream{};
    std::vector<std::uint8_t> input = std::vector<std::uint8_t>(65536);
    bool ended = false;
    bool complete = false;
    State() { inflateInit2(&stream, -15); }
    ~State() { inflateEnd(&stream); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
};

RawInflater::RawInflater(const InputFile& file, std::uint64_t offset)
    : m_file(file), m_position(offset), m_state(std::make_unique<State>()) {}

RawInflater::~RawInflater() = default;

std::size_t RawInflater::read(std::span<std::uint8_t> bytes) {
    z_stream& stream = m_state->stream;
    stream.next_out = bytes.data();
    stream.avail_out = static_cast<uInt>(bytes.size());
    while (stream.avail_out > 0 && !m_state->ended) {
        if (stream.avail_in == 0) {
            const std::uint64_t rest = m_file.size() - std::min(m_position, m_file.size());
            const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(m_state->input.size(), rest));
            if (count == 0 || !m_file.readAt(m_position, {m_state->input.data(), count})) break;
            m_position += count;
            stream.next_in = m_state->input.data();
            stream.avail_in = static_cast<uInt>(count);
        }
        const int status = inflate(&stream, Z_NO_FLUSH);
        m_state->ended = status != Z_OK && status != Z_BUF_ERROR;
        m_state->complete = status == Z_STREAM_END;
    }
    return bytes.size() - stream.avail_out;
}

bool RawInflater::isComplete() const { return m_state->complete; }

}  // namespace echolucent
