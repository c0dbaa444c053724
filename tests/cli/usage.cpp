#include <algorithm>
#include <string>
#include <vector>

#include "program.h"

namespace echolucent {
namespace {

struct Row {
    std::string arguments;  ///< VOLUME stands for a file that can be read, FOLDER for an empty folder
    int status;
    std::string says;  ///< part of the message
};

std::string replaced(std::string text, const std::string& word, const std::string& with) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word))
        text.replace(at, word.size(), with);
    return text;
}

class ExitStatus : public testing::TestWithParam<Row> {};

TEST_P(ExitStatus, AndOneSentenceForAPerson) {
    const Folder folder;
    const Outcome outcome =
        runProgram(replaced(replaced(GetParam().arguments, "VOLUME", shapesFile()), "FOLDER", folder / ""));
    EXPECT_EQ(outcome.status, GetParam().status) << GetParam().arguments << "\n" << outcome.errors;
    EXPECT_NE(outcome.errors.find(GetParam().says), std::string::npos) << outcome.errors;
    EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << outcome.errors;
    EXPECT_LT(outcome.errors.size(), 300u) << outcome.errors;
}

INSTANTIATE_TEST_SUITE_P(
    Otf, ExitStatus,
    testing::Values(Row{"", 2, ""}, Row{"otf", 2, "VOLUME"}, Row{"otf VOLUME --nonsense", 2, "nonsense"},
                    Row{"otf VOLUME --tube-grid 0x5", 2, "--tube-grid"},
                    Row{"otf VOLUME --tube-grid 15", 2, "--tube-grid"},
                    Row{"otf VOLUME --cell-size 99", 2, "--cell-size must be 2 to 32"},
                    Row{"otf VOLUME --cell-size five", 2, "cell-size"},
                    Row{"otf VOLUME --form product --strength -1", 2, "strength"},
                    Row{"otf VOLUME --form product --strength nan", 2, "strength"},
                    Row{"otf VOLUME --tube-spacing -3", 2, "--tube-spacing must be 0 to"},
                    Row{"otf VOLUME --opacity-scale -1", 2, "--opacity-scale"},
                    Row{"otf VOLUME --reading settled --significance 2", 2, "significance"},
                    Row{"otf VOLUME --reading settled --finest-scale 9", 2, "scales"},
                    Row{"otf VOLUME --floor-quantile 1.5", 2, "--floor-quantile must be 0 to 1"},
                    Row{"otf VOLUME --initial cubic", 2, "is not an opacity curve"},
                    Row{"otf VOLUME --initial manual:", 2, "is not an opacity curve"},
                    Row{"otf VOLUME --beam-axis w", 2, "--beam-axis"}, Row{"otf VOLUME --near -1", 2, "--near"},
                    Row{"otf VOLUME --view-azimuth inf", 2, "--view-azimuth"},
                    Row{"otf VOLUME --phase 4", 2, "--phase"}, Row{"otf VOLUME --json - --csv -", 2, "standard output"},
                    Row{"otf VOLUME --threads 0", 2, "threads"}, Row{"otf FOLDER/missing.mha", 3, "missing.mha"},
                    Row{"otf FOLDER", 3, ""}, Row{"otf VOLUME --initial manual:FOLDER/missing.json", 3, "missing.json"},
                    Row{"otf VOLUME --json FOLDER/none/otf.json", 4, "otf.json"},
                    Row{"otf VOLUME --csv FOLDER/none/o.csv", 4, "o.csv"},
                    Row{"otf VOLUME --json /dev/full/otf.json", 4, "otf.json"},
                    Row{"nonsense", 2, "\"nonsense\" is not a command"}, Row{"otf VOLUME --phase -1", 2, "--phase"},
                    Row{"info VOLUME --raw-size 4x4x4 --raw-header-bytes -1", 2, "--raw-header-bytes"},
                    Row{"otf VOLUME --tube-grid 4000x4000", 2, "262144"},
                    Row{"otf VOLUME --view-azimuth 1e300", 2, "--view-azimuth"},
                    Row{"otf VOLUME --json FOLDER/x --csv FOLDER/x", 2, "named twice"},
                    Row{"otf VOLUME --json VOLUME", 2, "would overwrite"},
                    Row{"render VOLUME -o VOLUME", 2, "would overwrite"},
                    Row{"render VOLUME --otf cubic -o FOLDER/x.png", 2, "adaptive"},
                    Row{"phantom FOLDER/p.mha --truth FOLDER/p.mha", 2, "named twice"},
                    Row{"phantom FOLDER/p.mha --seed -1", 2, "--seed"},
                    Row{"phantom FOLDER/p.mha --seed 18446744073709551616", 2, "--seed"},
                    Row{"otf VOLUME --raw-spacing 1x1x1", 2, "--raw-size"}));

