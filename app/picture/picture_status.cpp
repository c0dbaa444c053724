#include "app/picture/picture_status.h"

#include <QCoreApplication>
#include <QLocale>

namespace echolucent {

namespace {

QString statusText(const char* text) { return QCoreApplication::translate("pictureStatus", text); }

QString qualityText(const PictureReport& report) {
    return statusText("%1: %2 × %3 rays, step %4")
        .arg(QCoreApplication::translate("qualities", report.quality.toLatin1().constData()))
        .arg(report.rays.width())
        .arg(report.rays.height())
        .arg(QLocale::c().toString(report.step, 'g', 3));
}

}  // namespace

QString pictureToolTip(const PictureReport& newest, const std::optional<PictureReport>& movement) {
    const QLocale locale = QLocale::c();
    QStringList lines{qualityText(newest), statusText("casting %1 ms, drawing %2 ms")
                                               .arg(locale.toString(newest.castMilliseconds, 'f', 1))
                                               .arg(locale.toString(newest.drawMilliseconds, 'f', 1))};
    if (movement && movement->framesPerSecond)
        lines << statusText("while moving %1 frames/s, %2")
                     .arg(locale.toString(*movement->framesPerSecond, 'f', 0), qualityText(*movement));
    return lines.join(QLatin1Char('\n'));
}

}  // namespace echolucent
