#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "temporary_folder.h"

namespace echolucent {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

RawLayout plainLayout(const std::string& type) {
    RawLayout layout;
    layout.size = {2, 1, 2};
    layout.type = type;
    return layout;
}

template <typename T>
void expectRead(const std::string& type) {
    const TemporaryFolder folder;
    for (const bool big : {false, true}) {
        ReadOptions options = withoutGuess();
        options.raw = plainLayout(type);
        options.raw->bigEndian = big;
        options.raw->headerBytes = 5;
        const auto study = readStudy(folder.write("v.raw", "12345" + bytesFrom<T>({1, 2, 3, 100}, big)), options);
        ASSERT_TRUE(study) << study.error().sentence();
        EXPECT_THAT(storedValues(*study->phases[0]), ElementsAre(1, 2, 3, 100)) << type << big;
        EXPECT_FALSE(study->phases[0]->geometry().spacingKnown);
    }
}

TEST(RawVolume, EveryTypeIsReadInBothByteOrders) {
    expectRead<std::uint8_t>("uint8");
    expectRead<std::int8_t>("int8");
    expectRead<std::uint16_t>("uint16");
    expectRead<std::int16_t>("int16");
    expectRead<std::uint32_t>("uint32");
    expectRead<std::int32_t>("int32");
    expectRead<float>("float32");
    expectRead<double>("float64");
}

TEST(RawVolume, RememberedLayoutIsUsedNextTime) {
    const TemporaryFolder folder;
    const std::string file = folder.write("v.raw", "HH" + bytesFrom<std::uint16_t>({7, 8, 9, 10}, true));
    RawLayout layout = plainLayout("uint16");
    layout.bigEndian = true;
    layout.headerBytes = 2;
    layout.spacing = {0.1, 0.2, 0.3};
    layout.spacingKnown = true;
    ASSERT_FALSE(readStudy(file));
    ASSERT_TRUE(rememberRawLayout(file, layout));
    const auto study = readStudy(file, withoutGuess());
    ASSERT_TRUE(study) << study.error().sentence();
    EXPECT_THAT(storedValues(*study->phases[0]), ElementsAre(7, 8, 9, 10));
    EXPECT_EQ(study->phases[0]->geometry().spacing, Vec3(0.1, 0.2, 0.3));
    EXPECT_TRUE(study->phases[0]->geometry().spacingKnown);

    const auto recalled = recalledRawLayout(file);
    ASSERT_TRUE(recalled && *recalled);
    EXPECT_EQ((*recalled)->size, layout.size);
    EXPECT_EQ((*recalled)->type, "uint16");
    EXPECT_TRUE((*recalled)->bigEndian);
    EXPECT_EQ((*recalled)->headerBytes, 2);
    EXPECT_FALSE(recalledRawLayout(folder.file("other.raw")).value().has_value());
}

TEST(RawVolume, WrongLayoutsAreRefusedWithTheNumbers) {
    const TemporaryFolder folder;
    const std::string file = folder.write("v.raw", "abcd");
    const auto sentenceWith = [&](const std::function<void(RawLayout&)>& change) {
        ReadOptions options;
        options.raw = plainLayout("uint8");
        change(*options.raw);
        const auto study = readStudy(file, options);
        return study ? std::string("was read") : study.error().sentence();
    };
    EXPECT_EQ(sentenceWith([](RawLayout&) {}), "was read");
    EXPECT_THAT(sentenceWith([](RawLayout& l) { l.size = {2, 2, 2}; }), HasSubstr("declares 8 bytes"));
    EXPECT_THAT(sentenceWith([](RawLayout& l) { l.size = {2, 2, 2}; }), HasSubstr("holds only 4"));
    EXPECT_THAT(sentenceWith([](RawLayout& l) { l.size = {0, 2, 2}; }), HasSubstr("three whole numbers above 0"));
    EXPECT_THAT(sentenceWith([](RawLayout& l) {
                    l.size = {1LL << 40, 1LL << 40, 2};
                }),
                HasSubstr("more voxels than any file"));
    EXPECT_THAT(sentenceWith([](RawLayout& l) { l.type = "int12"; }), HasSubstr("--raw-type is \"int12\""));
    EXPECT_THAT(sentenceWith([](RawLayout& l) { l.headerBytes = 1; }), HasSubstr("holds only 3"));
    EXPECT_THAT(sentenceWith([](RawLayout& l) { l.headerBytes = -1; }), HasSubstr("--raw-header-bytes"));
    EXPECT_THAT(sentenceWith([](RawLayout& l) { l.spacing = {1, 0, 1}; }), HasSubstr("--raw-spacing"));
}

TEST(RawVolume, ALayoutOfAnyEdgeIsRecalledAsItWasRemembered) {
    const TemporaryFolder folder;
    RawLayout layout = plainLayout("int16");
    layout.size = {2'000'000, 3, 1};
    layout.bigEndian = true;
    layout.headerBytes = 12;
    layout.spacing = {0.1, 1.0 / 3.0, 2};
    layout.spacingKnown = true;
    ASSERT_TRUE(rememberRawLayout(folder.file("v.raw"), layout));
    const auto recalled = recalledRawLayout(folder.file("v.raw"));
    ASSERT_TRUE(recalled) << recalled.error().sentence();
    EXPECT_EQ(*recalled, std::optional(layout));
}

TEST(Reading, IsEndedByCancelAndReportsItsShare) {
    const TemporaryFolder folder;
    const std::string file = folder.write("v.raw", std::string(16 << 20, 'x'));
    ReadOptions options = withoutGuess();
    options.raw = plainLayout("uint8");
    options.raw->size = {256, 256, 256};
    std::atomic<bool> cancel{false};
    std::vector<double> shares;
    const Progress progress{[&](double share) {
                                shares.push_back(share);
                                cancel = share > 0.3;
                            },
                            &cancel};
    const auto study = readStudy(file, options, progress);
    ASSERT_FALSE(study);
    EXPECT_EQ(study.error().kind, FailureKind::cancelled);
    ASSERT_GE(shares.size(), 2U);
    EXPECT_TRUE(std::is_sorted(shares.begin(), shares.end()));
    EXPECT_LT(shares.back(), 0.6);

    cancel = false;
    shares.clear();
    const Progress whole{[&](double share) { shares.push_back(share); }, &cancel};
    ASSERT_TRUE(readStudy(file, options, whole));
    EXPECT_EQ(shares.back(), 1.0);
}

}  // namespace
}  // namespace echolucent
