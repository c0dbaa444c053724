#include "io/restricted/reader_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <mutex>

#include <fmt/format.h>

#include "io/files/input_problems.h"
#include "io/program_beside.h"
#include "io/restricted/message.h"
#include "io/restricted/reader_limits.h"
#include "io/restricted/shared_study.h"

namespace echolucent::restricted {

namespace {

constexpr int readerSocket = 3;
// Lower priority than the threads that make the picture.
constexpr int niceAfterCoarse = 10;
// How often cancel is checked.
constexpr std::chrono::milliseconds lookEvery(20);
// A sleeping disk takes seconds. A reader that is silent for minutes never answers.
constexpr std::chrono::minutes longestSilence(5);

struct ProgramPath {
    std::mutex access;
    std::string path;
};
ProgramPath& programPath() {
    static ProgramPath path;
    return path;
}

/// The open files and signals of a new process.
class SpawnPlan {
public:
    explicit SpawnPlan(int socket) {
        posix_spawn_file_actions_init(&m_files);
        posix_spawnattr_init(&m_attributes);
        posix_spawn_file_actions_addopen(&m_files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        posix_spawn_file_actions_addopen(&m_files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
        // Libraries may print what they read, also names.
        posix_spawn_file_actions_addopen(&m_files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
#endif
        posix_spawn_file_actions_adddup2(&m_files, socket, readerSocket);
        posix_spawn_file_actions_addclosefrom_np(&m_files, readerSocket + 1);
        sigset_t none, all;
        sigemptyset(&none);
        sigfillset(&all);
        posix_spawnattr_setsigmask(&m_attributes, &none);
        posix_spawnattr_setsigdefault(&m_attributes, &all);
        // In its own group, the reader gets no Ctrl-C. The program that a person runs gets it and ends the reader.
        posix_spawnattr_setflags(&m_attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
    }
    ~SpawnPlan() {
        posix_spawn_file_actions_destroy(&m_files);
        posix_spawnattr_destroy(&m_attributes);
    }
    SpawnPlan(const SpawnPlan&) = delete;
    SpawnPlan& operator=(const SpawnPlan&) = delete;

    [[nodiscard]] int spawn(pid_t& process, const std::string& program, char* const* arguments) const {
        return posix_spawn(&process, program.c_str(), &m_files, &m_attributes, arguments, environ);
    }

private:
    posix_spawn_file_actions_t m_files{};
    posix_spawnattr_t m_attributes{};
};

/// Hands over the coarse volume of a message. False if the message holds none, or if none was wanted.
bool tellCoarse(const Message& message, const Progress& progress) {
    if (!progress.coarse || message.files.size() != 1) return false;
    const auto coarse = takeCoarse({reinterpret_cast<const std::uint8_t*>(message.bytes.data()), message.bytes.size()},
                                   message.files.front());
    if (coarse) progress.coarse(*coarse);
    return coarse.has_value();
}

}  // namespace

std::string readerProgram() {
    ProgramPath& known = programPath();
    const std::lock_guard alone(known.access);
    if (!known.path.empty()) return known.path;
    known.path = programBeside("echolucent-reader");
    return known.path;
}

void useReaderProgram(const std::string& path) {
    ProgramPath& known = programPath();
    const std::lock_guard alone(known.access);
    known.path = path;
}

Result<std::unique_ptr<ReaderProcess>> ReaderProcess::start(bool loadsAhead) {
    const std::string program = readerProgram();
    const auto cannot = [&](const std::string& why) {
        return fail(FailureKind::unreadable, program, "", "cannot be started to read files: " + why,
                    "Install Echolucent again.");
    };
    auto ends = Channel::pair();
    if (!ends) return cannot(std::strerror(errno));
    const SpawnPlan plan(ends->second.number());
    std::string name = program, ahead = "--load-ahead";
    std::array<char*, 3> arguments{name.data(), loadsAhead ? ahead.data() : nullptr, nullptr};
    pid_t process = -1;
    if (const int error = plan.spawn(process, program, arguments.data()); error != 0)
        return cannot(error == ENOENT ? "it is not there" : std::strerror(error));
    return std::unique_ptr<ReaderProcess>(new ReaderProcess(process, std::move(ends->first)));
}

ReaderProcess::~ReaderProcess() { static_cast<void>(end(true)); }

int ReaderProcess::end(bool kill) {
    if (m_process < 0) return 0;
    if (kill) ::kill(m_process, SIGKILL);
    int status = 0;
    while (waitpid(m_process, &status, 0) < 0 && errno == EINTR) {
    }
    m_process = -1;
    return status;
}

bool ReaderProcess::request(const std::string& bytes) {
    m_baseBytes = addressSpaceOf(m_process);
    return m_channel.send(MessageKind::request, bytes, {}, std::chrono::seconds(5));
}

tl::unexpected<Failure> ReaderProcess::died(const std::string& file) {
    const int status = end(false);
    const auto refuse = [&](const std::string& problem, const std::string& remedy) {
        return fail(FailureKind::unreadable, file, "", problem, remedy);
    };
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
        return refuse("takes longer to read than any file of its size may", doNotOpen);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL)
        return refuse("was not read: the system ended the process that read it, most likely for want of memory",
                      "Close other programs and open it again.");
    if (WIFSIGNALED(status))
        return refuse(fmt::format("made the process that reads files end (signal {})", WTERMSIG(status)), doNotOpen);
    return refuse(fmt::format("was not read: the process that reads files ended without a word (status {})",
                              WIFEXITED(status) ? WEXITSTATUS(status) : -1),
                  "Open it again; where that does not help, do not open it.");
}

Result<ReaderProcess::Answer> ReaderProcess::serve(FileBroker& broker, const std::string& file,
                                                   const Progress& progress) {
    const auto noAnswer = [&]() -> tl::unexpected<Failure> {
        static_cast<void>(end(true));
        return fail(FailureKind::unreadable, file, "",
                    "was not read: the process that reads files said what makes no sense", doNotOpen);
    };
    Answer result;
    holdTo(limitsFor(0), m_process, m_baseBytes);
    auto heard = std::chrono::steady_clock::now();
    bool coarseIsThere = false;
    while (true) {
        if (progress.cancelled()) {
            static_cast<void>(end(true));
            return fail(FailureKind::cancelled, file, "", "was not read: cancelled");
        }
        Message message;
        const Channel::Wait wait = m_channel.receive(message, lookEvery);
        if (wait == Channel::Wait::nothingYet) {
            if (std::chrono::steady_clock::now() - heard < longestSilence) continue;
            static_cast<void>(end(true));
            return fail(FailureKind::unreadable, file, "", "was not read: reading it does not go on",
                        "Look whether its disk or network still answers, and open it again.");
        }
        if (wait == Channel::Wait::ended) return died(file);
        heard = std::chrono::steady_clock::now();
        MessageReader reader({reinterpret_cast<const std::uint8_t*>(message.bytes.data()), message.bytes.size()});
        if (message.kind == MessageKind::confined && !m_hasBegun) {
            reader(result.systemCallsFiltered);
            m_hasBegun = true;
            if (!reader.complete()) return noAnswer();
            continue;
        }
        // An unconfined reader must not see anything of a file.
        if (!m_hasBegun) return noAnswer();
        if (message.kind == MessageKind::result) {
            static_cast<void>(end(true));
            result.bytes = std::move(message.bytes);
            result.files = std::move(message.files);
            result.asked = broker.asked();
            return result;
        }
        if (message.kind == MessageKind::progress) {
            double share = 0.0;
            reader(share);
            if (!reader.complete() || !(share >= 0.0 && share <= 1.0)) return noAnswer();
            progress.at(share);
            continue;
        }
        if (message.kind == MessageKind::coarse) {
            if (coarseIsThere || !tellCoarse(message, progress)) return noAnswer();
            coarseIsThere = true;
            // The coarse picture comes first.
            setpriority(PRIO_PROCESS, static_cast<id_t>(m_process), niceAfterCoarse);
            continue;
        }
        std::string bytes;
        Descriptor opened;
        if (!broker.answer(message, progress, bytes, opened)) return noAnswer();
        if (message.kind == MessageKind::openFile) holdTo(limitsFor(broker.openedBytes()), m_process, m_baseBytes);
        const std::vector<int> files = opened ? std::vector{opened.number()} : std::vector<int>{};
        if (!m_channel.send(MessageKind::answer, bytes, files, std::chrono::seconds(5))) return died(file);
    }
}

}  // namespace echolucent::restricted
