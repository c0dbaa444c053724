// The tests take extremes through the real program: files that hold them, and the study that lists them.
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "otf_of.h"
#include "program.h"
#include "tables.h"

namespace echolucent {
namespace {

using nlohmann::json;

/// A MetaImage of one type of voxels.
template <typename Stored>
void writeVolume(const std::string& path, const std::string& size, const std::string& spacing, const std::string& type,
                 const std::vector<Stored>& voxels) {
    std::string bytes(voxels.size() * sizeof(Stored), '\0');
    std::memcpy(bytes.data(), voxels.data(), bytes.size());
    write(path, "ObjectType = Image\nNDims = 3\nDimSize = " + size + "\nElementSpacing = " + spacing +
                    "\nElementType = " + type + "\nElementDataFile = LOCAL\n" + bytes);
}

/// Fluid in the front half, tissue behind, some noise.
template <typename Stored>
std::vector<Stored> fluidAndTissue(int edge) {
    std::vector<Stored> voxels;
    for (int i = 0; i < edge * edge * edge; ++i)
        voxels.push_back(static_cast<Stored>((i / (edge * edge) < edge / 2 ? 14 : 120) + i * 7 % 11));
    return voxels;
}

/// Everything must be finite, and there must be a curve or a sentence.
void expectSound(const json& otf) {
    ASSERT_EQ(otf["otf"]["opacity"].size(), 256u);
    for (const json& opacity : otf["otf"]["opacity"]) {
        ASSERT_TRUE(opacity.is_number()) << "not finite";
        EXPECT_GE(opacity.get<double>(), 0.0);
        EXPECT_LE(opacity.get<double>(), 1.0);
    }
    double weight = 0.0;
    for (const json& tube : otf["tubes"]) {
        ASSERT_TRUE(tube["d"].is_number());
        weight += tube["d"].get<double>();
    }
    if (weight == 0.0) {
        EXPECT_NE(otf["message"].get<std::string>().find("the initial function is used."), std::string::npos);
    }
}

TEST(Extremes, OfFilesEndInACurveOrASentence) {
    const Folder folder;
    const std::string file = folder / "v.mha";
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const auto expectSoundFile = [&](const std::string& name, const std::string& options = {}) {
        SCOPED_TRACE(name + " " + options);
        expectSound(otfOf(file, options));
    };
    writeConstantVolume(file, 60, 0);
    expectSoundFile("all zero");
    writeVolume<std::uint8_t>(file, "1 1 1", "1 1 1", "MET_UCHAR", {200});
    expectSoundFile("one voxel");
    for (const std::string size : {"1 40 50", "40 1 50", "40 50 1"}) {
        writeVolume(file, size, "1 1 1", "MET_USHORT", std::vector<std::uint16_t>(2000, 65000));
        expectSoundFile(size);
        expectSoundFile(size, "--view-azimuth 20");
    }
    writeVolume(file, "60 60 60", "0.1 0.1 5", "MET_UCHAR", fluidAndTissue<std::uint8_t>(60));
    expectSoundFile("spacing 1 : 50", "--tube-grid 5x5");
    auto voxels = fluidAndTissue<float>(60);
    for (std::size_t i = 0; i < voxels.size(); i += 101) voxels[i] = i % 2 == 0 ? std::nanf("") : -infinity;
    writeVolume(file, "60 60 60", "1 1 1", "MET_FLOAT", voxels);
    expectSoundFile("NaN and infinite voxels");
    expectSoundFile("NaN and infinite voxels", "--form product --strength 0");
    expectSoundFile("NaN and infinite voxels", "--form product --strength 225e6 --view-elevation 9");
    expectSoundFile("one tube core", "--tube-grid 1x1");
}

TEST(Extremes, AbsurdVoxelsDoNotSetTheWhiteLevelAndAreSaid) {
    const Folder folder;
    const std::string file = folder / "v.mha";
    auto voxels = fluidAndTissue<float>(60);
    for (std::size_t i = 17; i < voxels.size(); i += 20011) voxels[i] = 3e38f;
    writeVolume(file, "60 60 60", "1 1 1", "MET_FLOAT", voxels);
    const json otf = otfOf(file);
    expectSound(otf);
    EXPECT_EQ(otf["volume"]["white_level"], 130.0);
    const Outcome info = runProgram("info \"" + file + "\"");
    EXPECT_EQ(info.status, 0);
    EXPECT_NE((info.output + info.errors).find("11 voxels hold values up to 3e+38"), std::string::npos)
        << info.output << info.errors;
}

TEST(Extremes, TheSharedVolumeWithNaNAndAbsurdVoxelsIsSeen) {
    const std::string file = ECHOLUCENT_SOURCE_DIR "/../shared/data/volumes/odd_nan.mha";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "the shared volumes are not here";
    const json otf = otfOf(file);
    expectSound(otf);
    EXPECT_LT(otf["volume"]["white_level"].get<double>(), 600.0) << "not 3.2e38: the picture would be black";
}

TEST(Extremes, A4DFileWithOnePhaseIsAVolume) {
    const Folder folder;
    const auto voxels = fluidAndTissue<std::uint8_t>(60);
    write(folder / "v.nrrd",
          "NRRD0004\ntype: uint8\ndimension: 4\nsizes: 60 60 60 1\nencoding: raw\n"
          "spacings: 0.5 0.5 0.5 1\n\n" +
              std::string(voxels.begin(), voxels.end()));
    expectSound(otfOf(folder / "v.nrrd"));
    expectSound(otfOf(folder / "v.nrrd", "--phase 0"));
    EXPECT_EQ(runProgram("otf \"" + folder / "v.nrrd" + "\" --phase 1").status, 2);
}

TEST(LongStudyStability, EveryNumberHoldsItsBoundAndEveryCaseIsSound) {
    const Folder folder;
    const Outcome outcome = runProgram("study stability -o \"" + folder / "s" + "\"");
    ASSERT_EQ(outcome.status, 0) << outcome.errors;
    const auto numbers = rowsOf(contentsOf(folder / "s/stability-numbers.csv"));
    ASSERT_GT(numbers.size(), 60u);
    int bounded = 0, literal = 0;
    for (std::size_t i = 1; i < numbers.size(); ++i) {
        ASSERT_EQ(numbers[i].size(), 7u);
        if (numbers[i][6].empty()) {
            literal += numbers[i][5] == "infinite" || std::stod(numbers[i][5]) > 1e-3 ? 1 : 0;
            continue;
        }
        ++bounded;
        EXPECT_LE(std::stod(numbers[i][5]), std::stod(numbers[i][6])) << numbers[i][0] << ", " << numbers[i][1];
    }
    EXPECT_GT(bounded, 30);
    EXPECT_GT(literal, 10) << "the textbook formulas' errors are what the page is for";
    const auto cases = rowsOf(contentsOf(folder / "s/stability-cases.csv"));
    ASSERT_GT(cases.size(), 60u);
    for (std::size_t i = 1; i < cases.size(); ++i) {
        ASSERT_EQ(cases[i].size(), 10u);
        EXPECT_EQ(cases[i][4], "1") << cases[i][0] << ", " << cases[i][1];
        EXPECT_EQ(cases[i][8], "1") << cases[i][0] << ", " << cases[i][1] << ": " << cases[i][9];
    }
    const std::string page = contentsOf(folder / "s/stability.html");
    EXPECT_TRUE(page.starts_with("<!DOCTYPE html>"));
    EXPECT_NE(page.find("not a medical device"), std::string::npos);
    EXPECT_EQ(page.find("http"), page.find("http://www.w3.org")) << "nothing is loaded from elsewhere";
}

}  // namespace
}  // namespace echolucent
