#include "app/planes/edge_letters.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace echolucent {

QString patientLetters(const Vec3& towards) {
    const double least = std::sin(std::numbers::pi / 9.0);
    std::array<int, 3> axes{0, 1, 2};
    std::ranges::stable_sort(axes, std::greater{}, [&towards](int axis) { return std::abs(towards[axis]); });
    QString letters;
    for (const int axis : axes)
        if (std::abs(towards[axis]) >= least) letters += QLatin1String(towards[axis] > 0 ? "LPH" : "RAF")[axis];
    return letters;
}

std::array<QString, 4> edgeLetters(const ViewFrame& frame, BeamAxis beam, const VolumeGeometry& geometry) {
    const Vec3 towardsProbe = -frameOf(Viewpoint{.beamAxis = beam}).forward;
    const double least = std::cos(std::numbers::pi / 6.0);
    const std::array<Vec3, 4> edges{-frame.right, frame.right, -frame.down, frame.down};
    std::array<QString, 4> letters;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        QStringList words;
        if (geometry.patientFrameKnown) words << patientLetters(geometry.direction * edges[i]);
        if (edges[i].dot(towardsProbe) >= least) words << QCoreApplication::translate("planes", "probe");
        letters[i] = words.join(QStringLiteral(" · "));
    }
    return letters;
}

}  // namespace echolucent
