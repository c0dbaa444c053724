// Lines, discs and words over a picture, besides its annotations. Some lie in the volume, some in the picture.
#pragma once

#include <string>
#include <vector>

#include "processing/picture/annotation_layout.h"
#include "processing/picture/picture_place.h"

namespace echolucent {

/// A line between two places of the grid, mm. It is drawn over the volume even if it lies behind the volume. It is not
/// drawn if one of its places lies behind the eye.
struct SpaceLine {
    Vec3 from, to;
    Colour colour{};
    double width = 1.5;  ///< pixels of a plain screen
    friend bool operator==(const SpaceLine&, const SpaceLine&) = default;
};

/// A line through two or more places of the grid, mm, drawn as a SpaceLine.
struct SpacePath {
    std::vector<Vec3> places;
    Colour colour{};
    double width = 1.5;            ///< pixels of a plain screen
    double dash = 0.0, gap = 0.0;  ///< lengths of dashes and of gaps between them, pixels of a plain screen; 0: none
    friend bool operator==(const SpacePath&, const SpacePath&) = default;
};

/// A place of the grid that can be held: a disc.
struct SpaceDisc {
    Vec3 at;
    Colour colour{};
    double radius = 4.0;  ///< pixels of a plain screen
    friend bool operator==(const SpaceDisc&, const SpaceDisc&) = default;
};

/// Words beside places of the grid, mm. labelsOf() (processing/scene/shown_measurement.h) chooses the side.
struct SpaceText {
    std::vector<Vec3> beside;  ///< at least one
    std::string text;          ///< UTF-8
    Colour colour{};
    double gap = 9.0;  ///< between place and words, pixels of a plain screen
    friend bool operator==(const SpaceText&, const SpaceText&) = default;
};

/// A line through places of the picture.
struct PictureLine {
    std::vector<PicturePlace> places;
    Colour colour{};
    double width = 1.5;  ///< pixels of a plain screen
    friend bool operator==(const PictureLine&, const PictureLine&) = default;
};

struct Overlay {
    std::vector<SpaceLine> spaceLines{};
    std::vector<SpacePath> spacePaths{};
    std::vector<SpaceDisc> discs{};
    std::vector<PictureLine> pictureLines{};
    std::vector<SpaceText> texts{};
    friend bool operator==(const Overlay&, const Overlay&) = default;
};

}  // namespace echolucent
