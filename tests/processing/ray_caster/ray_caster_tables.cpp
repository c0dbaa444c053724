// What the kernel looks up instead of computing it: opacities of bytes, and colours as sums.
#include <gtest/gtest.h>

#include "processing/ray_caster/packed/transfer_table.h"
#include "ray_caster_scenes.h"

namespace echolucent {
namespace {

using ray_casting::ByteOpacities;
using ray_casting::ColourBends;
using ray_casting::TransferTable;

TEST(RayCasterTables, ColoursAsSumsAreThoseOfTheMap) {
    for (const ColourMap map : {ColourMap::sepia, ColourMap::grey, ColourMap::ice}) {
        const ColourBends bends(map);
        EXPECT_EQ(bends.any, map != ColourMap::grey);
        for (int i = 0; i <= 1000; ++i) {
            const double intensity = i / 1000.0;
            const Vec3 expected = colourOf(map, intensity);
            for (std::size_t channel = 0; channel < 3; ++channel) {
                double colour =
                    static_cast<double>(bends.base[channel]) + static_cast<double>(bends.slope[channel]) * intensity;
                for (int bend = 0; bend < ColourBends::count; ++bend)
                    colour += static_cast<double>(bends.change[channel][static_cast<std::size_t>(bend)]) *
                              std::max(0.0, intensity - static_cast<double>(ColourBends::at(bend)));
                EXPECT_NEAR(colour, expected[static_cast<int>(channel)], 1e-6) << nameOf(map) << " " << intensity;
            }
        }
    }
}

TEST(RayCasterTables, BytesHaveTheOpacityOfTheCurve) {
    for (const double white : {255.0, 200.0, 90.5}) {
        const OpacityCurve curve = PowerCurve{2, 0.5};
        const TransferTable table(curve, ColourMap::sepia, 0.7);
        const ByteOpacities opacities(table, TransferTable::intervals / white);
        for (int i = 0; i <= 255 * ByteOpacities::perLevel; ++i) {
            const double intensity = std::min(1.0, i / (ByteOpacities::perLevel * white));
            EXPECT_NEAR(static_cast<double>(opacities.data()[i]), opacityForStep(opacityAt(curve, intensity), 0.7),
                        1e-6)
                << white << " " << i;
        }
    }
}

TEST(RayCasterTables, NothingThatIsVisibleLiesBelowTheFirstVisible) {
    for (const double begin : {0.0, 0.3, 0.62, 1.0}) {
        const TransferTable table(begin < 1.0 ? OpacityCurve{LinearCurve{begin, 1.0, 0.9}} : everywhere(0.0),
                                  ColourMap::grey, 1.0);
        const ByteOpacities bytes(table, 8.0);
        // A lookup takes the entry that is nearest, a table position the two around it.
        const auto below = static_cast<int>(std::lround(bytes.firstVisible()));
        for (int i = 0; i <= std::min(below, 255 * ByteOpacities::perLevel); ++i)
            EXPECT_EQ(bytes.data()[i], 0.0f) << begin << " " << i;
        for (int i = 0; i <= std::min<int>(static_cast<int>(table.firstVisible()), TransferTable::intervals); ++i)
            EXPECT_EQ(table.opacities()[i], 0.0f) << begin << " " << i;
        if (begin == 1.0) continue;
        EXPECT_NEAR(bytes.firstVisible() / (255 * ByteOpacities::perLevel), begin, 1e-3);
        EXPECT_NEAR(table.firstVisible() / TransferTable::intervals, begin, 1e-3);
    }
}

TEST(RayCasterTables, BytesOfASmoothVolumeAreShownToATenthOfALevel) {
    // There are at most 12 levels from voxel to voxel, as between the structures of a scan: shares of 7 bits are a
    // tenth of a level.
    const Volume volume = volumeOf<std::uint8_t>({48, 45, 50}, {1, 0.9, 1.1}, [](auto x, auto y, auto z) {
        return 0.5 + 0.24 * std::sin(0.17 * static_cast<double>(x) + 0.4) * std::cos(0.19 * static_cast<double>(y)) +
               0.24 * std::sin(0.13 * static_cast<double>(z) - 0.08 * static_cast<double>(y));
    });
    for (const Viewpoint& view :
         {Viewpoint{}, Viewpoint{BeamAxis::minusX, 0, 0, 0}, Viewpoint{BeamAxis::plusY, 31, -22, 4}}) {
        RayCastSettings settings = settingsFor(volume, view, 40, 40);
        settings.step = 0.77;
        for (const OpacityCurve& curve : {OpacityCurve{PowerCurve{2, 0.2}}, OpacityCurve{LinearCurve{0.3, 0.9, 0.2}}})
            EXPECT_LT(largestDifference(volume, curve, settings) * 255.0, 0.1) << curve.index();
    }
}

}  // namespace
}  // namespace echolucent
