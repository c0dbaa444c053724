#include "widgets/motion/motion_words.h"

#include <QCoreApplication>
#include <QLocale>

namespace echolucent {

namespace {
QString motionText(const char* text) { return QCoreApplication::translate("motion", text); }
}  // namespace

QString axisText(MotionAxis axis) {
    switch (axis) {
        case MotionAxis::x: return motionText("Elevation (older file)");
        case MotionAxis::y: return motionText("Azimuth (older file)");
        case MotionAxis::z: return motionText("Roll (older file)");
        case MotionAxis::screenVertical: return motionText("Screen's vertical");
        case MotionAxis::screenHorizontal: return motionText("Screen's horizontal");
        case MotionAxis::picturePlane: return motionText("In the picture's plane");
    }
    return {};
}

QString shortAxisText(MotionAxis axis) {
    switch (axis) {
        case MotionAxis::screenVertical: return motionText("Upright");
        case MotionAxis::screenHorizontal: return motionText("Across");
        case MotionAxis::picturePlane: return motionText("In plane");
        default: return axisText(axis);
    }
}

QString speedText(double speed) {
    if (speed == 0.25) return QStringLiteral("¼×");
    if (speed == 0.5) return QStringLiteral("½×");
    return QStringLiteral("%1×").arg(QLocale::c().toString(speed, 'g', 3));
}

QString speedTip(const MotionChoice& motion, const PhaseTimes& times) {
    const QString rate = QLocale::c().toString(1.0 / frameSeconds(motion, times), 'g', 3);
    QString why;
    if (!movesObject(motion.scenario))
        why = motionText("at 1× the view turns by %1° a second").arg(motionDegreesPerSecond);
    else if (!times.starts.empty())
        why = motionText("at 1× as it was scanned, unevenly");
    else if (times.meanSeconds)
        why = motionText("at 1× as fast as it was scanned");
    else
        why = motionText("at 1× %1, as the file does not say the time between volumes").arg(assumedPhasesPerSecond);
    return motionText("Speed: %1 frames a second if they can be made in time (%2)").arg(rate, why);
}

}  // namespace echolucent
