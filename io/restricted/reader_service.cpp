#include "io/restricted/reader_service.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <tbb/global_control.h>
#include <unistd.h>
#include <csignal>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>
#include <thread>

#include "io/dicom/elements/dicom_tables.h"
#include "io/files/input_problems.h"
#include "io/restricted/confinement.h"
#include "io/restricted/remote_files.h"
#include "io/restricted/request.h"
#include "io/restricted/shared_study.h"
#include "io/voxels/voxel_bytes.h"

namespace echolucent::restricted {

namespace {

constexpr std::size_t pageSize = 4096;

[[noreturn]] void leave() { _exit(1); }

/// Tells the workstation the progress of reading, at most every 20 ms.
class ProgressSender {
public:
    explicit ProgressSender(Channel& channel) : m_channel(channel) {}
    void at(double share) {
        const auto now = std::chrono::steady_clock::now();
        constexpr std::chrono::milliseconds apart(20);
        if (now - m_last < apart) return;
        m_last = now;
        MessageWriter writer;
        writer(share);
        if (!m_channel.send(MessageKind::progress, writer.bytes())) leave();
    }

private:
    Channel& m_channel;
    std::chrono::steady_clock::time_point m_last{};
};

/// Ends the process when the workstation is gone, as nobody waits for the minutes that reading may take.
void endWithTheWorkstation(int socket) {
    std::thread([socket] {
        pollfd gone{socket, POLLRDHUP, 0};
        while (poll(&gone, 1, -1) < 0 && errno == EINTR) {
        }
        leave();
    }).detach();
}

template <typename Value>
bool sendOutcome(Channel& channel, const Result<Value>& done) {
    MessageWriter writer;
    writer(done ? std::optional<Failure>() : std::optional(done.error()), done.has_value());
    if (done) writer(*done);
    return channel.send(MessageKind::result, writer.bytes());
}

bool sendStudy(Channel& channel, Result<Study> read, SharedVoxelMemory& memory) {
    const Result<SharedStudy> shared = read ? shareStudy(std::move(*read), memory) : tl::unexpected(read.error());
    MessageWriter writer;
    writer(shared ? std::optional<Failure>() : std::optional(shared.error()));
    if (!shared) return channel.send(MessageKind::result, writer.bytes());
    return channel.send(MessageKind::result, writer.bytes() + shared->bytes, {shared->voxels.number()});
}

/// Sends the coarse volume, which can be seen before the study is read. If it cannot be shared, it is left out, because
/// the study follows.
void sendCoarse(Channel& channel, const CoarseVolume& coarse) {
    const Result<SharedStudy> shared = shareCoarse(coarse);
    if (shared && !channel.send(MessageKind::coarse, shared->bytes, {shared->voxels.number()})) leave();
}

/// Performs the request and sends its result. Reads in this process, unlike the functions of restricted_reader.h with
/// the same names. False if the result cannot be sent.
bool perform(Channel& channel, const Request& request, SharedVoxelMemory& memory, const Progress& progress) {
    switch (request.task) {
        case Task::readStudy:
            return sendStudy(channel, echolucent::readStudy(request.path, request.options, progress), memory);
        case Task::readSeries:
            return sendStudy(
                channel, echolucent::readSeries(request.list, request.list.series.front(), request.options, progress),
                memory);
        case Task::listSeries: return sendOutcome(channel, echolucent::listSeries(request.path, progress));
        case Task::holdsSeries: return sendOutcome(channel, Result<bool>(echolucent::holdsSeries(request.path)));
        case Task::middlePicture:
            return sendOutcome(channel, echolucent::middlePicture(request.list.series.front(),
                                                                  std::max(1, request.longestEdge), progress));
        case Task::readPatient:
            return sendOutcome(channel, echolucent::readPatient(request.files, request.series, progress));
    }
    return false;
}

/// The failure if memory runs out outside of readStudy().
Failure tooLarge(const Request& request) {
    return fail(FailureKind::unreadable, request.path.empty() ? request.list.path : request.path, "",
                "needs more memory than a file of its size may take", doNotOpen)
        .value();
}

}  // namespace

int serveReader(const ReaderStart& start) {
    if (start.loadsAhead) loadDicomTables();
    Channel channel{Descriptor(start.socket)};
    Message message;
    if (channel.receive(message, std::chrono::milliseconds(-1)) != Channel::Wait::arrived) return 0;
    Request request;
    MessageReader reader({reinterpret_cast<const std::uint8_t*>(message.bytes.data()), message.bytes.size()});
    reader(request);
    if (!reader.complete()) return 2;
    if (request.mayBeDicom && !start.loadsAhead) loadDicomTables();
    const Confinement confinement = confine();
    MessageWriter writer;
    writer(confinement.systemCalls);
    if (!channel.send(MessageKind::confined, writer.bytes())) return 1;
    endWithTheWorkstation(start.socket);
    RemoteFileAccess files(channel, leave);
    useFileAccess(files);
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(std::max(1, request.threads)));
    SharedVoxelMemory memory;
    setVoxelMemory(memory);
    ProgressSender sender(channel);
    bool sent = false;
    Progress progress{[&](double share) { sender.at(share); }, nullptr};
    if (request.wantsCoarse) progress.coarse = [&](const CoarseVolume& coarse) { sendCoarse(channel, coarse); };
    try {
        sent = perform(channel, request, memory, progress);
    } catch (const std::bad_alloc&) {
        sent = sendOutcome(channel, Result<bool>(tl::unexpected(tooLarge(request))));
    } catch (const std::length_error&) {
        sent = sendOutcome(channel, Result<bool>(tl::unexpected(tooLarge(request))));
    }
    // The kernel frees all memory at once, faster than piece by piece.
    _exit(sent ? 0 : 1);
}

int tryWhatIsForbidden() {
    const Confinement confinement = confine();
    std::printf("%s\n", inWords(confinement).c_str());
    bool allRefused = true;
    const auto tried = [&](const char* what, bool possible) {
        allRefused = allRefused && !possible;
        std::printf("%s: %s\n", what,
                    possible ? "POSSIBLE" : (std::string("refused (") + std::strerror(errno) + ")").c_str());
    };
    tried("opening a file", open("/etc/passwd", O_RDONLY | O_CLOEXEC) >= 0);
    tried("creating a file", open("/tmp", O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600) >= 0);
    tried("making a socket of the network", socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0) >= 0);
    tried("making a socket of this machine", socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0) >= 0);
    tried("signalling another process", kill(getppid(), 0) == 0);
    tried("mapping code",
          mmap(nullptr, pageSize, PROT_READ | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0) != MAP_FAILED);
    std::array<char*, 2> arguments{const_cast<char*>("/bin/true"), nullptr};
    const pid_t child = fork();
    if (child == 0) {
        execv(arguments[0], arguments.data());
        _exit(0);
    }
    tried("starting a process", child > 0);
    if (child > 0) waitpid(child, nullptr, 0);
    tried("running a program", execv(arguments[0], arguments.data()) == 0);
    std::thread([] {}).join();  // threads are needed and must start
    return allRefused ? 0 : 1;
}

}  // namespace echolucent::restricted
