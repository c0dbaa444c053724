#include "app/explanation.h"

#include <QCoreApplication>
#include <QStringList>

namespace echolucent {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("explanation", text); }

QString curveSentence(const PictureFacts& facts) {
    switch (facts.active) {
        case CurveKind::adaptive:
            return tr("What is seen and what is clear follows from the adaptive opacity transfer function (OTF), which was "
                      "computed from this volume.");
        case CurveKind::manual: return tr("What is seen and what is clear follows from the OTF drawn by hand.");
        case CurveKind::linear:
            return tr("A linear OTF: everything above a threshold becomes opaque in proportion to its intensity.");
        case CurveKind::parabolic: return tr("A parabolic OTF: opacity grows with the square of the intensity.");
        case CurveKind::quartic: return tr("A quartic OTF: opacity grows with the fourth power of the intensity.");
    }
    return {};
}

struct Interface {
    double low = 0, high = 0, weight = 0;
};

/// Means of I_L and I_H over the tube cores, weighted by how much each counts.
Interface meanInterface(const AdaptiveOtf& otf) {
    Interface mean;
    for (const TubeCore& tube : otf.tubes) {
        if (!(tube.d > 0) || !tube.lowIntensity || !tube.highIntensity) continue;
        mean.low += tube.d * *tube.lowIntensity;
        mean.high += tube.d * *tube.highIntensity;
        mean.weight += tube.d;
    }
    if (mean.weight > 0) {
        mean.low /= mean.weight;
        mean.high /= mean.weight;
    }
    return mean;
}

QString methodSentence(const AdaptiveOtf& otf) {
    if (!otf.message.empty()) return QString::fromStdString(otf.message);
    const Interface mean = meanInterface(otf);
    return tr("%1 of %2 tube cores (columns of voxels along the view) found a surface behind darker tissue or fluid. In front "
              "of it the intensity is about %3 and becomes clearer, at it about %4 and becomes more opaque.")
        .arg(otf.tubesWithSurface)
        .arg(otf.tubesMeetingVolume)
        .arg(mean.low, 0, 'f', 2)
        .arg(mean.high, 0, 'f', 2);
}

}  // namespace

QString explainPicture(const PictureFacts& facts) {
    QStringList sentences;
    if (facts.simulated) sentences << tr("This is a simulated scan, not a patient.");
    sentences << tr("The volume is looked at along its %1 axis, turned by %2° of azimuth and %3° of elevation.")
                     .arg(QString::fromUtf8(nameOf(facts.view.beamAxis).data()))
                     .arg(facts.view.azimuthDegrees, 0, 'f', 0)
                     .arg(facts.view.elevationDegrees, 0, 'f', 0);
    if (facts.view.nearCutMm > 0)
        sentences << tr("The near cut removes the first %1 mm; the tube cores begin there too.")
                         .arg(facts.view.nearCutMm, 0, 'f', 1);
    sentences << curveSentence(facts);
    if (facts.otf != nullptr && facts.active == CurveKind::adaptive) sentences << methodSentence(*facts.otf);
    if (facts.shaded) sentences << tr("Light from the upper left in front shows the shape of surfaces.");
    if (!facts.volume.dataMask().empty())
        sentences << tr("Voxels outside the scanned sector hold no data and are left out.");
    if (!facts.volume.geometry().spacingKnown)
        sentences << tr("The spacing of the voxels is unknown, so proportions may be wrong.");
    if (facts.study.lossyCompressed) sentences << tr("The data were compressed with loss, which changes intensities.");
    sentences << tr("Not a medical device.");
    return sentences.join(QStringLiteral("\n\n"));
}

}  // namespace echolucent
