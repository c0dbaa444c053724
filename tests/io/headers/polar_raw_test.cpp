#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <limits>
#include <numbers>

#include "processing/scan_conversion/scan_conversion.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::HasSubstr;

RawLayout polarLayout(PolarKind kind, const std::string& type = "uint8") {
    RawLayout layout;
    layout.size = {12, 7, 5};
    layout.type = type;
    layout.polar = polarGeometry({kind, 1, 0.5, {-20, 25}, {-15, 10}, 30, 20}, layout.size);
    return layout;
}

/// Values from 1 on, so that none is 0.
template <typename Value>
std::vector<Value> countedValues() {
    std::vector<Value> values(12 * 7 * 5);
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<Value>(1 + i % 250);
    return values;
}

template <typename Value>
void expectConverted(const std::string& type) {
    const TemporaryFolder folder;
    for (const PolarKind kind : {PolarKind::linear, PolarKind::convex, PolarKind::linearWobbler, PolarKind::wobbler}) {
        ReadOptions options;
        options.raw = polarLayout(kind, type);
        options.raw->bigEndian = sizeof(Value) > 1;
        options.raw->headerBytes = 3;
        const auto values = countedValues<Value>();
        const auto study = readStudy(folder.write("v.raw", "HHH" + bytesFrom(values, sizeof(Value) > 1)), options);
        ASSERT_TRUE(study) << study.error().sentence();
        const ScanConversion conversion(*options.raw->polar, conversionGrid(*options.raw->polar));
        const auto expected = std::get<VoxelArray<Value>>(*conversion.convert(values));
        const Volume& volume = *study->phases.front();
        EXPECT_EQ(std::get<VoxelArray<Value>>(volume.voxels()), expected) << nameOf(kind);
        EXPECT_EQ(volume.dataMask(), conversion.mask());
        EXPECT_TRUE(volume.geometry().spacingKnown);
        ASSERT_TRUE(volume.geometry().probe);
        EXPECT_EQ(volume.geometry().probe->apexMm.has_value(), kind == PolarKind::wobbler);
        EXPECT_EQ(factOf(*study, "polar volume"), std::string(nameOf(kind)) + ": 12 samples x 7 lines x 5 planes");
    }
}

TEST(PolarRaw, EveryKindAndTypeIsConverted) {
    expectConverted<std::uint8_t>("uint8");
    expectConverted<std::uint16_t>("uint16");
    expectConverted<float>("float32");
}

// No guess is made where the geometry is known: echoes of 0 are data.
TEST(PolarRaw, SilenceWithinTheSweepIsData) {
    const TemporaryFolder folder;
    ReadOptions options;
    options.raw = polarLayout(PolarKind::wobbler);
    const auto study = readStudy(folder.write("v.raw", std::string(12 * 7 * 5, '\0')), options);
    ASSERT_TRUE(study);
    const auto& mask = study->phases.front()->dataMask();
    EXPECT_EQ(mask, ScanConversion(*options.raw->polar, conversionGrid(*options.raw->polar)).mask());
    EXPECT_GT(std::count(mask.begin(), mask.end(), 1), 100);
}

TEST(PolarRaw, SideCarKeepsEveryBit) {
    const TemporaryFolder folder;
    const std::string file = folder.write("v.raw", std::string(12 * 7 * 5, 'v'));
    for (const PolarKind kind : {PolarKind::linear, PolarKind::convex, PolarKind::linearWobbler, PolarKind::wobbler}) {
        RawLayout layout = polarLayout(kind);
        layout.polar->lines.values[2] += 1.0 / 300;  // lines need not be evenly spaced
        ASSERT_TRUE(rememberRawLayout(file, layout));
        const auto recalled = recalledRawLayout(file);
        ASSERT_TRUE(recalled && *recalled);
        EXPECT_EQ(**recalled, layout) << nameOf(kind);
        const auto study = readStudy(file);
        ASSERT_TRUE(study) << study.error().sentence();
        for (const ImportFact& fact : study->facts)
            if (fact.name == "lines") {
                EXPECT_EQ(fact.source, "v.raw.echolucent.json");
            }
    }
}

TEST(PolarRaw, OldSideCarsStillOpen) {
    const TemporaryFolder folder;
    const std::string file = folder.write("v.raw", "abcd");
    folder.write("v.raw.echolucent.json",
                 R"({"format": "echolucent-raw-layout", "version": 1, "size": [2, 2, 1], "type": "uint8",
                     "byte_order": "little", "header_bytes": 0, "spacing_mm": [0.3, 0.3, 0.5], "spacing_known": true})");
    const auto study = readStudy(file, withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_EQ(study->phases.front()->geometry().spacing, Vec3(0.3, 0.3, 0.5));
}

