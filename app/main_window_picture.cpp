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
            [this] { m_viewPanel->setLight(m_volumeView->light()); });
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
    const auto changed = [this] {
        showLook();
        keepSettings();
    };
    connect(m_viewPanel, &ViewPanel::modeChanged, this, changed);
    connect(m_viewPanel, &ViewPanel::shadedChanged, this, changed);
    connect(m_viewPanel, &ViewPanel::depthColouredChanged, this, changed);
    connect(m_viewPanel, &ViewPanel::colourMapChanged, this, changed);
    connect(m_viewPanel, &ViewPanel::interpolationChanged, this, changed);
    connect(m_viewPanel, &ViewPanel::projectionChanged, this, changed);
    connect(m_viewPanel, &ViewPanel::rendererChanged, this, [this] {
        takeRenderer();
        keepSettings();
    });
    connect(m_viewPanel, &ViewPanel::lightChanged, this, [this](const LightDirection& light) {
        m_volumeView->setLight(light);
        keepSettings();
    });
}

void MainWindow::showLook() {
    Look look = m_volumeView->look();  // the light stays as exact as the hand left it
    look.mode = m_viewPanel->mode();
    look.shaded = m_viewPanel->shaded();
    look.depthColoured = m_viewPanel->depthColoured();
    look.colourMap = m_viewPanel->colourMap();
    look.interpolation = m_viewPanel->interpolation();
    look.projection = m_viewPanel->projection();
    m_volumeView->setLook(look);
}

/// The renderer that the person chose. A graphics card that was chosen on another machine, or is not known yet, is left
/// to the view's own judgement.
void MainWindow::takeRenderer() {
    const bool usable = m_volumeView->graphicsCardUsable();
    m_viewPanel->setGraphicsCardUsable(usable);
    const PreferredRenderer chosen = m_viewPanel->renderer();
    const bool impossible = chosen == PreferredRenderer::graphicsCard && !usable;
    m_volumeView->setRenderer(impossible ? PreferredRenderer::automatic : chosen);
}

void MainWindow::restoreLook() {
    m_viewPanel->setMode(m_settings.mode());
    m_viewPanel->setShaded(m_settings.shaded());
    m_viewPanel->setLight(m_settings.light());
    m_viewPanel->setDepthColoured(m_settings.depthColoured());
    m_viewPanel->setColourMap(m_settings.colourMap());
    m_viewPanel->setInterpolation(m_settings.interpolation());
    m_viewPanel->setProjection(m_settings.projection());
    m_viewPanel->setRenderer(m_settings.renderer());
    m_volumeView->setLight(m_viewPanel->light());
    takeRenderer();
    showLook();
}

void MainWindow::keepLook() {
    m_settings.setMode(m_viewPanel->mode());
    m_settings.setShaded(m_viewPanel->shaded());
    m_settings.setLight(m_viewPanel->light());
    m_settings.setDepthColoured(m_viewPanel->depthColoured());
    m_settings.setColourMap(m_viewPanel->colourMap());
    m_settings.setInterpolation(m_viewPanel->interpolation());
    m_settings.setProjection(m_viewPanel->projection());
    m_settings.setRenderer(m_viewPanel->renderer());
}

}  // namespace echolucent
