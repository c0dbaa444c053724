// Asks other programs about a file: Python's readers, through scripts beside the tests, and checkers.
#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <string>

namespace echolucent {

/// How a program ended, and what it printed.
struct ToolOutcome {
    int status = -1;
    std::string output;
    bool missing = false;  ///< whether the program or its modules are missing, so that the test is skipped
};

/// Runs a shell command and keeps its standard output. The standard error goes where the command sends it.
inline ToolOutcome runTool(const std::string& command) {
    ToolOutcome outcome;
    std::FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return outcome;
    char buffer[65536];
    while (const auto count = std::fread(buffer, 1, sizeof buffer, pipe)) outcome.output.append(buffer, count);
    const int ended = pclose(pipe);
    outcome.status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
    return outcome;
}

/// Runs `python3 tests/io/written_files/SCRIPT ARGUMENTS`. If another python3 lacks the modules, Debian's own is tried:
/// its packages hold them. The standard error goes to the test's.
inline ToolOutcome runScript(const std::string& script, const std::string& arguments) {
    ToolOutcome outcome;
    for (const std::string python : {"python3", "/usr/bin/python3"}) {
        outcome = runTool(python + " " ECHOLUCENT_SOURCE_DIR "/tests/io/written_files/" + script + " " + arguments);
        constexpr int moduleMissing = 77, programMissing = 127;  // the scripts' own, and the shell's
        outcome.missing = outcome.status == moduleMissing || outcome.status == programMissing;
        if (!outcome.missing) break;
    }
    return outcome;
}

}  // namespace echolucent
