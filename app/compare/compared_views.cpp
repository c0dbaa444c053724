#include "app/compare/compared_views.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "app/compare/pane_parameters.h"
#include "app/compare/paper_figures.h"
#include "processing/pane_picture/pane_caster.h"
#include "processing/plots/series_style.h"
#include "widgets/casting/picture_image.h"
#include "widgets/compare/coloured_surfaces.h"
#include "widgets/compare/difference_image.h"
#include "widgets/otf_editor/curve_style.h"

namespace echolucent {

namespace {
constexpr double frameMilliseconds = 40.0;  // the time for a frame while the hand moves
}  // namespace

PaneFace faceOf(const Document& document, std::size_t place) {
    const Pane& choice = document.panes[place];
    PaneFace face{.name = QStringLiteral("%1  %2").arg(place + 1).arg(captionOfPane(document, place))};
    const auto colour = colourOfPane(choice);
    if (!colour) return face;
    // Panes are black in both themes.
    if (*colour >= allCurveKinds.size()) {
        const std::string_view name = colourAt(*colour).onDark;
        face.frame = QColor::fromString(QLatin1StringView(name.data(), static_cast<qsizetype>(name.size())));
        face.frameStyle = Qt::SolidLine;
        return face;
    }
    const CurveKind kind = allCurveKinds[*colour];
    face.frame = curveColor(kind, Theme::dark);
    face.frameStyle = curvePen(kind, false, Theme::dark).style();
    return face;
}

ComparedViews::ComparedViews(const Parts& parts, QObject* parent)
    : QObject(parent), m_parts(parts), m_caster(parts.works, PreviewQuality(frameMilliseconds)) {
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, this, &ComparedViews::forgetStudy);
    connect(&m_parts.panes, &ShownPanes::changed, this, &ComparedViews::follow);
    connect(&m_parts.grid, &CompareGrid::arranged, this, &ComparedViews::follow);
    connect(&m_parts.grid, &CompareGrid::painted, &m_caster, &ProgressiveCaster::drawn);
    connect(&m_caster, &ProgressiveCaster::delivered, this, &ComparedViews::take);
    connect(&m_caster, &ProgressiveCaster::failed, this, &ComparedViews::failed);
}

void ComparedViews::setInsets(bool shown) {
    m_insets = shown;
    showFaces();
}

void ComparedViews::setFullScreen(bool full) {
    m_fullScreen = full;
    m_parts.grid.setLarge(full);
    showFaces();
}

/// The names below the panes that are arranged.
QStringList ComparedViews::names() const {
    const Document& document = m_parts.model.document();
    QStringList names;
    for (std::size_t place = 0; place < document.panes.size(); ++place) names << faceOf(document, place).name;
    if (document.comparison.layout == ComparisonLayout::sideBySide) return names;
    return {tr("on the left: %1, on the right: %2")
                .arg(names[document.comparison.first], names[document.comparison.second])};
}

void ComparedViews::setShown(bool shown) {
    if (std::exchange(m_shown, shown) == shown) return;
    follow();
}

std::vector<std::size_t> ComparedViews::placesWanted() const {
    const Comparison& comparison = m_parts.model.document().comparison;
    if (comparison.layout == ComparisonLayout::sideBySide) return m_parts.grid.shownPanes();
    return {static_cast<std::size_t>(comparison.first), static_cast<std::size_t>(comparison.second)};
}

void ComparedViews::follow() {
    const Document& document = m_parts.model.document();
    const Comparison& comparison = document.comparison;
    m_parts.otfs.setComparing(m_shown && isCompared(document));
    m_waits = false;
    if (!m_shown || !isCompared(document) || !m_parts.openStudy.volume()) return clear();
    m_parts.grid.arrange(comparison.layout, document.panes.size());
    m_parts.grid.setNames(names());
    const QSize size = m_parts.grid.pictureSize();
    if (size.isEmpty()) return stopCasting();
    // While another study's document begins, the panes are still those of the study before, and may be fewer.
    if (m_parts.openStudy.beginning() || !paneAt(document.panes.size() - 1).voxels) {
        m_waits = true;
        return stopCasting();
    }
    m_asked = {};
    bool usable = true;
    for (const std::size_t place : placesWanted()) {
        const ShownPane& pane = paneAt(place);
        usable = usable && pane.ready;
        m_asked.panes.push_back({pane.voxels, pane.classification, place});
    }
    // The camera is that of the first pane, even if another pane has the whole room.
    const auto first = paneAt(firstPane).voxels;
    m_asked.settings = castSettingsOf(document, first->geometry(), first->dataBox(), size.width(), size.height());
    // The panes keep their pictures until the OTFs are there: a pane without an OTF would be black.
    m_waits = !usable && frameHasPanesAsked() && m_study == m_parts.openStudy.study();
    m_study = m_parts.openStudy.study();
    if (!m_waits) m_caster.request(m_asked);
    showFaces();
    if (frameHasPanesAsked()) {
        // A layout may show the same frame with colours, or without.
        if (std::exchange(m_colouredFor, comparison.layout) != comparison.layout) {
            m_pair.reset();
            colourImages();
        }
        showPair();
    }
    emit followed();
}

