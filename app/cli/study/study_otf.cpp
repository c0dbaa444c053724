#include <memory>

#include "app/cli/study/study.h"

namespace echolucent::cli {

void addStudyOtfCommand(CLI::App& study, Action& action) {
    CLI::App& command = *study.add_subcommand("otf", "Error against run time of the adaptive OTF");
    command.callback([&action] { action = [] { return Result<void>(); }; });
}

}  // namespace echolucent::cli
