#include "app/compare/lesson_figures.h"

#include <QDockWidget>
#include <QMainWindow>
#include <utility>

#include "app/compare/paper_figures.h"
#include "app/motion/motion_player.h"
#include "widgets/controls/message_bar.h"
#include "widgets/otf_editor/otf_editor.h"

namespace echolucent {

namespace {
constexpr const char* figureTopic = "figure of the paper";
}  // namespace

LessonFigures::LessonFigures(const Parts& parts, const Work& work, QObject* parent)
    : QObject(parent), m_parts(parts), m_underWay(parts.works, withCancel(work, [this] { cancel(); })) {
    connect(&m_parts.openStudy, &OpenStudy::loadingBegun, this, &LessonFigures::cancel);
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, this, [this] {
        const int figure = std::exchange(m_waits, 0);
        const bool opened = nameTheSame(m_parts.openStudy.reference(), m_scan);
        cancel();
        if (figure != 0 && opened) setUpFigure(figure);
    });
    // The next frame would change what its receivers still follow.
    connect(&m_parts.panes, &ShownPanes::changed, this, &LessonFigures::showNextFrame, Qt::QueuedConnection);
    connect(&m_parts.player, &MotionPlayer::playingChanged, this, [this](bool playing) {
        if (playing) cancel();
    });
}

void LessonFigures::show(int figure, const std::optional<SimulatedScan>& scan) {
    cancel();
    m_parts.messages.takeBack(figureTopic);
    if (!scan || nameTheSame(m_parts.openStudy.reference(), *scan)) return setUpFigure(figure);
    m_parts.openStudy.study() != nullptr ? ask(figure, *scan) : open(figure, *scan);
}

void LessonFigures::ask(int figure, const SimulatedScan& scan) {
    const bool fetus = scan.scene == PhantomScene::fetus;
    m_parts.messages.showMessage(
        MessageKind::info,
        tr("Figure %1 on the %2 opens another study. What nobody saved of this one stays in File > Left unsaved.")
            .arg(figure)
            .arg(fetus ? tr("simulated fetus") : tr("simulated shapes")),
        MessageEnd::withStudy(figureTopic),
        {{fetus ? tr("Open the simulated fetus") : tr("Open the simulated shapes"),
          [this, figure, scan] { open(figure, scan); }}});
}

void LessonFigures::open(int figure, const SimulatedScan& scan) {
    m_parts.openStudy.openSimulatedScan(scan);
    m_waits = figure;  // what was asked for before waits no longer
    m_scan = scan;
}

void LessonFigures::cancel() {
    m_waits = 0;
    m_frames.clear();
    m_shown.reset();
    m_underWay.end();
}

void LessonFigures::setUpFigure(int number) {
    if (m_parts.openStudy.study() == nullptr) return;
    m_parts.player.pause();
    const PaperFigure& figure = paperFigure(number);
    const Document wanted = withFigure(m_parts.model.ownDocument(), number);
    m_parts.model.editWithFrame(wanted, tr("Figure %1 of the paper").arg(number));
    // If the motion stood at this angle about another axis, the other axis has begun it anew.
    m_parts.model.showFrame(wanted.scene.motionAngle, wanted.scene.phase);
    emit setUp();
    if (number == 6) showCurvesOfFigure6();
    bringToFront(QLatin1String(figure.dock));
    m_frames.assign(figure.frames.begin(), figure.frames.end());
    if (m_frames.empty()) return;
    m_shown = static_cast<int>(m_parts.player.angle());
    m_underWay.begin();
    showNextFrame();
}

/// Which curves the editor draws is no part of the document.
void LessonFigures::showCurvesOfFigure6() {
    for (const CurveKind kind : allCurveKinds)
        m_parts.editor.model().setVisible(kind, kind != CurveKind::manual && kind != CurveKind::quartic);
}

void LessonFigures::bringToFront(const QString& dock) {
    auto* found = dock.isEmpty() ? nullptr : m_parts.window.findChild<QDockWidget*>(dock);
    if (found == nullptr) return;
    found->show();
    found->raise();
}

void LessonFigures::showNextFrame() {
    if (m_frames.empty()) return;
    // A hand or an undo has moved the motion.
    if (m_parts.model.document().scene.motionAngle != m_shown) return cancel();
    if (m_parts.otfs.isAnyRefused()) return cancel();
    const std::size_t panes = m_parts.otfs.comparing() ? m_parts.model.document().panes.size() : 1;
    for (std::size_t pane = 0; pane < panes; ++pane)
        if (!m_parts.panes.at(pane).newest) return;
    if (!m_parts.otfs.isNewest(PaneOtfs::adaptiveOfScene)) return;
    m_shown = m_frames.front();
    m_frames.pop_front();
    m_parts.player.setAngle(*m_shown);
    if (m_frames.empty()) cancel();
}

}  // namespace echolucent
