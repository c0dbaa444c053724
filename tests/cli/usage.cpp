#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "program.h"

namespace echolucent {
namespace {

struct UsageRow {
    std::string arguments;  ///< VOLUME stands for a file that can be read, FOLDER for an empty folder
    int status;
    std::string says;  ///< part of the message
};

std::string replaced(std::string text, const std::string& word, const std::string& with) {
    for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word))
        text.replace(at, word.size(), with);
    return text;
}

class ExitStatus : public testing::TestWithParam<UsageRow> {};

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
    testing::Values(
        UsageRow{"", 2, "No command is given: use info, "}, UsageRow{"otf", 2, "VOLUME"},
        UsageRow{"otf VOLUME --nonsense", 2, "nonsense"}, UsageRow{"otf VOLUME --tube-grid 0x5", 2, "--tube-grid"},
        UsageRow{"otf VOLUME --tube-grid 15", 2, "--tube-grid"},
        UsageRow{"otf VOLUME --cell-size 99", 2, "--cell-size must be 2 to 32"},
        UsageRow{"otf VOLUME --cell-size five", 2, "cell-size"},
        UsageRow{"otf VOLUME --form product --strength -1", 2, "strength"},
        UsageRow{"otf VOLUME --form product --strength nan", 2, "strength"},
        UsageRow{"otf VOLUME --tube-spacing 1,234", 2, "\"1,234\" has two meanings. Write 1.234 or 1234."},
        UsageRow{"otf VOLUME --cell-size 1,5", 2, "cell-size"},
        UsageRow{"otf VOLUME --cell-size 1,024", 2, "--cell-size must be 2 to 32"},
        UsageRow{"otf VOLUME --near 1,2,3", 2, "--near must be 0 mm or more"},
        UsageRow{"compare VOLUME", 2,
                 "is no document of the workstation. Compare OTFs of the volume in the window (F5)"},
        UsageRow{"compare FOLDER", 2, "is no document of the workstation"},
        UsageRow{"compare FOLDER/missing.json", 3, "does not exist"},
        UsageRow{"render --document VOLUME -o FOLDER/a.png", 2, "is no document of the workstation"},
        UsageRow{"otf VOLUME --tube-spacing -3", 2, "--tube-spacing must be 0 to"},
        UsageRow{"otf VOLUME --opacity-scale -1", 2, "--opacity-scale"},
        UsageRow{"otf VOLUME --reading settled --significance 2", 2, "significance"},
        UsageRow{"otf VOLUME --reading settled --finest-scale 9", 2, "scales"},
        UsageRow{"otf VOLUME --floor-quantile 1.5", 2, "--floor-quantile must be 0 to 1"},
        UsageRow{"otf VOLUME --initial cubic", 2, "is not an opacity curve"},
        UsageRow{"otf VOLUME --initial manual:", 2, "is not an opacity curve"},
        UsageRow{"otf VOLUME --beam-axis w", 2, "--beam-axis"}, UsageRow{"otf VOLUME --near -1", 2, "--near"},
        UsageRow{"otf VOLUME --view-azimuth inf", 2, "--view-azimuth"}, UsageRow{"otf VOLUME --phase 4", 2, "--phase"},
        UsageRow{"otf VOLUME --json - --csv -", 2, "standard output"}, UsageRow{"otf VOLUME --threads 0", 2, "threads"},
        UsageRow{"otf FOLDER/missing.mha", 3, "missing.mha"}, UsageRow{"otf FOLDER", 3, ""},
        UsageRow{"otf VOLUME --initial manual:FOLDER/missing.json", 3, "missing.json"},
        UsageRow{"otf VOLUME --json FOLDER/none/otf.json", 4, "otf.json"},
        UsageRow{"otf VOLUME --csv FOLDER/none/o.csv", 4, "o.csv"},
        UsageRow{"otf VOLUME --json /dev/full/otf.json", 4, "otf.json"},
        UsageRow{"nonsense", 2, "\"nonsense\" is not a command"}, UsageRow{"otf VOLUME --phase -1", 2, "--phase"},
        UsageRow{"info VOLUME --raw-size 4x4x4 --raw-header-bytes -1", 2, "--raw-header-bytes"},
        UsageRow{"otf VOLUME --tube-grid 4000x4000", 2, "262144"},
        UsageRow{"otf VOLUME --without-tube 225", 2,
                 "--without-tube must be 0 to 224 in a grid of 15x15 tube cores, not 225"},
        UsageRow{"otf VOLUME --without-tube 1,8,9 --tube-grid 3x3", 2, "must be 0 to 8"},
        UsageRow{"otf VOLUME --without-tube -1", 2, "--without-tube"},
        UsageRow{"otf VOLUME --without-tube 1,x", 2, "--without-tube"},
        UsageRow{"otf VOLUME --without-tube 99999999999999999999", 2, "--without-tube"},
        UsageRow{"render VOLUME --without-tube 300 -o FOLDER/x.png", 2, "--without-tube must be 0 to 224"},
        UsageRow{"sweep VOLUME --without-tube 300", 2, "--without-tube must be 0 to 224"},
        UsageRow{"otf VOLUME --view-azimuth 1e300", 2, "--view-azimuth"},
        UsageRow{"otf VOLUME --json FOLDER/x --csv FOLDER/x", 2, "named twice"},
        UsageRow{"otf VOLUME --json VOLUME", 2, "would overwrite"},
        UsageRow{"render VOLUME -o VOLUME", 2, "would overwrite"},
        UsageRow{"render VOLUME --otf cubic -o FOLDER/x.png", 2, "adaptive"},
        UsageRow{"phantom FOLDER/p.mha --truth FOLDER/p.mha", 2, "named twice"},
        UsageRow{"phantom FOLDER/p.mha --seed -1", 2, "--seed"},
        UsageRow{"phantom FOLDER/p.mha --seed 18446744073709551616", 2, "--seed"},
        UsageRow{"otf VOLUME --raw-spacing 1x1x1", 2, "--raw-size"}));