bool ComparedViews::frameHasPanesAsked() const {
    return m_frame &&
           std::ranges::equal(m_frame->request.panes, m_asked.panes, {}, &PaneRequest::pane, &PaneRequest::pane);
}

bool ComparedViews::frameIsCurrent() const {
    return !m_waits && (m_asked.panes.empty() || (m_frame && samePicture(m_frame->request, m_asked)));
}

void ComparedViews::stopCasting() {
    m_asked = {};
    m_caster.clear();
}

/// Leaves nothing of a closed study or comparison in the panes.
void ComparedViews::clear() {
    stopCasting();
    m_rows.clear();
    m_pair.reset();
    m_images.clear();
    m_shownImages.clear();
    m_colours.clear();
    if (std::exchange(m_frame, nullptr) == nullptr) return;
    for (std::size_t place = 0; place < mostPanes; ++place) {
        m_parts.grid.pane(place).setImage({});
        m_parts.grid.pane(place).setFace({});
    }
    m_parts.grid.pair().setWipe({}, std::nullopt);
    m_parts.grid.pair().setImage({});
    m_parts.grid.pair().setFace({});
    emit followed();
}

void ComparedViews::forgetStudy() {
    clear();
    follow();
}

bool ComparedViews::settled() const {
    const Document& document = m_parts.model.document();
    if (!m_shown || !m_frame || !m_frame->converged() || !frameIsCurrent() || m_caster.busy()) return false;
    for (std::size_t place = 0; place < document.panes.size(); ++place)
        if (!paneAt(place).newest) return false;
    return true;
}

bool ComparedViews::refused() const {
    if (!m_shown || !m_parts.openStudy.volume()) return false;
    for (std::size_t place = 0; place < m_parts.model.document().panes.size(); ++place)
        if (paneAt(place).refused) return true;
    return false;
}

void ComparedViews::take(const std::shared_ptr<const CastPicture>& frame) {
    const auto before = std::exchange(m_frame, frame);
    // Do not show a frame whose panes are not those of the newest request.
    if (!frameHasPanesAsked()) {
        m_frame = before;
        return;
    }
    std::vector<QImage> images;
    for (std::size_t i = 0; i < frame->panes.size(); ++i) {
        // A pane whose pixels are those of the frame before keeps its image.
        const bool stayed = before && i < m_images.size() && before->panes[i].screen == frame->panes[i].screen;
        images.push_back(stayed ? m_images[i] : imageOf(*frame->panes[i].screen));
    }
    m_images = std::move(images);
    colourImages();
    showFrame();
    emit frameShown();
}

const ColouredRays* ComparedViews::coloursAt(std::size_t place) const {
    const bool plain = m_parts.model.document().comparison.layout == ComparisonLayout::difference;
    return plain || place >= m_colours.size() ? nullptr : m_colours[place].get();
}

SurfaceLegend ComparedViews::legendAt(std::size_t place) const {
    const ColouredRays* colours = coloursAt(place);
    if (colours == nullptr) return {};
    ShownDepth depth;
    for (const ShownSurface shown : colours->shown) depth.count(shown);
    return surfaceLegend(depth);
}

bool ComparedViews::coloured() const {
    return m_frame && std::ranges::any_of(m_frame->request.panes,
                                          [this](const PaneRequest& pane) { return coloursAt(pane.pane) != nullptr; });
}

QImage ComparedViews::imageToSave(std::size_t index) const {
    const SurfaceLegend legend = legendAt(m_frame->request.panes.at(index).pane);
    return legend.empty() ? m_shownImages.at(index) : withSurfaceLegend(m_shownImages.at(index), legend);
}

void ComparedViews::setColours(const std::vector<std::shared_ptr<const ColouredRays>>& colours) {
    if (std::exchange(m_colours, colours) == colours || !m_frame) return;
    m_pair.reset();
    colourImages();
    showFrame();
    showFaces();
}

