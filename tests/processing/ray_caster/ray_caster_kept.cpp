// RayCaster: samples kept between pictures change nothing but the time they take.
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <atomic>
#include <cstdio>

#include "processing/ray_caster/kernel_job.h"
#include "ray_caster_scenes.h"

namespace echolucent {
namespace {

/// The picture from kept samples is that of castRays() but for what 16 bits a sample cost: 1/512 of a byte's step,
/// enough to reach the next entry of the bytes' opacities; and the time when a ray ends.
void expectSameAsAlone(RayCaster& caster, const OpacityCurve& curve, const RayCastSettings& settings,
                       const std::string& what) {
    const auto picture = caster.cast(curve, settings), alone = castRays(*caster.volume(), curve, settings);
    const Apart difference = apart(*picture, *alone);
    EXPECT_LT(difference.rootMeanSquare, settings.shading ? 0.03 : 0.02) << what;
    EXPECT_LT(difference.largest, settings.shading ? 1.0 : 0.5) << what;
    ASSERT_EQ(picture->depthMm.size(), alone->depthMm.size()) << what;
    std::size_t elsewhere = 0;
    for (std::size_t i = 0; i < alone->depthMm.size(); ++i)
        elsewhere += picture->depthMm[i] == alone->depthMm[i] ? 0 : 1;
    EXPECT_LE(elsewhere, alone->depthMm.size() / 200) << what << ": half reached a sample earlier or later, at most";
}

const std::vector<std::pair<std::string, OpacityCurve>> edits{
    {"opaque", PowerCurve{1, 3.0}},        {"transparent", PowerCurve{2, 0.01}},
    {"opaque again", everywhere(0.95)},    {"narrow", onlyBetween(0.5, 0.9, 0.3)},
    {"nothing", everywhere(0.0)},          {"adaptive", SampledCurve{{0, 0, 0.02, 0, 0.3, 0.6, 0.2, 1.0}}},
    {"wholly opaque", everywhere(1.0)},    {"very transparent", everywhere(1e-4)},
    {"linear", LinearCurve{0.2, 0.7, 0.9}}};

void expectEditsFollowed(const Volume& volume, const RayCastSettings& settings, const std::string& what) {
    RayCaster caster(held(volume));
    for (int round = 0; round < 2; ++round)
        for (const auto& [name, curve] : edits) {
            std::string edit = what;
            edit.append(", ").append(name);
            expectSameAsAlone(caster, curve, settings, edit);
            EXPECT_TRUE(round == 0 || caster.keptSampleBytes() > 0) << edit;
        }
}

/// With depth, and with rays that end as early as they do in the window.
RayCastSettings settingsWithDepth(const Volume& volume, int width = 73, int height = 59) {
    RayCastSettings settings = obliqueSettings(volume, width, height);
    settings.terminationTransmittance = RayCastSettings{}.terminationTransmittance;
    settings.findDepth = true;
    return settings;
}

template <typename Voxel>
void expectEditsFollowedInEveryView() {
    const Volume volume = speckledShell<Voxel>({41, 37, 45}, {1, 1.2, 0.8}, 5);
    RayCastSettings settings = settingsWithDepth(volume);
    expectEditsFollowed(volume, settings, "parallel");
    expectEditsFollowed(sectorOf(volume), settings, "masked");
    RayCastSettings plain = settings;
    plain.findDepth = false;
    expectEditsFollowed(volume, plain, "plain");
    expectEditsFollowed(sectorOf(volume), plain, "plain, masked");
    settings.camera.projection = Projection::perspective;
    settings.camera.viewAngleDegrees = 60;
    settings.step = 0.37;
    expectEditsFollowed(volume, settings, "perspective");
    settings = settingsWithDepth(volume);
    settings.interpolation = Interpolation::nearest;
    settings.box = RenderBox{{3, 4, 5}, {30, 41, 28}};
    settings.clippingPlanes = {{volume.geometry().centreMm(), {1, 2, -1}}};
    expectEditsFollowed(sectorOf(volume), settings, "cut, nearest");
}
TEST(RayCasterKept, EditsOfTheCurveOnBytes) { expectEditsFollowedInEveryView<std::uint8_t>(); }
TEST(RayCasterKept, EditsOfTheCurveOnWords) { expectEditsFollowedInEveryView<std::uint16_t>(); }
TEST(RayCasterKept, EditsOfTheCurveOnFloats) { expectEditsFollowedInEveryView<float>(); }

// A wall ends the rays that meet it. Beside them are rays that end sooner, at a plane, and let light through: what lies
// behind the wall must not be taken as known.
TEST(RayCasterKept, RaysThatEndedEarlyGoOnUnderATransparentCurve) {
    const Volume volume = volumeOf<std::uint8_t>({40, 40, 160}, {1, 1, 1}, [](auto x, auto y, auto z) {
        return z >= 60 && z < 65 ? 1.0 : 0.4 + 0.2 * static_cast<double>((x + y + z) % 2);
    });
    // Of neighbouring rays one ends this much farther along the view than the other, in steps across and down.
    const std::pair<double, double> slopes[] = {{1.5, 0.0}, {0.0, 9.0}, {20.0, -35.0}};
    for (const double azimuth : {0.0, 20.0, 65.0})
        for (const auto& [across, down] : slopes) {
            RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::plusZ, azimuth, 9, 0}, 61, 67);
            const ViewFrame& frame = settings.camera.frame;
            const double pixelMm = settings.camera.heightMm / settings.height;
            settings.clippingPlanes = {{Vec3(19.5, 19.5, 55), frame.right * (across / pixelMm) +
                                                                  frame.down * (down / pixelMm) - frame.forward}};
            RayCaster caster(held(volume));
            const OpacityCurve wallAlone = ManualCurve{{{0.0, 0.0}, {0.9, 0.0}, {0.95, 1.0}, {1.0, 1.0}}};
            for (int i = 0; i < 3; ++i) expectSameAsAlone(caster, wallAlone, settings, "the wall alone");
            for (int i = 0; i < 2; ++i) expectSameAsAlone(caster, PowerCurve{2, 0.01}, settings, "all of it");
            expectSameAsAlone(caster, wallAlone, settings, "the wall again");
        }
}

