#include <CLI/CLI.hpp>

#include "app/cli/command.h"
#include "app/cli/report/parameter_page.h"
#include "io/output/atomic_file.h"
#include "processing/adaptive/method_parameters.h"

namespace echolucent::cli {

void addParametersCommand(CLI::App& program, Action& action) {
    CLI::App& command = *program.add_subcommand(
        "parameters", "Prints the method's parameters with range, default and source, as docs/cli-otf.md has them");
    command.footer("Example: echolucent-cli parameters");
    command.callback(
        [&action] { action = [] { return writeFileAtomically("-", parameterPage(methodParameters())); }; });
}

}  // namespace echolucent::cli
