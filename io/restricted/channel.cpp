#include "io/restricted/channel.h"

#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <span>
#include <utility>

namespace echolucent::restricted {

namespace {

/// The beginning of every packet.
struct PacketHead {
    std::uint32_t kind = 0;
    std::uint32_t inMemory = 0;  // whether the bytes are in shared memory, the packet's last file
    std::uint64_t bytes = 0;
};

constexpr std::size_t mostPacketBytes = std::size_t{32} << 10;
// One more, for shared memory.
constexpr std::size_t mostPacketFiles = mostMessageFiles + 1;

int waitFor(int socket, short what, std::chrono::milliseconds patience) {
    pollfd waiting{socket, what, 0};
    int ready = 0;
    do ready = poll(&waiting, 1, static_cast<int>(patience.count()));
    while (ready < 0 && errno == EINTR);
    return ready;
}

/// Copies the bytes from a packet's memory, as the sender may still change them.
bool readAll(int file, std::uint64_t size, std::string& bytes) {
    struct stat status {};
    if (fstat(file, &status) != 0 || !S_ISREG(status.st_mode) || static_cast<std::uint64_t>(status.st_size) < size)
        return false;
    bytes.resize(static_cast<std::size_t>(size));
    std::span<char> rest(bytes);
    for (off_t at = 0; !rest.empty();) {
        const ssize_t got = pread(file, rest.data(), rest.size(), at);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        at += got;
        rest = rest.subspan(static_cast<std::size_t>(got));
    }
    return true;
}

/// Room for the open files of one packet.
union FileRoom {
    cmsghdr head;
    std::array<char, CMSG_SPACE(mostPacketFiles * sizeof(int))> bytes;
};

std::vector<Descriptor> filesOf(msghdr& packet) {
    std::vector<Descriptor> files;
    for (cmsghdr* part = CMSG_FIRSTHDR(&packet); part != nullptr; part = CMSG_NXTHDR(&packet, part)) {
        if (part->cmsg_level != SOL_SOCKET || part->cmsg_type != SCM_RIGHTS) continue;
        const std::size_t count = (part->cmsg_len - CMSG_LEN(0)) / sizeof(int);
        for (std::size_t index = 0; index < count; ++index) {
            int number = -1;
            std::memcpy(&number, CMSG_DATA(part) + index * sizeof(int), sizeof number);
            files.emplace_back(number);
        }
    }
    return files;
}

}  // namespace

Descriptor sharedMemory(std::uint64_t bytes) {
    Descriptor memory(memfd_create("echolucent", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!memory || ftruncate(memory.number(), static_cast<off_t>(bytes)) != 0) return {};
    return memory;
}

std::optional<std::pair<Descriptor, Descriptor>> Channel::pair() {
    std::array<int, 2> ends{-1, -1};
    if (socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) return std::nullopt;
    return std::pair(Descriptor(ends[0]), Descriptor(ends[1]));
}

bool Channel::send(MessageKind kind, const std::string& bytes, const std::vector<int>& files,
                   std::chrono::milliseconds patience) {
    PacketHead head{static_cast<std::uint32_t>(kind), 0, bytes.size()};
    std::vector<int> numbers = files;
    Descriptor memory;
    if (bytes.size() > mostPacketBytes) {
        memory = sharedMemory(0);
        if (!memory || writeAll(memory.number(), bytes) != 0) return false;
        numbers.push_back(memory.number());
        head.inMemory = 1;
    }
    std::array<iovec, 2> parts{iovec{&head, sizeof head},
                               iovec{const_cast<char*>(bytes.data()), memory ? 0 : bytes.size()}};
    FileRoom room{};
    msghdr packet{};
    packet.msg_iov = parts.data();
    packet.msg_iovlen = parts.size();
    if (!numbers.empty()) {
        packet.msg_control = room.bytes.data();
        packet.msg_controllen = CMSG_SPACE(numbers.size() * sizeof(int));
        cmsghdr* const part = CMSG_FIRSTHDR(&packet);
        part->cmsg_level = SOL_SOCKET;
        part->cmsg_type = SCM_RIGHTS;
        part->cmsg_len = CMSG_LEN(numbers.size() * sizeof(int));
        std::memcpy(CMSG_DATA(part), numbers.data(), numbers.size() * sizeof(int));
    }
    const std::lock_guard alone(m_sending);
    if (waitFor(m_socket.number(), POLLOUT, patience) <= 0) return false;
    ssize_t sent = 0;
    do sent = sendmsg(m_socket.number(), &packet, MSG_NOSIGNAL);
    while (sent < 0 && errno == EINTR);
    return sent >= 0;
}

Channel::Wait Channel::receive(Message& message, std::chrono::milliseconds patience) {
    const int ready = waitFor(m_socket.number(), POLLIN, patience);
    if (ready == 0) return Wait::nothingYet;
    if (ready < 0) return Wait::ended;
    PacketHead head;
    std::string bytes(mostPacketBytes, '\0');
    std::array<iovec, 2> parts{iovec{&head, sizeof head}, iovec{bytes.data(), bytes.size()}};
    FileRoom room{};
    msghdr packet{};
    packet.msg_iov = parts.data();
    packet.msg_iovlen = parts.size();
    packet.msg_control = room.bytes.data();
    packet.msg_controllen = sizeof room.bytes;
    ssize_t got = 0;
    do got = recvmsg(m_socket.number(), &packet, MSG_CMSG_CLOEXEC);
    while (got < 0 && errno == EINTR);
    if (got <= 0) return Wait::ended;
    std::vector<Descriptor> files = filesOf(packet);
    const auto size = static_cast<std::size_t>(got);
    const bool whole = (packet.msg_flags & (MSG_TRUNC | MSG_CTRUNC)) == 0 && size >= sizeof head &&
                       head.kind <= static_cast<std::uint32_t>(MessageKind::result) && head.bytes <= mostMessageBytes;
    if (!whole) return Wait::ended;
    if (head.inMemory != 0) {
        if (files.empty() || size != sizeof head || !readAll(files.back().number(), head.bytes, bytes))
            return Wait::ended;
        files.pop_back();
    } else {
        if (size != sizeof head + head.bytes) return Wait::ended;
        bytes.resize(size - sizeof head);
    }
    if (files.size() > mostMessageFiles) return Wait::ended;
    message = {static_cast<MessageKind>(head.kind), std::move(bytes), std::move(files)};
    return Wait::arrived;
}

}  // namespace echolucent::restricted