TEST(RayCasterKept, WhatSamplesDoNotDependOnMayChange) {
    const Volume volume = sectorOf(speckledShell<std::uint8_t>({41, 37, 45}, {1, 1.2, 0.8}, 6));
    const RayCastSettings plain = settingsWithDepth(volume);
    RayCaster caster(held(volume));
    const OpacityCurve curve = PowerCurve{2, 0.4};
    (void)caster.cast(curve, plain);
    (void)caster.cast(curve, plain);
    const std::size_t bytes = caster.keptSampleBytes();
    ASSERT_GT(bytes, 0u);
    const auto same = [&](const char* what, const auto& change) {
        RayCastSettings settings = plain;
        change(settings);
        for (int i = 0; i < 2; ++i) expectSameAsAlone(caster, curve, settings, what);
        EXPECT_GE(caster.keptSampleBytes(), bytes) << what << ": the samples are those of the same view";
        EXPECT_LT(caster.keptSampleBytes(), 2 * bytes) << what;
        expectSameAsAlone(caster, curve, plain, std::string("back from ") + what);
    };
    using Settings = RayCastSettings;
    same("a colour map", [](Settings& s) { s.colourMap = ColourMap::ice; });
    same("shading", [](Settings& s) { s.shading = Shading{}; });
    same("depth colouring", [](Settings& s) { s.depthColouring = DepthColouring{}; });
    same("no early end", [](Settings& s) { s.terminationTransmittance = 0.0; });
    same("an earlier end", [](Settings& s) { s.terminationTransmittance = 0.2; });
    same("no skipping", [](Settings& s) { s.skipEmptySpace = false; });
    same("no depth", [](Settings& s) { s.findDepth = false; });
}

TEST(RayCasterKept, WhatSamplesDependOnMakesAnotherView) {
    const Volume volume = speckledShell<std::uint16_t>({31, 37, 35}, {1, 1.2, 0.8}, 7);
    const RayCastSettings plain = settingsWithDepth(volume, 50, 40);
    const OpacityCurve curve = PowerCurve{2, 0.4};
    const auto other = [&](const char* what, const auto& change) {
        RayCaster caster(held(volume));
        for (int i = 0; i < 2; ++i) (void)caster.cast(curve, plain);
        RayCastSettings settings = plain;
        change(settings);
        for (int i = 0; i < 3; ++i) expectSameAsAlone(caster, PowerCurve{2, 0.2 + 0.1 * i}, settings, what);
        for (int i = 0; i < 3; ++i)
            expectSameAsAlone(caster, PowerCurve{2, 0.2 + 0.1 * i}, plain, std::string("before ") + what);
    };
    using Settings = RayCastSettings;
    other("another camera", [](Settings& s) { s.camera.focalPoint[0] += 3.0; });
    other("another projection", [](Settings& s) { s.camera.projection = Projection::perspective; });
    other("another size", [](Settings& s) { s.width = 47; });
    other("another step", [](Settings& s) { s.step = 0.6; });
    other("another front", [&volume](Settings& s) {
        s.front =
            CuttingFace{s.camera.frame.forward, volume.geometry().depthsAlong(s.camera.frame.forward).nearest + 9};
    });
    other("nearest", [](Settings& s) { s.interpolation = Interpolation::nearest; });
    other("a box", [](Settings& s) { s.box = RenderBox{{5, 5, 5}, {20, 20, 20}}; });
    other("a plane", [](Settings& s) { s.clippingPlanes = {{{15, 15, 15}, {1, 0, 0}}}; });
    other("maximum", [](Settings& s) { s.mode = RenderMode::maximum; });
}

