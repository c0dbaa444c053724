// The semi-automatic OTF of Kindlmann and Durkin (1998): opacity by where a voxel lies within a boundary.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "processing/choice_names.h"
#include "processing/designers/design.h"
#include "processing/parameter.h"
#include "processing/progress.h"

namespace echolucent {

/// What opacity is a function of.
enum class KindlmannDimensions {
    one,  ///< the intensity: alpha(v) = b(p(v))
    two,  ///< the intensity and the gradient magnitude: alpha(v, g) = b(p(v, g))
};
inline constexpr ChoiceNames<2> kindlmannDimensionsNames{"one", "two"};
[[nodiscard]] inline std::string_view nameOf(KindlmannDimensions dimensions) {
    return nameIn(kindlmannDimensionsNames, dimensions);
}
[[nodiscard]] inline std::optional<KindlmannDimensions> kindlmannDimensionsFromName(std::string_view name) {
    return choiceNamed<KindlmannDimensions>(kindlmannDimensionsNames, name);
}

/// Where the boundary emphasis function b comes from.
enum class BoundaryEmphasis {
    hat,    ///< made of three numbers
    drawn,  ///< KindlmannConfig::drawn
};
inline constexpr ChoiceNames<2> boundaryEmphasisNames{"hat", "drawn"};
[[nodiscard]] inline std::string_view nameOf(BoundaryEmphasis emphasis) {
    return nameIn(boundaryEmphasisNames, emphasis);
}
[[nodiscard]] inline std::optional<BoundaryEmphasis> boundaryEmphasisFromName(std::string_view name) {
    return choiceNamed<BoundaryEmphasis>(boundaryEmphasisNames, name);
}

/// One point of the boundary emphasis function.
struct EmphasisNode {
    double position = 0.0;  ///< within the boundary, standard deviations of it, negative on the darker side
    double opacity = 0.0;   ///< per reference step, [0,1]
    friend bool operator==(const EmphasisNode&, const EmphasisNode&) = default;
};

/// The most nodes that KindlmannConfig::drawn may have; it must have two.
inline constexpr std::size_t mostEmphasisNodes = 64;

/// parametersOf() has the ranges, the meanings and the sources of all members but `drawn`.
struct KindlmannConfig {
    KindlmannDimensions dimensions = KindlmannDimensions::one;
    double prefilter = 1.0;  ///< standard deviation of the Gaussian under which derivatives are taken, units
    double smoothing = 2.0;  ///< standard deviation over the intensity of the mean derivatives, levels of 255
    double threshold = 0.2;  ///< g0, share of the largest mean gradient magnitude
    BoundaryEmphasis emphasis = BoundaryEmphasis::hat;
    double centre = 0.0;     ///< of the hat, standard deviations of the boundary
    double halfWidth = 1.0;  ///< of the hat, standard deviations of the boundary
    double peak = 1.0;       ///< of the hat, opacity per reference step
    /// What a person drew, piecewise linear, constant beyond its first and last node; two nodes at one position make a
    /// step, of which the later one holds there. It counts where `emphasis` says so, and is kept where it does not, so
    /// that a person can go to the hat and back. Tables of parameters hold scalars and so do not hold it. 2 to
    /// mostEmphasisNodes nodes, of positions in [-8,8] that do not descend; the default is the default hat.
    std::vector<EmphasisNode> drawn{{-1.0, 0.0}, {0.0, 1.0}, {1.0, 0.0}};
    friend bool operator==(const KindlmannConfig&, const KindlmannConfig&) = default;
};

[[nodiscard]] std::span<const Parameter<KindlmannConfig>> parametersOf(const KindlmannConfig&);

/// What is wrong in a config, lower case, no full stop, nodes included; empty where nothing is.
[[nodiscard]] std::string problemOf(const KindlmannConfig& config);

/// The boundary emphasis function b of a position, standard deviations of the boundary: the opacity, [0,1].
[[nodiscard]] double emphasisAt(const KindlmannConfig& config, double position);

/// Opacity is b of the position in boundaries (boundaryPositions()), and 0 where no position is known. The derivatives
/// are those of input.shown. One dimension gives a SampledCurve of 256 nodes, two a TwoDimensionalOtf of 256 x 64.
/// Facts: the boundary's width with and without the prefilter, the extremes of the mean derivatives, the share of the
/// voxels with data that count. Plots: mean derivatives and position over the intensity.
/// Where no boundary is found, where what is found is speckle or thin layers
/// (BoundaryWidth::isSharperThanBoundaries()), or where b leaves nothing of it, x^2 is given and the message says so.
/// The result is empty only where progress.cancel was raised, and has the same bits for any number of threads. Throws
/// std::invalid_argument where problemOf(config) is not empty or where the volumes have different grids.
[[nodiscard]] std::optional<Design> design(const KindlmannConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

}  // namespace echolucent
