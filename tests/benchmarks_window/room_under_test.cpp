#include "tests/benchmarks_window/room_under_test.h"

#include <QMouseEvent>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "processing/document/box_editing.h"
#include "widgets/planes/pane_grid.h"

namespace echolucent::bench {

namespace {

constexpr double warmUp = 1000;       // ms; the quality follows the cost of the frames before
constexpr double boxShare = 0.9;      // of the data along each axis
constexpr double nearCutShare = 0.1;  // of the depth
constexpr double handRadius = 60;     // pixels of the circle or line on which the hand goes
// No two places lie level, or one upon the other: each move changes both planes that it moves.
constexpr double degreesPerMove = 6.1803;

/// Calls back when a widget is about to be painted.
class PaintWatch : public QObject {
public:
    explicit PaintWatch(std::function<void(QObject*)> painted) : m_painted(std::move(painted)) {}
    bool eventFilter(QObject* watched, QEvent* event) override {
        if (event->type() == QEvent::Paint) m_painted(watched);
        return false;
    }

private:
    std::function<void(QObject*)> m_painted;
};

}  // namespace

RoomUnderTest::RoomUnderTest(const QString& volume, int edge) {
    auto* grid = child<PaneGrid>(QStringLiteral("panes"));
    trigger(QStringLiteral("room.quad"));
    const int logical = static_cast<int>(std::lround(edge / window().devicePixelRatioF()));
    constexpr int gap = 3;  // between panes
    grid->setFixedSize(2 * logical + gap, 2 * logical + gap);
    window().adjustSize();
    show();
    // The panes' upper edge is the screen's: as much of them is on it as there is room for.
    window().move(0, -grid->mapTo(&window(), QPoint(0, 0)).y());
    for (const PlaneName plane : allPlaneNames)
        m_panes[indexOf(plane)] =
            child<PlanePane>(QStringLiteral("planes.") + QChar(u'a' + static_cast<int>(indexOf(plane))));
    openVolume(volume);
    await("the size asked for", [&] { return view().settings().width == edge && view().settings().height == edge; });
    waitUntilConverged();
}

void RoomUnderTest::switchEverythingOn() {
    const std::shared_ptr<const Volume> volume = window().openStudy().volume();
    Document next = withBoxSwitched(window().document().document(), true, volume->dataBox());
    next.scene.box.sizeMm *= boxShare;
    next.scene.front = {};
    next.scene.front.depthMm = nearCutShare * depthAlongViewMm(otfViewpointOf(next, firstPane), volume->geometry());
    next.scene.look = lookAtStart();  // quiet voxels and light that tells depth
    next.scene.planes.linesIn3d = true;
    next.panes.at(firstPane).curve = CurveKind::adaptive;
    window().document().edit(next, QStringLiteral("everything"));
    waitUntilConverged();
    drawStroke();
    waitUntilConverged();
    if (!window().openStudy().volume()->isCut()) qFatal("the stroke cut nothing");
}

RoomUnderTest::Painted RoomUnderTest::presentOf(const PlanePane& pane) {
    const auto& scene = pane.scene();
    return scene ? Painted{scene->planes, scene->box.box, pane.image().cacheKey()} : Painted{};
}

bool RoomUnderTest::updated(Watched watched) const {
    const auto all = [this](const auto& isNew) {
        return std::ranges::all_of(allPlaneNames, [&](PlaneName plane) {
            return isNew(plane, m_painted[indexOf(plane)], m_before[indexOf(plane)]);
        });
    };
    switch (watched) {
        case Watched::camera: return m_deliveredDrawn;
        case Watched::box:
            return m_deliveredDrawn &&
                   all([](PlaneName, const Painted& now, const Painted& before) { return now.box != before.box; });
        case Watched::reference: break;
    }
    // What is dragged within plane A is seen in the same voxels there.
    const bool lines = window().document().document().scene.planes.linesIn3d;
    return (m_drawn || !lines) && all([](PlaneName plane, const Painted& now, const Painted& before) {
               return now.planes != before.planes && (plane == PlaneName::a || now.image != before.image);
           });
}

void RoomUnderTest::beginUpdate() {
    m_before = m_painted;
    m_delivered = m_deliveredDrawn = m_drawn = false;
}

Row RoomUnderTest::follow(Watched watched, const Amount& amount, const std::function<void()>& move) {
    FrameRecord record;
    for (const PlaneName plane : allPlaneNames) m_painted[indexOf(plane)] = presentOf(*m_panes[indexOf(plane)]);
    beginUpdate();
    QObject context;
    const auto lookAgain = [&] {
        if (!updated(watched)) return;
        record.drawn();
        beginUpdate();
        // Not here: a pane is being painted.
        QMetaObject::invokeMethod(&context, move, Qt::QueuedConnection);
    };
    PaintWatch watch([&](QObject* pane) {
        const auto at = std::ranges::find(m_panes, pane);
        m_painted[static_cast<std::size_t>(at - m_panes.begin())] = presentOf(**at);
        lookAgain();
    });
    for (PlanePane* pane : m_panes) pane->installEventFilter(&watch);
    QObject::connect(&view(), &VolumeViewWidget::pictureDelivered, &context, [&](const PictureReport& report) {
        record.delivered(report);
        m_delivered = true;
    });
    QObject::connect(&view(), &VolumeViewWidget::pictureDrawn, &context, [&] {
        m_drawn = true;
        m_deliveredDrawn = m_delivered;
        lookAgain();
    });
    bool measuring = false;
    const auto enough = [&] {
        if (!measuring && (amount.frames > 0 || record.milliseconds() > warmUp)) {
            measuring = true;
            record.begin();
        }
        if (amount.frames > 0) return record.drawnFrames() >= amount.frames;
        return measuring && record.milliseconds() > amount.seconds * 1e3;
    };
    record.begin();
    move();
    QCoreApplication::processEvents();  // this one is being made when the next one comes
    move();
    while (!enough()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents);
    Row row;
    record.summarise(row);
    return row;
}

void RoomUnderTest::send(QEvent::Type type, const QPointF& place) {
    PlanePane& pane = *m_panes[indexOf(PlaneName::a)];
    const bool move = type == QEvent::MouseMove, release = type == QEvent::MouseButtonRelease;
    QMouseEvent event(type, place, pane.mapToGlobal(place), move ? Qt::NoButton : Qt::LeftButton,
                      release ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&pane, &event);
}

Row RoomUnderTest::dragInPlane(Watched watched, const QPointF& from, const Amount& amount,
                               const std::function<QPointF(int)>& placeOfMove) {
    send(QEvent::MouseButtonPress, from);
    int moves = 0;
    Row row = follow(watched, amount, [&] { send(QEvent::MouseMove, placeOfMove(++moves)); });
    send(QEvent::MouseButtonRelease, placeOfMove(moves));
    waitUntilConverged();
    return row;
}

Row RoomUnderTest::dragReference(const Amount& amount) {
    const PlanePane& pane = *m_panes[indexOf(PlaneName::a)];
    const double reach = std::min(handRadius, pane.width() / 5.0);
    const auto place = [&](int move) {
        const double angle = (move * degreesPerMove + 45.0) * std::numbers::pi / 180.0;
        return QPointF(pane.rect().center()) + QPointF(std::cos(angle), std::sin(angle)) * reach;
    };
    if (gripAt(pane.drawing(), place(0))) qFatal("something of the box lies where the reference point is dragged");
    Row row = dragInPlane(Watched::reference, place(0), amount, place);
    row.action = QStringLiteral("reference");
    return row;
}

Row RoomUnderTest::dragBox(const Amount& amount) {
    const PlanePane& pane = *m_panes[indexOf(PlaneName::a)];
    const BoxDrawing& drawing = pane.drawing();
    const auto side =
        std::ranges::find_if(drawing.grips, [](const BoxGrip& grip) { return grip.kind == BoxGrip::Kind::face; });
    if (side == drawing.grips.end()) qFatal("the box has no side in plane A");
    const QPointF from = side->at, inwards = QPointF(pane.rect().center()) - from;
    const double reach = std::min(handRadius, pane.width() / 5.0) / std::hypot(inwards.x(), inwards.y());
    Row row = dragInPlane(Watched::box, from, amount, [=](int move) {
        return from + inwards * (reach * (0.5 - 0.5 * std::cos(move * degreesPerMove * std::numbers::pi / 180.0)));
    });
    row.action = QStringLiteral("box");
    return row;
}

Row RoomUnderTest::orbit(const Amount& amount) {
    QWindow* surface = pictureWindow();
    // Beside the grips of the box, which would be dragged instead.
    QPointF hand(0.06 * surface->width(), 0.94 * surface->height());
    QTest::mousePress(surface, Qt::LeftButton, {}, hand.toPoint());
    Row row = follow(Watched::camera, amount, [&] {
        hand += QPointF(surface->height() / 180.0, 0);
        QMouseEvent move(QEvent::MouseMove, hand, surface->mapToGlobal(hand), Qt::NoButton, Qt::LeftButton, {});
        QCoreApplication::sendEvent(surface, &move);
    });
    QTest::mouseRelease(surface, Qt::LeftButton, {}, hand.toPoint());
    waitUntilConverged();
    row.action = QStringLiteral("orbit in quad");
    return row;
}

}  // namespace echolucent::bench
