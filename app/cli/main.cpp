#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/cli/program.h"
#include "app/cli/study_program.h"

namespace {

void addCommands(CLI::App& program, echolucent::cli::Action& action, const echolucent::cli::Invocation& invocation) {
    using namespace echolucent::cli;
    program.footer("Example: echolucent-cli render chest.mha -o chest.png");
    addInfoCommand(program, action);
    addFilesCommand(program, action);
    addOtfCommand(program, action, invocation);
    addParametersCommand(program, action);
    addRenderCommand(program, action);
    addCompareCommand(program, action);
    addLessonCommand(program, action, invocation);
    addQuietCommand(program, action);
    addPhantomCommand(program, action);
    addStudyProgram(program);
    addSweepCommand(program, action, invocation);
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
    const auto add = [&](CLI::App& commands, Action& action) { addCommands(commands, action, invocation); };
    return runProgram(program, invocation.program, add, count, arguments);
}
