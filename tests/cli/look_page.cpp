// docs/cli-render.md lists every option of the look as the table of the look has it.
#include <fmt/format.h>

#include <cctype>
#include <string>

#include "processing/picture/look.h"
#include "program.h"

namespace echolucent {
namespace {

std::string upper(std::string_view text) {
    std::string result(text);
    for (char& letter : result) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
    return result;
}

/// The row of the page, without its end of line.
std::string lineOf(const Parameter<Look>& parameter) {
    const ParameterValue standard = *parameter.get(lookAtStart());
    const std::string option = optionOf(parameter.name);
    if (std::holds_alternative<bool>(standard)) return fmt::format("| `{}` | {} | off |", option, parameter.meaning);
    if (const auto number = numberOf(standard))
        return fmt::format("| `{} {}` | {}, {} to {} | {:.3g} |", option,
                           parameter.unit.empty() ? "SHARE" : upper(parameter.unit), parameter.meaning,
                           textOf(parameter.range.least), textOf(parameter.range.largest), *number);
    std::string choices;
    for (const ParameterChoice& choice : parameter.choices)
        choices += fmt::format("{}`{}`", choices.empty() ? "" : ", ", choice.name);
    return fmt::format("| `{} NAME` | {}: {} | `{}` |", option, parameter.meaning, choices,
                       std::get<std::string>(standard));
}

TEST(LookPage, HasALineForEveryRowOfTheTable) {
    const std::string page = contentsOf(std::string(ECHOLUCENT_SOURCE_DIR) + "/docs/cli-render.md");
    const Outcome help = runProgram("render --help");
    for (const Parameter<Look>& parameter : lookParameters()) {
        EXPECT_NE(page.find(lineOf(parameter) + "\n"), std::string::npos) << "missing: " << lineOf(parameter);
        EXPECT_NE(help.output.find(optionOf(parameter.name)), std::string::npos) << parameter.name;
    }
}

TEST(LongLookPage, ShortFormsMakeTheSamePicture) {
    const Folder folder;
    const auto rendered = [&](const std::string& options) {
        const std::string file = folder / "picture.png";
        EXPECT_EQ(runProgram("render \"" + shapesFile() + "\" --otf parabolic --size 40x30 " + options + " -o \"" +
                             file + "\"")
                      .status,
                  0)
            << options;
        return contentsOf(file);
    };
    EXPECT_EQ(rendered("--shade"), rendered("--lighting surface"));
    EXPECT_EQ(rendered("--depth-colour"), rendered("--depth-colouring"));
    EXPECT_EQ(rendered("--perspective"), rendered("--projection perspective"));
    EXPECT_EQ(rendered("--light 60,-20"), rendered("--light-azimuth 60 --light-elevation -20"));
    EXPECT_NE(rendered("--light 60,-20"), rendered(""));
    EXPECT_NE(rendered("--lighting flat"), rendered("--shade"));
    EXPECT_NE(rendered("--perspective"), rendered(""));
}

TEST(LookPage, OutOfRangeIsSaidWithTheRangeOfTheTable) {
    const Folder folder;
    const Outcome outcome =
        runProgram("render \"" + shapesFile() + "\" --step 101 -o \"" + folder / "picture.png" + "\"");
    EXPECT_EQ(outcome.status, 2);
    EXPECT_NE(outcome.errors.find("--step must be 0.001 to 100 units"), std::string::npos) << outcome.errors;
}

}  // namespace
}  // namespace echolucent