TEST(PolarRaw, WrongGeometriesAreRefusedInWords) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const TemporaryFolder folder;
    const std::string file = folder.write("v.raw", std::string(12 * 7 * 5, 'v'));
    const auto sentenceWith = [&](const std::function<void(RawLayout&)>& change) {
        ReadOptions options;
        options.raw = polarLayout(PolarKind::wobbler);
        change(*options.raw);
        const auto study = readStudy(file, options);
        return study ? "was read" : study.error().sentence();
    };
    EXPECT_EQ(sentenceWith([](RawLayout&) {}), "was read");
    EXPECT_THAT(sentenceWith([](RawLayout& l) {
                    l.size = {13, 7, 5};
                    l.polar->samples = 13;
                }),
                HasSubstr("declares 455 bytes"));
    EXPECT_THAT(sentenceWith([](RawLayout& l) {
                    l.size = {12, 5, 7};
                }),
                HasSubstr("the lines of --raw-lines are 7 where --raw-size says 5"));
    EXPECT_THAT(sentenceWith([](RawLayout& l) { l.polar->samples = 13; }),
                HasSubstr("the range of --raw-range has 13 samples where --raw-size says 12"));
    EXPECT_THAT(sentenceWith([](RawLayout& l) { l.polar->planes.values.pop_back(); }),
                HasSubstr("the planes of --raw-planes are 4 where --raw-size says 5"));
    EXPECT_THAT(sentenceWith([](RawLayout& l) { l.polar->lines.values[3] = nan; }), HasSubstr("hold nan radians"));
    EXPECT_THAT(sentenceWith([](RawLayout& l) { l.polar->lines.values[3] = -1; }), HasSubstr("neither rise nor fall"));
    EXPECT_THAT(sentenceWith([](RawLayout& l) { l.polar->rangeStepMm = -1; }), HasSubstr("has a step of -1 mm"));
}

// Two lines a hundredth of a millimetre apart: within the memory limit the grid has one voxel across them.
TEST(PolarRaw, AGridOfOneVoxelIsRefusedBeforeItIsMade) {
    const TemporaryFolder folder;
    const std::string file = folder.write("thin.raw", "");
    std::filesystem::resize_file(file, std::size_t{4000} * 2 * 4000);
    ReadOptions options;
    options.raw = RawLayout{.size = {4000, 2, 4000}};
    options.raw->polar = polarGeometry({PolarKind::linear, 0, 0.02, {0, 0.01}, {0, 79.98}, 0, 0}, options.raw->size);
    const auto study = readStudy(file, options);
    ASSERT_FALSE(study);
    EXPECT_THAT(study.error().sentence(), HasSubstr("the lines of --raw-lines make a grid of 1 x "));
    EXPECT_THAT(study.error().sentence(), HasSubstr("one voxel thick within the memory limit"));
    EXPECT_THAT(study.error().sentence(), HasSubstr("--conversion-memory"));
}

TEST(PolarRaw, ASideCarMayHoldAsManyLinesAsAProbe) {
    const TemporaryFolder folder;
    RawLayout layout{.size = {2, mostPolarLines, 2}};
    layout.polar = polarGeometry({PolarKind::wobbler, 0, 0.5, {-35, 35}, {-30, 30}, 40, 25}, layout.size);
    ASSERT_TRUE(rememberRawLayout(folder.file("v.raw"), layout));
    EXPECT_GT(std::filesystem::file_size(folder.file("v.raw.echolucent.json")), 1U << 20);
    const auto recalled = recalledRawLayout(folder.file("v.raw"));
    ASSERT_TRUE(recalled) << recalled.error().sentence();
    EXPECT_EQ(**recalled, layout);
}

TEST(PolarRaw, WrongSideCarsAreRefusedWithTheirKey) {
    const TemporaryFolder folder;
    const std::string file = folder.write("v.raw", std::string(8, 'v'));
    const auto sentenceOf = [&](const std::string& polar) {
        folder.write("v.raw.echolucent.json", R"({"format": "echolucent-raw-layout", "version": 1, "size": [2, 2, 2],
                                                  "polar": )" +
                                                  polar + "}");
        const auto study = readStudy(file);
        return study ? "was read" : study.error().sentence();
    };
    const std::string range = R"("range_start_mm": 0, "range_step_mm": 0.5, )";
    const std::string planes = R"(, "planes": {"positions_mm": [0, 1]}})";
    EXPECT_EQ(sentenceOf("{" + range + R"("lines": {"positions_mm": [0, 1]})" + planes), "was read");
    EXPECT_THAT(sentenceOf("7"), HasSubstr("polar"));
    EXPECT_THAT(sentenceOf("{" + range + R"("lines": {"positions_mm": [0, "x"]})" + planes), HasSubstr("positions_mm"));
    EXPECT_THAT(sentenceOf("{" + range + R"("lines": {})" + planes), HasSubstr("must stand alone, or positions_mm"));
    EXPECT_THAT(sentenceOf("{" + range + R"("lines": {"angles_radians": [0, 1]})" + planes), HasSubstr("radius_mm"));
    EXPECT_THAT(sentenceOf("{" + range + R"("lines": {"positions_mm": [0, 1, 2]})" + planes),
                HasSubstr("the lines of v.raw.echolucent.json are 3"));
}

}  // namespace
}  // namespace echolucent