INSTANTIATE_TEST_SUITE_P(
    ShortForms, ExitStatus,
    testing::Values(UsageRow{"otf VOLUME --tube-grid 3x3 --tube-rows 5", 2, "--tube-grid"},
                    UsageRow{"otf VOLUME --tube-columns 5 --tube-grid 3x3", 2, "--tube-columns"},
                    UsageRow{"otf VOLUME --sigma 1 --sigma-per-kernel-size 1", 2, "--sigma"},
                    UsageRow{"otf VOLUME --interface-function variance --sigma 9", 2, "--sigma must be 0.01 to 4"},
                    UsageRow{"otf VOLUME --interface-function variance --sigma-per-kernel-size 9", 2,
                             "--sigma-per-kernel-size must be 0.01 to 4"},
                    UsageRow{"render VOLUME --light 40,-20 --light-azimuth 5 -o FOLDER/x.png", 2, "--light-azimuth"},
                    UsageRow{"render VOLUME --light-elevation 5 --light 40,-20 -o FOLDER/x.png", 2,
                             "--light-elevation"},
                    UsageRow{"render VOLUME --projection parallel --perspective -o FOLDER/x.png", 2, "--perspective"},
                    UsageRow{"render VOLUME --light 200,0 -o FOLDER/x.png", 2,
                             "--light must be an azimuth from -180 to 180 and an elevation from -90 to 90 degrees"}));

INSTANTIATE_TEST_SUITE_P(
    WithoutAPart, ExitStatus,
    testing::Values(UsageRow{"render VOLUME --mixed-mode mean -o FOLDER/x.png", 2,
                             "--mixed-mode plays a part only in direct mode if something is mixed in. Leave it out.\n"},
                    UsageRow{"render VOLUME --mode mean --shadow 1 -o FOLDER/x.png", 2, "Leave it out.\n"}));

INSTANTIATE_TEST_SUITE_P(
    Numbers, ExitStatus,
    testing::Values(UsageRow{"phantom FOLDER/p.mha --size abc", 2, "--size must be like 199x197x199, not \"abc\""},
                    UsageRow{"phantom FOLDER/p.mha --contrast 1,2", 2, "--contrast must be like 14,85,170"},
                    UsageRow{"render VOLUME --background 1 -o FOLDER/x.png", 2, "--background must be like 14,85,170"},
                    UsageRow{"render VOLUME --light 40 -o FOLDER/x.png", 2, "--light must be like 40,-20"}));

