#include "app/study/shown_study.h"

#include <QMainWindow>
#include <utility>

#include "app/otf/shown_design.h"
#include "app/study/study_names.h"
#include "io/study/import_report.h"
#include "processing/box_section.h"
#include "processing/document/view_caster.h"
#include "processing/picture/empty_picture.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/message_bar.h"
#include "widgets/panels/method_panel.h"
#include "widgets/panels/run_status.h"
#include "widgets/panels/study_panel.h"
#include "widgets/panels/view_panel.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

ShownStudy::ShownStudy(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, this, &ShownStudy::tellFacts);
    connect(&m_parts.names, &StudyNames::changed, this, &ShownStudy::nameStudy);
    connect(&m_parts.openStudy, &OpenStudy::volumeChanged, this, &ShownStudy::takeVolume);
    connect(&m_parts.openStudy, &OpenStudy::otfComputed, this, &ShownStudy::takeOtf);
    connect(&m_parts.openStudy, &OpenStudy::quietVoxelsMade, this, &ShownStudy::takeQuietVoxels);
    connect(&m_parts.openStudy, &OpenStudy::volumeCut, this, &ShownStudy::takeCut);
    connect(&m_parts.model, &DocumentModel::strokesChanged, this, &ShownStudy::takeStrokes);
    connect(&m_parts.openStudy, &OpenStudy::otfFailed, this, &ShownStudy::doWithoutOtf);
    connect(&m_parts.player, &MotionPlayer::playingChanged, this, [this](bool playing) {
        m_parts.editor.setPlaying(playing);
        if (playing) return;
        m_numbers.tellNow();
        showRemark();
        takeQuietVoxels();  // those that were made while it played
    });
    connect(&m_parts.model, &DocumentModel::phaseChanged, this, &ShownStudy::takePhase);
    connect(&m_parts.model, &DocumentModel::curvesChanged, this, &ShownStudy::showRemarkAtRest);
    connect(&m_parts.model, &DocumentModel::panesChanged, this, &ShownStudy::showRemarkAtRest);
    connect(&m_parts.model, &DocumentModel::panesChanged, this, &ShownStudy::showNumbers);
    connect(&m_parts.designs, &ViewDesigns::computed, this, [this](std::size_t pane) {
        if (pane != firstPane) return;
        showRemarkAtRest();
        m_parts.player.isPlaying() || m_parts.model.previewing() ? m_numbers.tell() : m_numbers.tellNow();
    });
    connect(&m_parts.model, &DocumentModel::lookChanged, this, &ShownStudy::showRemarkAtRest);
    connect(&m_parts.model, &DocumentModel::boxChanged, this, &ShownStudy::showRemarkAtRest);
    connect(&m_parts.model, &DocumentModel::beamChanged, this, &ShownStudy::showNearCutRange);
    connect(&m_parts.model, &DocumentModel::sideChanged, this, &ShownStudy::showNearCutRange);
}

/// All that calls the study by its name, in the title and in the facts.
void ShownStudy::nameStudy() {
    const Study* study = m_parts.openStudy.study();
    if (study == nullptr) return;
    StudyNames& names = m_parts.names;
    const VolumeGeometry& geometry = m_parts.openStudy.volume()->geometry();
    const QString name = m_parts.openStudy.isSimulatedScan() ? QString::fromStdString(study->name)
                                                             : names.nameOf(m_parts.openStudy.path());
    QStringList title{tr("Echolucent"), name,
                      QStringLiteral("%1×%2×%3").arg(geometry.size[0]).arg(geometry.size[1]).arg(geometry.size[2])};
    title << (geometry.spacingKnown ? tr("%1 mm").arg(geometry.unit(), 0, 'g', 3) : tr("spacing unknown"));
    m_parts.window.setWindowTitle(title.join(QStringLiteral(" · ")) + QStringLiteral("[*]"));

    QList<StudyFactRow> facts;
    const auto& finds = m_parts.openStudy.finds();
    for (const ImportFact& fact : finds ? importReport(*study, finds->beam) : study->facts)
        facts << StudyFactRow{QString::fromStdString(fact.name), names.shown(QString::fromStdString(fact.value)),
                              names.shown(QString::fromStdString(fact.source))};
    m_parts.facts.setStudy(facts, warnings());
}

QStringList ShownStudy::warnings() const {
    QStringList warnings;
    for (const std::string& warning : m_parts.openStudy.study()->warnings)
        warnings << m_parts.names.shownOfFile(QString::fromStdString(warning));
    return warnings;
}

