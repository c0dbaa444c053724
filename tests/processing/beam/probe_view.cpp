// The view from the probe, where a file says where the probe was.
#include "processing/beam/probe_view.h"

#include <gtest/gtest.h>

#include "processing/beam/beam_guess.h"
#include "processing/document/opening_finds.h"

namespace echolucent {
namespace {

TEST(ProbeView, LooksAlongTheSoundWithTheProbesDownBelow) {
    for (const double azimuth : {-30.0, 0.0, 20.0})
        for (const double elevation : {-25.0, 0.0, 40.0})
            for (const double roll : {-120.0, 0.0, 90.0})
                for (const BeamAxis axis : {BeamAxis::plusX, BeamAxis::minusY, BeamAxis::plusZ}) {
                    const ViewFrame stated = frameOf({axis, azimuth, elevation, roll});
                    const ViewFrame seen = frameOf(viewFromProbe({stated.forward, stated.down, std::nullopt}));
                    EXPECT_LT(length(seen.forward - stated.forward), 1e-7);
                    EXPECT_LT(length(seen.down - stated.down), 1e-7);
                }
}

TEST(ProbeView, IsRelativeToTheNearestAxisAndHasNoRoundingInItsAngles) {
    EXPECT_EQ(viewFromProbe({{0, 0, 1}, frameOf(Viewpoint{}).down, std::nullopt}), Viewpoint{});
    EXPECT_EQ(viewFromProbe({normalized({0.1, -0.9, 0.3}), {1, 0, 0}, std::nullopt}).beamAxis, BeamAxis::minusY);
    EXPECT_EQ(viewFromProbe({normalized({0.9, -0.2, 0.3}), {0, 1, 0}, std::nullopt}).beamAxis, BeamAxis::plusX);
}

/// Bytes that say nothing of a beam.
Volume evenVolume(const std::optional<StatedProbe>& probe) {
    VolumeGeometry geometry;
    geometry.size = {20, 21, 22};
    geometry.probe = probe;
    return {geometry, Voxels(std::vector<std::uint8_t>(20 * 21 * 22, 90))};
}

TEST(ProbeView, WhatTheFileSaysIsTakenWithoutAGuess) {
    const ViewFrame stated = frameOf({BeamAxis::minusX, 15, -10, 30});
    const auto found = findOnOpening(evenVolume(StatedProbe{stated.forward, stated.down, std::nullopt}));
    ASSERT_TRUE(found);
    const Document document = withFinds({}, *found);
    EXPECT_EQ(document.beam.axis, BeamAxis::minusX);
    EXPECT_EQ(document.beam.source, BeamSource::file);
    EXPECT_NEAR(document.beam.lean.azimuth, 15, 1e-9);
    EXPECT_NEAR(document.beam.lean.elevation, -10, 1e-9);
    EXPECT_NEAR(document.beam.lean.roll, 30, 1e-9);
    EXPECT_EQ(document.scene.side, document.beam.lean) << "the tube cores look along the sound";
    EXPECT_LT(length(frameOf(viewAlongBeam(document.beam)).forward - stated.forward), 1e-7);
    EXPECT_FALSE(guessBeamAxis(evenVolume(std::nullopt))->sure) << "the volume itself says nothing";
}

}  // namespace
}  // namespace echolucent
