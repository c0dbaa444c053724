// What lies over a picture beside its annotations: lines and discs, some in the volume, some in the picture.
#pragma once

#include <array>
#include <vector>

#include "processing/picture/picture_place.h"

namespace echolucent {

/// Red, green, blue, each 0..255.
using Colour = std::array<unsigned char, 3>;

/// A line between two places of the grid, mm. It is drawn over the volume, also where it lies behind it.
struct SpaceLine {
    Vec3 from, to;
    Colour colour{};
    double width = 1.5;  ///< pixels of a plain screen
    friend bool operator==(const SpaceLine&, const SpaceLine&) = default;
};

/// A place of the grid that can be held: a disc.
struct SpaceDisc {
    Vec3 at;
    Colour colour{};
    double radius = 4.0;  ///< pixels of a plain screen
    friend bool operator==(const SpaceDisc&, const SpaceDisc&) = default;
};

/// A line through places of the picture.
struct PictureLine {
    std::vector<PicturePlace> places;
    Colour colour{};
    double width = 1.5;  ///< pixels of a plain screen
    friend bool operator==(const PictureLine&, const PictureLine&) = default;
};

/// What lies over a picture beside its annotations.
struct Overlay {
    std::vector<SpaceLine> spaceLines{};
    std::vector<SpaceDisc> discs{};
    std::vector<PictureLine> pictureLines{};
    friend bool operator==(const Overlay&, const Overlay&) = default;
};

}  // namespace echolucent
