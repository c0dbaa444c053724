#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/report/parameter_page.h"
#include "io/output/atomic_file.h"
#include "processing/adaptive/method_parameters.h"

namespace echolucent::cli {

void addParametersCommand(CLI::App& program, Action& action) {
    CLI::App& command = *program.add_subcommand(
        "parameters", "Prints the method's parameters with range, default and source, as docs/cli-otf.md has them");
    const auto json = std::make_shared<bool>(false);
    command.add_flag(
        "--json", *json,
        "Prints the rows of all tables as JSON: of the method, the designers, the look and the curve's sliders");
    command.footer("Example: echolucent-cli parameters");
    command.callback([json, &action] {
        action = [json] {
            return writeFileAtomically("-",
                                       *json ? allParametersJson() : parameterPage(defaultsOf(methodParameters())));
        };
    });
}

}  // namespace echolucent::cli
