#include "tests/benchmarks_window/large_study.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>

#include "app/sessions/session_keeping.h"
#include "app/window/review_room.h"

namespace echolucent::bench {

namespace {
constexpr double nearCutShare = 0.2;  // of the depth
constexpr int atRest = 500;           // ms
}  // namespace

LargeStudy::LargeStudy() {
    window().resize(1440, 920);
    trigger(QStringLiteral("room.quad"));
    show();
    window().openSimulatedScan();
    await("the simulated scan", [&] { return window().otfs().adaptive() != nullptr; });
    waitUntilConverged();
}

QStringList LargeStudy::underWay() {
    const OpenStudy& openStudy = window().openStudy();
    QStringList names;
    if (openStudy.loading()) names << QStringLiteral("loading");
    if (openStudy.takingChecksum()) names << QStringLiteral("checksum");
    if (window().sessionKeeping().saving()) names << QStringLiteral("saving");
    if (openStudy.quietPhases().busy()) names << QStringLiteral("quieting");
    if (window().otfs().busy() || openStudy.cutting()) names << QStringLiteral("OTF or cutting");
    if (!view().pictureIsFine()) names << QStringLiteral("picture");
    if (names.isEmpty() && !window().idle()) names << QStringLiteral("planes or writing");
    return names;
}

QList<Stall> LargeStudy::stalls(const QString& volume) {
    Heartbeat heartbeat([this] { return underWay(); });
    const auto listen = [&](const char* action, const std::function<void()>& act) {
        heartbeat.begin(QString::fromLatin1(action));
        act();
        waitUntilConverged();
        heartbeat.end();
    };
    listen("rest", [] {
        QElapsedTimer rested;
        rested.start();
        await("the rest", [&] { return rested.elapsed() > atRest; });
    });
    listen("open", [&] {
        const Study* before = window().openStudy().study();
        window().open(volume);
        await("the volume", [&] { return window().openStudy().study() != before; });
        QElapsedTimer taken;
        taken.start();
        await("the checksum", [&] { return !window().openStudy().takingChecksum(); });
        m_checksumMilliseconds = static_cast<double>(taken.nsecsElapsed()) * 1e-6;
    });
    DocumentSteps& steps = window().document().steps();
    const QTemporaryDir reports;
    listen("report", [&] {
        window().saveReport(reports.filePath(QStringLiteral("report.html")), false);
        await("the report", [&] { return window().idle(); });
    });
    if (!QFile::exists(reports.filePath(QStringLiteral("report.html")))) qFatal("no report was written");
    listen("near cut", [&] {
        Document next = window().document().document();
        const VolumeGeometry& geometry = window().openStudy().volume()->geometry();
        next.scene.front = {};
        next.scene.front.depthMm = nearCutShare * depthAlongViewMm(otfViewpointOf(next, firstPane), geometry);
        window().document().edit(next, QStringLiteral("near cut"));
    });
    listen("stroke", [&] { drawStroke(); });
    if (!window().openStudy().volume()->isCut()) qFatal("the stroke cut nothing");
    const QTemporaryDir folder;
    listen("save", [&] {
        bool saved = false;
        const auto told =
            QObject::connect(&window().sessionKeeping(), &SessionKeeping::saved, &window(), [&] { saved = true; });
        for (int i = 0; i < 20; ++i)
            (void)window().sessionKeeping().snapshots().keep(QString("snapshot %1").arg(i),
                                                             window().document().document());
        window().sessionKeeping().saveAs(folder.filePath("large.session.json"));
        await("the session", [&] { return saved; });
        QObject::disconnect(told);
    });
    listen("undo", [&] { steps.undo(); });
    if (window().openStudy().volume()->isCut()) qFatal("the stroke was not undone");
    listen("close", [&] { window().openSimulatedScan(); });
    return heartbeat.stalls();
}

}  // namespace echolucent::bench
