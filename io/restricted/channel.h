// The pipe between the workstation and its reader process. Messages with open files arrive in order, each whole or not
// at all.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "io/files/descriptor.h"

namespace echolucent::restricted {

/// The kind of a message. Questions and answers alternate; progress comes at any time.
enum class MessageKind : std::uint32_t {
    request,      ///< to the reader: what to read; the first message and the only one of its kind
    openFile,     ///< from the reader: a path; the answer brings the open file
    fileKind,     ///< from the reader: a path; the answer says what is there
    resolvePath,  ///< from the reader: a path; the answer has no links in it
    listFolder,   ///< from the reader: a folder; the answer lists the files below it
    answer,       ///< to the reader
    confined,     ///< from the reader: its confinement
    progress,     ///< from the reader: the share done
    coarse,       ///< from the reader, once, if the request wants it: what a coarse grid shows, as a study
    result,       ///< from the reader: its last message
};

/// One message. If its bytes are too many for a packet, they travel in shared memory.
struct Message {
    MessageKind kind = MessageKind::request;
    std::string bytes;
    std::vector<Descriptor> files;
};

/// The longest message; a list of 50,000 files with the longest paths is shorter.
constexpr std::uint64_t mostMessageBytes = std::uint64_t{256} << 20;
/// The most open files of a message.
constexpr std::size_t mostMessageFiles = 2;

/// One end of the pipe. send() may be called from several threads at once.
class Channel {
public:
    explicit Channel(Descriptor socket) : m_socket(std::move(socket)) {}
    /// Two ends that belong together; no value if the system gives none.
    [[nodiscard]] static std::optional<std::pair<Descriptor, Descriptor>> pair();

    /// False if the other end is gone or takes nothing within `patience` (negative: for ever), or if there is no shared
    /// memory for long bytes.
    [[nodiscard]] bool send(MessageKind kind, const std::string& bytes, const std::vector<int>& files = {},
                            std::chrono::milliseconds patience = std::chrono::milliseconds(-1));

    enum class Wait { arrived, nothingYet, ended };
    /// Waits at most `patience` (negative: for ever) for a message. `ended`: the other end is gone, or what came is no
    /// message.
    [[nodiscard]] Wait receive(Message& message, std::chrono::milliseconds patience);

    [[nodiscard]] int socket() const { return m_socket.number(); }

private:
    Descriptor m_socket;
    std::mutex m_sending;
};

/// Memory of `bytes` bytes without a name that both ends can share, opened for reading and writing. It can be sealed.
/// The descriptor is not open if the system gives no memory.
[[nodiscard]] Descriptor sharedMemory(std::uint64_t bytes);

}  // namespace echolucent::restricted
