#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "otf_of.h"
#include "program.h"
#include "tests/inputs.h"

namespace echolucent {
namespace {

using nlohmann::json;

/// What a tube core says: of the quiet voxels, if the report holds these.
const json& readingOf(const json& tube) { return tube.contains("quiet") ? tube["quiet"] : tube; }

/// The value is ln initial(x) + sum ln(1+d) g(x), by eqs. 5 to 7 as they stand (with (x - c) in eq. 5), in extended
/// precision.
struct Reference {
    long double value = 0, size = 0;
};
Reference logOpacityFrom(const json& tubes, long double initialLog, long double x) {
    Reference sum{initialLog, std::abs(initialLog)};
    for (const json& tube : tubes) {
        const long double d = tube["d"].get<double>();
        if (d == 0) continue;
        const long double low = readingOf(tube)["i_low"].get<double>(), high = readingOf(tube)["i_high"].get<double>();
        const long double b = 2 / ((high - low) * (high - low)), c = 1 / std::sqrt(2 * b) + low;
        const long double g =
            std::sqrt(2 * b * std::numbers::e_v<long double>) * (x - c) * std::exp(-b * (x - c) * (x - c));
        sum.value += std::log1p(d) * g;
        sum.size += std::abs(std::log1p(d) * g);
    }
    return sum;
}

void expectCurveFollowsFromTubes(const json& otf, int exponent) {
    const long double a = otf["parameters"]["opacity_scale"].get<double>();
    ASSERT_EQ(otf["otf"]["intensity"].size(), 256u);
    ASSERT_EQ(otf["otf"]["opacity"].size(), 256u);
    EXPECT_TRUE(otf["otf"]["log_opacity"][0].is_null());
    EXPECT_EQ(otf["otf"]["opacity"][0], 0.0);
    for (std::size_t i = 1; i < 256; ++i) {
        const double x = otf["otf"]["intensity"][i];
        EXPECT_EQ(x, static_cast<double>(i) / 255);
        const Reference expected =
            logOpacityFrom(otf["tubes"], std::log(a) + exponent * std::log(static_cast<long double>(x)), x);
        const double got = otf["otf"]["log_opacity"][i];
        EXPECT_LE(std::abs(got - expected.value), 1e-12L * std::max(1.0L, expected.size)) << i;
        EXPECT_NEAR(otf["otf"]["opacity"][i].get<double>(),
                    static_cast<double>(std::min(1.0L, std::exp(expected.value))), 1e-12);
    }
}

/// The initial function's opacity by what the report says of it.
long double initialAt(const json& function, long double x) {
    if (function.contains("exponent"))
        return std::min(1.0L, function["scale"].get<double>() * std::pow(x, function["exponent"].get<int>()));
    const long double lower = function["lower"].get<double>(), upper = function["upper"].get<double>();
    return std::clamp(function["slope"].get<double>() * (std::min(x, upper) - lower), 0.0L, 1.0L);
}

/// The curve of the ramps by docs/method.md, "7. Curve", from the report alone, in extended precision.
long double rampCurveAt(const json& otf, long double x) {
    const json& parameters = otf["parameters"];
    const long double initial = initialAt(parameters["initial_function"], x);
    const long double begin = parameters["quiet_ramp_begin"].get<double>(),
                      end = parameters["quiet_ramp_end"].get<double>();
    long double weights = 0, ramps = 0;
    int weighted = 0, meeting = 0;
    for (const json& tube : otf["tubes"]) {
        meeting += tube["entry_voxel"].is_null() ? 0 : 1;
        const long double d = tube["d"].get<double>();
        if (d == 0) continue;
        ++weighted;
        const json& reading = readingOf(tube);
        const long double low = reading["i_low"].get<double>(), rise = reading["i_high"].get<double>() - low;
        const long double spread = reading["fluid_spread"].is_null() ? 0.0 : reading["fluid_spread"].get<double>();
        const long double clear = std::max(begin * rise, parameters["clear_spreads"].get<double>() * spread);
        const long double full = std::max(end * rise, clear + 0.3L * rise);
        weights += d;
        ramps += d * std::clamp((x - low - clear) / (full - clear), 0.0L, 1.0L);
    }
    if (weighted == 0 || parameters["surfaces_where_data_begin"] == true) return initial;
    const long double trust =
        std::min(1.0L, weighted / (parameters["trusted_share"].get<double>() * static_cast<long double>(meeting)));
    const long double opacity = parameters["ramp_opacity"].get<double>(), aim = parameters["aim"].get<double>();
    long double shown = (1 - aim) * ramps / weights;
    if (aim > 0) {
        const json& every = parameters["every_wall"];
        const long double from = every["begin"].get<double>(), to = every["end"].get<double>();
        shown += aim * every["opacity"].get<double>() * std::clamp((x - from) / (to - from), 0.0L, 1.0L);
    }
    return std::min(1.0L, trust * opacity * shown + (1 - trust) * initial);
}

void expectCurveIsThatOfItsRamps(const json& otf) {
    long double largest = 0;
    for (std::size_t i = 0; i < 256; ++i)
        largest = std::max(largest, std::abs(rampCurveAt(otf, i / 255.0L) - otf["otf"]["opacity"][i].get<double>()));
    EXPECT_LE(largest, 1e-12L) << otf["made_of"]["study"]["file"] << ", " << otf["reduction"];
}

/// What the report says of the ramp is that of docs/method.md, "7. Curve".
void expectRampIsQuieterBySpeckle(const json& otf) {
    const json& parameters = otf["parameters"];
    const double gone = 1 - otf["speckle_left"].get<double>();
    const double begin = parameters["ramp_begin"].get<double>() + 0.16 * gone;
    EXPECT_NEAR(parameters["quiet_ramp_begin"].get<double>(), begin, 1e-14);
    EXPECT_NEAR(parameters["quiet_ramp_end"].get<double>(),
                std::max(begin, parameters["ramp_end"].get<double>() - 0.5 * gone), 1e-14);
    EXPECT_EQ(gone > 0, otf["reduction"] != "off");
}

void expectWeightsFollowFromTubes(const json& otf) {
    const json& tubes = otf["tubes"];
    int meeting = 0, surfaces = 0;
    for (const json& tube : tubes) meeting += tube["status"] != "outside" ? 1 : 0;
    const double dMax = otf["parameters"]["d_max"];
    EXPECT_DOUBLE_EQ(dMax, 6.75 / meeting) << "the paper's strength, which holds for the ramp too";
    for (const json& tube : tubes) {
        if (tube["status"] != "surface") {
            EXPECT_EQ(tube["d"], 0.0);
            for (const char* key : {"surface_voxel", "i_low", "i_high", "i_low_max", "slope"})
                EXPECT_TRUE(tube[key].is_null());
            EXPECT_EQ(tube["entry_voxel"].is_null(), tube["status"] == "outside");
            continue;
        }
        ++surfaces;
        int lowMaxima = 0, slopes = 0;
        for (const json& other : tubes) {
            if (other["status"] != "surface") continue;
            lowMaxima += other["i_low_max"].get<double>() <= tube["i_low_max"].get<double>() ? 1 : 0;
            slopes +=
                other["slope"].get<double>() > 0 && other["slope"].get<double>() <= tube["slope"].get<double>() ? 1 : 0;
        }
        const long double intensity = 1 - lowMaxima / static_cast<long double>(meeting);
        const long double slope = tube["slope"].get<double>() > 0 ? slopes / static_cast<long double>(meeting) : 0;
        const long double extra = tube["w_extra"].get<double>();
        EXPECT_NEAR(tube["w_intensity"].get<double>(), static_cast<double>(intensity), 1e-15);
        EXPECT_NEAR(tube["w_slope"].get<double>(), static_cast<double>(slope), 1e-15);
        EXPECT_NEAR(tube["d"].get<double>(), static_cast<double>(dMax * intensity * slope * extra), 1e-15 * dMax);
        const bool standsOut =
            !tube["edge_to_noise"].is_null() &&
            tube["edge_to_noise"].get<double>() >= otf["parameters"]["least_edge_to_noise"].get<double>();
        EXPECT_EQ(tube["w_extra"], tube["i_high"].get<double>() > tube["i_low"].get<double>() && standsOut ? 1.0 : 0.0);
    }
    EXPECT_GT(surfaces, 20);
}

TEST(OtfJson, SaysWhereTheBeamIsFrom) {
    const json assumed = otfOf(shapesFile());
    EXPECT_EQ(assumed["beam"]["axis"], "+z");
    EXPECT_EQ(assumed["beam"]["source"], "assumed") << "nothing in this scan tells its beam";
    EXPECT_LT(assumed["beam"]["confidence"], 0.5);
    const json given = otfOf(shapesFile(), "--beam-axis -y");
    EXPECT_EQ(given["beam"]["axis"], "-y");
    EXPECT_EQ(given["beam"]["source"], "option");
    EXPECT_TRUE(given["beam"]["confidence"].is_null());
    EXPECT_EQ(given["view"]["beam_axis"], "-y");
}

TEST(OtfJson, HoldsVolumeViewParametersTubesAndCurve) {
    const json otf = otfOf(shapesFile(), "--side 1");
    EXPECT_EQ(otf["message"], "");
    EXPECT_EQ(otf["volume"]["size"], (json{110, 100, 120}));
    EXPECT_EQ(otf["volume"]["spacing_mm"], (json{0.5, 0.5, 0.5}));
    EXPECT_EQ(otf["volume"]["type"], "uint8");
    EXPECT_EQ(otf["volume"]["white_level"], 255.0);
    EXPECT_EQ(otf["view"]["direction_voxel"], (json{0.0, 0.0, 1.0}));
    EXPECT_EQ(otf["view"]["beam_axis"], "+z");
    EXPECT_EQ(otf["view"]["near_mm"], 0.0);
    const json& parameters = otf["parameters"];
    EXPECT_EQ(parameters["initial"], "parabolic");
    EXPECT_EQ(parameters["tube_grid"], (json{15, 15}));
    EXPECT_EQ(parameters["tube_spacing_units"], (json{7.0, 6.0}));
    EXPECT_EQ(parameters["cell_size"], 5);
    EXPECT_DOUBLE_EQ(parameters["d_max"], 6.75 / parameters["tubes_meeting_volume"].get<int>());
    ASSERT_EQ(otf["tubes"].size(), 225u);
    for (std::size_t t = 0; t < 225; ++t) {
        EXPECT_EQ(otf["tubes"][t]["u"], t % 15);
        EXPECT_EQ(otf["tubes"][t]["v"], t / 15);
    }
}

TEST(OtfJson, CurveFollowsFromTheTubesByEquations4To7) {
    expectCurveFollowsFromTubes(otfOf(shapesFile(), "--form product"), 2);
    expectCurveFollowsFromTubes(
        otfOf(
            shapesFile(),
            "--form product --initial quartic --opacity-scale 0.3 --strength 40 --view-azimuth 21 --view-elevation -9"),
        4);
}

TEST(OtfJson, CurveFollowsFromTheQuietTubesToo) {
    for (const std::string reduction : {"off", "light", "medium", "strong"}) {
        if (takesSomeInputs && (reduction == "light" || reduction == "strong")) continue;
        const json otf = otfOf(shapesFile(), "--reduction " + reduction);
        EXPECT_EQ(otf["tubes"][0].contains("quiet"), reduction != "off");
        expectRampIsQuieterBySpeckle(otf);
        expectCurveIsThatOfItsRamps(otf);
    }
    expectCurveFollowsFromTubes(otfOf(shapesFile(), "--form product --reduction medium"), 2);
    for (const std::string options : {"--aim 0.3 --reduction medium", "--aim 1", "--aim 0.7 --ramp-opacity 0.4"}) {
        if (takesSomeInputs && options == "--aim 1") continue;
        const json aimed = otfOf(shapesFile(), options);
        EXPECT_GT(aimed["parameters"]["every_wall"]["end"], aimed["parameters"]["every_wall"]["begin"]);
        expectCurveIsThatOfItsRamps(aimed);
    }
    const json bright = otfOf(shapesFile(), "--reading 0.1"), ends = otfOf(shapesFile(), "--aim 0");
    EXPECT_FALSE(bright["parameters"].contains("every_wall")) << "bright surfaces ask for none";
    EXPECT_EQ(bright["otf"], ends["otf"]);
    EXPECT_EQ(ends["parameters"]["reading"], "0.1");
    EXPECT_EQ(otfOf(shapesFile())["parameters"]["reading"], "default");
    EXPECT_TRUE(otfOf(shapesFile(), "--aim 0.2")["parameters"]["reading"].is_null());
    // Few tube cores, so that the initial function has a say.
    const json few = otfOf(shapesFile(), "--reduction medium --initial linear --trusted-share 0.9");
    EXPECT_LT(few["parameters"]["trust"].get<double>(), 1.0);
    expectCurveIsThatOfItsRamps(few);
}

void expectRealCurvesAreThoseOfTheirRamps(const std::string& names) {
    const std::string folder = ECHOLUCENT_SOURCE_DIR "/../shared/data/volumes";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the shared volumes are not here";
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().filename().string().find(names) != std::string::npos)
            expectCurveIsThatOfItsRamps(otfOf(entry.path(), "--reduction medium"));
}
TEST(OtfOfRealData, CurveFollowsFromTheQuietTubes) { expectRealCurvesAreThoseOfTheirRamps("iso0.3mm"); }
TEST(LongOtfOfRealData, CurvesFollowFromTheQuietTubes) { expectRealCurvesAreThoseOfTheirRamps(""); }

TEST(OtfJson, WeightsFollowFromTheTubesByEquations8To11) {
    expectWeightsFollowFromTubes(otfOf(shapesFile(), "--interface-function variance"));
    expectWeightsFollowFromTubes(
        otfOf(shapesFile(), "--interface-function variance --view-azimuth 35 --view-elevation 20 --tube-grid 9x13"));
}

TEST(OtfJson, FindsThePhantomsSurfaces) {
    const Folder folder;
    const Outcome made = runProgram("phantom \"" + folder / "p.mha" +
                                    "\" --scene shapes --size 150 --spacing 0.4x0.4x0.6 --seed 8 --truth \"" +
                                    folder / "truth.json" + "\"");
    ASSERT_EQ(made.status, 0) << made.errors;
    const json otf = otfOf(folder / "p.mha");
    double weight = 0;
    for (const json& tube : otf["tubes"]) {
        weight += tube["d"].get<double>();
        if (tube["d"] > 0) {
            // The surface lies on the axis, behind the entry.
            EXPECT_NEAR(tube["surface_voxel"][0].get<double>(), tube["entry_voxel"][0].get<double>(), 1e-9);
            EXPECT_NEAR(tube["surface_voxel"][1].get<double>(), tube["entry_voxel"][1].get<double>(), 1e-9);
            EXPECT_GT(tube["surface_voxel"][2].get<double>(), 5.0);
            EXPECT_NEAR(tube["entry_voxel"][2].get<double>(), -0.5, 1e-9);
        }
    }
    EXPECT_GT(weight, 0.3);
}

TEST(OtfJson, TheViewTurnsByAzimuthAndElevationOnTheGridsAxesInMm) {
    // d = R_y(azimuth) R_x(elevation) (0,0,1), then divided by the spacing.
    const std::string file = phantomFile("flat.mha", "--scene shapes --size 60x60x30 --spacing 0.5x0.5x1 --seed 2");
    const double azimuth = 30 * std::numbers::pi / 180, elevation = 20 * std::numbers::pi / 180;
    const json direction = otfOf(file, "--view-azimuth 30 --view-elevation 20")["view"]["direction_voxel"];
    const double x = std::sin(azimuth) * std::cos(elevation) / 0.5, y = -std::sin(elevation) / 0.5;
    const double z = std::cos(azimuth) * std::cos(elevation);
    const double size = std::sqrt(x * x + y * y + z * z);
    EXPECT_NEAR(direction[0].get<double>(), x / size, 1e-14);
    EXPECT_NEAR(direction[1].get<double>(), y / size, 1e-14);
    EXPECT_NEAR(direction[2].get<double>(), z / size, 1e-14);
    EXPECT_EQ(otfOf(file, "--beam-axis -y")["view"]["direction_voxel"], (json{0.0, -1.0, 0.0}));
    EXPECT_EQ(otfOf(file, "--beam-axis=+x")["view"]["direction_voxel"], (json{1.0, 0.0, 0.0}));
}

TEST(OtfJson, TheNearCutMovesTheTubesBeginning) {
    const json otf = otfOf(shapesFile(), "--near 10");
    EXPECT_EQ(otf["view"]["near_mm"], 10.0);
    for (const json& tube : otf["tubes"])
        if (!tube["entry_voxel"].is_null()) {
            EXPECT_NEAR(tube["entry_voxel"][2].get<double>(), 19.5, 1e-9);
        }
}

TEST(OtfJson, IsTheSameOnAnyNumberOfThreads) {
    const auto withoutTimes = [](json otf) {
        otf.erase("times_ms");
        otf["made_of"].erase("command");
        return otf.dump();
    };
    EXPECT_TRUE(withoutTimes(otfOf(shapesFile(), "--threads 1 --view-azimuth 10")) ==
                withoutTimes(otfOf(shapesFile(), "--threads 2 --view-azimuth 10")));
}

TEST(OtfJson, AManualInitialFunctionIsTakenFromItsFile) {
    const Folder folder;
    write(folder / "curve.json", R"({"format": "echolucent-opacity-curve", "version": 1,
        "nodes": [{"intensity": 0.2, "opacity": 0.0}, {"intensity": 0.6, "opacity": 0.4}]})");
    const json otf =
        otfOf(shapesFile(), "--form product --strength 0 --initial \"manual:" + folder / "curve.json" + "\"");
    EXPECT_EQ(otf["message"], "The strength is 0: the initial function is used.");
    EXPECT_TRUE(otf["otf"]["log_opacity"][51].is_null()) << "0 up to the first node";
    EXPECT_NEAR(otf["otf"]["opacity"][102].get<double>(), 0.2, 1e-12);
    EXPECT_NEAR(otf["otf"]["log_opacity"][255].get<double>(), std::log(0.4), 1e-12);
    const json scaled =
        otfOf(shapesFile(),
              "--form product --strength 0 --opacity-scale 0.5 --initial \"manual:" + folder / "curve.json" + "\"");
    EXPECT_EQ(scaled["parameters"]["opacity_scale"], 0.5);
    EXPECT_NEAR(scaled["otf"]["log_opacity"][255].get<double>(), std::log(0.5 * 0.4), 1e-12);
    const json linear = otfOf(shapesFile(), "--form product --strength 0 --initial linear --opacity-scale 0.25");
    EXPECT_EQ(linear["parameters"]["opacity_scale"], 0.25);
    EXPECT_NEAR(linear["otf"]["opacity"][255].get<double>(), 0.25 * 235 / 255, 1e-12);
}

