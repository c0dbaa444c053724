// The list of designers: each has its own name and config, and says whether it reads tube cores.
#include "processing/designers/choice/designer_config.h"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace echolucent {
namespace {

TEST(DesignerConfig, EachDesignerHasItsNameItsLabelAndItsConfig) {
    std::set<std::string_view> names, labels;
    for (const Designer designer : allDesigners) {
        EXPECT_TRUE(names.insert(nameOf(designer)).second) << nameOf(designer);
        EXPECT_TRUE(labels.insert(labelOf(designer)).second) << labelOf(designer);
        EXPECT_EQ(designerFromName(nameOf(designer)), designer);
        EXPECT_EQ(designerOf(defaultConfigOf(designer)), designer);
    }
    EXPECT_EQ(allDesigners.front(), designerOf(AdaptiveConfig{}));
    EXPECT_EQ(nameOf(designerOf(ContourSpectrumConfig{})), "contour-spectrum");
    EXPECT_EQ(labelOf(designerOf(KindlmannConfig{})), "Kindlmann and Durkin");
    EXPECT_FALSE(designerFromName("sakas"));
}

TEST(DesignerConfig, TubeCoresAreReadByTheMethodAndByLevoyIfHisLevelsAreTheirs) {
    std::set<std::string_view> readers;
    for (const Designer designer : allDesigners)
        if (readsTubeCores(defaultConfigOf(designer))) readers.insert(nameOf(designer));
    EXPECT_EQ(readers, (std::set<std::string_view>{"adaptive", "levoy"}));
    EXPECT_FALSE(readsTubeCores(LevoyConfig{.levels = LevoyLevels::otsu}));
    EXPECT_FALSE(readsTubeCores(LevoyConfig{.levels = LevoyLevels::given}));
}

}  // namespace
}  // namespace echolucent
