#include <CLI/CLI.hpp>

#include "app/cli/program.h"
#include "app/measuring/study.h"

namespace {

void addCommands(CLI::App& program, echolucent::cli::Action& action) {
    using namespace echolucent::cli;
    program.footer("Example: echolucent-cli study otf --phantoms -o study");
    addBenchCommand(program, action);
    addStudyCommand(program, action);
}

}  // namespace

/// `echolucent-cli study` and `echolucent-cli bench` start this program.
int main(int count, char** arguments) {
    CLI::App program{"Echolucent's studies and benches. Not a medical device."};
    // This program calls itself echolucent-cli: that is the program that a person has started.
    return echolucent::cli::runProgram(program, std::string("echolucent-cli ") + ECHOLUCENT_VERSION, addCommands, count,
                                       arguments);
}
