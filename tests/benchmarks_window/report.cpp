#include "tests/benchmarks_window/report.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSaveFile>
#include <QThread>
#include <algorithm>

namespace echolucent::bench {

namespace {

QString number(double value, int decimals, int width) { return QString("%1").arg(value, width, 'f', decimals); }

double mebibytes(std::size_t bytes) { return static_cast<double>(bytes) / (1 << 20); }

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

QJsonObject json(const KeptMotion& kept) {
    return {{"frames", kept.frames},
            {"frame_mib", mebibytes(kept.frameBytes)},
            {"quiet_phases", kept.quietPhases},
            {"quiet_mib", mebibytes(kept.quietBytes)},
            {"otfs", kept.otfs},
            {"otf_mib", mebibytes(kept.otfBytes)}};
}

QJsonObject json(const Stall& stall) {
    return {{"action", stall.action},
            {"under_way", stall.underWay},
            {"longest_ms", stall.milliseconds},
            {"processor_ms", stall.processorMilliseconds},
            {"over_limit", stall.overLimit}};
}

QJsonObject json(const OpeningTimes& times) {
    return {{"plain_read_ms", times.plainRead},
            {"dimmed_ms", times.dimmed},
            {"coarse_ms", times.coarsePainted ? QJsonValue(*times.coarsePainted) : QJsonValue()},
            {"opened_ms", times.opened},
            {"first_picture_ms", times.firstPicture},
            {"all_rays_ms", times.allRays},
            {"converged_ms", times.converged}};
}

}  // namespace

QString tableHeader() {
    return QString("%1 %2 %3  frames/s  delivered/s  median ms  95 % ms  cast ms  draw ms   CPU  quality")
        .arg("action", -16)
        .arg("curve", -14)
        .arg("size", -5);
}

QString tableLine(const Row& row) {
    QStringList cells{QString("%1 %2 %3").arg(row.action, -16).arg(row.curve, -14).arg(row.edge, -5)};
    cells << number(row.framesPerSecond, 1, 9) << number(row.deliveredPerSecond, 1, 12)
          << number(row.medianInterval, 1, 10) << number(row.interval95, 1, 8) << number(row.castMilliseconds, 1, 8)
          << number(row.drawMilliseconds, 1, 8) << number(100 * row.processorShare, 0, 4) + " %";
    if (row.quality.isEmpty()) return cells.join(' ');  // nothing was cast
    cells << QString(" %1 %2x%3, step %4 (%5 %)")
                 .arg(row.quality)
                 .arg(row.rays.width())
                 .arg(row.rays.height())
                 .arg(row.step)
                 .arg(100 * row.qualityShare, 0, 'f', 0);
    return cells.join(' ');
}

QString memoryLine(const Memory& memory) {
    return QString("With everything on %1 MiB are resident, and at most %2 MiB were.")
        .arg(memory.residentMiB, 0, 'f', 0)
        .arg(memory.peakMiB, 0, 'f', 0);
}

QString keptLine(const KeptMotion& kept) {
    return QString("In memory are %1 pictures (%2 MiB), quiet voxels of %3 phases (%4 MiB) and %5 OTFs (%6 MiB).")
        .arg(kept.frames)
        .arg(mebibytes(kept.frameBytes), 0, 'f', 1)
        .arg(kept.quietPhases)
        .arg(mebibytes(kept.quietBytes), 0, 'f', 1)
        .arg(kept.otfs)
        .arg(mebibytes(kept.otfBytes), 0, 'f', 1);
}

QString stallTable(const QList<Stall>& stalls) {
    QStringList lines{QString("%1 %2 longest ms  of it busy  over %3 ms")
                          .arg("action", -10)
                          .arg("under way", -16)
                          .arg(stallLimit, 0, 'f', 0)};
    for (const Stall& stall : stalls)
        lines << QString("%1 %2").arg(stall.action, -10).arg(stall.underWay, -16) + number(stall.milliseconds, 1, 11) +
                     number(stall.processorMilliseconds, 1, 12) + QString("%1").arg(stall.overLimit, 12);
    const auto longest = std::ranges::max_element(stalls, {}, &Stall::milliseconds);
    if (longest != stalls.end())
        lines << QString("The longest stall is %1 ms (action \"%2\", under way: %3).")
                     .arg(longest->milliseconds, 0, 'f', 1)
                     .arg(longest->action, longest->underWay);
    return lines.join('\n');
}

bool writeJson(const QString& path, const Findings& findings) {
    QJsonArray rows, stalls, kept;
    for (const KeptMotion& motion : findings.kept) kept.append(json(motion));
    for (const Row& row : findings.rows) rows.append(json(row));
    for (const Stall& stall : findings.stalls) stalls.append(json(stall));
    const QJsonObject memory{{"resident_mib", findings.memory.residentMiB}, {"peak_mib", findings.memory.peakMiB}};
    QJsonObject whole{{"processors", QThread::idealThreadCount()},
                      {"rows", rows},
                      {"memory", memory},
                      {"kept", kept},
                      {"stalls", stalls}};
    if (findings.opening) whole.insert(QStringLiteral("opening"), json(*findings.opening));
    QDir().mkpath(QFileInfo(path).absolutePath());
    QSaveFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(QJsonDocument(whole).toJson()) > 0 && file.commit();
}

}  // namespace echolucent::bench
