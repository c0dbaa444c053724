// VolumeOptions and the info command, run in this process.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <CLI/CLI.hpp>

#include <nlohmann/json.hpp>

#include "app/cli/command.h"
#include "app/cli/options/option_text.h"
#include "app/cli/options/volume_options.h"
#include "dicom_files.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using nlohmann::json;
using testing::HasSubstr;

struct InfoOutcome {
    int status = 0;
    std::string text;
    std::string sentence;
};

InfoOutcome runInfo(std::vector<std::string> arguments) {
    CLI::App program{"test"};
    program.require_subcommand(1);
    cli::Action action;
    cli::addInfoCommand(program, action);
    arguments.insert(arguments.begin(), "info");
    std::reverse(arguments.begin(), arguments.end());
    InfoOutcome outcome;
    testing::internal::CaptureStdout();
    try {
        program.parse(arguments);
        const auto done = action();
        if (!done) outcome = {cli::exitStatus(done.error()), "", done.error().sentence()};
    } catch (const CLI::ParseError& error) {
        outcome = {error.get_exit_code() == 0 ? 0 : 2, "", error.what()};
    }
    outcome.text = testing::internal::GetCapturedStdout();
    return outcome;
}

std::string movingVolume(const TemporaryFolder& folder) {
    return folder.write("v.mha",
                        "NDims = 4\nDimSize = 1 1 2 3\nElementSpacing = 0.1 0.2 0.3 0.05\nElementType = MET_USHORT\n"
                        "WhiteLevel = 4095\nElementDataFile = LOCAL\n" +
                            bytesFrom<std::uint16_t>({1, 2, 3, 4, 5, 6}));
}

