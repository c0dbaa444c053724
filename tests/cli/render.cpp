#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/cli/report/picture_words.h"
#include "program.h"

namespace echolucent {
namespace {

TEST(Render, WritesAPictureOfTheAskedSizeThatDependsOnTheCurve) {
    const Folder folder;
    std::vector<std::string> pictures;
    for (const std::string otf : {"linear", "parabolic", "quartic", "adaptive"}) {
        const std::string path = folder / (otf + ".png");
        const Outcome outcome =
            runProgram("render \"" + shapesFile() + "\" --otf " + otf + " --size 64x48 -o \"" + path + "\"");
        ASSERT_EQ(outcome.status, 0) << outcome.errors;
        pictures.push_back(contentsOf(path));
        ASSERT_EQ(pictures.back().substr(0, 8), "\x89PNG\r\n\x1a\n");
        EXPECT_EQ(pictures.back().substr(16, 8), std::string("\0\0\0\x40\0\0\0\x30", 8)) << "width and height";
        for (std::size_t i = 0; i + 1 < pictures.size(); ++i) EXPECT_NE(pictures[i], pictures.back()) << otf;
    }
}

TEST(Render, SaysWhatItCannotDo) {
    const Folder folder;
    EXPECT_EQ(runProgram("render \"" + shapesFile() + "\" --otf nonsense -o \"" + folder / "p.png" + "\"").status, 2);
    EXPECT_EQ(runProgram("render \"" + folder / "missing.mha" + "\" -o \"" + folder / "p.png" + "\"").status, 3);
    EXPECT_EQ(runProgram("render \"" + shapesFile() + "\" --size 16x16 -o \"" + folder / "none/p.png" + "\"").status,
              4);
}

TEST(Render, SaysInThePictureThatTheVolumeWasReduced) {
    const Folder folder;
    const std::string render =
        "render \"" + shapesFile() + "\" --otf linear --size 400x200 -o \"" + folder / "p.png" + "\"";
    const std::string sentence = "This volume was reduced 2 x 2 x 2: fine detail in the picture is averaged.";
    const Outcome whole = runProgram(render + " --study-memory 2"), reduced = runProgram(render + " --study-memory 1");
    ASSERT_EQ(whole.status + reduced.status, 0) << reduced.errors;
    EXPECT_EQ(whole.errors.find(sentence), std::string::npos);
    EXPECT_NE(reduced.errors.find(sentence), std::string::npos) << reduced.errors;
    EXPECT_EQ(cli::pictureWordsOf(VolumeGeometry{}), "");
    VolumeGeometry geometry;
    geometry.reduction = Reduction{{2, 2, 1}, {9, 9, 3}};
    EXPECT_EQ(cli::pictureWordsOf(geometry), "reduced 2 x 2 x 1");
    geometry.spacingKnown = false;
    EXPECT_EQ(cli::pictureWordsOf(geometry), "spacing unknown, reduced 2 x 2 x 1");
    // The words are written where the background was.
    const std::vector<std::uint8_t> black(3 * 400 * 200);
    std::vector<std::uint8_t> written = black;
    cli::writeWords(written, 400, 200, "");
    EXPECT_EQ(written, black);
    cli::writeWords(written, 400, 200, cli::pictureWordsOf(geometry));
    EXPECT_NE(written, black);
}

TEST(Render, InfoSaysWhatWasReduced) {
    const Outcome outcome = runProgram("info \"" + shapesFile() + "\" --study-memory 1 --json");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const auto volume = nlohmann::json::parse(outcome.output).at("volume");
    EXPECT_EQ(volume.at("size"), nlohmann::json({55, 50, 60}));
    EXPECT_EQ(volume.at("stored_size"), nlohmann::json({110, 100, 120}));
    EXPECT_EQ(volume.at("reduced_by"), nlohmann::json({2, 2, 2}));
    const Outcome whole = runProgram("info \"" + shapesFile() + "\" --json");
    EXPECT_FALSE(nlohmann::json::parse(whole.output).at("volume").contains("reduced_by"));
}

TEST(Render, SaysThatTheCurveShowsNothing) {
    const Folder folder;
    writeConstantVolume(folder / "faint.mha", 20, 10);  // the linear curve begins at 20
    const auto errorsWith = [&](const std::string& options) {
        const Outcome outcome = runProgram("render \"" + folder / "faint.mha" + "\" --size 16x16 -o \"" +
                                           folder / "p.png" + "\" " + options);
        EXPECT_EQ(outcome.status, 0);
        return outcome.errors;
    };
    EXPECT_NE(errorsWith("--otf linear").find("Nothing is shown: the curve is 0 over all intensities of the data"),
              std::string::npos);
    EXPECT_EQ(errorsWith("--otf parabolic").find("Nothing is shown"), std::string::npos);
    EXPECT_EQ(errorsWith("--mode maximum").find("Nothing is shown"), std::string::npos);
}

/// The check sum of a picture made with these options: what differs is not worth printing.
std::size_t rendered(const Folder& folder, const std::string& options) {
    const std::string path = folder / "picture.png";
    const Outcome outcome =
        runProgram("render \"" + shapesFile() + "\" --size 64x48 " + options + " -o \"" + path + "\"");
    EXPECT_EQ(outcome.status, 0) << options << ": " << outcome.errors;
    return std::hash<std::string>{}(contentsOf(path));
}

TEST(LongRender, ALightFromElsewhereMakesAnotherPicture) {
    const Folder folder;
    const std::size_t usual = rendered(folder, "--otf parabolic --shade");
    const std::size_t left = rendered(folder, "--otf parabolic --light -80,0 --shade");
    const std::size_t right = rendered(folder, "--otf parabolic --light 80,0 --shade");
    EXPECT_NE(usual, left);
    EXPECT_NE(left, right);
    EXPECT_NE(rendered(folder, "--otf parabolic --lighting flat"), usual);
    EXPECT_NE(rendered(folder, "--otf parabolic"), usual) << "light that reaches is the default";
}

TEST(Render, ModesAndDepthColoursMakePicturesOfTheirOwn) {
    const Folder folder;
    std::vector<std::size_t> pictures{rendered(folder, "--otf parabolic"),
                                      rendered(folder, "--otf parabolic --depth-colour")};
    for (const std::string mode : {"maximum", "minimum", "mean"}) {
        pictures.push_back(rendered(folder, "--mode " + mode));
        EXPECT_EQ(pictures.back(), rendered(folder, "--otf parabolic --mode " + mode)) << "the curve plays no part";
    }
    EXPECT_EQ(pictures.front(), rendered(folder, "--otf parabolic --mode direct"));
    for (std::size_t i = 0; i < pictures.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_NE(pictures[i], pictures[j]) << i << ", " << j;
}

TEST(Render, RefusesModesAndLightsThatMakeNoSense) {
    const Folder folder;
    const std::string picture = " -o \"" + folder / "p.png" + "\"";
    for (const std::string options : {"--mode brightest", "--mode maximum --shade", "--mode mean --depth-colour",
                                      "--mode minimum --light 0,0", "--lighting flat --light 0,0", "--lighting none",
                                      "--light 30", "--light 181,0", "--light 0,91", "--light nan,0"}) {
        const Outcome outcome = runProgram("render \"" + shapesFile() + "\" " + options + picture);
        EXPECT_EQ(outcome.status, 2) << options;
        EXPECT_FALSE(outcome.errors.empty()) << options;
    }
}

}  // namespace
}  // namespace echolucent
