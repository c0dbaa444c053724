// Compresses bytes for a file, piece by piece.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace echolucent {

enum class DeflateFormat { zlib, gzip };

/// Compresses the added bytes. The same bytes always give the same stream: gzip names neither file nor date.
class DeflateStream {
public:
    explicit DeflateStream(DeflateFormat format);
    ~DeflateStream();
    DeflateStream(const DeflateStream&) = delete;
    DeflateStream& operator=(const DeflateStream&) = delete;

    void add(const std::uint8_t* bytes, std::size_t count);
    /// Ends the stream and returns it. Nothing may be added afterwards.
    [[nodiscard]] std::string finish();

private:
    struct State;
    void drain(int flush);
    std::unique_ptr<State> m_state;
    std::string m_output;
};

}  // namespace echolucent