void ShownStudy::tellFacts() {
    const Study& study = *m_parts.openStudy.study();
    const VolumeGeometry& geometry = m_parts.openStudy.volume()->geometry();
    if (!m_parts.openStudy.isSimulatedScan()) {
        QStringList files;
        for (const std::string& file : study.files) files << QString::fromStdString(file);
        m_parts.names.know(m_parts.openStudy.path(), files);
    }
    nameStudy();

    QStringList notes;
    if (study.lossyCompression != LossyCompression::unknown)
        notes << (study.lossyCompression == LossyCompression::yes ? tr("lossy compression")
                                                                  : tr("no lossy compression"));
    if (!geometry.spacingKnown) notes << tr("spacing unknown");
    m_parts.status.setNotes(notes);

    if (m_parts.openStudy.isSimulatedScan())
        m_parts.messages.showMessage(MessageKind::info,
                                     tr("Open a volume, or drop it here. This is a simulated scan."));
    else if (const QStringList words = warnings(); !words.isEmpty())
        m_parts.messages.showMessage(MessageKind::warning, words.join(QStringLiteral(" ")));
    else
        m_parts.messages.dismiss();
}

void ShownStudy::takeVolume() {
    // A new study begins with its first phase; another phase keeps camera, cut and beam axis.
    OpenStudy& openStudy = m_parts.openStudy;
    const bool otherStudy = openStudy.study() != m_study;
    m_study = openStudy.study();
    m_parts.editor.setHistogram(openStudy.histogram());
    m_parts.editor.setWhiteLevel(openStudy.volume()->whiteLevel());
    if (otherStudy)
        beginDocument();
    else if (openStudy.phase() == m_parts.player.phase())
        return;  // a frame of the motion, which knows what follows
    m_parts.player.setPhase(openStudy.phase());
    const Document& document = m_parts.model.document();
    const bool oneOtf = document.motion.otf == MotionOtf::oneOtf;
    if (oneOtf && !otherStudy) return m_parts.motion.showWithOneOtf();
    m_parts.method.clearResult();
    m_parts.status.clearOtf();
    m_parts.computing.computeFor(oneOtf ? m_parts.computing.viewpoint() : viewpointOf(document));
}

void ShownStudy::beginDocument() {
    OpenStudy& openStudy = m_parts.openStudy;
    const int before = std::exchange(m_phases, static_cast<int>(m_study->phases.size()));
    m_parts.player.pause();  // first, as it shows the remark of the study before
    m_parts.messages.setRemark({});
    m_parts.view.hold();
    if (const OtfEditorState& state = m_parts.editor.state(); state.designed)  // a design of the study before
        m_parts.editor.setDesign(QString::fromStdString(state.designer), std::nullopt);
    m_parts.model.cancelPreview();  // a drag that goes on is no part of the new document
    m_parts.controls.setPhaseCount(m_phases);
    m_parts.motion.setStudy(*m_study);
    emit aboutToBegin();
    OpenedDocuments opened =
        openedDocuments(m_parts.model.document(),
                        {openStudy.reference(), openStudy.volume()->dataBox(), m_phases, before, openStudy.finds()},
                        m_parts.picture.aspect());
    m_opened = std::move(opened.found);
    if (openStudy.saved()) {
        m_parts.model.begin(openStudy.saved()->session.document);
    } else {
        m_parts.model.begin(opened.plain);
        m_parts.model.edit(m_opened, tr("beam and cut found on opening"));  // one step that can be taken back
    }
    takeStrokes();  // the open study has forgotten those that the document before had too
    m_parts.motion.beginAtRest();
    m_parts.computing.begin();
    showNearCutRange();
}

void ShownStudy::takePhase() {
    const int phase = phaseOf(m_parts.model.document(), firstPane);
    m_parts.controls.setPhase(phase);
    if (m_study && phase < static_cast<int>(m_study->phases.size())) m_parts.openStudy.setPhase(phase);
}

void ShownStudy::takeOtf() {
    const std::shared_ptr<const AdaptiveOtf> otf = m_parts.openStudy.otf();
    // Curve first, then volume: the picture is never made of one study's voxels and another's curve.
    const SampledCurve curve = m_parts.motion.curveToShow(otf);
    m_parts.view.setAdaptiveCurve(curve);
    m_parts.editor.setAdaptiveCurve(curve);
    // A drag of a box or a cut, as a motion, brings one OTF after another.
    m_parts.player.isPlaying() || m_parts.model.previewing() ? m_numbers.tell() : m_numbers.tellNow();
    showRemarkAtRest();
    m_parts.view.showVolume(m_parts.openStudy.voxelsForOtf(), m_parts.openStudy.volume());
    m_parts.motion.showWaitingFrame();
}

