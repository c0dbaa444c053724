// The same picture on every instruction set, run after run, and for any number of threads.
#include "processing/ray_caster/packet_targets.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include <cstdio>
#include <map>

#include "processing/ray_caster/kernel_job.h"
#include "ray_caster_scenes.h"
#include "tests/inputs.h"

namespace echolucent {
namespace {

/// Those that the kernel was compiled for and this processor has, the widest first. Highway's own function for this is
/// inline: the linker may take that of a file which was compiled for other targets.
std::vector<std::int64_t> targetsOfTheKernel() {
    std::vector<std::int64_t> targets;
    for (std::int64_t left = hwy::SupportedTargets() & HWY_TARGETS; left != 0; left &= left - 1)
        targets.push_back(left & ~(left - 1));
    return targets;
}

struct Case {
    std::string name;
    RayCastSettings settings;
    OpacityCurve curve;
    bool masked = false, kept = false;
};

/// One of each kind of picture.
std::vector<Case> casesFor(const Volume& volume, int width, int height) {
    const RayCastSettings plain = settingsFor(volume, Viewpoint{BeamAxis::plusZ, 24, -17, 4}, width, height);
    const OpacityCurve power = PowerCurve{2, 0.5}, narrow = onlyBetween(0.45, 0.95, 0.4);
    std::vector<Case> cases;
    const auto add = [&](const std::string& name, const auto& change, const OpacityCurve& curve) -> Case& {
        cases.push_back({name, plain, curve});
        cases.back().settings.terminationTransmittance = RayCastSettings{}.terminationTransmittance;
        change(cases.back().settings);
        return cases.back();
    };
    using Settings = RayCastSettings;
    const auto nothing = [](Settings&) {};
    const auto shade = [](Settings& s) { s.shading = Shading{}; };
    add("unshaded", nothing, power);
    add("unshaded, empty space", nothing, narrow);
    add("shaded", shade, power);
    add("shaded, empty space", shade, narrow);
    add("masked", nothing, power).masked = true;
    add("masked, shaded", shade, power).masked = true;
    add(
        "maximum", [](Settings& s) { s.mode = RenderMode::maximum; }, power);
    add(
        "minimum", [](Settings& s) { s.mode = RenderMode::minimum; }, power);
    add(
        "mean, masked", [](Settings& s) { s.mode = RenderMode::mean; }, power)
        .masked = true;
    add(
        "nearest", [](Settings& s) { s.interpolation = Interpolation::nearest; }, power);
    add(
        "perspective", [](Settings& s) { s.camera.projection = Projection::perspective; }, power);
    add(
        "tinted by depth", [](Settings& s) { s.depthColouring = DepthColouring{}; }, power);
    add("kept", nothing, power).kept = true;
    add("kept, masked, shaded", shade, narrow).masked = true;
    cases.back().kept = true;
    add(
        "along an axis, where no step is cut",
        [&](Settings& s) {
            const Settings straight = settingsFor(volume, Viewpoint{}, width, height);
            s.camera = straight.camera;
        },
        power);
    add(
        "thick steps", [](Settings& s) { s.step = 2.7; }, power);
    return cases;
}

Picture pictureOf(const Case& c, const Volume& volume) {
    const auto held = std::make_shared<const Volume>(c.masked ? sectorOf(volume) : volume);
    if (!c.kept) return *castRays(*held, c.curve, c.settings);
    RayCaster caster(held);
    // The samples are kept by the second picture and used by the third; they are of a curve under which rays end
    // elsewhere.
    (void)caster.cast(PowerCurve{1, 0.9}, c.settings);
    (void)caster.cast(PowerCurve{1, 0.9}, c.settings);
    EXPECT_GT(caster.keptSampleBytes(), 0u);
    return *caster.cast(c.curve, c.settings);
}

template <typename Voxel>
void expectOnePictureOnEveryTarget() {
    const Volume volume = speckledShell<Voxel>({48, 44, 52}, {1, 1.1, 0.9}, 31);
    const std::vector<std::int64_t> targets = targetsOfTheKernel();
    if (targets.size() < 2) GTEST_SKIP() << "compiled for one instruction set only";
    const std::vector<Case> cases = takesSomeInputs ? casesFor(volume, 41, 37) : casesFor(volume, 110, 97);
    std::map<std::string, Picture> expected;
    std::vector<int> lanes;
    // The loop goes from the scalar route, the last, to the widest.
    for (auto target = targets.rbegin(); target != targets.rend(); ++target) {
        hwy::SetSupportedTargetsForTest(*target);
        const ray_casting::PacketShape shape = ray_casting::packetShape();
        lanes.push_back(shape.columns * shape.rows);
        double worst = 0.0, largest = 0.0;
        for (const Case& c : cases) {
            const Picture picture = pictureOf(c, volume);
            const auto [known, isFirst] = expected.try_emplace(c.name, picture);
            if (isFirst) continue;
            const Apart difference = apart(picture, known->second);
            EXPECT_LT(difference.rootMeanSquare, 0.01)
                << c.name << " on " << hwy::TargetName(*target) << ", largest " << difference.largest;
            worst = std::max(worst, difference.rootMeanSquare);
            largest = std::max(largest, difference.largest);
        }
        std::printf("%s %s: %d rays a packet, at most %.6f levels RMSE, %.4f in any pixel from the scalar route\n",
                    std::string(volume.typeName()).c_str(), hwy::TargetName(*target), lanes.back(), worst, largest);
    }
    hwy::SetSupportedTargetsForTest(0);
    EXPECT_LT(lanes.front(), lanes.back()) << "the targets are told apart";
}
TEST(RayCasterTargets, BytesLookTheSameOnEveryInstructionSet) { expectOnePictureOnEveryTarget<std::uint8_t>(); }
TEST(RayCasterTargets, WordsLookTheSameOnEveryInstructionSet) { expectOnePictureOnEveryTarget<std::uint16_t>(); }
TEST(RayCasterTargets, FloatsLookTheSameOnEveryInstructionSet) { expectOnePictureOnEveryTarget<float>(); }

TEST(RayCasterTargets, TheScalarRouteAgreesWithTheSlowReference) {
    hwy::SetSupportedTargetsForTest(targetsOfTheKernel().back());
    for (const bool shaded : {false, true}) {
        const Volume volume = sectorOf(speckledShell<std::uint16_t>({24, 22, 26}, {1, 1.1, 0.9}, 32));
        RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::plusZ, 24, -17, 4}, 41, 37);
        if (shaded) settings.shading = Shading{};
        EXPECT_LT(largestDifference(volume, PowerCurve{2, 0.5}, settings), shaded ? 3e-3 : 2e-4);
    }
    hwy::SetSupportedTargetsForTest(0);
}

