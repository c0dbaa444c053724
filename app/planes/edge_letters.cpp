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

namespace {

constexpr double cosine30 = std::numbers::sqrt3 / 2.0, sine30 = 0.5;

Vec3 beamOf(BeamAxis axis) { return frameOf(Viewpoint{.beamAxis = axis}).forward; }

QString translated(const char* words) { return QCoreApplication::translate("planes", words); }

}  // namespace

EdgeLetters edgeLetters(const ViewFrame& frame, std::optional<BeamAxis> beam, const VolumeGeometry& geometry) {
    const std::array<Vec3, 4> edges{-frame.right, frame.right, -frame.down, frame.down};
    EdgeLetters letters;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        QStringList words;
        if (geometry.patientFrameKnown) words << patientLetters(geometry.direction * edges[i]);
        const bool namesProbe = beam && edges[i].dot(-beamOf(*beam)) >= cosine30;
        if (namesProbe) words << translated("probe");
        letters.nameProbe = letters.nameProbe || namesProbe;
        letters.words[i] = words.join(QStringLiteral(" · "));
    }
    return letters;
}

std::optional<QPointF> towardsProbe(const ViewFrame& frame, BeamAxis beam) {
    const Vec3 way = -beamOf(beam);
    const QPointF seen(frame.right.dot(way), frame.down.dot(way));
    const double share = std::hypot(seen.x(), seen.y());
    return share > sine30 ? std::optional(seen / share) : std::nullopt;
}

QString lieOf(const ViewFrame& frame, BeamAxis beam) {
    const double along = frame.forward.dot(beamOf(beam));
    if (along >= cosine30) return translated("from the probe");
    if (along <= -cosine30) return translated("towards the probe");
    return translated(std::abs(along) <= sine30 ? "along the beam" : "oblique to the beam");
}

}  // namespace echolucent
