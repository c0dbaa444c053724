#include "tests/benchmarks_window/opening_time.h"

#include <QApplication>
#include <QElapsedTimer>
#include <QEvent>
#include <QFile>
#include <QStringList>
#include <algorithm>

#include "io/restricted/restricted_reader.h"

namespace echolucent::bench {

namespace {

constexpr int atRest = 500;  // ms; the reader process that waits has loaded its libraries by then

double median(QList<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

double millisecondsOf(const QElapsedTimer& clock) { return static_cast<double>(clock.nsecsElapsed()) * 1e-6; }

/// What reading the file from the page cache into memory of its own takes.
double plainReadOf(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly | QIODevice::Unbuffered)) qFatal("cannot read %s", qPrintable(path));
    QElapsedTimer clock;
    clock.start();
    const QByteArray bytes = file.readAll();
    const double milliseconds = millisecondsOf(clock);
    if (bytes.size() != file.size()) qFatal("cannot read %s", qPrintable(path));
    return milliseconds;
}

/// Notes when the coarse picture is painted for the first time.
class PaintWatch : public QObject {
public:
    explicit PaintWatch(const QElapsedTimer& clock) : m_clock(clock) { qApp->installEventFilter(this); }
    [[nodiscard]] std::optional<double> painted() const { return m_painted; }

    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Paint && !m_painted && watched->objectName() == QLatin1String("view3d.coarse"))
            // What is painted is on the screen once the event has been handled.
            QMetaObject::invokeMethod(
                this,
                [this] {
                    if (!m_painted) m_painted = millisecondsOf(m_clock);
                },
                Qt::QueuedConnection);
        return QObject::eventFilter(watched, event);
    }

private:
    const QElapsedTimer& m_clock;
    std::optional<double> m_painted;
};

}  // namespace

OpeningTime::OpeningTime() {
    restricted::prepareReader(restricted::Readiness::always);
    window().resize(1280, 720);
    show();
    window().openSimulatedScan();
    await("the simulated scan", [&] { return window().otfs().adaptive() != nullptr; });
    waitUntilConverged();
}

void OpeningTime::rest() const {
    QElapsedTimer rested;
    rested.start();
    await("the rest", [&] { return rested.elapsed() > atRest; });
}

OpeningTimes OpeningTime::measure(const QString& volume, int runs) {
    QList<double> plain, dimmed, coarse, opened, first, allRays, converged;
    for (int run = 0; run < runs; ++run) {
        rest();
        plain << plainReadOf(volume);
        const Study* before = window().openStudy().study();
        std::optional<double> dimmedAt, openedAt, firstAt, allRaysAt;
        QElapsedTimer clock;
        clock.start();
        const PaintWatch watch(clock);
        QObject context;
        QObject::connect(&window().openStudy(), &OpenStudy::studyOpened, &context,
                         [&] { openedAt = millisecondsOf(clock); });
        bool hasAllRays = false;
        QObject::connect(&view(), &VolumeViewWidget::pictureDelivered, &context, [&](const PictureReport& report) {
            hasAllRays = report.converged || report.quality == QLatin1String("high quality");
        });
        QObject::connect(&view(), &VolumeViewWidget::pictureDrawn, &context, [&] {
            if (!dimmedAt && view().dimmed()) dimmedAt = millisecondsOf(clock);
            if (!openedAt || view().measured() != window().openStudy().volume()) return;
            if (!firstAt) firstAt = millisecondsOf(clock);
            if (!allRaysAt && hasAllRays) allRaysAt = millisecondsOf(clock);
        });
        window().open(volume);
        await("the volume", [&] { return window().openStudy().study() != before && allRaysAt.has_value(); });
        waitUntilConverged();
        converged << millisecondsOf(clock);
        dimmed << dimmedAt.value_or(firstAt.value_or(0.0));
        if (watch.painted()) coarse << *watch.painted();
        opened << *openedAt;
        first << *firstAt;
        allRays << *allRaysAt;
        window().openSimulatedScan();
        await("the simulated scan", [&] { return window().openStudy().isSimulatedScan(); });
        waitUntilConverged();
    }
    OpeningTimes times;
    times.plainRead = median(plain);
    times.dimmed = median(dimmed);
    if (!coarse.isEmpty()) times.coarsePainted = median(coarse);
    times.opened = median(opened);
    times.firstPicture = median(first);
    times.allRays = median(allRays);
    times.converged = median(converged);
    return times;
}

QString openingTable(const OpeningTimes& times) {
    const auto cell = [&](double milliseconds) {
        return QString("%1 (%2 x)").arg(milliseconds, 0, 'f', 0).arg(milliseconds / times.plainRead, 0, 'f', 1);
    };
    const QStringList cells{QString::number(times.plainRead, 'f', 0),
                            QString::number(times.dimmed, 'f', 0),
                            times.coarsePainted ? cell(*times.coarsePainted) : QStringLiteral("none"),
                            cell(times.opened),
                            cell(times.firstPicture),
                            cell(times.allRays),
                            cell(times.converged)};
    return QStringLiteral(
               "| plain read, ms | old picture dimmed, ms | coarse picture | study opened | first picture | all rays | "
               "converged, idle "
               "|\n|---|---|---|---|---|---|---|\n| ") +
           cells.join(QStringLiteral(" | ")) + QStringLiteral(" |");
}

}  // namespace echolucent::bench
