#include <QLocale>

#include "app/explanation.h"
#include "app/main_window.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/method_panel.h"
#include "widgets/panels/motion_panel.h"
#include "widgets/panels/run_status.h"
#include "widgets/panels/study_panel.h"
#include "widgets/panels/view_panel.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

void MainWindow::studyOpened() {
    const Study& study = *m_session.study();
    const VolumeGeometry& geometry = m_session.volume()->geometry();
    QStringList title{tr("Echolucent"), QString::fromStdString(study.name),
                      QStringLiteral("%1×%2×%3").arg(geometry.size[0]).arg(geometry.size[1]).arg(geometry.size[2])};
    title << (geometry.spacingKnown ? tr("%1 mm").arg(geometry.unit(), 0, 'g', 3) : tr("spacing unknown"));
    setWindowTitle(title.join(QStringLiteral(" · ")));

    QList<StudyFactRow> facts;
    for (const ImportFact& fact : study.facts)
        facts << StudyFactRow{QString::fromStdString(fact.name), QString::fromStdString(fact.value),
                              QString::fromStdString(fact.source)};
    QStringList warnings;
    for (const std::string& warning : study.warnings) warnings << QString::fromStdString(warning);
    m_studyPanel->setStudy(facts, warnings);

    QStringList notes{study.lossyCompressed ? tr("lossy compression") : tr("no lossy compression")};
    if (!geometry.spacingKnown) notes << tr("spacing unknown");
    m_runStatus->setNotes(notes);

    if (m_session.isSimulatedScan())
        m_messageBar->showMessage(MessageKind::info, tr("Open a volume, or drop it here. This is a simulated scan."));
    else if (!warnings.isEmpty())
        m_messageBar->showMessage(MessageKind::warning, warnings.join(QStringLiteral(" ")));
    else
        m_messageBar->dismiss();
    if (!m_session.isSimulatedScan()) m_settings.addRecentFile(m_session.path());
}

void MainWindow::volumeChanged() {
    // A new study begins with its first phase; another phase keeps camera, cut and beam axis.
    const bool otherStudy = m_session.study() != m_shownStudy;
    m_newStudy = m_newStudy || otherStudy;
    m_shownStudy = m_session.study();
    m_otfEditor->setHistogram(m_session.histogram());
    m_otfEditor->setWhiteLevel(m_session.volume()->whiteLevel());
    if (otherStudy) {
        m_otfView = Viewpoint{};
        m_shownOtf.reset();
        m_messageBar->setRemark({});
        m_viewPanel->setPhaseCount(static_cast<int>(m_session.study()->phases.size()));
        m_viewPanel->setPhase(0);
        m_viewPanel->setBeamAxis(m_otfView.beamAxis);
        m_viewPanel->setNearCutMm(0);
        beginMotionAtRest();
        showNearCutRange();
    } else if (m_session.phase() == m_motionPlayer.phase()) {
        return;  // a frame of the motion, which knows what follows
    }
    m_methodPanel->clearResult();
    m_runStatus->clearOtf();
    m_motionPlayer.setPhase(m_session.phase());
    const bool oneOtf = m_motionPanel->otf() == MotionOtf::oneOtf;
    computeFor(oneOtf ? m_otfView : motionView());
}

void MainWindow::showNearCutRange() {
    const VolumeGeometry& geometry = m_session.volume()->geometry();
    m_viewPanel->setNearCutRange(depthAlongViewMm(m_otfView, geometry), geometry.spacingKnown);
}

AdaptiveOtfConfig MainWindow::methodConfig() const {
    AdaptiveOtfConfig config = m_methodPanel->config();
    if (m_methodPanel->initialKind() == InitialKind::manual) config.initial = m_otfEditor->state().manual;
    if (m_methodPanel->initialKind() == InitialKind::linear) config.initial = m_otfEditor->state().linear;
    return config;
}

void MainWindow::computeFor(const Viewpoint& view) {
    m_otfView = view;
    m_session.requestOtf(view, methodConfig());
}

void MainWindow::computeForThisView() {
    if (!m_session.volume()) return;
    computeFor(m_volumeView->view());
}

