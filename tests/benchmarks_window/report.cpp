#include "tests/benchmarks_window/report.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QThread>

namespace echolucent::bench {

namespace {

QString number(double value, int decimals, int width) { return QString("%1").arg(value, width, 'f', decimals); }

QJsonObject json(const Row& row) {
    return {{"action", row.action},
            {"curve", row.curve},
            {"size", row.edge},
            {"shaded", row.shaded},
            {"frames_per_second", row.framesPerSecond},
            {"delivered_per_second", row.deliveredPerSecond},
            {"interval_ms_median", row.medianInterval},
            {"interval_ms_95", row.interval95},
            {"cast_ms", row.castMilliseconds},
            {"draw_ms", row.drawMilliseconds},
            {"quality", row.quality},
            {"rays_across", row.rays.width()},
            {"rays_down", row.rays.height()},
            {"step", row.step},
            {"quality_share", row.qualityShare},
            {"processor_share", row.processorShare},
            {"frames", row.frames}};
}

}  // namespace

QString tableHeader() {
    return QString("%1 %2 %3  frames/s  delivered/s  median ms  95 % ms  cast ms  draw ms   CPU  quality")
        .arg("action", -12)
        .arg("curve", -14)
        .arg("size", -5);
}

QString tableLine(const Row& row) {
    QStringList cells{QString("%1 %2 %3").arg(row.action, -12).arg(row.curve, -14).arg(row.edge, -5)};
    cells << number(row.framesPerSecond, 1, 9) << number(row.deliveredPerSecond, 1, 12)
          << number(row.medianInterval, 1, 10) << number(row.interval95, 1, 8) << number(row.castMilliseconds, 1, 8)
          << number(row.drawMilliseconds, 1, 8) << number(100 * row.processorShare, 0, 4) + " %";
    cells << QString(" %1 %2x%3, step %4 (%5 %)")
                 .arg(row.quality)
                 .arg(row.rays.width())
                 .arg(row.rays.height())
                 .arg(row.step)
                 .arg(100 * row.qualityShare, 0, 'f', 0);
    return cells.join(' ');
}

bool writeJson(const QString& path, const QList<Row>& rows) {
    QJsonArray array;
    for (const Row& row : rows) array.append(json(row));
    const QJsonObject whole{{"processors", QThread::idealThreadCount()}, {"rows", array}};
    QDir().mkpath(QFileInfo(path).absolutePath());
    QSaveFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(QJsonDocument(whole).toJson()) > 0 && file.commit();
}

}  // namespace echolucent::bench
