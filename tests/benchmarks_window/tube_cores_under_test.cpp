#include "tests/benchmarks_window/tube_cores_under_test.h"

#include <QDockWidget>
#include <QScrollArea>
#include <QSlider>
#include <QTest>
#include <QToolButton>
#include <random>

#include "app/explain/tube_core_choice.h"
#include "app/explain/tube_core_explaining.h"
#include "widgets/tube_cores/tube_core_map.h"

namespace echolucent::bench {

namespace {

/// Whether a widget was painted since reset(). Qt paints all that waits for it, and shows it, in one go.
class Painted : public QObject {
public:
    explicit Painted(QWidget& widget) { widget.installEventFilter(this); }
    void reset() { m_is = false; }
    [[nodiscard]] bool is() const { return m_is; }

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        m_is |= event->type() == QEvent::Paint;
        return false;
    }

private:
    bool m_is = false;
};

/// Runs the event loop until `done`, which is asked behind every event.
void awaitAtOnce(const std::function<bool()>& done) {
    while (!done()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents);
}

}  // namespace

TubeCoresUnderTest::TubeCoresUnderTest(const QString& volume) {
    window().resize(1280, 720);
    show();
    openVolume(volume);
    child<QToolButton>("face.teach")->click();
    child<QDockWidget>("dock.tubeCores")->show();
    child<QDockWidget>("dock.tubeCores")->raise();
    window().tubeCoreChoice().setShown(true);
    waitUntilConverged();
}

/// What lies outside the panel's frame is not painted.
void TubeCoresUnderTest::bringIntoView(const QString& name) const {
    child<QDockWidget>("dock.tubeCores")->findChild<QScrollArea*>()->ensureWidgetVisible(child<QWidget>(name));
}

Row TubeCoresUnderTest::rowOf(const QString& action, const std::vector<double>& milliseconds) const {
    Row row;
    row.action = action;
    row.edge = view().settings().height;
    row.shaded = true;
    row.frames = static_cast<int>(milliseconds.size());
    row.medianInterval = quantile(milliseconds, 0.5);
    row.interval95 = quantile(milliseconds, 0.95);
    row.framesPerSecond = row.deliveredPerSecond = 1000.0 / row.medianInterval;
    return row;
}

Row TubeCoresUnderTest::explain(int clicks) {
    auto* map = child<TubeCoreMap>("tubeCores.map");
    Painted facts(*child<QWidget>("tubeCores.facts")->findChild<QWidget*>("qt_scrollarea_viewport"));
    bringIntoView("tubeCores.facts");
    std::mt19937 random(50);
    std::vector<double> times;
    const auto tubes = static_cast<unsigned>(window().otfs().adaptive()->tubes.size());
    for (int i = 0; i <= clicks; ++i) {
        const int number = static_cast<int>(random() % tubes);
        if (number == window().tubeCoreChoice().number()) continue;
        bool drawn = false, explained = false;
        QObject context;
        QObject::connect(&view(), &VolumeViewWidget::pictureDrawn, &context, [&] { drawn = true; });
        QObject::connect(&window().tubeCoreExplaining(), &TubeCoreExplaining::explained, &context, [&] {
            explained = window().tubeCoreExplaining().explanation()->explanation->number == number;
            facts.reset();
        });
        Stopwatch clock;
        clock.start();
        QTest::mouseClick(map, Qt::LeftButton, {}, map->cellOf(number).center().toPoint());
        awaitAtOnce([&] { return drawn && explained && facts.is(); });
        if (i > 0) times.push_back(clock.milliseconds());  // the first lays the panel out
        waitUntilConverged();
    }
    return rowOf(QStringLiteral("explain"), times);
}

Row TubeCoresUnderTest::grow(const Amount& amount) {
    auto* slider = child<QSlider>("tubeCores.growth");
    Painted curves(*child<QWidget>("tubeCores.plot.curves"));
    slider->setFocus();
    bringIntoView("tubeCores.plot.curves");
    std::vector<double> times;
    Stopwatch all;
    all.start();
    const auto enough = [&] {
        return amount.frames > 0 ? static_cast<int>(times.size()) >= amount.frames
                                 : all.milliseconds() > amount.seconds * 1e3;
    };
    bool fewer = true;
    while (!enough()) {
        if (slider->value() == slider->maximum()) fewer = true;
        if (slider->value() == slider->minimum()) fewer = false;
        Stopwatch clock;
        clock.start();
        curves.reset();
        QTest::keyClick(slider, fewer ? Qt::Key_Left : Qt::Key_Right);
        awaitAtOnce([&] { return curves.is(); });
        times.push_back(clock.milliseconds());
    }
    return rowOf(QStringLiteral("grow"), times);
}

}  // namespace echolucent::bench