TEST(RayCasterTargets, SamePixelsRunAfterRunAndForAnyNumberOfThreads) {
    const Volume volume = speckledShell<std::uint8_t>({48, 44, 52}, {1, 1.1, 0.9}, 33);
    std::vector<Case> cases = casesFor(volume, 203, 141);
    // There are more threads than this machine may have cores.
    const tbb::global_control threadsAllowed(tbb::global_control::max_allowed_parallelism, 8);
    for (Case& c : cases) {
        c.settings.findDepth = true;
        Picture alone;
        tbb::task_arena(1).execute([&] { alone = pictureOf(c, volume); });
        for (const int threads : {1, 2, 3, 7})
            tbb::task_arena(threads).execute([&] {
                const Picture picture = pictureOf(c, volume);
                EXPECT_TRUE(picture.rgba == alone.rgba) << c.name << ", " << threads << " threads";
                EXPECT_TRUE(picture.depthMm == alone.depthMm) << c.name << ", " << threads << " threads";
            });
    }
}

TEST(RayCasterTargets, WhatARayShowsDoesNotDependOnThePicturesSize) {
    // The same rays lie in other packets: one column and one row on.
    const Volume volume = speckledShell<std::uint8_t>({48, 44, 52}, {1, 1.1, 0.9}, 34);
    for (const OpacityCurve& curve : {OpacityCurve{PowerCurve{2, 0.5}}, onlyBetween(0.45, 0.95, 0.4)}) {
        RayCastSettings settings = settingsFor(volume, Viewpoint{BeamAxis::plusZ, 24, -17, 4}, 81, 81);
        const auto picture = castRays(volume, curve, settings);
        const double pixel = settings.camera.heightMm / 81;
        settings.width = settings.height = 83;
        settings.camera.heightMm = 83 * pixel;
        const auto wider = castRays(volume, curve, settings);
        double largest = 0.0;
        for (int row = 0; row < 81; ++row)
            for (int column = 0; column < 81; ++column)
                for (int channel = 0; channel < 4; ++channel)
                    largest =
                        std::max(largest, std::abs(static_cast<double>(pixelAt(*picture, column, row)[channel]) -
                                                   static_cast<double>(pixelAt(*wider, column + 1, row + 1)[channel])));
        EXPECT_LT(largest * 255, 0.3);
    }
}

}  // namespace
}  // namespace echolucent
