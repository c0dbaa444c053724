// The suggested near cut on phantoms with a wall of tissue in front, whose fluid and surfaces are known.
#include "processing/near_cut/near_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <string>
#include <vector>

#include "app/measuring/measures/detection_quality.h"
#include "processing/phantom/phantom.h"
#include "processing/tube_core/slabs/tube_grid.h"
#include "tests/processing/tube_core/plane_volume.h"
#include "tests/processing/wobbler.h"

namespace echolucent {
namespace {

PhantomConfig phantomOf(PhantomScene scene, std::uint64_t seed, bool frontWall) {
    PhantomConfig config = defaultPhantom(scene);
    config.size = {128, 128, 128};
    config.seed = seed;
    config.frontWall = frontWall;
    return config;
}

/// Counts, of the tube cores that see an interface, those that are in the fluid before it at the cut.
struct CutTruth {
    int tubes = 0, inFluid = 0, behindTheCut = 0;
};

/// The tube cores of a view that see an interface when nothing is cut off.
class TubesWithInterface {
public:
    TubesWithInterface(const PhantomConfig& config, const VolumeGeometry& geometry, const Viewpoint& view)
        : m_truth(config), m_forward(frameOf(view).forward), m_front(nearPlaneDepthMm(view, geometry)) {
        for (const TubeAxis& axis : tubeAxes(geometry, view, {}, CellRule{}.size)) {
            if (!axis.entryVoxel) continue;
            if (const auto surface = interfaceDepthMm(m_truth, geometry, view, axis, {0, 0, 0}))
                m_tubes.push_back({geometry.gridMmFromVoxel(*axis.entryVoxel), *surface});
        }
    }
    [[nodiscard]] CutTruth at(double nearCutMm) const {
        return behind([&](const Tube&) { return m_front + nearCutMm; });
    }
    [[nodiscard]] CutTruth at(const CutSurface& surface) const {
        return behind([&](const Tube& tube) { return surface.depthAt(tube.entryMm); });
    }

private:
    struct Tube {
        Vec3 entryMm;
        double surfaceMm;
    };
    template <typename DepthOf>
    [[nodiscard]] CutTruth behind(const DepthOf& depthOf) const {
        CutTruth counted{.tubes = static_cast<int>(m_tubes.size())};
        for (const Tube& tube : m_tubes) {
            const double cut = depthOf(tube);
            if (tube.surfaceMm <= cut) continue;
            ++counted.behindTheCut;
            // A tube that enters the volume's box behind the cut begins there.
            const Vec3 first = tube.entryMm + m_forward * std::max(0.0, cut - m_forward.dot(tube.entryMm));
            if (m_truth.materialAt(first) == PhantomMaterial::fluid) ++counted.inFluid;
        }
        return counted;
    }

