#include "app/compare/compared_views.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "processing/document/view_caster.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/compare/difference_image.h"
#include "widgets/otf_editor/canvas/curve_style.h"

namespace echolucent {

namespace {

/// A curve has its colour and dashes wherever it is shown; a designer's OTF has none.
PaneFace faceOf(std::size_t place, const Pane& choice) {
    PaneFace face{.name = QStringLiteral("%1  %2").arg(place + 1).arg(nameOfPane(choice))};
    const bool adaptive = choice.designer && designerOf(*choice.designer) == Designer::adaptive;
    if (choice.designer && !adaptive) return face;
    const CurveKind kind = adaptive ? CurveKind::adaptive : choice.curve;
    // Panes are on black in both themes.
    face.frame = curveColor(kind, Theme::dark);
    face.frameStyle = curvePen(kind, false, Theme::dark).style();
    return face;
}

}  // namespace

ComparedViews::ComparedViews(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
    connect(&m_parts.model, &DocumentModel::changed, this, &ComparedViews::follow);
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, this, &ComparedViews::forgetStudy);
    connect(&m_parts.openStudy, &OpenStudy::volumeChanged, this, &ComparedViews::follow);
    connect(&m_parts.openStudy, &OpenStudy::volumeCut, this, &ComparedViews::follow);
    connect(&m_parts.openStudy, &OpenStudy::otfComputed, this, &ComparedViews::follow);
    connect(&m_parts.openStudy, &OpenStudy::quieteningChanged, this, &ComparedViews::follow);
    connect(&m_parts.designs, &ViewDesigns::computed, this, &ComparedViews::takeDesign);
    connect(&m_parts.designs, &ViewDesigns::busyChanged, this, &ComparedViews::showFaces);
    connect(&m_parts.designs, &ViewDesigns::cancelled, this, &ComparedViews::follow);
    connect(&m_parts.designs, &ViewDesigns::failed, this, &ComparedViews::follow);
    connect(&m_parts.grid, &CompareGrid::arranged, this, &ComparedViews::follow);
    connect(&m_parts.grid, &CompareGrid::painted, &m_caster, &CompareCaster::drawn);
    connect(&m_caster, &CompareCaster::delivered, this, &ComparedViews::take);
    connect(&m_caster, &CompareCaster::busyChanged, this, &ComparedViews::busyChanged);
    connect(&m_caster, &CompareCaster::failed, this, &ComparedViews::failed);
}

void ComparedViews::setShown(bool shown) {
    if (std::exchange(m_shown, shown) == shown) return;
    m_courses.clear();
    follow();
}

/// Whether what a pane shows is computed for it alone: by its designer, or as the adaptive OTF of a phase or of frames
/// that are not the 3D view's.
bool ComparedViews::isComputedForItself(std::size_t place) const {
    const Document& document = m_parts.model.document();
    const Pane& pane = document.panes.at(place);
    if (pane.designer) return true;
    return pane.curve == CurveKind::adaptive &&
           (pane.motionOtf || pane.phase || pane.withoutTubes != document.panes.front().withoutTubes);
}

void ComparedViews::askForDesigns() {
    std::vector<std::size_t> panes;
    if (m_shown && isCompared(m_parts.model.document()))
        for (std::size_t place = 0; place < m_parts.model.document().panes.size(); ++place)
            if (isComputedForItself(place)) panes.push_back(place);
    if (panes == m_askedPanes) return;
    m_askedPanes = panes;
    m_parts.designs.setExtraPanes(std::move(panes));
}

