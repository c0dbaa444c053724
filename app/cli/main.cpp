#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/cli/program.h"
#include "app/cli/study_program.h"

namespace {

void addCommands(CLI::App& program, echolucent::cli::Action& action) {
    using namespace echolucent::cli;
    program.footer(
        "Example: echolucent-cli render chest.mha --beam-axis +y --near 18 --otf adaptive --shade -o chest.png");
    addInfoCommand(program, action);
    addFilesCommand(program, action);
    addOtfCommand(program, action);
    addParametersCommand(program, action);
    addRenderCommand(program, action);
    addCompareCommand(program, action);
    addQuietCommand(program, action);
    addPhantomCommand(program, action);
    addStudyProgram(program);
    addSweepCommand(program, action);
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
    return runProgram(program, std::string("echolucent-cli ") + ECHOLUCENT_VERSION, addCommands, count, arguments);
}
