#include "app/cli/study_program.h"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstring>

#include "app/cli/program.h"
#include "io/program_beside.h"

namespace echolucent::cli {

namespace {

constexpr std::pair<const char*, const char*> commandsOfStudyProgram[] = {
    {"bench", "Measures how fast a stage is"}, {"study", "Reports of the method's error, run time and stability"}};

}  // namespace

void addStudyProgram(CLI::App& program) {
    for (const auto& [name, meaning] : commandsOfStudyProgram) program.add_subcommand(name, meaning)->allow_extras();
}

bool isForStudyProgram(int count, char** arguments) {
    const auto words = wordsOf(count, arguments);
    return !words.empty() && std::ranges::any_of(commandsOfStudyProgram,
                                                 [&](const auto& command) { return words.front() == command.first; });
}

Result<void> becomeStudyProgram(int count, char** arguments) {
    std::string program = programBeside("echolucent-study");
    std::vector<char*> words{program.data()};
    words.insert(words.end(), arguments + 1, arguments + count);
    words.push_back(nullptr);
    execv(program.c_str(), words.data());
    return fail(FailureKind::unreadable, program, "",
                std::string("cannot be started to measure: ") + (errno == ENOENT ? "it is not there" : strerror(errno)),
                "Install Echolucent again.");
}

}  // namespace echolucent::cli
