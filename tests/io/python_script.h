// What another reader says, through a script beside the tests.
#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <optional>
#include <string>

namespace echolucent {

/// What `python3 tests/io/SCRIPT ARGUMENTS` prints; no value where it does not end well under any python3, as scripts
/// do whose modules are not there. Debian's own is tried too, since its packages hold these modules.
inline std::optional<std::string> printedByScript(const std::string& script, const std::string& arguments) {
    for (const char* python : {"python3", "/usr/bin/python3"}) {
        const std::string command =
            std::string(python) + " " ECHOLUCENT_SOURCE_DIR "/tests/io/" + script + " " + arguments + " 2>/dev/null";
        std::FILE* pipe = popen(command.c_str(), "r");
        if (pipe == nullptr) continue;
        std::string output;
        char buffer[65536];
        while (const auto count = std::fread(buffer, 1, sizeof buffer, pipe)) output.append(buffer, count);
        const int ended = pclose(pipe);
        if (WIFEXITED(ended) && WEXITSTATUS(ended) == 0) return output;
    }
    return std::nullopt;
}

}  // namespace echolucent
