#include "app/planes/edge_letters.h"

#include <QCoreApplication>
#include <cmath>
#include <numbers>

namespace echolucent {

std::array<QString, 4> edgeLetters(const ViewFrame& frame, BeamAxis beam) {
    const Vec3 towardsProbe = -frameOf(Viewpoint{.beamAxis = beam}).forward;
    const double least = std::cos(std::numbers::pi / 6.0);
    const std::array<Vec3, 4> edges{-frame.right, frame.right, -frame.down, frame.down};
    std::array<QString, 4> letters;
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (edges[i].dot(towardsProbe) >= least) letters[i] = QCoreApplication::translate("planes", "probe");
    return letters;
}

}  // namespace echolucent
