// Runs a command with a bound on its time, and writes down how it ended and what it took:
// measured_command BOUND_SECONDS ACCOUNT OUTPUT ERRORS COMMAND...
//
// It is a program of its own, and a small one, since the kernel counts what a process held before it became another
// program as that program's memory: a command started by a test of 500 MB would seem to take 500 MB.
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

using Clock = std::chrono::steady_clock;

/// The largest memory that a living process held so far, in KiB; 0 where it cannot be told.
long highWaterKib(pid_t process) {
    char name[64];
    std::snprintf(name, sizeof name, "/proc/%d/status", process);
    std::FILE* file = std::fopen(name, "r");
    if (file == nullptr) return 0;
    char line[256];
    long kib = 0;
    while (std::fgets(line, sizeof line, file) != nullptr)
        if (std::sscanf(line, "VmHWM: %ld", &kib) == 1) break;
    std::fclose(file);
    return kib;
}

/// The same of a process and of all that it started: too much where they share pages, and never too little.
long highWaterOfTreeKib(pid_t process) {
    long sum = highWaterKib(process);
    char name[64];
    std::snprintf(name, sizeof name, "/proc/%d/task/%d/children", process, process);
    std::FILE* file = std::fopen(name, "r");
    if (file == nullptr) return sum;
    int child = 0;
    while (std::fscanf(file, "%d", &child) == 1) sum += highWaterOfTreeKib(child);
    std::fclose(file);
    return sum;
}

/// The process itself becomes the command; it returns only where that fails.
void becomeCommand(const char* output, const char* errors, char** command) {
    setpgid(0, 0);
    const rlimit noCore{0, 0};
    setrlimit(RLIMIT_CORE, &noCore);
    const int in = open("/dev/null", O_RDONLY), out = open(output, O_WRONLY | O_CREAT | O_TRUNC, 0600),
              err = open(errors, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    if (in < 0 || out < 0 || err < 0 || dup2(in, 0) < 0 || dup2(out, 1) < 0 || dup2(err, 2) < 0) return;
    execv(command[0], command);
}

/// Waits for all processes of a group up to a time; whether none is left.
bool groupEnds(pid_t group, Clock::time_point until) {
    for (;;) {
        const pid_t ended = waitpid(-group, nullptr, WNOHANG);
        if (ended < 0) return errno == ECHILD;
        if (ended > 0) continue;
        if (Clock::now() > until) return false;
        poll(nullptr, 0, 1);
    }
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 6) {
        std::fprintf(stderr, "measured_command BOUND_SECONDS ACCOUNT OUTPUT ERRORS COMMAND...\n");
        return 2;
    }
    const std::chrono::duration<double> bound(std::atof(arguments[1]));
    // What the command leaves behind becomes a child of this process, so that it is seen.
    prctl(PR_SET_CHILD_SUBREAPER, 1);
    const auto begin = Clock::now();
    const pid_t process = fork();
    if (process == 0) {
        becomeCommand(arguments[3], arguments[4], arguments + 5);
        std::_Exit(127);
    }
    // The C library of Debian 12 declares pidfd_open() for C alone.
    const int handle = process > 0 ? static_cast<int>(syscall(SYS_pidfd_open, process, 0)) : -1;
    if (handle < 0) {
        std::perror("measured_command");
        return 2;
    }
    setpgid(process, process);  // as the child does, whoever comes first

    bool hangs = false;
    long treeKib = 0;
    pollfd ended{handle, POLLIN, 0};
    while (poll(&ended, 1, 5) == 0) {
        treeKib = std::max(treeKib, highWaterOfTreeKib(process));
        if (!hangs && Clock::now() - begin > bound) {
            hangs = true;
            kill(-process, SIGKILL);
        }
    }
    int raw = 0;
    rusage used{};
    if (wait4(process, &raw, 0, &used) != process) return 2;
    const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
    const bool leaves = !groupEnds(process, Clock::now() + std::chrono::seconds(1));
    if (leaves) {
        kill(-process, SIGKILL);
        groupEnds(process, Clock::now() + std::chrono::seconds(1));
    }

    std::FILE* account = std::fopen(arguments[2], "w");
    if (account == nullptr) return 2;
    std::fprintf(account, "%d %d %d %d %.6f %ld %ld\n", WIFEXITED(raw) ? WEXITSTATUS(raw) : -1,
                 WIFSIGNALED(raw) ? WTERMSIG(raw) : 0, hangs ? 1 : 0, leaves ? 1 : 0, seconds, used.ru_maxrss, treeKib);
    return std::fclose(account) == 0 ? 0 : 2;
}
