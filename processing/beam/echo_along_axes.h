// Traces of sound in the echo: it grows fainter on its way through one tissue, and shadows lie behind bright places.
#pragma once

#include <array>

#include "processing/beam/coarse_echo.h"

namespace echolucent {

/// How the echo changes along one grid axis. Falls are natural logarithms over the volume's whole extent. They are
/// above 0 if the echo falls along the positive axis.
struct EchoAlongAxis {
    /// The fall between places of nearly equal echo, taken for one tissue: the median over the slices of their means.
    double tissueFall = 0.0;
    /// Share of the slices in which the echo falls, [0,1]. Slices without a change count half.
    double tissueShare = 0.5;
    /// The fall between any two places one behind the other: the median over the slices of their medians.
    double typicalFall = 0.0;
    /// Share of the slices in which the echo falls, [0,1]. Slices without a change count half.
    double typicalShare = 0.5;
};

/// The figures of the grid axes x, y, z. If there is too little echo, the falls are 0 and the shares 0.5.
[[nodiscard]] std::array<EchoAlongAxis, 3> echoAlongAxes(const CoarseEcho& coarse);

/// Correlations, [-1,1], over pairs of neighbours across an axis in one tissue. The first correlates the difference of
/// their echo with the difference of all echo before them (towards index 0 of the axis), the second with that of all
/// echo behind them. If sound came along the positive axis, its shadows make the first negative and leave the second
/// positive. 0 without pairs.
struct ShadowCorrelation {
    double withBefore = 0.0, withBehind = 0.0;
};
[[nodiscard]] ShadowCorrelation shadowsAlong(const CoarseEcho& coarse, int axis);

}  // namespace echolucent