TEST(RayCasterKept, AMoveOfTheCameraForgetsAndAViewIsKeptFromItsSecondPictureOn) {
    const Volume volume = speckledShell<std::uint8_t>({31, 37, 35}, {1, 1, 1}, 8);
    RayCastSettings settings = settingsWithDepth(volume);
    RayCaster caster(held(volume));
    EXPECT_EQ(caster.keptSampleBytes(), 0u);
    (void)caster.cast(PowerCurve{2, 0.4}, settings);
    EXPECT_EQ(caster.keptSampleBytes(), 0u) << "a view seen once";
    (void)caster.cast(PowerCurve{2, 0.4}, settings);
    EXPECT_GT(caster.keptSampleBytes(), 0u);
    const Camera before = settings.camera;
    settings.camera.heightMm *= 1.1;
    (void)caster.cast(PowerCurve{2, 0.4}, settings);
    EXPECT_EQ(caster.keptSampleBytes(), 0u) << "the camera moved";
    settings.camera = before;
    for (const double scale : {0.1, 0.9, 0.3}) expectSameAsAlone(caster, PowerCurve{2, scale}, settings, "back");
}

TEST(RayCasterKept, AnUnchangedViewGivesTheSamePixels) {
    const Volume volume = sectorOf(speckledShell<float>({31, 37, 35}, {1, 1, 1}, 9));
    RayCastSettings settings = settingsWithDepth(volume);
    RayCaster caster(held(volume));
    for (int i = 0; i < 2; ++i) (void)caster.cast(PowerCurve{2, 0.4}, settings);
    const auto third = caster.cast(PowerCurve{2, 0.4}, settings), fourth = caster.cast(PowerCurve{2, 0.4}, settings);
    EXPECT_TRUE(third->rgba == fourth->rgba);
    EXPECT_TRUE(third->depthMm == fourth->depthMm);
}

TEST(RayCasterKept, SeveralSizesAndStepsInTurn) {
    const Volume volume = speckledShell<std::uint8_t>({31, 37, 35}, {1, 1, 1}, 10);
    RayCaster caster(held(volume));
    for (int round = 0; round < 4; ++round)
        for (int level = 0; level < 6; ++level) {
            RayCastSettings settings = settingsWithDepth(volume, 20 + 10 * level, 20 + 9 * level);
            settings.camera = settingsWithDepth(volume).camera;
            settings.step = 2.0 - 0.3 * level;
            if (level > 3 && round % 2 == 0) continue;
            expectSameAsAlone(caster, PowerCurve{2, 0.1 + 0.2 * round}, settings, "level " + std::to_string(level));
        }
}

TEST(RayCasterKept, ACancelledPictureLeavesTheSamplesSound) {
    const Volume volume = sectorOf(speckledShell<std::uint8_t>({41, 37, 45}, {1, 1.2, 0.8}, 11));
    const RayCastSettings settings = settingsWithDepth(volume, 150, 170);
    RayCaster caster(held(volume));
    (void)caster.cast(PowerCurve{1, 2.0}, settings);
    for (const double stopAt : {0.1, 0.4, 0.8}) {
        std::atomic<bool> cancel = false;
        Progress progress;
        progress.cancel = &cancel;
        progress.report = [&](double share) { cancel = cancel || share > stopAt; };
        tbb::task_arena(1).execute([&] {
            EXPECT_FALSE(caster.cast(PowerCurve{1, 2.0}, settings, progress).has_value());
        });
        EXPECT_GT(caster.keptSampleBytes(), 0u);
        for (const double scale : {0.05, 2.0}) {
            if (stopAt < 0.5) continue;  // cancelled again before it is whole
            expectSameAsAlone(caster, PowerCurve{1, scale}, settings, "after a cancel");
        }
    }
}