TEST(OtfJson, SaysSoWhereThereIsNoSurface) {
    const Folder folder;
    for (const int edge : {60, 3}) {
        writeConstantVolume(folder / "constant.mha", edge, 77);
        const Outcome outcome = runProgram("otf \"" + folder / "constant.mha" + "\" --json -");
        ASSERT_EQ(outcome.status, 0);
        const json otf = json::parse(outcome.output);
        EXPECT_EQ(otf["message"], "No surface found: the initial function is used.");
        EXPECT_TRUE(outcome.errors.ends_with("\nNo surface found: the initial function is used.\n")) << outcome.errors;
        for (std::size_t i = 0; i < 256; ++i)
            EXPECT_NEAR(otf["otf"]["opacity"][i].get<double>(), static_cast<double>(i * i) / 65025, 1e-15);
        EXPECT_EQ(outcome.output.find("nan"), std::string::npos);
    }
}

TEST(OtfOfRealData, FindsSurfacesBehindTheChestsNearCut) {
    const std::string file = ECHOLUCENT_SOURCE_DIR "/../shared/data/volumes/fetal_chest_iso0.3mm.mha";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "the shared volumes are not here";
    const json otf = otfOf(file, "--beam-axis +y --near 18 --interface-function variance --form product");
    EXPECT_EQ(otf["message"], "");
    int weighted = 0;
    for (const json& tube : otf["tubes"]) {
        if (!tube["entry_voxel"].is_null()) {
            EXPECT_NEAR(tube["entry_voxel"][1].get<double>(), 59.5, 1e-9) << "18 mm of 0.3 mm voxels";
        }
        weighted += tube["d"] > 0 ? 1 : 0;
    }
    EXPECT_GT(weighted, 20);
    expectWeightsFollowFromTubes(otf);
    expectCurveFollowsFromTubes(otf, 2);
}

