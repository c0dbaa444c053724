// `lesson`: a lesson in a folder as a page for a class.
#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

#include "app/cli/command.h"
#include "app/cli/options/volume_options.h"
#include "app/pages/lesson_handout.h"
#include "io/lesson/lesson_file.h"
#include "io/output/atomic_file.h"
#include "io/output/overwriting.h"

namespace echolucent::cli {

namespace {

struct LessonOptions {
    std::string folder, page, language = "en";
    std::string program;  ///< name and version
};

Result<void> writePage(const LessonOptions& options) {
    if (auto checked = checkOutputs({options.page}); !checked) return checked;
    const auto files = lessonFilesIn(options.folder);
    if (!files) return tl::unexpected<Failure>(files.error());
    std::vector<std::string> inputs;
    for (const auto& [name, bytes] : files->bytes) inputs.push_back(options.folder + "/" + name);
    if (auto checked = refuseToOverwrite(inputs, {options.page}); !checked) return checked;
    const auto lesson = lessonFrom(*files);
    if (!lesson) return tl::unexpected<Failure>(lesson.error());
    LessonHandout handout;
    handout.language = options.language;
    handout.program = options.program;
    handout.pictures = *lessonPictures(*lesson);  // never cancelled
    return writeFileAtomically(options.page, lessonHandout(*lesson, handout));
}

}  // namespace

void addLessonCommand(CLI::App& program, Action& action, const Invocation& invocation) {
    auto options = std::make_shared<LessonOptions>();
    options->program = invocation.program;
    CLI::App& command = *program.add_subcommand("lesson", "Writes a lesson as a page for a class, with its pictures");
    command.add_option("FOLDER", options->folder, "The lesson's folder")->required();
    command.add_option("--page", options->page, "HTML file to write; it needs no network")
        ->type_name("OUT.html")
        ->required();
    command
        .add_option("--language", options->language, "Language of the texts; if the lesson has none, as in the window")
        ->type_name("NAME")
        ->capture_default_str();
    command.footer("Example: echolucent-cli lesson two-curves --page two-curves.html");
    command.callback([options, &action] { action = [options] { return writePage(*options); }; });
}

}  // namespace echolucent::cli