INSTANTIATE_TEST_SUITE_P(
    Outputs, ExitStatus,
    testing::Values(
        UsageRow{"render VOLUME -o FOLDER/x.jpg", 2,
                 "x.jpg\", but pictures are written as PNG. Give it a name that ends in .png."},
        UsageRow{"render VOLUME -o FOLDER/x.TIFF", 2, "pictures are written as PNG"},
        UsageRow{"render VOLUME -o FOLDER/x.avi", 2, "pictures are written as PNG"},
        UsageRow{"render --document FOLDER/none.json -o FOLDER/x.jpeg", 2, "pictures are written as PNG"},
        UsageRow{"sweep VOLUME --movie FOLDER/x.webm", 2,
                 "x.webm: --movie ends in .webm, which is no kind of movie that can be written. Give it a name "
                 "that ends in .avi, .mp4 or .mkv."},
        UsageRow{"sweep VOLUME --movie FOLDER/x.GIF", 2, "ends in .gif, which is no kind of movie"},
        UsageRow{"sweep VOLUME --movie FOLDER/x", 2, "does not say by its ending what kind of movie"},
        UsageRow{"sweep VOLUME --size 33x32 --movie FOLDER/x.mp4", 2,
                 "would have 33 x 32 pixels, but those of movies are counted in twos. Take an even width and height."},
        UsageRow{"quiet VOLUME -o FOLDER/x.nrrd", 2,
                 "volumes are written as MetaImage. Give it a name that ends in .mha."},
        UsageRow{"phantom FOLDER/x.nrrd", 2, "Use .mha, .mhd, .nii, .nii.gz or .dcm."},
        UsageRow{"phantom FOLDER/x.mha.gz", 2, "Use .mha, .mhd, .nii, .nii.gz or .dcm."},
        UsageRow{"phantom FOLDER/x.png", 2, "Use .mha, .mhd, .nii, .nii.gz or .dcm."}));

INSTANTIATE_TEST_SUITE_P(
    NearCuts, ExitStatus,
    testing::Values(
        UsageRow{
            "render VOLUME --beam-axis +z --near 300 -o FOLDER/x.png", 2,
            "--near is 300 mm, but along this view the volume ends 60 mm behind its foremost corner: nothing is left. "
            "Give less than 60."},
        UsageRow{"otf VOLUME --beam-axis +z --near 60", 2, "nothing is left"},
        UsageRow{"otf VOLUME --beam-axis +z --near 59.9 --json FOLDER/none/o.json", 4, "o.json"},
        UsageRow{"otf VOLUME --beam-axis +y --near 50.1", 2, "ends 50 mm behind"},
        UsageRow{"sweep VOLUME --beam-axis +z --near 1e6", 2, "nothing is left"}));

INSTANTIATE_TEST_SUITE_P(
    Commands, ExitStatus,
    testing::Values(UsageRow{"study", 2, "\"study\" is only the beginning of a command: use otf, contrast, "},
                    UsageRow{"study nonsense", 2, "\"study nonsense\" is not a command: use otf, contrast, "},
                    UsageRow{"bench", 2, "\"bench\" is only the beginning of a command: use otf."},
                    UsageRow{"--threads 2", 2, "No command is given: use info, "},
                    UsageRow{"--threads 2 otff VOLUME", 2, "\"otff\" is not a command: use info, "}));

TEST(Usage, ARawSizeThatIsTooLargeIsNoFaultOfAHeader) {
    const Folder folder;
    write(folder / "v.raw", std::string(4, 'x'));
    const Outcome outcome = runProgram("info \"" + folder / "v.raw" + "\" --raw-size 2x2x2");
    EXPECT_EQ(outcome.status, 3);
    EXPECT_NE(outcome.errors.find("--raw-size declares 8 bytes of voxels"), std::string::npos) << outcome.errors;
    EXPECT_NE(outcome.errors.find("Correct the size, the type, or the bytes before the voxels."), std::string::npos);
    for (const char* wrong : {"header is wrong", "incomplete", "damaged"})
        EXPECT_EQ(outcome.errors.find(wrong), std::string::npos) << outcome.errors;
}

TEST(Usage, InfoWritesJsonWhereOtherCommandsDo) {
    const Folder folder;
    const std::string volume = "\"" + shapesFile() + "\"";
    const std::string text = runProgram("info " + volume + " --json").output;
    EXPECT_EQ(nlohmann::json::parse(text).at("volume").at("phases"), 1);
    EXPECT_EQ(runProgram("info " + volume + " --json -").output, text);
    EXPECT_EQ(runProgram("info --json " + volume).output, text);
    EXPECT_EQ(runProgram("info --json - " + volume).output, text);
    const Outcome toFile = runProgram("info " + volume + " --json \"" + folder / "i.json" + "\"");
    EXPECT_EQ(toFile.status, 0) << toFile.errors;
    EXPECT_EQ(toFile.output, "");
    EXPECT_EQ(contentsOf(folder / "i.json"), text);
    const Outcome over = runProgram("info " + volume + " --json " + volume);
    EXPECT_EQ(over.status, 2);
    EXPECT_NE(over.errors.find("would overwrite"), std::string::npos) << over.errors;
    EXPECT_EQ(runProgram("info --json").status, 2);
}

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