void ComparedViews::takeDesign(std::size_t pane) {
    const Document& document = m_parts.model.document();
    const Study* study = m_parts.openStudy.study();
    const auto design = m_parts.designs.of(pane);
    if (m_shown && design && study != nullptr && isComputedForItself(pane) && document.panes.at(pane).motionOtf) {
        const auto phases = static_cast<int>(study->phases.size());
        const CourseFrame frame{static_cast<int>(std::lround(document.scene.motionAngle)), phaseOf(document, pane),
                                phases};
        const CourseKey key = courseKeyOf(document, configOf(document, pane), frame);
        Course& kept = m_courses[pane];
        if (kept.course.newest(MotionOtf::eachView).opacities.empty() || kept.key != key) {
            kept.key = key;
            kept.course.forgetPast();
            kept.course.begin(key.rows, phases);
        }
        // The adaptive OTF is one value an intensity.
        if (const auto* curve = std::get_if<SampledCurve>(&design->design.classification.curve()))
            kept.course.add(frame, *curve);
    }
    follow();
}

std::vector<std::size_t> ComparedViews::placesWanted() const {
    const Comparison& comparison = m_parts.model.document().comparison;
    if (comparison.layout == ComparisonLayout::sideBySide) return m_parts.grid.shownPanes();
    return {static_cast<std::size_t>(comparison.first), static_cast<std::size_t>(comparison.second)};
}

ComparedViews::ComparedPane ComparedViews::paneAt(std::size_t place) const {
    const Document& document = m_parts.model.document();
    OpenStudy& openStudy = m_parts.openStudy;
    const int phases = static_cast<int>(openStudy.study()->phases.size());
    const int phase = std::min(phaseOf(document, place), phases - 1);
    ComparedPane pane{.request = {openStudy.newestVoxelsOf(phase)}};
    ViewOtf otf;
    if (isComputedForItself(place)) {
        const auto design = m_parts.designs.of(place);
        pane.newest = m_parts.designs.isNewest(place);
        // What was made of the same voxels is shown until the next is there; what was made of others only where the
        // next does not come. Another study's never is.
        const int otfPhase = std::min(otfPhaseOf(document, place, phases), phases - 1);
        pane.refused = !pane.newest && m_parts.designs.isRefused(place);
        pane.usable = pane.newest || pane.refused || (design && design->raw == openStudy.rawVoxelsOf(otfPhase));
        if (design && pane.usable) {
            Classification made = design->design.classification;
            const auto motionOtf = document.panes.at(place).motionOtf;
            const auto course = m_courses.find(place);
            const CourseFrame frame{static_cast<int>(std::lround(document.scene.motionAngle)), phaseOf(document, place),
                                    phases};
            const bool ofThisMotion = course != m_courses.end() &&
                                      course->second.key == courseKeyOf(document, configOf(document, place), frame);
            if (motionOtf && *motionOtf != MotionOtf::oneOtf && ofThisMotion)
                made = course->second.course.newest(*motionOtf);
            if (const auto* curve = std::get_if<SampledCurve>(&made.curve())) otf.curve = *curve;
            otf.designed = std::move(made);
        }
    } else if (document.panes.at(place).curve == CurveKind::adaptive) {
        pane.newest = openStudy.otf() != nullptr && !openStudy.computingOtf();
        pane.usable = openStudy.otf() != nullptr || !openStudy.computingOtf();
        if (openStudy.otf()) otf.curve = m_parts.adaptive();
    }
    if (!needsComputedOtf(document, place)) {
        pane.newest = pane.usable = true;
        pane.refused = false;
    }
    pane.request.classification = classificationOf(document, place, otf);
    return pane;
}

void ComparedViews::follow() {
    const Document& document = m_parts.model.document();
    const Comparison& comparison = document.comparison;
    askForDesigns();
    m_waits = false;
    if (!m_shown || !isCompared(document) || !m_parts.openStudy.volume()) return clear();
    m_parts.grid.arrange(comparison.layout, document.panes.size());
    const QSize size = m_parts.grid.pictureSize();
    if (size.isEmpty()) return m_caster.clear();
    m_places = placesWanted();
    CompareRequest request{.places = m_places};
    bool usable = true;
    for (const std::size_t place : m_places) {
        ComparedPane pane = paneAt(place);
        usable = usable && pane.usable;
        request.panes.push_back(std::move(pane.request));
    }
    // The camera is that of the first pane, also where another one has the whole room.
    const auto first = paneAt(0).request.volume;
    request.settings = castSettingsOf(document, first->geometry(), first->dataBox(), size.width(), size.height());
    // Before a frame's OTFs are there, what was shown stays: a pane without one would be black.
    m_waits = !usable && m_frame && m_frame->request.places == m_places && m_study == m_parts.openStudy.study();
    m_study = m_parts.openStudy.study();
    if (!m_waits) m_caster.request(request);
    showFaces();
    if (m_frame && m_frame->request.places == m_places) showPair();
    emit followed();
}