TEST(RayCasterKept, RaysOfOnePacketFarApartAreNotMixedUp) {
    const Volume volume = volumeOf<std::uint8_t>(
        {32768, 1, 1}, {1, 1, 1}, [](auto x, auto, auto) { return static_cast<double>(x * 37 / 100 % 100) / 100; });
    RayCastSettings settings = settingsFor(volume, Viewpoint{}, 4, 1);
    settings.camera.heightMm = 8000.0;
    settings.step = 0.05;
    RayCaster caster(held(volume));
    for (const auto& [name, curve] : edits) expectSameAsAlone(caster, curve, settings, name);
}

/// The largest part of the kept samples' bytes that a view's own samples make.
TEST(RayCasterKept, MemoryIsWhatTheSamplesTake) {
    const Volume volume = constantVolume<std::uint8_t>({64, 64, 150}, 0.5);
    for (const double opacity : {0.001, 0.9}) {
        RayCastSettings settings = settingsFor(volume, Viewpoint{}, 128, 128);
        settings.camera.heightMm = 60;
        settings.terminationTransmittance = 1.0 / 512;
        RayCaster caster(held(volume));
        for (int i = 0; i < 2; ++i) (void)caster.cast(everywhere(opacity), settings);
        for (int i = 0; i < 2; ++i) (void)caster.cast(everywhere(0.001), settings);
        const std::size_t samples = 128 * 128 * 150;
        EXPECT_GE(caster.keptSampleBytes(), samples * 2);
        EXPECT_LE(caster.keptSampleBytes(), samples * 2 * 11 / 10);
    }
}

/// Casts two pictures but for all but the first tiles, and says what is kept.
std::size_t bytesKeptOfTheFirstTiles(const Volume& volume, const RayCastSettings& settings) {
    RayCaster caster(held(volume));
    for (int i = 0; i < 2; ++i) {
        std::atomic<bool> cancel = false;
        Progress progress;
        progress.cancel = &cancel;
        progress.report = [&](double) { cancel = true; };
        tbb::task_arena(1).execute([&] { (void)caster.cast(everywhere(0.001), settings, progress); });
    }
    return caster.keptSampleBytes();
}

TEST(RayCasterKept, AViewAboveTheMemoryLimitKeepsNothing) {
    const Volume volume = constantVolume<std::uint8_t>({32, 32, 32}, 0.5);
    struct Wanted {
        int width, height;
        double step;
    };
    for (const Wanted& wanted : {Wanted{2048, 2048, 0.2}, {512, 512, 0.01}, {4096, 1, 0.001}, {1, 4096, 0.001}}) {
        RayCastSettings settings = settingsFor(volume, Viewpoint{}, wanted.width, wanted.height);
        settings.camera.heightMm = 32.0 / std::max(1, wanted.width / wanted.height);
        settings.step = wanted.step;
        const double bytes = 2.0 * 32 / wanted.step * wanted.width * wanted.height;
        // A packet of one row or column takes the room of its other rays too.
        const ray_casting::PacketShape packet = ray_casting::packetShape();
        const int room = wanted.height == 1 ? packet.rows : wanted.width == 1 ? packet.columns : 1;
        if (bytes * room <= static_cast<double>(RayCaster::sampleMemoryLimit)) {
            ASSERT_LT(room, 4);
            std::printf("SKIP of %dx%d: packets of this instruction set are too small\n", wanted.width, wanted.height);
            continue;
        }
        EXPECT_EQ(bytesKeptOfTheFirstTiles(volume, settings), 0u) << wanted.width << "x" << wanted.height;
        settings.step *= 8;
        EXPECT_GT(bytesKeptOfTheFirstTiles(volume, settings), 0u) << "below the limit it is kept";
    }
}

TEST(RayCasterKept, WhatAPlaneCutsOffDoesNotLowerTheEstimate) {
    const Volume volume = constantVolume<std::uint8_t>({32, 32, 32}, 0.5);
    RayCastSettings settings = settingsFor(volume, Viewpoint{}, 2048, 2048);
    settings.step = 0.1;  // half the picture: 1.3 GB
    const Vec3 up = settings.camera.frame.down * -1.0;
    // Along the rays, and so nearly along them that those below end far before the volume.
    for (const double slope : {0.0, 1e-6}) {
        settings.clippingPlanes = {{volume.geometry().centreMm(), up - settings.camera.frame.forward * slope}};
        EXPECT_EQ(bytesKeptOfTheFirstTiles(volume, settings), 0u) << slope;
    }
}

}  // namespace
}  // namespace echolucent