/// The colours lie where the frame's own camera sees the surfaces, also while a newer frame is on its way.
void ComparedViews::colourImages() {
    m_shownImages = m_images;
    std::shared_ptr<const SurfaceRectangles> seen;
    std::vector<std::int32_t> rays;
    for (std::size_t i = 0; i < m_images.size(); ++i) {
        const ColouredRays* colours = coloursAt(m_frame->request.panes[i].pane);
        if (colours == nullptr) continue;
        const QSize size = m_images[i].size();
        // Panes of one phase have the same rays, and all images of a frame one size.
        if (std::exchange(seen, colours->rectangles) != colours->rectangles)
            rays = raysInPicture(m_frame->request.settings.camera, size.width(), size.height(), *seen);
        m_shownImages[i] = colouredSurfaces(m_images[i], rays, colours->shown);
    }
}

void ComparedViews::showFrame() {
    if (m_parts.model.document().comparison.layout != ComparisonLayout::sideBySide) return showPair();
    for (std::size_t i = 0; i < m_shownImages.size(); ++i)
        m_parts.grid.pane(m_frame->request.panes[i].pane).setImage(m_shownImages[i]);
}

void ComparedViews::showPair() {
    const Comparison& comparison = m_parts.model.document().comparison;
    if (comparison.layout == ComparisonLayout::sideBySide || m_shownImages.size() != 2) return;
    const QImage& first = m_shownImages[0];
    const QImage& second = m_shownImages[1];
    ComparePane& pair = m_parts.grid.pair();
    const auto nameAt = [&](int place) {
        const auto at = static_cast<std::size_t>(place);
        return QStringLiteral("%1 %2").arg(place + 1).arg(captionOfPane(m_parts.model.document(), at));
    };
    const QString one = nameAt(comparison.first), other = nameAt(comparison.second);
    // The document changes more often than the pair: do not paint the same pair again.
    ShownPair asked{m_frame, comparison, one, other};
    if (m_pair == asked) return;
    m_pair = std::move(asked);
    if (comparison.layout == ComparisonLayout::difference) {
        const DifferenceImage difference = differenceOf(first, second, comparison.amplification);
        pair.setWipe({}, std::nullopt);
        pair.setImage(difference.image);
        pair.setFace({.name = tr("%1 minus %2").arg(one, other),
                      .numbers = tr("RMSE %1 of 255 levels · difference × %2 · grey is equal")
                                     .arg(difference.rmse, 0, 'f', 2)
                                     .arg(comparison.amplification, 0, 'g', 3)});
    } else {
        pair.setImage(first);
        pair.setWipe(second, comparison.wipe);
        pair.setFace({.name = tr("on the left: %1, on the right: %2").arg(one, other),
                      .numbers = tr("Drag the line, or move it with ← and →"),
                      .legend = coloured() ? surfaceLegend({}) : SurfaceLegend{}});
    }
}

void ComparedViews::showFaces() {
    const Document& document = m_parts.model.document();
    if (!m_shown || !m_parts.openStudy.volume()) return;
    bool pairBusy = false;
    for (std::size_t place = 0; place < document.panes.size(); ++place) {
        PaneFace face = faceOf(document, place);
        face.coloured = document.comparison.colours;
        CompareRow row = place < m_rows.size() ? m_rows[place] : CompareRow{};
        face.numbers = numbersOf(row);
        face.legend = legendAt(place);
        const ShownPane& pane = paneAt(place);
        if (m_insets || m_fullScreen) face.otf = pane.classification;
        const bool busy = !pane.newest && !pane.refused;
        m_parts.grid.pane(place).setFace(face);
        m_parts.grid.pane(place).setBusy(busy);
        pairBusy =
            pairBusy || (busy && std::ranges::find(m_asked.panes, place, &PaneRequest::pane) != m_asked.panes.end());
    }
    m_parts.grid.pair().setBusy(pairBusy);
}

void ComparedViews::addTime(std::size_t place, CompareRow& row) const {
    if (!m_frame || !m_frame->converged()) return;
    const std::vector<PaneRequest>& panes = m_frame->request.panes;
    const auto found = std::ranges::find(panes, place, &PaneRequest::pane);
    if (found != panes.end())
        if (const CastPane& picture = m_frame->panes[static_cast<std::size_t>(found - panes.begin())];
            picture.sampled)  // a picture from kept samples does not measure the OTF
            row.pictureMilliseconds = picture.milliseconds;
}

void ComparedViews::setRows(const std::vector<CompareRow>& rows) {
    m_rows = rows;
    showFaces();
}

}  // namespace echolucent
