#include "app/otf/shown_panes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "processing/pane_picture/pane_caster.h"

namespace echolucent {

ShownPanes::ShownPanes(DocumentModel& model, OpenStudy& openStudy, PaneOtfs& otfs, OtfCourse& course, QObject* parent)
    : QObject(parent), m_model(model), m_openStudy(openStudy), m_otfs(otfs), m_sceneCourse(course) {
    connect(&m_otfs, &PaneOtfs::followed, this, &ShownPanes::follow);
}

void ShownPanes::setPlaying(bool playing) {
    m_playing = playing;
    m_otfs.setPlaying(playing);  // this emits followed()
}

const SampledCurve& ShownPanes::adaptiveCurve() const {
    static const SampledCurve none;
    const auto course = m_courses.find(PaneOtfs::adaptiveOfScene);
    return course == m_courses.end() ? none : course->second.curve;
}

void ShownPanes::follow() {
    if (std::exchange(m_study, m_openStudy.study()) != m_openStudy.study()) {
        m_courses.clear();
        m_last.clear();
    }
    const std::size_t panes = m_model.document().panes.size();
    const std::size_t seen = m_otfs.comparing() ? panes : 1;
    const auto isUnseen = [seen](const auto& each) {
        return each.first != PaneOtfs::adaptiveOfScene && each.first >= seen;
    };
    std::erase_if(m_courses, isUnseen);
    std::erase_if(m_last, isUnseen);
    followCourse(PaneOtfs::adaptiveOfScene);
    for (std::size_t pane = 0; pane < seen; ++pane) followCourse(pane);
    m_shown.resize(panes);
    for (std::size_t pane = 0; pane < panes; ++pane) {
        m_shown[pane] = shownNow(pane);
        if (pane < seen && m_shown[pane].ready) m_last[pane] = m_shown[pane];
    }
    emit changed();
}

const ShownPane& ShownPanes::at(std::size_t pane) const {
    static const ShownPane none;
    return pane < m_shown.size() ? m_shown[pane] : none;
}

MotionOtf ShownPanes::modeOf(std::size_t place) const {
    const Document& document = m_model.document();
    if (place == PaneOtfs::adaptiveOfScene) return document.motion.otf;
    return document.panes.at(place).motionOtf.value_or(document.motion.otf);
}

/// A frame joins the course once its OTF is there. A view that the hand turns meanwhile is no frame.
void ShownPanes::followCourse(std::size_t place) {
    const Document& document = m_model.document();
    const bool ofScene = place == PaneOtfs::adaptiveOfScene;
    const auto made = m_otfs.of(place);
    if (!made || !made->design.tubeCores) {
        m_courses.erase(place);
        return;
    }
    // If pane and scene have the same OTF and mode, they share one course.
    const auto scenes = m_courses.find(PaneOtfs::adaptiveOfScene);
    if (!ofScene && scenes != m_courses.end() && scenes->second.otf == made->design.tubeCores &&
        scenes->second.mode == modeOf(place)) {
        m_courses.erase(place);
        return;
    }
    if (!m_otfs.isNewest(place)) return;
    const std::size_t pane = ofScene ? firstPane : place;
    const auto phases = static_cast<int>(m_openStudy.study()->phases.size());
    const int phase = std::min(phaseOf(document, pane), phases - 1);
    const Scene& scene = document.scene;
    const auto& otf = made->design.tubeCores;
    const MotionOtf mode = modeOf(place);
    Course& taken = m_courses[place];
    const bool anotherFrame = taken.pose == scene.pose && (taken.angle != scene.motionAngle || taken.phase != phase);
    const CourseFrame frame{static_cast<int>(std::lround(scene.motionAngle)), phase, phases};
    CourseKey key = courseKeyOf(document, otf->config, frame);
    const bool anotherCourse = taken.pose == scene.pose && taken.key != key;
    if (taken.otf == otf && taken.mode == mode && !anotherFrame && !anotherCourse) return;
    const bool begins = std::exchange(taken.mode, mode) == MotionOtf::oneOtf && mode != MotionOtf::oneOtf;
    taken.otf = otf;
    taken.angle = scene.motionAngle;
    taken.phase = phase;
    taken.pose = scene.pose;

    OtfCourse& course = ofScene ? m_sceneCourse : taken.course;
    if (taken.key != key) {
        course.begin(key.rows, phases);
        // Another loop does not need the OTFs of the one before.
        if (ofScene && mode != MotionOtf::oneOtf) m_otfs.forgetAdaptive();
        taken.key = std::move(key);
    } else if (ofScene && begins) {
        m_otfs.forgetAdaptive();
    }
    // If one OTF serves the whole motion, it may be of another view or phase than this frame.
    const bool ofFrame = otf->view == viewpointOf(document) && otfPhaseOf(document, pane, phases) == phase;
    if (ofFrame) course.add(frame, otf->curve);
    if (mode == MotionOtf::oneOtf) course.addOneOtf(frame, otf->curve);
    taken.curve = ofFrame && mode != MotionOtf::oneOtf ? course.newest(mode) : otf->curve;
    if (ofScene) emit courseChanged();
}

const SampledCurve* ShownPanes::curveAt(std::size_t pane, const ComputedOtf& otf) const {
    if (!otf.design.tubeCores) return nullptr;
    for (const std::size_t place : {PaneOtfs::adaptiveOfScene, pane}) {
        const auto course = m_courses.find(place);
        if (course != m_courses.end() && course->second.otf == otf.design.tubeCores &&
            course->second.mode == modeOf(pane))
            return &course->second.curve;
    }
    return &otf.design.tubeCores->curve;
}

void ShownPanes::takeVoxels(std::size_t place, int phase, ShownPane& pane) const {
    pane.voxels = m_openStudy.newestVoxelsOf(phase);
    const QuietPhases& quiet = m_openStudy.quietPhases();
    const bool comeSoon = !m_playing && quiet.busy() && !quiet.of(phase);
    const auto last = m_last.find(place);
    if (last != m_last.end()) {
        if (comeSoon && last->second.measured == pane.measured) pane.voxels = last->second.voxels;
        return;
    }
    // One picture follows an opening, not two.
    const bool small = pane.measured->geometry().voxelCount() <= PaneOtfs::quietFirstVoxels;
    if ((comeSoon && small) || m_openStudy.isCutting(phase)) pane.ready = false;
}

ShownPane ShownPanes::shownNow(std::size_t place) const {
    const Study* study = m_openStudy.study();
    if (study == nullptr || !m_openStudy.volume()) return {};
    const Document& document = m_model.document();
    const auto phases = static_cast<int>(study->phases.size());
    const int phase = std::min(phaseOf(document, place), phases - 1);
    ShownPane pane{.measured = m_openStudy.rawVoxelsOf(phase), .newest = true, .ready = true};
    if (!needsComputedOtf(document, place)) {
        takeVoxels(place, phase, pane);
        pane.classification = classificationOf(document, place, {});
        return pane;
    }
    const auto made = m_otfs.of(place);
    pane.newest = m_otfs.isNewest(place);
    pane.refused = !pane.newest && m_otfs.isRefused(place);
    if (made && !pane.refused && made->asked.raw == pane.measured)
        pane.voxels = made->asked.shown;  // the OTF was made for these voxels
    else
        takeVoxels(place, phase, pane);
    const int otfPhase = std::min(otfPhaseOf(document, place, phases), phases - 1);
    const bool ofScan = made && made->asked.raw->isSameScanAs(*m_openStudy.rawVoxelsOf(otfPhase));
    pane.ready = pane.newest || pane.refused || (ofScan && !m_playing);
    // If a pane's first OTF has not come, the pane keeps its last classification.
    if (const auto last = m_last.find(place); !made && last != m_last.end()) {
        pane.classification = last->second.classification;
        return pane;
    }
    PaneOtf otf;
    if (made) {
        otf.designed = made->design.classification;
        if (const SampledCurve* curve = curveAt(place, *made)) {
            otf.curve = *curve;
            otf.designed = *curve;
        }
    }
    pane.classification = classificationOf(document, place, otf);
    return pane;
}

}  // namespace echolucent
