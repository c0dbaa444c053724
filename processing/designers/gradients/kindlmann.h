// The semi-automatic OTF of Kindlmann and Durkin (1998): opacity by where a voxel lies within a boundary.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "processing/choice_names.h"
#include "processing/designers/designer_declarations.h"

namespace echolucent {

/// What opacity depends on.
enum class KindlmannDimensions {
    one,  ///< the intensity: alpha(v) = b(p(v))
    two,  ///< the intensity and the gradient magnitude: alpha(v, g) = b(p(v, g))
};
inline constexpr ChoiceNames<2> kindlmannDimensionsNames{"one", "two"};

/// Where the boundary emphasis function b comes from.
enum class BoundaryEmphasis {
    hat,    ///< from centre, half-width and peak
    drawn,  ///< KindlmannConfig::drawn
};
inline constexpr ChoiceNames<2> boundaryEmphasisNames{"hat", "drawn"};

struct EmphasisNode {
    double position = 0.0;  ///< within the boundary, in its standard deviations, negative on the darker side
    double opacity = 0.0;   ///< per reference step, [0,1]
    friend bool operator==(const EmphasisNode&, const EmphasisNode&) = default;
};

/// The most nodes of KindlmannConfig::drawn; the least is two.
inline constexpr std::size_t mostEmphasisNodes = 64;

/// parametersOf() has the ranges, the meanings and the sources of all members but `drawn`.
struct KindlmannConfig {
    static constexpr DesignerWords words{"kindlmann", "Kindlmann and Durkin"};
    KindlmannDimensions dimensions = KindlmannDimensions::one;
    double prefilter = 1.0;  ///< standard deviation of the Gaussian under which derivatives are taken, units
    double smoothing = 2.0;  ///< standard deviation over the intensity of the mean derivatives, levels of 255
    double threshold = 0.2;  ///< g0, share of the largest mean gradient magnitude
    BoundaryEmphasis emphasis = BoundaryEmphasis::hat;
    double centre = 0.0;     ///< of the hat, standard deviations of the boundary
    double halfWidth = 1.0;  ///< of the hat, standard deviations of the boundary
    double peak = 1.0;       ///< of the hat, opacity per reference step
    /// The function that a person drew: piecewise linear, constant beyond its first and last node. Two nodes at one
    /// position make a step; the later one holds there. Only BoundaryEmphasis::drawn uses it, but it is always kept, so
    /// that a person can go to the hat and back. Tables of parameters hold scalars, so they do not hold it. 2 to
    /// mostEmphasisNodes nodes, at positions in [-8,8] that do not descend. The default is the default hat.
    std::vector<EmphasisNode> drawn{{-1.0, 0.0}, {0.0, 1.0}, {1.0, 0.0}};
    friend bool operator==(const KindlmannConfig&, const KindlmannConfig&) = default;
};
/// The table also checks the drawn nodes.
[[nodiscard]] const ParameterTable<KindlmannConfig>& parametersOf(const KindlmannConfig&);

/// The boundary emphasis function b: the opacity, [0,1], at a position in standard deviations of the boundary.
[[nodiscard]] double emphasisAt(const KindlmannConfig& config, double position);

/// Opacity is b of the position in boundaries (boundaryPositions()), and 0 if no position is known. The derivatives are
/// those of input.shown. One dimension gives a SampledCurve of 256 nodes, two a TwoDimensionalOtf of 256 x 64.
///
/// Facts: the boundary's width with and without the prefilter, the extremes of the mean derivatives, the share of the
/// voxels with data that count. Plots: mean derivatives and position over the intensity.
///
/// The curve is x^2, and the message says so, in three cases: no boundary is found, the one found is speckle or thin
/// layers (BoundaryWidth::isSharperThanBoundaries()), or b leaves nothing of the boundaries.
[[nodiscard]] std::optional<Design> design(const KindlmannConfig& config, const DesignerInput& input,
                                           const Progress& progress = {});

}  // namespace echolucent
