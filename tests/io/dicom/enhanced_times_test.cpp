// The times of phases in functional groups beside Temporal Position Time Offset: triggers, and dates with times.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

#include "dicom_bytes.h"
#include "temporary_folder.h"

namespace echolucent {
namespace {

/// One frame of 2 x 2 pixels.
struct Frame {
    double z = 0;
    std::string acquired{}, reference{};   ///< date and time
    std::optional<double> trigger{};       ///< ms
    std::optional<std::uint32_t> index{};  ///< Temporal Position Index
};

/// Frame i has the value 1 + i.
Result<Study> readFrames(const std::vector<Frame>& frames) {
    std::vector<DicomBytes> items;
    for (const Frame& frame : frames) {
        DicomBytes content, place, trigger, item;
        if (frame.trigger) item.sequence(0x0018, 0x9118, {trigger.real(0x0020, 0x9153, *frame.trigger)});
        if (!frame.acquired.empty()) content.text(0x0018, 0x9074, "DT", frame.acquired);
        if (!frame.reference.empty()) content.text(0x0018, 0x9151, "DT", frame.reference);
        if (frame.index) content.put(0x0020, 0x9128, "UL", bytesFrom<std::uint32_t>({*frame.index}));
        item.sequence(0x0020, 0x9111, {content});
        place.text(0x0020, 0x0032, "DS", "0\\0\\" + std::to_string(frame.z));
        items.push_back(item.sequence(0x0020, 0x9113, {place}));
    }
    DicomBytes orientation, measures, shared, file;
    orientation.text(0x0020, 0x0037, "DS", "1\\0\\0\\0\\1\\0");
    measures.text(0x0028, 0x0030, "DS", "0.5\\0.5");
    shared.sequence(0x0020, 0x9116, {orientation}).sequence(0x0028, 0x9110, {measures});
    file.text(0x0008, 0x0060, "CS", "US").picture(2, 2, static_cast<int>(frames.size()));
    file.sequence(0x5200, 0x9229, {shared}).sequence(0x5200, 0x9230, items);
    std::string pixels;
    for (std::size_t frame = 0; frame < frames.size(); ++frame) pixels += std::string(4, static_cast<char>(1 + frame));
    file.put(0x7fe0, 0x0010, "OB", pixels);
    const TemporaryFolder folder;
    return readStudy(folder.write("a.dcm", file.file("1.2.840.10008.5.1.4.1.1.6.2")), withoutGuess());
}

std::vector<std::vector<double>> framesOf(const Result<Study>& study) {
    std::vector<std::vector<double>> phases;
    EXPECT_TRUE(study) << study.error().sentence();
    if (!study) return phases;
    for (const auto& phase : study->phases) {
        phases.emplace_back();
        for (std::int64_t i = 0; i < phase->geometry().size[2]; ++i)
            phases.back().push_back(phase->storedValue(static_cast<std::size_t>(4 * i)));
    }
    return phases;
}

using Frames = std::vector<std::vector<double>>;

TEST(EnhancedTimes, TriggerDelaysSplitFramesWhosePlacesRepeat) {
    const auto study = readFrames({{.z = 0, .trigger = 90.0},
                                   {.z = 1, .trigger = 90.0},
                                   {.z = 0, .trigger = 10.0},
                                   {.z = 1, .trigger = 10.0},
                                   {.z = 0, .trigger = 50.0},
                                   {.z = 1, .trigger = 50.0}});
    EXPECT_EQ(framesOf(study), (Frames{{3, 4}, {5, 6}, {1, 2}}));
    EXPECT_DOUBLE_EQ(*study->phaseTimes.meanSeconds, 0.04);
    EXPECT_TRUE(study->phaseTimes.starts.empty());
    EXPECT_TRUE(warnsOf(*study, "(0020,9153) Nominal Cardiac Trigger Delay Time tells 3 phases apart"));
    EXPECT_EQ(sourceOf(*study, "time between phases"), "(0020,9153) Nominal Cardiac Trigger Delay Time");
}

TEST(EnhancedTimes, DatesSplitTheFramesOfEachPlaceInTheirOrder) {
    // Around midnight and in several zones, each slice a little later than the one below.
    const auto study = readFrames({{.z = 0, .acquired = "20240229235959.900000+0000"},
                                   {.z = 1, .acquired = "20240229185959.950000-0500"},
                                   {.z = 1, .acquired = "20240301000000.250000"},
                                   {.z = 0, .acquired = "20240301000000.200000"},
                                   {.z = 0, .acquired = "20240301010001.000000+0100"},
                                   {.z = 1, .acquired = "20240301010001.050000+0100"}});
    EXPECT_EQ(framesOf(study), (Frames{{1, 2}, {4, 3}, {5, 6}}));
    ASSERT_EQ(study->phaseTimes.starts.size(), 3U);
    EXPECT_NEAR(study->phaseTimes.starts[1], 0.3, 1e-4);
    EXPECT_NEAR(study->phaseTimes.starts[2], 1.1, 1e-4);
    EXPECT_EQ(sourceOf(*study, "time between phases"), "(0018,9074) Frame Acquisition Date Time");
    EXPECT_TRUE(warnsOf(*study, "at each of 2 places 3 times: (0018,9074) Frame Acquisition Date Time tells 3 phases"));
}

TEST(EnhancedTimes, IndicesTakeTheirTimesFromDates) {
    const auto study = readFrames({{.z = 0, .reference = "20240101120000.5", .index = 1},
                                   {.z = 1, .reference = "20240101120000.5", .index = 1},
                                   {.z = 0, .reference = "20240101120001", .index = 2},
                                   {.z = 1, .reference = "20240101120001", .index = 2}});
    EXPECT_EQ(framesOf(study), (Frames{{1, 2}, {3, 4}}));
    EXPECT_NEAR(*study->phaseTimes.meanSeconds, 0.5, 1e-4);
    EXPECT_EQ(sourceOf(*study, "time between phases"),
              "(0018,9151) Frame Reference Date Time; phases by (0020,9128) Temporal Position Index");
}

TEST(EnhancedTimes, TimesThatMakeNoSenseAreLeftOut) {
    for (const std::string bad : {"2024", "20241301000000", "yesterday", "20240101120000.x", ""}) {
        const auto study = readFrames({{.z = 0, .acquired = "20240101120000", .index = 1},
                                       {.z = 1, .acquired = "20240101120000", .index = 1},
                                       {.z = 0, .acquired = bad, .index = 2},
                                       {.z = 1, .acquired = "20240101120001", .index = 2}});
        EXPECT_EQ(framesOf(study), (Frames{{1, 2}, {3, 4}})) << bad;
        EXPECT_FALSE(study->phaseTimes.meanSeconds) << bad;
    }
    // Against the order of the index.
    const auto against = readFrames({{.z = 0, .trigger = 9.0, .index = 1},
                                     {.z = 1, .trigger = 9.0, .index = 1},
                                     {.z = 0, .trigger = 1.0, .index = 2},
                                     {.z = 1, .trigger = 1.0, .index = 2}});
    EXPECT_FALSE(against->phaseTimes.meanSeconds);
    // A slow sweep: each frame has a time and a place of its own.
    const auto sweep = readFrames({{.z = 0, .acquired = "20240101120000"},
                                   {.z = 1, .acquired = "20240101120001"},
                                   {.z = 2, .acquired = "20240101120002"}});
    EXPECT_EQ(framesOf(sweep), (Frames{{1, 2, 3}}));
    // A place that is there more often than another.
    EXPECT_FALSE(readFrames({{.z = 0, .acquired = "20240101120000"},
                             {.z = 1, .acquired = "20240101120000"},
                             {.z = 1, .acquired = "20240101120001"}}));
}

}  // namespace
}  // namespace echolucent
