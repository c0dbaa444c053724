// What a graphics card draws one picture from, as plain values.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "processing/classification.h"
#include "processing/light/light_volume.h"
#include "processing/picture/picture.h"
#include "processing/picture/ray_cast_settings.h"
#include "processing/ray_caster/packed/transfer_table.h"
#include "processing/ray_caster/ray_geometry.h"
#include "processing/sampling/gradient_levels.h"
#include "processing/volume/volume.h"

namespace echolucent {

/// The voxels of a scan as a card takes them. A scalpel's cut changes none of them.
struct CardScan {
    Volume filled;                 ///< FilledVolume::voxels
    std::vector<float> positions;  ///< of a volume of floats: their table positions (PackedVoxels); else empty
    float toPosition = 1.0f;       ///< factor from a voxel of `filled` (1 if there are positions) to its table position
};

/// How far it is from each brick of 8 x 8 x 8 cubes to the next that shows something (EmptySpace).
struct CardBricks {
    std::array<std::int64_t, 3> size{};
    std::vector<std::uint8_t> distances;
};

/// All that a card needs to draw a picture like that of castRays(). A value, made by CardPictures in any thread. Parts
/// that are the same object in two pictures need not be brought to the card again.
struct CardPicture {
    std::shared_ptr<const CardScan> scan;
    std::shared_ptr<const Volume> presence;  ///< FilledVolume::presence; null if all voxels carry data
    std::shared_ptr<const ray_casting::TransferTable> table;
    Classification classification;
    std::shared_ptr<const GradientLevels> gradients;  ///< null unless a two-dimensional OTF gives opacities
    float firstVisible = 0.0f;                        ///< VisibleNodes::firstVisible() of that OTF
    std::shared_ptr<const CardBricks> bricks;         ///< null if rays may not jump
    std::shared_ptr<const LightVolume> light;         ///< null if the light asks for none
    RayCastSettings settings;
    ray_casting::RayPlan rays;
    ray_casting::RayGeometry::PixelBox pixels{};  ///< RayGeometry::visiblePixels()
    std::shared_ptr<const CutSurface> surface;    ///< RayCastSettings::cutSurface; null if there is none
    double milliseconds = 0.0;                    ///< wall time of making this
    double lightMilliseconds = 0.0;               ///< of it for the light volume
};

/// Bytes on a card of what a lit picture of a curve is drawn from, the picture itself and the one before included. Told
/// before anything is made: bricks, tables and surfaces, which are small, are left out.
[[nodiscard]] std::int64_t bytesOnCard(const Volume& volume, int width, int height);

/// A small picture whose pixels are known. A card that draws it wrongly is not used.
struct KnownCardPicture {
    CardPicture picture;
    Picture expected;  ///< of castRays()

    /// RMSE over all pixels and channels, in levels of 8 bits, up to which a card's picture is right. A card's filter
    /// reads with 8 bits between two voxels, which makes less than a level.
    static constexpr double tolerance = 2.0;
};
/// 32 x 32 pixels of a lit ball of 32^3 voxels behind a flat front. Takes some milliseconds.
[[nodiscard]] KnownCardPicture knownCardPicture();

/// RMSE between two pictures of one size over all pixels and channels, alpha included, in levels of 8 bits. Infinity if
/// sizes differ or a value is not finite.
[[nodiscard]] double levelsBetween(const Picture& one, const Picture& other);

}  // namespace echolucent
