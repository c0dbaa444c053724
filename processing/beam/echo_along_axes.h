// What sound leaves in the echo on its way: it grows fainter within one tissue, and shadows lie behind bright places.
#pragma once

#include <array>

#include "processing/beam/coarse_echo.h"

namespace echolucent {

/// How the echo changes along one grid axis. Falls are natural logarithms over the volume's whole extent; they are
/// above 0 where the echo falls along the positive axis.
struct EchoAlongAxis {
    /// The fall between places of nearly equal echo, which are of one tissue: the median over the slices.
    double tissueFall = 0.0;
    double tissueShare = 0.5;  ///< share of the slices in which it falls, [0,1]
    /// The fall between any two places one behind the other: the median over the slices of their medians.
    double typicalFall = 0.0;
    double typicalShare = 0.5;  ///< share of the slices in which it falls, [0,1]
};

/// The figures of the grid axes x, y, z. They are 0 (and the shares one half) where there is too little echo.
[[nodiscard]] std::array<EchoAlongAxis, 3> echoAlongAxes(const CoarseEcho& coarse);

/// Correlation, [-1,1], of the echo with the echo that lies before it (towards index 0 of an axis) and with that behind
/// it, between neighbours across the axis that are of one tissue. Shadows of sound that came along the positive axis
/// make the first one negative and leave the second one positive.
struct ShadowCorrelation {
    double withBefore = 0.0, withBehind = 0.0;
};
[[nodiscard]] ShadowCorrelation shadowsAlong(const CoarseEcho& coarse, int axis);

}  // namespace echolucent