    PhantomTruth m_truth;
    Vec3 m_forward;
    double m_front;
    std::vector<Tube> m_tubes;
};

TEST(NearCut, LiesBehindTheWallAndBeforeTheSurfaces) {
    for (const PhantomScene scene : {PhantomScene::shapes, PhantomScene::fetus}) {
        const PhantomConfig config = phantomOf(scene, 23, true);
        const Volume volume = *makePhantom(config);
        for (const Viewpoint& view : {Viewpoint{}, Viewpoint{.azimuthDegrees = 12, .elevationDegrees = -8}}) {
            const NearCutFinding cut = *findNearCut(volume, view);
            const TubesWithInterface tubes(config, volume.geometry(), view);
            const CutTruth truth = tubes.at(cut.nearCutMm);
            ASSERT_TRUE(cut.surface);
            const CutTruth curved = tubes.at(*cut.surface);
            std::printf(
                "%s, azimuth %.0f: cut at %.2f mm; of %d tubes with an interface %d have it behind, %d are in fluid "
                "(says: %d of %d); behind the curved cut %d have it behind, %d are in fluid\n",
                std::string(nameOf(scene)).c_str(), view.azimuthDegrees, cut.nearCutMm, truth.tubes, truth.behindTheCut,
                truth.inFluid, cut.tubesThatSaySo, cut.tubes, curved.behindTheCut, curved.inFluid);
            EXPECT_EQ(cut.answer, NearCutAnswer::wallBeforeFluid) << cut.message;
            EXPECT_GT(cut.nearCutMm, 0.0);
            ASSERT_GT(truth.tubes, 50);
            EXPECT_GE(truth.behindTheCut, 0.95 * truth.tubes);
            // Obliquely, a cut across the view cannot lie behind all of a wall and in front of all surfaces.
            int best = 0;
            for (double depth = 0.0; depth < depthAlongViewMm(view, volume.geometry()); depth += 2.0)
                best = std::max(best, tubes.at(depth).inFluid);
            if (view == Viewpoint{}) {
                EXPECT_GE(truth.inFluid, 0.95 * truth.tubes);
            } else {
                EXPECT_GE(truth.inFluid, 0.8 * best) << "of a plane it is asked to leave fluid behind, too";
            }
            EXPECT_GE(curved.inFluid, 0.85 * truth.tubes) << "a surface can";
            // Uncut, hardly any of them begins in fluid: the suggested cut is what brought it.
            EXPECT_LE(tubes.at(0.0).inFluid, 0.3 * truth.tubes);
        }
    }
}

TEST(NearCut, DoesNotDependOnTheViewsOwn) {
    const Volume volume = *makePhantom(phantomOf(PhantomScene::shapes, 24, true));
    const NearCutFinding uncut = *findNearCut(volume, {});
    EXPECT_EQ(findNearCut(volume, withFrontAcross({}, 20))->nearCutMm, uncut.nearCutMm);
}

TEST(NearCut, IsNoneWhereNothingStandsInFront) {
    const Volume volume = *makePhantom(phantomOf(PhantomScene::shapes, 25, false));
    for (const Viewpoint& view : {Viewpoint{}, Viewpoint{.azimuthDegrees = 12, .elevationDegrees = -8}}) {
        const NearCutFinding cut = *findNearCut(volume, view);
        EXPECT_EQ(cut.nearCutMm, 0.0);
        EXPECT_EQ(cut.answer, NearCutAnswer::fluidAtFront) << cut.message;
        EXPECT_GT(cut.tubes, 50);
    }
}

TEST(NearCut, IsNoneWithoutASurface) {
    const Volume volume = *makePhantom(phantomOf(PhantomScene::empty, 26, false));
    const NearCutFinding cut = *findNearCut(volume, {});
    EXPECT_EQ(cut.nearCutMm, 0.0);
    EXPECT_EQ(cut.answer, NearCutAnswer::noFluid);
    EXPECT_NE(cut.message.find("No fluid was found"), std::string::npos) << cut.message;
}

TEST(NearCut, OfAViewWithoutDataIsNotSure) {
    const Volume some = PlaneVolume().make();
    const auto voxels = static_cast<std::size_t>(some.geometry().voxelCount());
    const auto found = findNearCut(some.withDataMask(std::vector<std::uint8_t>(voxels, 0)), {});
    EXPECT_EQ(found->answer, NearCutAnswer::noFluid);
    EXPECT_FALSE(found->sure);
    EXPECT_EQ(found->message, "No tube core meets data here, so no front can be found.");
}

TEST(NearCut, OfACancelledRunIsNone) {
    const Volume volume = *makePhantom(phantomOf(PhantomScene::empty, 26, false));
    std::atomic<bool> cancel = true;
    Progress progress;
    progress.cancel = &cancel;
    EXPECT_FALSE(findNearCut(volume, {}, progress));
}

/// The sector of a wobbler is wide: many tube cores meet tissue beside the fluid, and fluid lies behind the fetus too.
TEST(NearCut, IsNotSoughtBehindWhatTheFluidOfAWideSectorSurrounds) {
    PhantomConfig config = defaultPhantom(PhantomScene::fetus);
    config.size = {100, 100, 100};
    const Volume volume = scanOfWobbler(config);
    const auto found = findNearCut(volume, {});
    EXPECT_EQ(found->answer, NearCutAnswer::fluidAtFront) << found->message;
}

}  // namespace
}  // namespace echolucent