void ShownStudy::showNumbers() {
    const AdaptiveOtf* otf = m_parts.motion.otf();
    if (otf != nullptr) m_parts.method.showResult(*otf);
    if (designerConfigOf(m_parts.model.document(), firstPane) != nullptr) {
        const auto made = m_parts.designs.of(firstPane);
        made ? m_parts.status.setDesign(labelOf(made->config), made->milliseconds) : m_parts.status.clearOtf();
    } else if (otf != nullptr) {
        m_parts.status.setOtf(otf->times.total, otf->tubesWithWeight, otf->tubesMeetingVolume);
    }
}

/// The curve is adapted to the quiet voxels first, so that both come into the picture together. What plays takes them
/// with the phase's next turn.
void ShownStudy::takeQuietVoxels() {
    OpenStudy& openStudy = m_parts.openStudy;
    if (m_parts.player.isPlaying() || !openStudy.volume()) return;
    if (openStudy.lookingForNearCut()) return;  // it asks for the OTF itself once it has ended
    if (openStudy.otfIsOfNewestVoxels()) {
        // The OTF of another phase stays.
        if (openStudy.phaseOfOtf() != openStudy.phase())
            m_parts.view.showVolume(openStudy.newestVoxels(), openStudy.volume());
        return;
    }
    if (openStudy.otf() || openStudy.computingOtf())
        m_parts.computing.computeAgain();
    else if (m_parts.motion.otf())
        m_parts.view.showVolume(openStudy.newestVoxels(), openStudy.volume());
}

void ShownStudy::takeStrokes() { m_parts.openStudy.setStrokes(m_parts.model.document().scene.strokes); }

/// The picture shows the stroke at once, with the curve that it had; the OTF of what is left follows.
void ShownStudy::takeCut() {
    const OpenStudy& openStudy = m_parts.openStudy;
    if (m_parts.player.isPlaying() || m_parts.view.held() || m_parts.motion.otf() == nullptr) return;
    m_parts.view.showVolume(m_parts.openStudy.newestVoxels(), openStudy.volume());
    if (openStudy.otf()) m_parts.computing.computeAgain();
}

/// The picture is that of the volume all the same, with the curve shown before or, in a study without one, with none.
void ShownStudy::doWithoutOtf(const QString& sentence) {
    m_parts.player.pause();
    m_parts.messages.showMessage(MessageKind::error, sentence);
    if (m_parts.motion.otf() == nullptr) {
        m_parts.view.setAdaptiveCurve({});
        m_parts.editor.setAdaptiveCurve({});
    }
    m_parts.view.showVolume(m_parts.openStudy.newestVoxels(), m_parts.openStudy.volume());
    m_parts.motion.showWaitingFrame();
}

/// While it plays the bar would come and go over the picture.
void ShownStudy::showRemarkAtRest() {
    if (!m_parts.player.isPlaying()) showRemark();
}

void ShownStudy::showRemark() {
    if (m_parts.motion.otf() == nullptr || !m_parts.openStudy.volume()) return;
    const Document& document = m_parts.model.document();
    const std::optional<OrientedBox> box = viewpointOf(document).box;
    if (box && !meets(*box, m_parts.openStudy.volume()->dataBox()))
        return m_parts.messages.setRemark(
            tr("Nothing is shown: the render box lies beside the data. Drag its centre, or switch it off (B)."));
    m_parts.messages.setRemark(remarks().join(QLatin1Char(' ')));
}

/// What the OTF that is rendered has to say. A picture that is black because of its curve says so.
QStringList ShownStudy::remarks() const {
    const Document& document = m_parts.model.document();
    const AdaptiveOtf& otf = *m_parts.motion.otf();
    QString message = QString::fromStdString(otf.message);
    OpacityCurve curve;
    if (designerConfigOf(document, firstPane) != nullptr) {
        const auto made = m_parts.designs.of(firstPane);
        if (!made) return {};
        message = QString::fromStdString(made->design.message);
        if (!message.isEmpty()) message = tr("%1: %2").arg(labelOf(made->config), message);
        curve = upperCurveOf(classificationOf(document, firstPane, {.designed = made->design.classification}));
    } else {
        curve = curveOf(document, firstPane, otf.curve);
    }
    QStringList remarks{message};
    if (document.scene.look.mode == RenderMode::direct)
        remarks << QString::fromStdString(whyNothingShows(curve, m_parts.openStudy.histogramOfOtf()));
    remarks.removeAll(QString());
    return remarks;
}

void ShownStudy::showNearCutRange() {
    if (!m_parts.openStudy.volume()) return;
    const Document& document = m_parts.model.document();
    const VolumeGeometry& geometry = m_parts.openStudy.volume()->geometry();
    m_parts.controls.setNearCutRange(depthAlongViewMm(otfViewpointOf(document, firstPane), geometry),
                                     geometry.spacingKnown);
    m_parts.controls.setNearCutMm(document.scene.front.depthMm);
}

}  // namespace echolucent
