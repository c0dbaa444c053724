#include "measured_run.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace echolucent {

namespace {

std::string textOf(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

std::int64_t MeasuredRun::memoryBytes() const { return std::max(largestProcessBytes, sumOfProcessesBytes); }

MeasuredRun measuredRun(const std::vector<std::string>& command, const std::filesystem::path& scratch,
                        double boundSeconds) {
    std::vector<std::string> words{ECHOLUCENT_MEASURED_COMMAND, std::to_string(boundSeconds), scratch / "account",
                                   scratch / "output", scratch / "errors"};
    words.insert(words.end(), command.begin(), command.end());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);

    pid_t process = 0;
    if (posix_spawn(&process, arguments[0], nullptr, nullptr, arguments.data(), environ) != 0)
        throw std::runtime_error("no process could be started");
    int raw = 0;
    while (waitpid(process, &raw, 0) < 0)
        if (errno != EINTR) throw std::runtime_error("a process could not be waited for");

    MeasuredRun run;
    std::int64_t largestKib = 0, sumKib = 0;
    std::ifstream account(scratch / "account");
    account >> run.status >> run.signal >> run.hangs >> run.leavesProcesses >> run.seconds >> largestKib >> sumKib;
    if (!account || !WIFEXITED(raw) || WEXITSTATUS(raw) != 0)
        throw std::runtime_error("how a command ended could not be read");
    run.largestProcessBytes = largestKib * 1024;
    run.sumOfProcessesBytes = sumKib * 1024;
    run.output = textOf(scratch / "output");
    run.errors = textOf(scratch / "errors");
    return run;
}

}  // namespace echolucent
