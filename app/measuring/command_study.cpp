#include <CLI/CLI.hpp>

#include "app/measuring/study.h"

namespace echolucent::cli {

void addStudyCommand(CLI::App& program, Action& action) {
    CLI::App& study = *program.add_subcommand("study", "Reports of the method's error, run time and stability");
    study.require_subcommand(1);
    study.fallthrough();
    for (const auto& own : {otfStudy(), contrastStudy(), motionStudy(), stabilityStudy(), renderStudy(), lightStudy(),
                            quietStudy(), cutStudy(), sidesStudy(), designersStudy(), aimStudy(), theoryStudy()})
        StudyCommand::add(own, study, action);
    study.footer("Example: echolucent-cli study otf --phantoms -o study");
}

}  // namespace echolucent::cli