void MainWindow::otfComputed() {
    m_shownOtf = m_session.otf();
    const AdaptiveOtf& otf = *m_shownOtf;
    // Curve first, then volume: the picture is never made of one study's voxels and another's curve.
    m_otfEditor->setAdaptiveCurve(curveToShow(otf));
    m_volumeView->setCurve(m_otfEditor->activeCurve());
    m_methodPanel->showResult(otf);
    m_runStatus->setOtf(otf.times.total, otf.tubesWithSurface, otf.tubesMeetingVolume);
    // Not while it plays: the bar would push the picture up and down.
    if (!m_motionPlayer.isPlaying()) m_messageBar->setRemark(QString::fromStdString(otf.message));
    m_volumeView->setVolume(m_session.volume());
    if (std::exchange(m_newStudy, false)) {
        m_volumeView->setBeamAxis(m_otfView.beamAxis);
        m_volumeView->setNearCut(m_otfView.nearCutMm);
        m_volumeView->resetView(m_otfView);
    }
    if (std::exchange(m_frameWaits, false)) m_volumeView->setView(motionView());
    announceShownFrame();
    updateIdle();
}

void MainWindow::setNearCut(double mm) {
    m_volumeView->setNearCut(mm);
    m_motionStart.nearCutMm = mm;
    Viewpoint view = m_otfView;
    view.nearCutMm = mm;
    // The tubes begin where the picture begins.
    computeFor(view);
}

void MainWindow::suggestNearCut() {
    if (!m_session.volume()) return;
    m_motionPlayer.pause();
    m_nearCutView = m_frameWaits ? motionView() : m_volumeView->view();
    m_lookingForNearCut = true;
    m_runStatus->beginProgress(tr("looking for the near cut"));
    m_session.requestNearCut(m_nearCutView, methodConfig());
}

void MainWindow::takeNearCut(const NearCutSuggestion& suggestion) {
    const QLocale locale;
    const double before = m_viewPanel->nearCutMm();
    if (std::exchange(m_lookingForNearCut, false)) m_runStatus->endProgress();
    if (!suggestion.message.empty()) {
        m_messageBar->showMessage(MessageKind::warning, tr("The near cut stays at %1 mm. %2")
                                                            .arg(locale.toString(before, 'f', 1))
                                                            .arg(QString::fromStdString(suggestion.message)));
        computeFor(m_otfView);  // it may have been under way when the search took its place
        return;
    }
    m_otfView = m_nearCutView;
    showNearCutRange();
    m_viewPanel->setNearCutMm(suggestion.nearCutMm);
    const double cut = m_viewPanel->nearCutMm();  // as the panel rounds it
    setNearCut(cut);
    const QString said = cut > 0 ? tr("Near cut at %1 mm: %2 of %3 tube cores are in fluid there.")
                                       .arg(locale.toString(cut, 'f', 1))
                                       .arg(suggestion.tubesInFluid)
                                       .arg(suggestion.tubesWithSurface)
                                 : tr("Nothing stands in front of the fluid: no near cut is needed.");
    if (cut == before) return m_messageBar->showMessage(MessageKind::info, said);
    const QString old = locale.toString(before, 'f', 1);
    m_messageBar->showMessage(MessageKind::info, said + QLatin1Char(' ') + tr("It was %1 mm before.").arg(old),
                              {{tr("Back to %1 mm").arg(old), [this, before] {
                                    m_viewPanel->setNearCutMm(before);
                                    setNearCut(before);
                                }}});
}

void MainWindow::setBeamAxis(BeamAxis axis) {
    if (!m_session.volume()) return;
    Viewpoint view;
    view.beamAxis = axis;
    m_otfView = view;
    m_viewPanel->setNearCutMm(0);
    showNearCutRange();
    m_volumeView->setBeamAxis(axis);
    m_volumeView->setNearCut(0);
    resetView();
    computeFor(view);
}

void MainWindow::resetView() {
    Viewpoint view;
    view.beamAxis = m_viewPanel->beamAxis();
    view.nearCutMm = m_viewPanel->nearCutMm();
    m_motionPlayer.pause();
    m_motionStart = view;
    m_motionPlayer.setAngle(0);
    m_volumeView->resetView(view);
}

QString MainWindow::explanation() const {
    if (!m_session.volume()) return tr("Nothing is open yet. Open a volume with File > Open volume.");
    return explainPicture({.study = *m_session.study(),
                           .volume = *m_session.volume(),
                           .otf = m_shownOtf.get(),
                           .motion = m_motionPanel->otf(),
                           .view = m_volumeView->view(),
                           .active = m_otfEditor->state().active,
                           .look = m_viewPanel->look(),
                           .simulated = m_session.isSimulatedScan()});
}

}  // namespace echolucent
