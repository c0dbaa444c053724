#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/cli/program.h"
#include "app/cli/study_program.h"

namespace {

/// Adds the command that a command line names, or all of them if it names none. The options of all take 2 ms to add,
/// and 100 ms under the address sanitizer, where tests start a thousand commands.
void addCommands(CLI::App& program, echolucent::cli::Action& action, const echolucent::cli::Invocation& invocation,
                 const std::vector<std::string>& words) {
    using namespace echolucent::cli;
    program.footer("Example: echolucent-cli render chest.mha -o chest.png");
    const std::pair<std::string_view, std::function<void()>> commands[] = {
        {"info", [&] { addInfoCommand(program, action); }},
        {"files", [&] { addFilesCommand(program, action); }},
        {"otf", [&] { addOtfCommand(program, action, invocation); }},
        {"parameters", [&] { addParametersCommand(program, action); }},
        {"render", [&] { addRenderCommand(program, action); }},
        {"compare", [&] { addCompareCommand(program, action); }},
        {"lesson", [&] { addLessonCommand(program, action, invocation); }},
        {"quiet", [&] { addQuietCommand(program, action); }},
        {"phantom", [&] { addPhantomCommand(program, action); }},
        {"study", [&] { addStudyProgram(program); }},  // and bench; never the only ones (isForStudyProgram())
        {"sweep", [&] { addSweepCommand(program, action, invocation); }},
    };
    const auto isNamed = [&](const auto& command) { return !words.empty() && words.front() == command.first; };
    const bool namesOne = std::ranges::any_of(commands, isNamed);
    for (const auto& command : commands)
        if (!namesOne || isNamed(command)) command.second();
}

}  // namespace

int main(int count, char** arguments) {
    using namespace echolucent::cli;
    if (isForStudyProgram(count, arguments)) {
        const auto failed = becomeStudyProgram(count, arguments);
        std::fprintf(stderr, "%s\n", failed.error().sentence().c_str());
        return exitStatus(failed.error());
    }
    CLI::App program{"Echolucent: adaptive opacity transfer functions for 3D ultrasound. Not a medical device."};
    const Invocation invocation{std::string("echolucent-cli ") + ECHOLUCENT_VERSION,
                                {arguments + 1, arguments + count}};
    const auto add = [&](CLI::App& commands, Action& action) {
        addCommands(commands, action, invocation, wordsOf(count, arguments));
    };
    return runProgram(program, invocation.program, add, count, arguments);
}
