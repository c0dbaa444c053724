#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/measuring/study.h"

namespace echolucent::cli {

void addStudyCommand(CLI::App& program, Action& action) {
    CLI::App& study = *program.add_subcommand("study", "Reports of the method's error, run time and stability");
    study.require_subcommand(1);
    study.fallthrough();
    addStudyOtfCommand(study, action);
    addStudyContrastCommand(study, action);
    addStudyMotionCommand(study, action);
    addStudyStabilityCommand(study, action);
    addStudyRenderCommand(study, action);
    addStudyLightCommand(study, action);
    addStudyQuietCommand(study, action);
    addStudyCutCommand(study, action);
    addStudyDesignersCommand(study, action);
    study.footer("Example: echolucent-cli study otf --phantoms -o study");
}

}  // namespace echolucent::cli
