// The near cut of real scans; skipped where these are not there.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "io/study/study.h"
#include "processing/near_cut/near_cut.h"
#include "shared_data.h"

namespace echolucent {
namespace {

std::string pathOf(const std::string& name) { return sharedData + "/volumes/" + name; }

#define SKIP_WITHOUT_VOLUMES() \
    if (!std::filesystem::is_directory(pathOf(""))) GTEST_SKIP() << "the shared volumes are not here"

Study studyOf(const std::string& name) { return *readStudy(pathOf(name), {}); }

NearCutFinding cutOf(const Volume& volume, BeamAxis axis, double azimuth = 0.0) {
    return *findNearCut(volume, {.beamAxis = axis, .azimuthDegrees = azimuth});
}

TEST(LongNearCutOfScans, OneChestAtTwoResolutionsIsCutAtOneDepth) {
    SKIP_WITHOUT_VOLUMES();
    const Study fine = studyOf("fetal_chest_600x614x66.nrrd"), coarse = studyOf("fetal_chest_iso0.3mm.mha");
    for (const BeamAxis axis :
         {BeamAxis::plusX, BeamAxis::minusX, BeamAxis::plusY, BeamAxis::minusY, BeamAxis::plusZ, BeamAxis::minusZ}) {
        const auto one = cutOf(*fine.phases[0], axis), other = cutOf(*coarse.phases[0], axis);
        EXPECT_EQ(one.answer, NearCutAnswer::wallBeforeFluid) << nameOf(axis);
        EXPECT_EQ(other.answer, NearCutAnswer::wallBeforeFluid) << nameOf(axis);
        EXPECT_NEAR(one.nearCutMm, other.nearCutMm, 2.0) << nameOf(axis);
    }
}

TEST(NearCutOfScans, TheChestIsCutThroughItsVentricles) {
    SKIP_WITHOUT_VOLUMES();
    const Study chest = studyOf("fetal_chest_iso0.3mm.mha");
    for (const double azimuth : {-8.0, 0.0, 8.0}) {
        // Slices show both ventricles from 14 mm to 27 mm along +y.
        const auto found = cutOf(*chest.phases[0], BeamAxis::plusY, azimuth);
        const Viewpoint view =
            withFrontAcross({.beamAxis = BeamAxis::plusY, .azimuthDegrees = azimuth}, found.nearCutMm);
        const auto& geometry = chest.phases[0]->geometry();
        const Vec3 ventricles(geometry.centreMm()[0], 22.0, geometry.centreMm()[2]);
        EXPECT_NEAR(nearPlaneDepthMm(view, geometry), frameOf(view).forward.dot(ventricles), 2.0) << azimuth;
        EXPECT_TRUE(found.sure);
        EXPECT_TRUE(found.surface);
    }
}

TEST(NearCutOfScans, TheCavitiesOfDenseHeartsAreFound) {
    SKIP_WITHOUT_VOLUMES();
    const Study still = studyOf("adult_heart_256.nrrd");
    const auto apical = cutOf(*still.phases[0], BeamAxis::plusZ);
    EXPECT_EQ(apical.answer, NearCutAnswer::wallBeforeFluid);
    EXPECT_TRUE(apical.sure);
    EXPECT_GT(apical.nearCutMm, 95.0) << "before that lies the near field's haze";
    EXPECT_LT(apical.nearCutMm, 150.0) << "the ventricle reaches to 215 mm (guessed spacing)";
    for (const auto& phase : studyOf("adult_heart_4d_56x52x56x3_float.nrrd").phases) {
        const auto found = cutOf(*phase, BeamAxis::plusZ);
        EXPECT_EQ(found.answer, NearCutAnswer::wallBeforeFluid);
        EXPECT_GT(found.nearCutMm, 72.0) << "there the valve hangs";
        EXPECT_LT(found.nearCutMm, 115.0);
    }
}

TEST(NearCutOfScans, ABeatingHeartIsCutAlikeInItsPhases) {
    SKIP_WITHOUT_VOLUMES();
    const Study heart = studyOf("fetal_heart_4d_128x128x128x20.nrrd");
    double least = 1e9, most = 0.0;
    for (std::size_t phase = 0; phase < heart.phases.size(); phase += 5) {
        const auto found = cutOf(*heart.phases[phase], BeamAxis::plusZ);
        EXPECT_EQ(found.answer, NearCutAnswer::wallBeforeFluid);
        least = std::min(least, found.nearCutMm);
        most = std::max(most, found.nearCutMm);
    }
    EXPECT_GT(least, 80.0) << "there the ventricles begin";
    EXPECT_LT(most - least, 0.06 * 256) << "of the volume's depth";
}

}  // namespace
}  // namespace echolucent
