// What a graphics card draws from, without a card.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <set>

#include "processing/card_picture/card_pictures.h"
#include "processing/ray_caster/ray_caster.h"
#include "processing/volume/filled_volume.h"

namespace echolucent {
namespace {

std::shared_ptr<const Volume> ramp(int edge = 20) {
    VolumeGeometry geometry;
    geometry.size = {edge, edge + 3, edge - 5};
    geometry.spacing = {0.5, 0.7, 1.1};
    std::vector<std::uint8_t> voxels;
    for (std::int64_t i = 0; i < geometry.voxelCount(); ++i) voxels.push_back(static_cast<std::uint8_t>(i * 7 % 251));
    return std::make_shared<const Volume>(geometry, std::move(voxels));
}

RayCastSettings litSettings(const Volume& volume) {
    RayCastSettings settings;
    settings.width = 30;
    settings.height = 20;
    settings.camera = defaultCamera(volume.dataBox(), Viewpoint{BeamAxis::plusZ, 20.0, 10.0}, 1.5);
    settings.shading = Shading{};
    settings.shading->reaching = ReachingLight{};
    return settings;
}

/// A dome across the view through the middle of the volume.
CutSurface domeIn(const Volume& volume, const ViewFrame& frame) {
    const Vec3 centre = volume.geometry().centreMm();
    CutSurface surface{.frame = frame, .spacingMm = 2.0, .columns = 15, .rows = 15};
    surface.firstRightMm = frame.right.dot(centre) - 14.0;
    surface.firstDownMm = frame.down.dot(centre) - 14.0;
    std::vector<float> depths;
    for (int row = -7; row <= 7; ++row)
        for (int column = -7; column <= 7; ++column)
            depths.push_back(static_cast<float>(frame.forward.dot(centre) - 3.0 + 0.1 * (row * row + column * column)));
    surface.depthMm = SharedList<float>(std::move(depths));
    return surface;
}

TEST(CardPictures, WhatStaysIsTheSameObject) {
    const auto volume = ramp();
    CardPictures maker(volume);
    RayCastSettings settings = litSettings(*volume);
    const auto first = maker.make(PowerCurve{2, 1.0}, settings), again = maker.make(PowerCurve{2, 1.0}, settings);
    EXPECT_EQ(first->scan, again->scan);
    EXPECT_EQ(first->table, again->table);
    EXPECT_EQ(first->bricks, again->bricks);
    EXPECT_EQ(first->light, again->light);
    settings.camera.frame = frameOf(Viewpoint{BeamAxis::plusZ, 50.0, 10.0});
    const auto turned = maker.make(PowerCurve{2, 1.0}, settings);
    EXPECT_EQ(turned->scan, first->scan);
    EXPECT_EQ(turned->table, first->table);
    EXPECT_NE(turned->light, first->light) << "light is the viewer's";
    const auto edited = maker.make(PowerCurve{3, 1.0}, settings);
    EXPECT_EQ(edited->scan, first->scan);
    EXPECT_NE(edited->table, turned->table);
    EXPECT_NE(edited->light, turned->light);
}

TEST(CardPictures, AScalpelsCutChangesThePresenceAlone) {
    const auto volume = ramp();
    std::vector<std::uint8_t> mask(static_cast<std::size_t>(volume->geometry().voxelCount()), 1);
    std::fill(mask.begin(), mask.begin() + 4000, std::uint8_t{0});
    const auto cut = std::make_shared<const Volume>(volume->withCut(std::make_shared<const DataMask>(std::move(mask))));
    CardPictures maker(volume);
    const auto before = maker.make(PowerCurve{1, 1.0}, litSettings(*volume));
    maker.setCut(cut);
    const auto after = maker.make(PowerCurve{1, 1.0}, litSettings(*volume));
    EXPECT_EQ(before->scan, after->scan);
    EXPECT_EQ(before->presence, nullptr);
    ASSERT_NE(after->presence, nullptr);
    const auto fresh = CardPictures(cut).make(PowerCurve{1, 1.0}, litSettings(*volume));
    EXPECT_TRUE(std::get<VoxelArray<std::uint8_t>>(after->presence->voxels()).toVector() ==
                std::get<VoxelArray<std::uint8_t>>(presenceIn(*cut)->voxels()).toVector());
    EXPECT_EQ(*after->light, *fresh->light);
    EXPECT_EQ(after->bricks == nullptr, fresh->bricks == nullptr);
    EXPECT_THROW(maker.setCut(ramp(24)), std::invalid_argument);
}

TEST(CardPictures, ABowedFrontStaysTheSameObject) {
    const auto volume = ramp();
    RayCastSettings settings = litSettings(*volume);
    CardPictures maker(volume);
    EXPECT_EQ(maker.make(PowerCurve{1, 1.0}, settings)->surface, nullptr);
    settings.cutSurface = domeIn(*volume, settings.camera.frame);
    const auto bowed = maker.make(PowerCurve{1, 1.0}, settings);
    ASSERT_NE(bowed->surface, nullptr);
    EXPECT_EQ(*bowed->surface, *settings.cutSurface);
    settings.camera.frame = frameOf(Viewpoint{BeamAxis::plusZ, 50.0, 10.0});
    EXPECT_EQ(maker.make(PowerCurve{1, 1.0}, settings)->surface, bowed->surface);
    settings.cutSurface->spacingMm = 2.5;
    EXPECT_NE(maker.make(PowerCurve{1, 1.0}, settings)->surface, bowed->surface);
}

TEST(CardPictures, FloatsOfThreadsBecomeFinitePositions) {
    VolumeGeometry geometry;
    geometry.size = {5, 4, 3};
    std::vector<float> voxels(60, 0.5f);
    voxels[7] = std::numeric_limits<float>::quiet_NaN();
    voxels[8] = std::numeric_limits<float>::infinity();
    voxels[9] = 3e38f;
    voxels[10] = -3e38f;
    const auto volume = std::make_shared<const Volume>(geometry, VoxelArray<float>(std::move(voxels)), 1.0);
    const auto picture = CardPictures(volume).make(PowerCurve{1, 1.0}, litSettings(*volume));
    ASSERT_EQ(picture->scan->positions.size(), 60u);
    for (const float position : picture->scan->positions) EXPECT_LE(std::abs(position), 1e15f);
    EXPECT_FLOAT_EQ(picture->scan->positions[0], 0.5f * ray_casting::TransferTable::intervals);
    EXPECT_NE(picture->presence, nullptr) << "what is not finite is no data";
}

TEST(CardPictures, EndIfTheyAreCancelled) {
    const auto volume = ramp();
    CardPictures maker(volume);
    const std::atomic<bool> cancel{true};
    RayCastSettings settings = litSettings(*volume);
    EXPECT_FALSE(maker.make(PowerCurve{1, 1.0}, settings, Progress{{}, &cancel}));
    settings.shading.reset();
    EXPECT_FALSE(maker.make(PowerCurve{1, 1.0}, settings, Progress{{}, &cancel}));
    EXPECT_TRUE(maker.make(PowerCurve{1, 1.0}, settings)) << "the next one is whole";
}

TEST(CardPictures, TheKnownPictureTellsAWrongOneFromARightOne) {
    const Picture known = knownCardPicture().expected;
    EXPECT_EQ(levelsBetween(known, known), 0.0);
    std::set<float> values(known.rgba.begin(), known.rgba.end());
    EXPECT_GT(values.size(), 500u) << "it is no plain field";
    const auto changed = [&](auto at) {
        Picture other = known;
        for (int row = 0; row < known.height; ++row)
            for (int column = 0; column < known.width; ++column)
                for (int i = 0; i < 4; ++i)
                    other.rgba[static_cast<std::size_t>(4 * (row * known.width + column) + i)] = at(column, row, i);
        return levelsBetween(known, other);
    };
    const auto pixel = [&](int column, int row, int i) {
        return known.rgba[static_cast<std::size_t>(4 * (row * known.width + column) + i)];
    };
    const int last = known.width - 1;
    EXPECT_GT(changed([&](int x, int y, int i) { return pixel(last - x, y, i); }), KnownCardPicture::tolerance);
    EXPECT_GT(changed([&](int x, int y, int i) { return pixel(x, last - y, i); }), KnownCardPicture::tolerance);
    EXPECT_GT(changed([&](int x, int y, int i) { return pixel(y, x, i); }), KnownCardPicture::tolerance);
    EXPECT_GT(changed([&](int x, int y, int i) { return pixel(x, y, i == 3 ? 3 : 2 - i); }),
              KnownCardPicture::tolerance);
    EXPECT_GT(changed([&](int x, int y, int i) { return i == 3 ? pixel(x, y, 3) : 0.95f * pixel(x, y, i); }),
              KnownCardPicture::tolerance);
    EXPECT_EQ(changed([&](int, int, int) { return std::numeric_limits<float>::quiet_NaN(); }),
              std::numeric_limits<double>::infinity());
    EXPECT_EQ(levelsBetween(known, Picture{}), std::numeric_limits<double>::infinity());
}

TEST(CardPictures, BytesOnTheCardAreToldBeforeAnythingIsMade) {
    const auto volume = ramp();
    const std::int64_t voxels = volume->geometry().voxelCount();
    const auto lit = CardPictures(volume).make(PowerCurve{2, 1.0}, litSettings(*volume));
    EXPECT_EQ(bytesOnCard(*volume, 0, 0), 3 * voxels) << "voxels and light";
    EXPECT_LE(lit->light->reaching.size(), static_cast<std::size_t>(2 * voxels));
    const Volume masked =
        volume->withDataMask(std::vector<std::uint8_t>(static_cast<std::size_t>(voxels), std::uint8_t{1}));
    EXPECT_EQ(bytesOnCard(masked, 0, 0), (masked.dataMask().empty() ? 3 : 4) * voxels) << "and presence";
    EXPECT_EQ(bytesOnCard(*volume, 60, 20) - bytesOnCard(*volume, 30, 20), 600 * 32) << "two pictures";
}

}  // namespace
}  // namespace echolucent