INSTANTIATE_TEST_SUITE_P(
    ShortForms, ExitStatus,
    testing::Values(Row{"otf VOLUME --tube-grid 3x3 --tube-rows 5", 2, "--tube-grid"},
                    Row{"otf VOLUME --tube-columns 5 --tube-grid 3x3", 2, "--tube-columns"},
                    Row{"otf VOLUME --sigma 1 --sigma-per-kernel-size 1", 2, "--sigma"},
                    Row{"otf VOLUME --interface-function variance --sigma 9", 2, "--sigma must be 0.01 to 4"},
                    Row{"otf VOLUME --interface-function variance --sigma-per-kernel-size 9", 2,
                        "--sigma-per-kernel-size must be 0.01 to 4"},
                    Row{"render VOLUME --light 40,-20 --light-azimuth 5 -o FOLDER/x.png", 2, "--light-azimuth"},
                    Row{"render VOLUME --light-elevation 5 --light 40,-20 -o FOLDER/x.png", 2, "--light-elevation"},
                    Row{"render VOLUME --projection parallel --perspective -o FOLDER/x.png", 2, "--perspective"},
                    Row{"render VOLUME --light 200,0 -o FOLDER/x.png", 2,
                        "--light must be an azimuth from -180 to 180 and an elevation from -90 to 90 degrees"}));

INSTANTIATE_TEST_SUITE_P(
    Numbers, ExitStatus,
    testing::Values(Row{"phantom FOLDER/p.mha --size abc", 2, "--size must be like 199x197x199, not \"abc\""},
                    Row{"phantom FOLDER/p.mha --contrast 1,2", 2, "--contrast must be like 14,85,170"},
                    Row{"render VOLUME --background 1 -o FOLDER/x.png", 2, "--background must be like 14,85,170"},
                    Row{"render VOLUME --light 40 -o FOLDER/x.png", 2, "--light must be like 40,-20"}));

TEST(Usage, ASpacingThatNoScannerMakesIsRefusedBeforeAnythingIsComputed) {
    const Folder folder;
    for (const std::string spacing : {"1e-9 1 1", "1e-3 1 1.1", "1 1 1e5"}) {
        write(folder / "h.mha",
              "ObjectType = Image\nNDims = 3\nDimSize = 4 4 4\nElementType = MET_UCHAR\nElementSpacing = " + spacing +
                  "\nElementDataFile = LOCAL\n" + std::string(64, 'x'));
        const Outcome outcome = runProgram("otf " + folder / "h.mha");
        EXPECT_EQ(outcome.status, 3) << spacing;
        EXPECT_NE(outcome.errors.find("ElementSpacing"), std::string::npos) << outcome.errors;
    }
}

TEST(Usage, EveryCommandHasHelpWithAnExample) {
    const Outcome program = runProgram("--help");
    EXPECT_EQ(program.status, 0);
    const std::string unknown = runProgram("nonsense").errors;
    for (const std::string command : {"info", "otf", "render", "phantom", "study", "sweep", "bench", "parameters"}) {
        EXPECT_NE(program.output.find(command), std::string::npos);
        EXPECT_NE(unknown.find(command), std::string::npos) << unknown;
        const Outcome help = runProgram(command + " --help");
        EXPECT_EQ(help.status, 0);
        EXPECT_NE(help.output.find("Example"), std::string::npos) << command;
        EXPECT_NE(help.output.find("echolucent-cli " + command), std::string::npos) << command;
    }
}

TEST(Usage, SaysItsVersion) {
    const Outcome outcome = runProgram("--version");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.output.find("echolucent-cli 0."), 0u) << outcome.output;
}

TEST(Usage, ThreadsMayStandBeforeOrAfterTheCommand) {
    EXPECT_EQ(runProgram("--threads 1 otf \"" + shapesFile() + "\"").status, 0);
    EXPECT_EQ(runProgram("otf \"" + shapesFile() + "\" --threads 1").status, 0);
}

}  // namespace
}  // namespace echolucent