/// Nothing of another study or of a comparison that is left stays in the panes.
void ComparedViews::clear() {
    m_caster.clear();
    m_courses.clear();
    m_rows.clear();
    m_pair.reset();
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

void ComparedViews::take(const std::shared_ptr<const CompareFrame>& frame) {
    m_frame = frame;
    showFrame();
    emit frameShown();
}

void ComparedViews::showFrame() {
    if (m_parts.model.document().comparison.layout != ComparisonLayout::sideBySide) return showPair();
    const std::vector<std::size_t>& places = m_frame->request.places;
    for (std::size_t i = 0; i < places.size(); ++i) m_parts.grid.pane(places[i]).setImage(m_frame->panes[i].image);
}

void ComparedViews::showPair() {
    const Comparison& comparison = m_parts.model.document().comparison;
    if (comparison.layout == ComparisonLayout::sideBySide || m_frame->panes.size() != 2) return;
    const QImage& first = m_frame->panes[0].image;
    const QImage& second = m_frame->panes[1].image;
    ComparePane& pair = m_parts.grid.pair();
    const auto nameAt = [&](int place) {
        const auto at = static_cast<std::size_t>(place);
        return QStringLiteral("%1 %2").arg(place + 1).arg(nameOfPane(m_parts.model.document().panes.at(at)));
    };
    const QString one = nameAt(comparison.first), other = nameAt(comparison.second);
    // The document changes oftener than the pair does.
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
        pair.setFace({.name = tr("left: %1 · right: %2").arg(one, other),
                      .numbers = tr("Drag the line, or move it with ← and →")});
    }
}

void ComparedViews::showFaces() {
    const Document& document = m_parts.model.document();
    if (!m_shown || !m_parts.openStudy.volume()) return;
    bool pairBusy = false;
    for (std::size_t place = 0; place < document.panes.size(); ++place) {
        PaneFace face = faceOf(place, document.panes[place]);
        CompareRow row = place < m_rows.size() ? m_rows[place] : CompareRow{};
        row.pictureMilliseconds.reset();  // it stands in the table; under a picture it would flutter
        face.numbers = numbersOf(row);
        const ComparedPane pane = paneAt(place);
        const bool busy = !pane.newest && !pane.refused;
        m_parts.grid.pane(place).setFace(face);
        m_parts.grid.pane(place).setBusy(busy);
        pairBusy = pairBusy || (busy && std::ranges::find(m_places, place) != m_places.end());
    }
    m_parts.grid.pair().setBusy(pairBusy);
}

void ComparedViews::addTimes(std::size_t place, CompareRow& row) const {
    const Pane& pane = m_parts.model.document().panes.at(place);
    if (const auto design = m_parts.designs.of(place); design && m_parts.designs.isNewest(place))
        row.designMilliseconds = design->milliseconds;
    else if (pane.curve == CurveKind::adaptive && m_parts.openStudy.otf() && !pane.designer)
        row.designMilliseconds = m_parts.openStudy.otf()->times.total;
    if (!m_frame || !m_frame->converged()) return;
    const std::vector<std::size_t>& places = m_frame->request.places;
    const auto found = std::ranges::find(places, place);
    if (found != places.end())
        if (const PanePicture& picture = m_frame->panes[static_cast<std::size_t>(found - places.begin())];
            picture.sampled)  // what is made of kept samples is no measure of the OTF
            row.pictureMilliseconds = picture.milliseconds;
}

void ComparedViews::setRows(const std::vector<CompareRow>& rows) {
    m_rows = rows;
    showFaces();
}

}  // namespace echolucent
