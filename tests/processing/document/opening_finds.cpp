// What opening makes of its finds: sure ones are taken, all others leave the document as it is.
#include "processing/document/opening_finds.h"

#include <gtest/gtest.h>

namespace echolucent {
namespace {

OpeningFinds finds() {
    OpeningFinds all;
    all.beam = {.axis = BeamAxis::minusY, .evidence = BeamEvidence::sectorShape, .confidence = 0.8, .sure = true};
    all.cut = NearCutFinding{.answer = NearCutAnswer::wallBeforeFluid, .nearCutMm = 10.6499, .sure = true};
    return all;
}

TEST(OpeningFinds, SureOnesAreTaken) {
    const Document taken = withFinds({}, finds());
    EXPECT_EQ(taken.beam, (Beam{BeamAxis::minusY, BeamSource::sectorShape}));
    EXPECT_EQ(taken.scene.front, (Front{.depthMm = 10.6, .source = FrontSource::found}));
    Document rest = taken;
    rest.beam = {};
    rest.scene.front = {};
    EXPECT_EQ(rest, Document{}) << "nothing else changes";
}

TEST(OpeningFinds, WhatIsNotSureStaysAsItIs) {
    OpeningFinds unsure = finds();
    unsure.beam.sure = false;
    EXPECT_EQ(withFinds({}, unsure), Document{}) << "without a sure beam nobody knows along what to cut";
    unsure = finds();
    unsure.cut->sure = false;
    EXPECT_EQ(withFinds({}, unsure).scene.front, Front{});
    EXPECT_EQ(withFinds({}, unsure).beam.axis, BeamAxis::minusY);
    unsure = finds();
    unsure.cut->answer = NearCutAnswer::fluidAtFront;
    EXPECT_EQ(withFinds({}, unsure).scene.front, Front{});
}

TEST(OpeningFinds, AVolumeOfOneValueHasNone) {
    VolumeGeometry geometry;
    geometry.size = {20, 21, 22};
    const Volume even(geometry, Voxels(std::vector<std::uint8_t>(20 * 21 * 22, 90)));
    const auto found = findOnOpening(even);
    ASSERT_TRUE(found);
    EXPECT_FALSE(found->cut) << "without a sure beam nothing is looked for";
    EXPECT_EQ(withFinds({}, *found), Document{});
}

}  // namespace
}  // namespace echolucent
