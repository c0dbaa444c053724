#include "app/picture/picture_controls.h"

#include <algorithm>

#include "app/picture/picture_status.h"
#include "processing/document/box_editing.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/controls/run_status.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/view_panel.h"

namespace echolucent {

namespace {

/// The name of a step that changes a look: "colour map".
QString nameOfChange(const Look& before, const Look& after) {
    for (const Parameter<Look>& row : lookParameters())
        if (row.get(before) != row.get(after)) return textOf(row.label).toLower();
    return {};
}

}  // namespace

PictureControls::PictureControls(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
    connectPanel();
    connectPicture();
    for (const auto part : {&DocumentModel::lookChanged, &DocumentModel::frontChanged, &DocumentModel::beamChanged})
        connect(&m_parts.model, part, this, &PictureControls::showDocument);
}

void PictureControls::connectPanel() {
    const ViewPanel* panel = &m_parts.panel;
    connect(panel, &ViewPanel::frontChanged, this, [this](double mm) {
        if (!hasStudy()) return showDocument();
        const std::shared_ptr<const Volume> volume = m_parts.openStudy.volume();
        if (!volume) return showDocument();
        m_parts.model.change(tr("front"), [&](Document& next) { setDepth(next, mm, volume->geometry()); });
    });
    connect(panel, &ViewPanel::beamAxisChanged, this, &PictureControls::setBeamAxis);
    connect(panel, &ViewPanel::lookChanged, this, &PictureControls::setLook);
    connect(panel, &ViewPanel::lightAmountChanged, this, [this](const Look& look) {
        m_parts.model.change(tr("light"), [&look](Document& next) { next.scene.look = look; });
        keep();
    });
    connect(panel, &ViewPanel::lookReset, this, [this](const Look& look, const QString& group) {
        m_parts.model.change(tr("reset %1").arg(group.toLower()), [&look](Document& next) { next.scene.look = look; });
        keep();
    });
    connect(panel, &ViewPanel::rendererChanged, this, [this] {
        takeRenderer();
        keep();
    });
}

void PictureControls::connectPicture() {
    connect(&m_parts.picture, &VolumeViewWidget::pointed, this, [this](auto intensity, auto opacity) {
        m_parts.status.setPointed(intensity, opacity);
        m_parts.editor.setCursorIntensity(intensity);
    });
    connect(&m_parts.picture, &VolumeViewWidget::pictureDelivered, this, &PictureControls::tellPicture);
}

/// Moves the front along its own forward. A flat front that was moved to 0 is gone; if the slider brings one back
/// before anything else changes, it has the direction of the one before.
void PictureControls::setDepth(Document& next, double mm, const VolumeGeometry& geometry) {
    Front& front = next.scene.front;
    if (cuts(front)) {
        m_goneFront = front.surface ? std::nullopt : std::optional(front.direction);
        m_goneFrom = next.scene.pose;
        front = movedTo(std::move(front), mm, geometry);
    } else {
        const bool comesBack = m_goneFront && m_goneFrom == next.scene.pose;
        front = frontAcross(comesBack ? *m_goneFront : shownPose(next).direction, mm);
    }
}

/// Whether a study is open. Without one there is nothing to cut and no beam.
bool PictureControls::hasStudy() const {
    return !std::holds_alternative<std::monostate>(m_parts.model.document().study);
}

void PictureControls::setLook(const Look& look) {
    m_parts.model.change(nameOfChange(m_parts.model.document().scene.look, look),
                         [&look](Document& next) { next.scene.look = look; });
    keep();
}

void PictureControls::reduceSpeckle(int levels) {
    Look look = m_parts.model.document().scene.look;
    constexpr int strongest = static_cast<int>(allSpeckleReductions.size()) - 1;
    look.reduction = static_cast<SpeckleReduction>(std::clamp(static_cast<int>(look.reduction) + levels, 0, strongest));
    setLook(look);
}

void PictureControls::nextLighting() {
    Look look = m_parts.model.document().scene.look;
    constexpr int kinds = static_cast<int>(Lighting::depth) + 1;
    look.lighting = static_cast<Lighting>((static_cast<int>(look.lighting) + 1) % kinds);
    setLook(look);
}

void PictureControls::setBeamAxis(BeamAxis axis) {
    if (!hasStudy()) return showDocument();
    m_parts.model.change(tr("beam axis"), [this, axis](Document& next) {
        next = withBeam(std::move(next), {axis, BeamSource::person});
        next.scene.front = Front{};
        next.scene.pose = m_parts.picture.wholeVolume(Viewpoint{.beamAxis = axis});
        next.scene.side = ViewDirection{};
        next.scene.motionAngle = 0.0;
    });
}

void PictureControls::resetView(const ViewDirection& direction) {
    m_parts.model.change(tr("reset view"), [&](Document& next) {
        next.scene.pose = m_parts.picture.wholeVolume(viewpointOf(next.beam.axis, direction));
    });
}

void PictureControls::resetAll(const Document& opened) {
    m_parts.model.change(tr("reset all"), [this, &opened](Document& next) {
        next.beam = opened.beam;
        next.curves = opened.curves;
        next.scene.side = opened.scene.side;
        next.scene.motionAngle = 0.0;
        next = withCurve(std::move(next), firstPane, opened.panes.at(firstPane).curve);
        next.panes.front().linear.reset();
        next.scene.front = opened.scene.front;
        next.scene.look = opened.scene.look;
        next.scene.exposure = opened.scene.exposure;
        next.scene.box = opened.scene.box;
        next.scene.planes = opened.scene.planes;
        next.scene.strokes = opened.scene.strokes;
        const Viewpoint fromSide = viewpointOf(next.beam.axis, opened.scene.side);
        const VolumeViewWidget& picture = m_parts.picture;
        next.scene.pose = picture.volume() ? picture.wholeVolume(fromSide, picture.volume()->dataBox())
                                           : picture.wholeVolume(fromSide);
    });
    keep();
}

void PictureControls::resetFront(const Front& front) {
    m_parts.model.change(tr("reset front"), [&front](Document& next) { next.scene.front = front; });
}

void PictureControls::showDocument() {
    const Document& document = m_parts.model.document();
    if (!m_parts.openStudy.volume()) m_parts.panel.setFrontMm(0.0);
    m_parts.panel.setBeamAxis(document.beam.axis);
    m_parts.panel.setLook(document.scene.look);
    m_parts.panel.setFrontThere(cuts(document.scene.front));
}

/// Takes the person's choice of renderer. If the choice is a graphics card that is not usable (that of another machine,
/// or one not known yet), the view chooses by itself.
void PictureControls::takeRenderer() {
    const bool usable = m_parts.picture.graphicsCardUsable();
    m_parts.panel.setGraphicsCardUsable(usable);
    const RendererChoice chosen = m_parts.panel.renderer();
    const bool impossible = chosen == RendererChoice::graphicsCard && !usable;
    m_parts.picture.setRenderer(impossible ? RendererChoice::automatic : chosen);
}

void PictureControls::tellPicture(const PictureReport& report) {
    if (report.framesPerSecond && report.followsHand) m_movement = report;
    m_newest = report;
    report.followsHand && !report.converged ? m_cost.tell() : m_cost.tellNow();
    takeRenderer();
}

void PictureControls::showCost() {
    m_parts.status.setRenderer(
        m_parts.picture.rendererName(), m_newest.castMilliseconds + m_newest.drawMilliseconds,
        pictureToolTip(m_newest, m_movement) + QLatin1Char('\n') + m_parts.picture.rendererRemark());
}

void PictureControls::restore() {
    Document document = m_parts.model.document();
    document.scene.look = m_parts.settings.look();
    m_parts.model.begin(document);
    showDocument();
    m_parts.panel.setRenderer(m_parts.settings.renderer());
    takeRenderer();
}

void PictureControls::keep() {
    m_parts.settings.setLook(m_parts.model.document().scene.look);
    m_parts.settings.setRenderer(m_parts.panel.renderer());
}

}  // namespace echolucent
