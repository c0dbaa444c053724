#include "process_memory.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <thread>

namespace echolucent::bench {

namespace {

using Clock = std::chrono::steady_clock;

/// Proportional set size of one process in KiB; 0 where it has ended.
long pssOf(pid_t process) {
    std::ifstream file("/proc/" + std::to_string(process) + "/smaps_rollup");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("Pss:")) return std::stol(line.substr(4));
    return 0;
}

/// The same of a process and all that it started.
long pssOfTree(pid_t process) {
    long sum = pssOf(process);
    std::error_code error;
    for (const auto& task : std::filesystem::directory_iterator("/proc/" + std::to_string(process) + "/task", error)) {
        std::ifstream children(task.path() / "children");
        for (pid_t child = 0; children >> child;) sum += pssOfTree(child);
    }
    return sum;
}

}  // namespace

WatchedRun watch(const std::vector<std::string>& command, double mostSeconds) {
    std::vector<char*> arguments;
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    WatchedRun run;
    const auto begin = Clock::now();
    const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    pid_t process = 0;
    if (posix_spawnp(&process, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0) return run;
    constexpr double kibibytes = 1024.0;
    int status = 0;
    bool ended = false, asked = false;
    while (!ended) {
        run.peakMebibytes = std::max(run.peakMebibytes, static_cast<double>(pssOfTree(process)) / kibibytes);
        if (seconds() > mostSeconds && !asked) {
            kill(process, SIGTERM);
            asked = true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        ended = waitpid(process, &status, WNOHANG) != 0;
    }
    run.seconds = seconds();
    run.succeeded = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    return run;
}

}  // namespace echolucent::bench
