#include "app/main_window.h"
#include "app/picture_status.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/run_status.h"
#include "widgets/panels/view_panel.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

void MainWindow::connectPicture() {
    connect(m_volumeView, &VolumeViewWidget::cameraChanged, this, &MainWindow::cameraMovedByPerson);
    connect(m_volumeView, &VolumeViewWidget::lightChanged, this,
            [this] { m_viewPanel->setLook(m_volumeView->look()); });
    connect(m_volumeView, &VolumeViewWidget::busyChanged, this, [this] {
        announceShownFrame();
        updateIdle();
    });
    connect(m_volumeView, &VolumeViewWidget::pointed, this, [this](auto intensity, auto opacity) {
        m_runStatus->setPointed(intensity, opacity);
        m_otfEditor->setCursorIntensity(intensity);
    });
    connect(m_volumeView, &VolumeViewWidget::filesDropped, this,
            [this](const QStringList& files) { open(files.first()); });
    connect(m_volumeView, &VolumeViewWidget::pictureDelivered, this, [this](const PictureReport& report) {
        if (report.framesPerSecond && report.followsHand) m_movement = report;
        m_runStatus->setRenderer(
            m_volumeView->rendererName(), report.castMilliseconds + report.drawMilliseconds,
            pictureToolTip(report, m_movement) + QLatin1Char('\n') + m_volumeView->rendererRemark());
        takeRenderer();
        announceShownFrame();
        updateIdle();
    });

    connect(m_viewPanel, &ViewPanel::nearCutChanged, this, &MainWindow::setNearCut);
    connect(m_viewPanel, &ViewPanel::nearCutSuggestionRequested, this, &MainWindow::suggestNearCut);
    connect(m_viewPanel, &ViewPanel::beamAxisChanged, this, &MainWindow::setBeamAxis);
    connect(m_viewPanel, &ViewPanel::phaseChanged, &m_session, &Session::setPhase);
    connect(m_viewPanel, &ViewPanel::resetRequested, this, &MainWindow::resetView);
    connect(m_viewPanel, &ViewPanel::savePictureRequested, this, &MainWindow::chooseAndSavePicture);
    connectLook();
}

void MainWindow::connectLook() {
    connect(m_viewPanel, &ViewPanel::lookChanged, this, [this](const Look& look) {
        m_volumeView->setLook(look);
        keepSettings();
    });
    connect(m_viewPanel, &ViewPanel::rendererChanged, this, [this] {
        takeRenderer();
        keepSettings();
    });
}

/// The renderer that the person chose. A graphics card that was chosen on another machine, or is not known yet, is left
/// to the view's own judgement.
void MainWindow::takeRenderer() {
    const bool usable = m_volumeView->graphicsCardUsable();
    m_viewPanel->setGraphicsCardUsable(usable);
    const RendererChoice chosen = m_viewPanel->renderer();
    const bool impossible = chosen == RendererChoice::graphicsCard && !usable;
    m_volumeView->setRenderer(impossible ? RendererChoice::automatic : chosen);
}

void MainWindow::restoreLook() {
    m_viewPanel->setLook(m_settings.look());
    m_viewPanel->setRenderer(m_settings.renderer());
    takeRenderer();
    m_volumeView->setLook(m_viewPanel->look());
}

void MainWindow::keepLook() {
    m_settings.setLook(m_viewPanel->look());
    m_settings.setRenderer(m_viewPanel->renderer());
}

}  // namespace echolucent