TEST(OtfJson, TubeCoresThatAreNeverPlacedAreSaidAndDoNotCount) {
    const std::string options = "--beam-axis +z --tube-grid 5x4 ";
    const json all = otfOf(shapesFile(), options);
    const json otf = otfOf(shapesFile(), options + "--without-tube 17,3 --without-tube 0 --without-tube 3");
    EXPECT_EQ(all["parameters"]["without_tubes"], json::array());
    EXPECT_EQ(otf["parameters"]["without_tubes"], (json{0, 3, 17}));
    EXPECT_EQ(all["parameters"]["tubes_meeting_volume"], 20);
    EXPECT_EQ(otf["parameters"]["tubes_meeting_volume"], 17);
    ASSERT_EQ(otf["tubes"].size(), 20u);
    for (std::size_t t = 0; t < 20; ++t) {
        EXPECT_EQ(otf["tubes"][t]["u"], t % 5);
        EXPECT_EQ(otf["tubes"][t]["v"], t / 5);
        EXPECT_EQ(otf["tubes"][t]["status"] == "never placed", t == 0 || t == 3 || t == 17) << t;
    }
    EXPECT_TRUE(otf["tubes"][3]["entry_voxel"].is_null());
    EXPECT_EQ(otf["tubes"][3]["d"], 0.0);
    EXPECT_DOUBLE_EQ(otf["parameters"]["d_max"].get<double>(), all["parameters"]["d_max"].get<double>() * 20 / 17);
    const std::string summary = runProgram("otf \"" + shapesFile() + "\" " + options + "--without-tube 0,3,17").output;
    EXPECT_NE(summary.find("17 of 20 tube cores meet the volume"), std::string::npos) << summary;
    EXPECT_NE(summary.find("3 of them are never placed"), std::string::npos) << summary;
    const std::string table =
        runProgram("otf " + options + "--tubes-csv - --without-tube 3 \"" + shapesFile() + "\"").output;
    EXPECT_NE(table.find("3,0,never placed,,,,"), std::string::npos) << table;
}

}  // namespace
}  // namespace echolucent
