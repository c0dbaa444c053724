// The six sides as values, the scan planes and the grain.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "processing/beam/probe_view.h"
#include "processing/sides/grain.h"
#include "processing/sides/scan_planes.h"
#include "processing/sides/side.h"
#include "tests/processing/grids.h"

namespace echolucent {
namespace {

constexpr BeamAxis beamAxes[] = {BeamAxis::plusX,  BeamAxis::minusX, BeamAxis::plusY,
                                 BeamAxis::minusY, BeamAxis::plusZ,  BeamAxis::minusZ};

double apart(const Vec3& one, const Vec3& other) { return length(one - other); }

ScanPlanes surePlanes(const Vec3& lateral) { return {lateral, ScanPlaneEvidence::spacing, 1.0, true, ""}; }

TEST(Sides, LookAlongTheBeamAcrossItAndOntoThePlanes) {
    for (const BeamAxis axis : beamAxes)
        for (const auto& [azimuth, elevation] : {std::pair{0.0, 0.0}, {17.0, -9.0}}) {
            const Viewpoint probe{.beamAxis = axis, .azimuthDegrees = azimuth, .elevationDegrees = elevation};
            const ViewFrame from = frameOf(probe);
            for (const Vec3& lateral : {from.right, from.right * -1.0, from.down}) {
                const Sides sides = sidesOf(probe, true, surePlanes(lateral));
                std::array<ViewFrame, 6> frames;
                for (std::size_t i = 0; i < sides.size(); ++i) {
                    frames[i] = frameOf(sides[i].view);
                    EXPECT_EQ(sides[i].number, static_cast<int>(i) + 1);
                    EXPECT_EQ(sides[i].view.beamAxis, axis);
                    EXPECT_FALSE(sides[i].view.frontPlane);
                    if (i < 2) continue;
                    EXPECT_LT(apart(frames[i].down, from.forward), 1e-12) << "the beam runs down";
                }
                EXPECT_EQ(sides[probeSide].view, probe) << "to the bit";
                EXPECT_LT(apart(frames[1].forward, from.forward * -1.0), 1e-12);
                EXPECT_LT(apart(frames[1].down, from.down), 1e-12) << "turned about the picture's vertical";
                EXPECT_LT(apart(frames[2].right, lateral), 1e-12) << "the plane as it was scanned";
                EXPECT_LT(apart(frames[3].right, lateral * -1.0), 1e-12);
                EXPECT_LT(apart(frames[4].forward, lateral), 1e-12) << "from the left of the plane";
                EXPECT_LT(apart(frames[5].forward, lateral * -1.0), 1e-12);
            }
        }
}

TEST(Sides, LeaveOutTheCutsOfTheViewFromTheProbe) {
    const Viewpoint cut{.frontPlane = FrontPlane{{0, 0, 1}, 5.0}, .cutSurface = CutSurface{}, .box = OrientedBox{}};
    for (const Side& side : sidesOf(cut, true, surePlanes({1, 0, 0}))) {
        EXPECT_FALSE(side.view.frontPlane);
        EXPECT_FALSE(side.view.cutSurface || side.view.box);
    }
}

TEST(Sides, AreNamedByWhatIsKnown) {
    const ScanPlanes unknown;
    const auto namesOf = [](const Sides& sides) {
        std::string names;
        for (const Side& side : sides) names += std::string(side.name) + '|' + std::string(side.word) + '\n';
        return names;
    };
    EXPECT_EQ(namesOf(sidesOf({}, true, surePlanes({1, 0, 0}))),
              "From the probe|probe\nFrom behind|behind\nOnto the scan plane|onto\n"
              "Onto the back of the scan plane|onto-back\nAlong the scan plane, from the left|along-left\n"
              "Along the scan plane, from the right|along-right\n");
    EXPECT_EQ(namesOf(sidesOf({}, true, unknown)),
              "From the probe|probe\nFrom behind|behind\nFrom the lower edge of side 1|across-1\n"
              "From the upper edge of side 1|across-2\nFrom the left edge of side 1|across-3\n"
              "From the right edge of side 1|across-4\n");
    for (const ScanPlanes& planes : {unknown, surePlanes({1, 0, 0})})
        EXPECT_EQ(namesOf(sidesOf({}, false, planes)),
                  "Side 1|side-1\nSide 2|side-2\nSide 3|side-3\nSide 4|side-4\nSide 5|side-5\nSide 6|side-6\n")
            << "who does not know the beam names no probe";
}

TEST(Sides, AcrossTheBeamLookFromTheEdgeOfSideOneThatTheyAreCalledAfter) {
    for (const BeamAxis axis : beamAxes)
        for (const double roll : {0.0, 25.0}) {
            const Viewpoint probe{.beamAxis = axis, .azimuthDegrees = 17, .elevationDegrees = -9, .rollDegrees = roll};
            const ViewFrame one = frameOf(probe);
            const ScanPlanes unsure{.lateral = one.right};
            const Sides sides = sidesOf(probe, true, unsure);
            const std::array<std::pair<std::string_view, Vec3>, 4> towards{
                {{"lower", one.down * -1.0}, {"upper", one.down}, {"left", one.right}, {"right", one.right * -1.0}}};
            for (std::size_t i = 0; i < towards.size(); ++i) {
                const Side& side = sides[i + 2];
                EXPECT_EQ(side.name, "From the " + std::string(towards[i].first) + " edge of side 1");
                EXPECT_LT(apart(frameOf(side.view).forward, towards[i].second), 1e-12) << side.name;
                EXPECT_LT(apart(frameOf(side.view).down, one.forward), 1e-12)
                    << "the probe is at the top: " << side.name;
            }
        }
}

TEST(Sides, AreFoundByWordAndNumber) {
    for (const Sides& sides : {sidesOf({}, true, surePlanes({1, 0, 0})), sidesOf({}, true, {}), sidesOf({}, false, {})})
        for (std::size_t i = 0; i < sides.size(); ++i) {
            EXPECT_EQ(sideNamed(sides, sides[i].word), i);
            EXPECT_EQ(sideNamed(sides, std::to_string(i + 1)), i);
        }
    const Sides across = sidesOf({}, true, {});
    for (const char* wrong : {"", "0", "7", "-1", "1x", " 1", "1.0", "Probe", "onto", "side-1", "99999999999"})
        EXPECT_FALSE(sideNamed(across, wrong)) << wrong;
}

TEST(ScanPlanes, LieAcrossTheCoarserSpacing) {
    for (const BeamAxis axis : beamAxes)
        for (int coarse = 0; coarse < 3; ++coarse) {
            const Viewpoint probe{.beamAxis = axis};
            const Vec3 beam = frameOf(probe).forward;
            if (std::abs(beam[coarse]) > 0.5) continue;
            VolumeGeometry geometry = gridOf({9, 9, 9}, {0.2, 0.2, 0.2});
            geometry.spacing[coarse] = 0.5;
            const ScanPlanes planes = scanPlanesOf(geometry, probe, {1, 1, 1});
            EXPECT_TRUE(planes.sure);
            EXPECT_EQ(planes.evidence, ScanPlaneEvidence::spacing);
            Vec3 elevation(0, 0, 0);
            elevation[coarse] = 1;
            EXPECT_EQ(planes.lateral.dot(elevation), 0.0);
            EXPECT_EQ(planes.lateral.dot(beam), 0.0);
            EXPECT_EQ(planes.lateral.dot(Vec3(1, 1, 1)), 1.0) << "the positive grid axis";
            const Sides sides = sidesOf(probe, true, planes);
            EXPECT_EQ(std::abs(frameOf(sides[2].view).forward[coarse]), 1.0) << "onto them is along the elevation";
            geometry.spacingKnown = false;
            EXPECT_FALSE(scanPlanesOf(geometry, probe, {1, 1, 1}).sure) << "a guessed spacing says nothing";
        }
}

TEST(ScanPlanes, LieAcrossTheCoarserGrainElse) {
    const VolumeGeometry even = gridOf({9, 9, 9});
    const ScanPlanes planes = scanPlanesOf(even, {}, {2, 3, 9});
    EXPECT_TRUE(planes.sure);
    EXPECT_EQ(planes.evidence, ScanPlaneEvidence::grain);
    EXPECT_EQ(planes.lateral, Vec3(1, 0, 0)) << "the grain along the beam plays no part";
    EXPECT_NE(planes.sentence.find("across y"), std::string::npos) << planes.sentence;
    const ScanPlanes alike = scanPlanesOf(even, {}, {2, 2.2, 9});
    EXPECT_FALSE(alike.sure);
    EXPECT_EQ(alike.evidence, ScanPlaneEvidence::none);
    EXPECT_EQ(alike.lateral, frameOf(Viewpoint{}).right);
    EXPECT_FALSE(scanPlanesOf(even, {.azimuthDegrees = 20}, {2, 3, 9}).sure) << "a view between the grid's axes";
    EXPECT_LT(scanPlanesOf(even, {}, {2, 2.7, 2}).confidence, planes.confidence);
}

TEST(ScanPlanes, OfTheFileWin) {
    VolumeGeometry geometry = gridOf({9, 9, 9}, {0.2, 0.5, 0.2});
    const Vec3 forward = normalized(Vec3(0.2, -0.1, 1)), right = normalized(Vec3(0, 1, 0.1));
    const Vec3 across = normalized(right - forward * right.dot(forward));
    geometry.probe = StatedProbe{.forward = forward, .down = forward.cross(across), .planesKnown = true};
    const Viewpoint probe = viewFromProbe(*geometry.probe);
    const ScanPlanes planes = scanPlanesOf(geometry, probe, {1, 9, 1});
    EXPECT_EQ(planes.evidence, ScanPlaneEvidence::file);
    EXPECT_TRUE(planes.sure);
    EXPECT_LT(apart(planes.lateral, across), 1e-9);
    Viewpoint rolled = probe;
    rolled.rollDegrees += 30;
    EXPECT_LT(apart(scanPlanesOf(geometry, rolled, {1, 9, 1}).lateral, across), 1e-9) << "whatever is down";
    EXPECT_NE(scanPlanesOf(geometry, {.beamAxis = BeamAxis::plusX}, {1, 9, 1}).evidence, ScanPlaneEvidence::file)
        << "a beam that a person chose";
    geometry.probe->planesKnown = false;
    EXPECT_NE(scanPlanesOf(geometry, probe, {1, 9, 1}).evidence, ScanPlaneEvidence::file);
}

/// White noise, averaged over so many voxels along one axis.
Volume noise(int averaged, int along) {
    constexpr std::int64_t edge = 112;
    const VolumeGeometry geometry = gridOf({edge, edge, edge}, {0.5, 0.4, 0.45});
    std::mt19937 random(3);
    std::vector<double> white(static_cast<std::size_t>(geometry.voxelCount()));
    for (double& value : white) value = random() / 4294967296.0;
    std::vector<float> voxels(white.size());
    const std::int64_t step = along == 0 ? 1 : along == 1 ? edge : edge * edge;
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        double sum = 0.0;
        for (int move = 0; move < averaged; ++move)
            sum += white[(i + static_cast<std::size_t>(move * step)) % white.size()];
        voxels[i] = static_cast<float>(sum / averaged);
    }
    return {geometry, std::move(voxels), 1.0};
}

TEST(Grain, OfWhiteNoiseIsTwoVoxels) { EXPECT_EQ(*grainMm(noise(1, 0)), Vec3(1.0, 0.8, 0.9)); }

TEST(Grain, IsCoarserWhereTheEchoIsAveraged) {
    for (int axis = 0; axis < 3; ++axis) {
        const Volume volume = noise(4, axis);
        const Vec3 grain = *grainMm(volume);
        for (int other = 0; other < 3; ++other) {
            const double voxels = grain[other] / volume.geometry().spacing[other];
            if (other == axis) {
                EXPECT_GT(voxels, 2.2);
            } else {
                EXPECT_EQ(voxels, 2.0);
            }
        }
    }
}

TEST(Grain, AlongADirectionIsThatOfAnEllipsoid) {
    const Vec3 grain(1, 2, 4);
    EXPECT_DOUBLE_EQ(grainAlong({0, 0, -1}, grain), 4.0);
    EXPECT_DOUBLE_EQ(grainAlong({0.6, 0.8, 0}, grain), 1.0 / std::hypot(0.6, 0.4));
}

}  // namespace
}  // namespace echolucent
