#include "app/compare/compare_hand.h"

namespace echolucent {

CompareHand::CompareHand(DocumentModel& model, OpenStudy& openStudy, CompareGrid& grid, QObject* parent)
    : QObject(parent), m_model(model), m_openStudy(openStudy), m_grid(grid) {
    connect(&m_grid, &CompareGrid::orbited, this, [this](double right, double down) {
        moveCamera([=](const CameraPose& camera, const ZoomLimits&) { return orbited(camera, right, down); });
    });
    connect(&m_grid, &CompareGrid::panned, this, [this](double right, double down) {
        moveCamera([=](const CameraPose& camera, const ZoomLimits&) { return panned(camera, right, down); });
    });
    connect(&m_grid, &CompareGrid::zoomed, this, [this](double factor) {
        moveCamera([=](const CameraPose& camera, const ZoomLimits& limits) { return zoomed(camera, factor, limits); });
    });
    connect(&m_grid, &CompareGrid::zoomedAbout, this, [this](double right, double down, double factor) {
        moveCamera([=](const CameraPose& camera, const ZoomLimits& limits) {
            return zoomedAbout(camera, right, down, factor, limits);
        });
    });
    connect(&m_grid, &CompareGrid::lightMoved, this, &CompareHand::moveLight);
    connect(&m_grid, &CompareGrid::wipeMoved, this, [this](double share) {
        Document next = m_model.document();
        next.comparison.wipe = share;
        m_model.take(next, tr("move the wipe"), m_grid.dragging());
    });
    connect(&m_grid, &CompareGrid::dragEnded, &m_model, &DocumentModel::commitPreview);
    connect(&m_grid, &CompareGrid::dragCancelled, &m_model, &DocumentModel::cancelPreview);
}

void CompareHand::moveCamera(
    const std::function<CameraPose(const CameraPose& camera, const ZoomLimits& limits)>& move) {
    const auto volume = m_openStudy.volume();
    const QSize size = m_grid.pictureSize();
    if (!volume || size.isEmpty()) return;
    const Document& document = m_model.document();
    const Pose shown = shownPose(document);
    const double aspect = static_cast<double>(size.width()) / size.height();
    const CameraPose before =
        cameraPoseOf(shown, document.beam.axis, volume->dataBox(), document.scene.look.projection, aspect);
    const CameraPose after = move(before, zoomLimits(volume->geometry()));
    const Pose moved = movedPose(shown, before, after, volume->dataBox(), aspect);
    if (moved == shown) return;
    m_model.moveCamera(moved, m_grid.dragging());
    emit cameraMoved();
}

void CompareHand::moveLight(double right, double down) {
    Document next = m_model.document();
    Look& look = next.scene.look;
    if (look.lighting == Lighting::flat || look.mode != RenderMode::direct) return;
    look.light = moved(look.light, right, down);
    m_model.take(next, tr("move light"), m_grid.dragging());
}

}  // namespace echolucent