TEST(InfoCommand, JsonSaysWhatTheVolumeIs) {
    const TemporaryFolder folder;
    const auto outcome = runInfo({movingVolume(folder), "--phase", "1", "--all-voxels", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.sentence;
    const json object = json::parse(outcome.text);
    const json& volume = object.at("volume");
    EXPECT_EQ(volume.at("size"), json({1, 1, 2}));
    EXPECT_EQ(volume.at("spacing_mm"), json({0.1, 0.2, 0.3}));
    EXPECT_EQ(volume.at("spacing_known"), true);
    EXPECT_EQ(volume.at("type"), "uint16");
    EXPECT_EQ(volume.at("white_level"), 4095);
    EXPECT_EQ(volume.at("phases"), 3);
    EXPECT_EQ(volume.at("phase"), 1);
    EXPECT_EQ(volume.at("phase_seconds"), 0.05);
    EXPECT_EQ(volume.at("stored_range"), json({3, 4}));
    EXPECT_EQ(volume.at("no_data_share"), 0);
    EXPECT_EQ(object.at("view").at("beam_axis"), "+z");
    EXPECT_EQ(object.at("beam").at("axis"), "+z");
    EXPECT_EQ(object.at("beam").at("source"), "assumed");
    EXPECT_EQ(object.at("facts").at(0),
              json({{"name", "format"}, {"value", "MetaImage"}, {"source", "keys of the header"}}));
    EXPECT_TRUE(object.at("warnings").is_array());
}

TEST(InfoCommand, TextNamesSizeSpacingAndDirection) {
    const TemporaryFolder folder;
    const auto outcome = runInfo({movingVolume(folder)});
    EXPECT_THAT(outcome.text, HasSubstr("1 x 1 x 2 voxels"));
    EXPECT_THAT(outcome.text, HasSubstr("0.1 x 0.2 x 0.3 mm  [ElementSpacing]"));
    EXPECT_THAT(outcome.text, HasSubstr("4095  [WhiteLevel]"));
    EXPECT_THAT(outcome.text, HasSubstr("+z"));
}

TEST(InfoCommand, ExitStatusesFollowWhatWentWrong) {
    const TemporaryFolder folder;
    const std::string volume = movingVolume(folder);
    const auto outOfRange = runInfo({volume, "--phase", "3"});
    EXPECT_EQ(outOfRange.status, 2);
    EXPECT_THAT(outOfRange.sentence, HasSubstr("--phase is 3, but the volume has 3 phase(s). Choose 0 to 2."));
    EXPECT_EQ(runInfo({volume, "--phase", "-1"}).status, 2);
    EXPECT_EQ(runInfo({volume, "--no-such-option"}).status, 2);
    EXPECT_EQ(runInfo({}).status, 2);
    EXPECT_EQ(runInfo({folder.file("none.mha")}).status, 3);
    EXPECT_EQ(cli::exitStatus(fail(FailureKind::unwritable, "", "", "").value()), 4);
}

/// Two series of 8 and 12 pixels a slice, of three and two slices.
void writeTwoSeries(const TemporaryFolder& folder) {
    for (const auto& [series, columns, slices] : {std::tuple{"1.2.3", 4, 3}, std::tuple{"1.2.4", 6, 2}})
        for (int i = 0; i < slices; ++i) {
            TestImage image;
            image.series = series;
            image.columns = columns;
            image.rows = 2;
            image.pixels8.assign(static_cast<std::size_t>(2 * columns), 7);
            makeSlice(image, i, 0.5);
            writeDicom(folder.file(series + std::string("-") + std::to_string(i)), image);
        }
}

TEST(InfoCommand, ListsTheSeriesOfAFolder) {
    const TemporaryFolder folder;
    writeTwoSeries(folder);
    const auto outcome = runInfo({folder.path(), "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.sentence;
    const json series = json::parse(outcome.text).at("series");
    ASSERT_EQ(series.size(), 2u);
    EXPECT_EQ(series[0].at("uid"), "1.2.3");
    EXPECT_EQ(series[0].at("number"), 1);
    EXPECT_EQ(series[0].at("size"), json({4, 2, 3}));
    EXPECT_EQ(series[0].at("files"), 3);
    EXPECT_EQ(series[0].at("read"), true);
    EXPECT_EQ(series[1].at("read"), false);
    EXPECT_TRUE(series[1].at("why_not").is_null());
    const auto text = runInfo({folder.path()}).text;
    EXPECT_THAT(text, HasSubstr("1, read"));
    EXPECT_THAT(text, HasSubstr("  series 2                     US, 6 x 2, 2 slices  [1.2.4]\n"));
}

TEST(InfoCommand, SaysOfASeriesWhatIsWrongAndWhatToDo) {
    const TemporaryFolder folder;
    writeTwoSeries(folder);
    TestImage cine;
    cine.series = "1.2.5";
    cine.frames = 3;
    cine.pixels8.assign(36, 7);
    writeDicom(folder.file("cine"), cine);
    cine.series = "1.2.6";
    cine.pixels8.resize(24);
    writeDicom(folder.file("short"), cine);
    const auto text = runInfo({folder.path()}).text;
    EXPECT_THAT(text, HasSubstr("it is a 2D cine of 3 frames without volume geometry. Add --frames-as-slices"));
    EXPECT_THAT(text, HasSubstr("(7fe0,0010) Pixel Data holds 24 bytes where 4 x 3 pixels in 3 frame(s) need 36. "));
}

TEST(VolumeOptions, ASeriesIsChosenByNumberOrName) {
    const TemporaryFolder folder;
    writeTwoSeries(folder);
    for (const char* chosen : {"2", "1.2.4"}) {
        const auto outcome = runInfo({folder.path(), "--series", chosen, "--json"});
        ASSERT_EQ(outcome.status, 0) << outcome.sentence;
        EXPECT_EQ(json::parse(outcome.text)["volume"]["size"], json({6, 2, 2}));
    }
    const auto tooFar = runInfo({folder.path(), "--series", "3"});
    EXPECT_EQ(tooFar.status, 2);
    EXPECT_THAT(tooFar.sentence, HasSubstr("--series is 3, but there are 2 series. Choose 1 to 2."));
    EXPECT_EQ(runInfo({folder.path(), "--series", "0"}).status, 2);
    const auto unknown = runInfo({folder.path(), "--series", "1.2.9"});
    EXPECT_EQ(unknown.status, 2);
    EXPECT_THAT(unknown.sentence,
                HasSubstr("holds no series \"1.2.9\". It holds 1 (4 x 2, 3 slices), 2 (6 x 2, 2 slices). "
                          "Choose one of the numbers that info lists."));
    const auto noFolder = runInfo({movingVolume(folder), "--series", "1"});
    EXPECT_EQ(noFolder.status, 2);
    EXPECT_THAT(noFolder.sentence, HasSubstr("--series names a series of a folder or DICOMDIR"));
}

TEST(InfoCommand, HelpHoldsAnExample) {
    CLI::App program{"test"};
    cli::Action action;
    cli::addInfoCommand(program, action);
    EXPECT_THAT(program.get_subcommand("info")->help(), HasSubstr("Example:\n  echolucent-cli info"));
}

TEST(VolumeOptions, DescribeARawFile) {
    const TemporaryFolder folder;
    const std::string file = folder.write("v.raw", "HHH" + bytesFrom<std::uint16_t>({10, 20, 30, 40}, true));
    const auto outcome = runInfo({file, "--raw-size", "2x2x1", "--raw-type", "uint16", "--raw-byte-order", "big",
                                  "--raw-header-bytes", "3", "--raw-spacing", "0.5x0.5x2", "--all-voxels", "--json"});
    ASSERT_EQ(outcome.status, 0) << outcome.sentence;
    const json volume = json::parse(outcome.text).at("volume");
    EXPECT_EQ(volume.at("size"), json({2, 2, 1}));
    EXPECT_EQ(volume.at("spacing_mm"), json({0.5, 0.5, 2.0}));
    EXPECT_EQ(volume.at("spacing_known"), true);
    EXPECT_EQ(volume.at("stored_range"), json({10, 40}));
    EXPECT_EQ(json::parse(runInfo({file, "--raw-size", "11x1x1", "--json"}).text)["volume"]["spacing_known"], false);
}

TEST(VolumeOptions, WrongRawOptionsAreWrongUsage) {
    const TemporaryFolder folder;
    const std::string file = folder.write("v.raw", "abcd");
    const std::vector<std::pair<std::vector<std::string>, std::string>> rows{
        {{"--raw-size", "2x2"}, "--raw-size must be like 256x256x128"},
        {{"--raw-size", "2x2xtwo"}, "--raw-size must be like 256x256x128"},
        {{"--raw-size", "2xx2x1"}, "--raw-size must be like 256x256x128"},
        {{"--raw-size", "2x2x0"}, "--raw-size must be three whole numbers"},
        {{"--raw-size", "2x2x1.5"}, "--raw-size must be three whole numbers"},
        {{"--raw-size", "2x2x1", "--raw-spacing", "1x0x1"}, "--raw-spacing must be three numbers above 0"},
        {{"--raw-size", "2x2x1", "--raw-spacing", "1xnanx1"}, "--raw-spacing must be three numbers above 0"},
        {{"--raw-spacing", "1x1x1"}, "--raw-size is missing"},
        {{"--raw-size", "2x2x1", "--raw-type", "int12"}, "--raw-type"},
        {{"--raw-size", "2x2x1", "--raw-byte-order", "middle"}, "--raw-byte-order"},
        {{"--raw-size", "2x2x1", "--raw-header-bytes", "-1"}, "--raw-header-bytes"}};
    for (const auto& [options, words] : rows) {
        std::vector<std::string> arguments{file};
        arguments.insert(arguments.end(), options.begin(), options.end());
        const auto outcome = runInfo(arguments);
        EXPECT_EQ(outcome.status, 2) << words;
        EXPECT_THAT(outcome.sentence, HasSubstr(words));
    }
    EXPECT_EQ(runInfo({file, "--raw-size", "2x2x2"}).status, 3);
}

TEST(ParseNumbers, TakesXAndCommas) {
    EXPECT_EQ(cli::parseNumbers("15x15", 2, "--a", "1x2").value(), (std::vector<double>{15, 15}));
    EXPECT_EQ(cli::parseNumbers("1.5,2,1e3", 3, "--a", "1,2,3").value(), (std::vector<double>{1.5, 2, 1000}));
    for (const char* text : {"", "x", "1", "1x", "x1", "1x2x3", "1 2", "0x1x2"})
        EXPECT_FALSE(cli::parseNumbers(text, 2, "--a", "1x2")) << text;
    EXPECT_THAT(cli::parseNumbers("1", 2, "--grid", "15x15").error().sentence(),
                HasSubstr("--grid must be like 15x15, not \"1\""));
}

}  // namespace
}  // namespace echolucent
