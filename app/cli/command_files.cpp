#include <CLI/CLI.hpp>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/options/volume_options.h"
#include "app/cli/report/file_table.h"
#include "io/output/atomic_file.h"

namespace echolucent::cli {

void addFilesCommand(CLI::App& program, Action& action) {
    CLI::App* command = program.add_subcommand(
        "files", "Say of every file in a folder, one by one, how it opens or why it does not, as a Markdown table");
    const auto folder = std::make_shared<std::string>();
    const auto output = std::make_shared<std::string>("-");
    command->add_option("FOLDER", *folder, "Folder; the folders in it are looked through too")->required();
    command->add_option("-o,--output", *output, "File to write; - is the standard output")->capture_default_str();
    command->footer("Example:\n  echolucent-cli files scans -o scans.md");
    command->callback([folder, output, &action] {
        action = [folder, output]() -> Result<void> {
            if (auto checked = checkOutputs({*output}); !checked) return checked;
            const auto table = fileTable(*folder, {}, *output);
            if (!table) return tl::unexpected(table.error());
            return writeFileAtomically(*output, *table);
        };
    });
}

}  // namespace echolucent::cli
