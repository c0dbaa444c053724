#include "tests/benchmarks_window/window_under_test.h"

#include <QComboBox>
#include <QMouseEvent>
#include <QSlider>
#include <QTest>
#include <QWheelEvent>
#include <QWindow>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "app/motion/motion_player.h"
#include "widgets/otf_editor/otf_editor.h"

namespace echolucent::bench {

namespace {

constexpr double warmUpSeconds = 1;        // the quality follows the cost of the frames before
constexpr int movementMilliseconds = 200;  // changes within that belong to one movement
constexpr double wantedShare = 2.0 / 3;

bool isFine(const PictureReport& report) { return report.converged || report.quality == "high quality"; }

}  // namespace

WindowUnderTest::WindowUnderTest(const QString& volume, int edge, bool shaded) {
    setPictureEdge(edge);
    show();
    auto* light = child<QComboBox>("view.lighting");
    light->setCurrentIndex(light->findData(shaded ? "depth" : "flat"));
    openVolume(volume);
    await("the size asked for", [&] { return view().settings().width == edge && view().settings().height == edge; });
    fillTwoThirds();
    waitUntilConverged();
}

void WindowUnderTest::setPictureEdge(int edge) {
    const int logical = static_cast<int>(std::lround(edge / window().devicePixelRatioF()));
    view().setFixedSize(logical, logical);
    window().adjustSize();
}

/// Zooms by the wheel, until the face of the volume covers that share of the picture.
void WindowUnderTest::fillTwoThirds() {
    const VolumeGeometry& geometry = window().openStudy().volume()->geometry();
    const Vec3 size = geometry.boxMaxMm() - geometry.boxMinMm();
    QWindow* window = pictureWindow();
    const auto share = [&] {
        const double height = view().settings().camera.heightMm;
        return size[0] * size[1] / (height * height);
    };
    while (share() > wantedShare) {
        const QPointF centre(window->width() / 2.0, window->height() / 2.0);
        QWheelEvent out(centre, window->mapToGlobal(centre), {}, {0, -5}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(window, &out);
    }
}

OpacityCurve WindowUnderTest::adaptiveCurve() const { return window().otfEditor().state().adaptive; }

void WindowUnderTest::showCurve(const OpacityCurve& curve) {
    view().setClassification(curve);
    waitUntilConverged();
}

/// Calls change() once more than pictures are drawn, until there are enough of them.
template <typename Change>
Row WindowUnderTest::follow(const Amount& amount, const Change& change) {
    FrameRecord record;
    bool measuring = false;
    QObject context;
    QObject::connect(&view(), &VolumeViewWidget::pictureDelivered, &context,
                     [&](const PictureReport& report) { record.delivered(report); });
    QObject::connect(&view(), &VolumeViewWidget::pictureDrawn, &context, [&] {
        record.drawn();
        change();
    });
    record.begin();
    change();
    QCoreApplication::processEvents();  // this one is being cast when the next one comes
    change();
    const auto enough = [&] {
        if (!measuring && (amount.frames > 0 || record.milliseconds() > warmUpSeconds * 1e3)) {
            measuring = true;
            record.begin();
        }
        if (amount.frames > 0) return record.drawnFrames() >= amount.frames;
        return measuring && record.milliseconds() > amount.seconds * 1e3;
    };
    while (!enough()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents);
    Row row;
    record.summarise(row);
    return row;
}

/// A view turns by a degree.
void WindowUnderTest::moveHand(Qt::KeyboardModifiers keys) {
    QWindow* window = pictureWindow();
    m_hand += QPointF(window->height() / 180.0, 0);
    QMouseEvent move(QEvent::MouseMove, m_hand, window->mapToGlobal(m_hand), Qt::NoButton, Qt::LeftButton, keys);
    QCoreApplication::sendEvent(window, &move);
}

Row WindowUnderTest::drag(Qt::KeyboardModifiers keys, const Amount& amount) {
    const QPoint centre(pictureWindow()->width() / 2, pictureWindow()->height() / 2);
    m_hand = centre;
    QTest::mousePress(pictureWindow(), Qt::LeftButton, keys, centre);
    Row row = follow(amount, [&] { moveHand(keys); });
    QTest::mouseRelease(pictureWindow(), Qt::LeftButton, keys, centre);
    waitUntilConverged();
    return row;
}

Row WindowUnderTest::orbit(const Amount& amount) {
    Row row = drag({}, amount);
    row.action = "orbit";
    return row;
}

Row WindowUnderTest::turnLight(const Amount& amount) {
    Row row = drag(Qt::ControlModifier, amount);
    row.action = "light";
    return row;
}

Row WindowUnderTest::slide(const QString& slider, const QString& action, const Amount& amount) {
    auto* moved = child<QSlider>(slider);
    const int before = moved->value();
    constexpr int there = 20, back = 2 * there;  // moves
    const int middle = (moved->minimum() + moved->maximum()) / 2;
    const int step = std::max(1, (moved->maximum() - middle) / back);  // each move changes the value
    int moves = 0;
    moved->setSliderDown(true);
    Row row = follow(amount, [&] { moved->setValue(middle + step * (std::abs(++moves % back - there) - there / 2)); });
    moved->setValue(before);
    moved->setSliderDown(false);
    waitUntilConverged();
    row.action = action;
    return row;
}

int WindowUnderTest::phases() const { return static_cast<int>(window().openStudy().study()->phases.size()); }

/// What is delivered and drawn until it is enough.
template <typename Enough>
Row WindowUnderTest::record(const Enough& enough) {
    FrameRecord record;
    QObject context;
    QObject::connect(&view(), &VolumeViewWidget::pictureDelivered, &context,
                     [&](const PictureReport& report) { record.delivered(report); });
    QObject::connect(&view(), &VolumeViewWidget::pictureDrawn, &context, [&] { record.drawn(); });
    record.begin();
    while (!enough(record)) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents);
    Row row;
    record.summarise(row);
    return row;
}

QList<Row> WindowUnderTest::playPhases(const Amount& amount) {
    auto* scenario = child<QComboBox>("motion.scenario");
    scenario->setCurrentIndex(scenario->findData(static_cast<int>(MotionScenario::object)));
    QMetaObject::invokeMethod(child<QWidget>("motion.mode.eachView"), "click");
    waitUntilConverged();
    MotionPlayer& player = window().motionPlayer();
    player.setMinimumFrameInterval(0);
    int steps = 0, fine = 0;  // fine: pictures in a row
    QObject context;
    QObject::connect(&player, &MotionPlayer::frameChanged, &context, [&] { ++steps; });
    QObject::connect(&view(), &VolumeViewWidget::pictureDelivered, &context,
                     [&](const PictureReport& report) { fine = isFine(report) ? fine + 1 : 0; });
    player.play();
    const auto turn = [&](const auto& enough) {
        const int before = steps;
        Row row = record(enough);
        // A phase may have several pictures, of which the screen shows the last at least.
        if (row.frames > 0) row.framesPerSecond *= std::min(1.0, 1.0 * (steps - before) / row.frames);
        return row;
    };
    Row first = turn([&](const FrameRecord&) { return steps >= phases(); });
    first.action = "first turn";
    Row later = turn([&](const FrameRecord&) { return fine >= 2 * phases(); });
    later.action = "later turns";
    Row kept = turn([&](const FrameRecord& now) { return now.milliseconds() > amount.seconds * 1e3; });
    kept.action = "from memory";
    m_kept = {.frames = view().keptFrames(),
              .quietPhases = window().openStudy().quietPhases().madeCount(),
              .otfs = static_cast<int>(window().otfs().kept().count()),
              .frameBytes = view().keptFrameBytes(),
              .quietBytes = window().openStudy().quietPhases().bytes(),
              .otfBytes = window().otfs().kept().bytes()};
    player.pause();
    waitUntilConverged();
    return {first, later, kept};
}

Row WindowUnderTest::edit(const OpacityCurve& curve, const Amount& amount) {
    const SampledCurve whole{sampledOpacities(curve, 256)};
    int edits = 0;
    Row row = follow(amount, [&] {
        SampledCurve edited = whole;
        const double scale = 0.9 + 0.1 * std::sin(0.2 * ++edits);
        for (double& opacity : edited.opacities) opacity *= scale;
        view().setClassification(edited);
    });
    showCurve(curve);
    row.action = "edit";
    return row;
}

Row WindowUnderTest::highQuality(const Amount& amount) {
    std::vector<double> times;
    Row row;
    for (int i = 0; i < amount.views; ++i) {
        FrameRecord record;
        bool made = false, drawn = false;
        QObject context;
        QObject::connect(&view(), &VolumeViewWidget::pictureDelivered, &context, [&](const PictureReport& report) {
            if (made || !isFine(report)) return;
            record.delivered(report);
            made = true;
        });
        QObject::connect(&view(), &VolumeViewWidget::pictureDrawn, &context, [&] {
            if (!made || std::exchange(drawn, true)) return;
            record.drawn();
            record.summarise(row);
            times.push_back(record.milliseconds());
        });
        record.begin();
        view().setView({BeamAxis::plusZ, 180.0 * (2 * i + 1) / amount.views - 180.0, 20.0, 0});
        await("the high-quality picture", [&] { return drawn; });
        waitUntilConverged();
        // What follows sooner would be taken for part of a movement.
        QTest::qWait(movementMilliseconds);
    }
    view().setView({});
    waitUntilConverged();
    row.action = "high quality";
    row.frames = static_cast<int>(times.size());
    row.medianInterval = quantile(times, 0.5);
    row.interval95 = quantile(times, 0.95);
    row.framesPerSecond = row.deliveredPerSecond = 1000.0 / row.medianInterval;
    return row;
}

template <typename Change>
double WindowUnderTest::timeToPicture(const Change& change) {
    const auto before = view().picture();
    std::optional<double> drawn;
    Stopwatch clock;
    QObject context;
    QObject::connect(&view(), &VolumeViewWidget::pictureDrawn, &context, [&] {
        if (!drawn && view().picture() != before && view().pictureIsCurrent()) drawn = clock.milliseconds();
    });
    clock.start();
    change();
    await("a picture of the change", [&] { return drawn.has_value(); });
    waitUntilConverged();
    QTest::qWait(movementMilliseconds);  // what follows sooner would be taken for part of a movement
    return *drawn;
}

QList<Row> WindowUnderTest::editDocument(int edits) {
    trigger("otfEditor.action.active.manual");
    waitUntilConverged();
    std::vector<double> editing, undoing;
    for (int i = 0; i < edits; ++i) {
        editing.push_back(timeToPicture([&] {
            Document next = window().document().document();
            for (CurveNode& node : next.curves.manual.nodes) node.opacity *= 0.8 + 0.1 * std::sin(i);
            window().document().edit(next, "curve");
        }));
        undoing.push_back(timeToPicture([&] { window().document().steps().undo(); }));
    }
    QList<Row> rows;
    for (const auto& [name, times] : {std::pair("edit in document", editing), std::pair("undo in document", undoing)}) {
        Row row;
        row.action = QString::fromLatin1(name);
        row.frames = static_cast<int>(times.size());
        row.medianInterval = quantile(times, 0.5);
        row.interval95 = quantile(times, 0.95);
        row.framesPerSecond = row.deliveredPerSecond = 1000.0 / row.medianInterval;
        rows << row;
    }
    return rows;
}

void WindowUnderTest::takePictures(const QString& folder, const QString& name) {
    view().screenImage().save(QString("%1/%2-rest.png").arg(folder, name));
    const QPoint centre(pictureWindow()->width() / 2, pictureWindow()->height() / 2);
    m_hand = centre;
    QTest::mousePress(pictureWindow(), Qt::LeftButton, {}, centre);
    for (int i = 0; i < 30; ++i) {
        bool delivered = false;
        QObject context;
        QObject::connect(&view(), &VolumeViewWidget::pictureDelivered, &context, [&] { delivered = true; });
        moveHand({});
        await("a picture in motion", [&] { return delivered; });
    }
    view().screenImage().save(QString("%1/%2-motion.png").arg(folder, name));
    QTest::mouseRelease(pictureWindow(), Qt::LeftButton, {}, centre);
    waitUntilConverged();
    view().screenImage().save(QString("%1/%2-rest-there.png").arg(folder, name));
    view().setView({});
    waitUntilConverged();
}

}  // namespace echolucent::bench
