#include "processing/pane_picture/small_picture.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <cmath>

#include "processing/document/preset.h"
#include "processing/pane_picture/pane_picture.h"
#include "processing/phantom/phantom.h"

namespace echolucent {
namespace {

TEST(SmallPicture, IsThePanesPictureMadeSmall) {
    PhantomConfig config = defaultPhantom(PhantomScene::shapes);
    config.size = {40, 38, 42};
    const auto volume = std::make_shared<const Volume>(*makePhantom(config));
    Document document;
    document.scene.look = Look{};
    PaneCaster caster({.scans = {volume}});
    for (const Preset& preset : standardPresets()) {
        Document next = withPreset(document, firstPane, preset);
        next.scene.look.reduction = SpeckleReduction::off;  // so that both are made of the same voxels
        const auto small = smallPicture(caster, next, firstPane, 24, 20);
        const auto whole = panePicture(next, firstPane, std::array{volume}, 48, 40);
        ASSERT_TRUE(small && whole);
        ASSERT_EQ(small->width, 24);
        ASSERT_EQ(small->height, 20);
        double sum = 0;
        for (std::size_t i = 0; i < small->rgba.size(); ++i) {
            const std::size_t x = i / 4 % 24, y = i / 4 / 24, channel = i % 4;
            double mean = 0;
            for (std::size_t n = 0; n < 4; ++n)
                mean += 0.25 * whole->picture.rgba[4 * ((2 * y + n / 2) * 48 + 2 * x + n % 2) + channel];
            sum += std::abs(small->rgba[i] - mean);
        }
        // The converged picture has a quarter of the step; pictures of other presets differ by ten times as much.
        EXPECT_LT(sum / static_cast<double>(small->rgba.size()), 0.006) << preset.name;
    }
}

TEST(SmallPicture, FollowsTheScalpelAndACancelledCall) {
    PhantomConfig config = defaultPhantom(PhantomScene::shapes);
    config.size = {40, 38, 42};
    const auto volume = std::make_shared<const Volume>(*makePhantom(config));
    Document before = withPreset(Document{}, firstPane, standardPresets()[0]);
    before.scene.look.reduction = SpeckleReduction::off;
    Document after = before;
    ScalpelStroke stroke;
    stroke.camera = castSettingsOf(before, volume->geometry(), volume->dataBox(), 48, 40).camera;
    stroke.places = {{-0.5, -0.5}, {0.0, -0.5}, {0.0, 0.5}, {-0.5, 0.5}};
    after.scene.strokes.push_back(stroke);
    PaneCaster caster({.scans = {volume}}), fresh({.scans = {volume}});
    const auto whole = smallPicture(caster, before, firstPane, 24, 20);
    const std::atomic<bool> cancelled{true};
    EXPECT_FALSE(smallPicture(caster, after, firstPane, 24, 20, Progress{{}, &cancelled}));
    const auto followed = smallPicture(caster, after, firstPane, 24, 20);
    const auto expected = smallPicture(fresh, after, firstPane, 24, 20);
    ASSERT_TRUE(whole && followed && expected);
    EXPECT_EQ(followed->rgba, expected->rgba);
    EXPECT_NE(followed->rgba, whole->rgba);
}

}  // namespace
}  // namespace echolucent
