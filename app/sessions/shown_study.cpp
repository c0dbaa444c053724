#include "app/sessions/shown_study.h"

#include <QMainWindow>
#include <utility>

#include "app/otf/editor_otfs.h"
#include "app/sessions/study_rows.h"
#include "app/study/study_names.h"
#include "io/study/import_report.h"
#include "processing/pane_picture/pane_caster.h"
#include "processing/picture/empty_picture.h"
#include "processing/viewpoint/box_section.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/run_status.h"
#include "widgets/motion/otf_course_panel.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/curve_sliders.h"
#include "widgets/panels/designer_panel.h"
#include "widgets/panels/method_panel.h"
#include "widgets/panels/study_panel.h"
#include "widgets/panels/view_panel.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace echolucent {

namespace {
constexpr const char *studyTopic = "study", *cuttingTopic = "cutting";
}  // namespace

ShownStudy::ShownStudy(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
    connect(&m_parts.openStudy, &OpenStudy::aboutToReplace, this, [this] {
        m_parts.player.pause();
        m_parts.model.cancelPreview();  // a running drag is not part of the new document
    });
    connect(&m_parts.openStudy, &OpenStudy::studyReplaced, this, &ShownStudy::beginDocument);
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, this, &ShownStudy::tellFacts);
    connect(&m_parts.names, &StudyNames::changed, this, &ShownStudy::nameStudy);
    connect(&m_parts.model, &DocumentModel::beamChanged, this, &ShownStudy::showFacts);
    const auto takeLoading = [this](bool loading) {
        m_asked = loading;
        entitle();
    };
    connect(&m_parts.openStudy, &OpenStudy::loadingBegun, this, [takeLoading] { takeLoading(true); });
    connect(&m_parts.openStudy, &OpenStudy::loadingChanged, this, takeLoading);
    takeLoading(m_parts.openStudy.loading());
    connect(&m_parts.openStudy, &OpenStudy::volumeChanged, this, &ShownStudy::takeVolume);
    connect(&m_parts.openStudy, &OpenStudy::cuttingFailed, this, [this](const QString& sentence) {
        m_parts.messages.showMessage(MessageKind::error, sentence, MessageEnd::withStudy(cuttingTopic));
    });
    connect(&m_parts.model, &DocumentModel::strokesChanged, this, [this] { m_parts.messages.takeBack(cuttingTopic); });
    connect(&m_parts.otfs, &PaneOtfs::computed, this, &ShownStudy::takeOtf);
    connect(&m_parts.otfs, &PaneOtfs::failed, this, [this](std::size_t place) {
        if (place == PaneOtfs::adaptiveOfScene) m_parts.player.pause();
    });
    connect(&m_parts.player, &MotionPlayer::playingChanged, this, [this](bool playing) {
        m_parts.editor.setPlaying(playing);
        if (playing) return;
        m_numbers.tellNow();
        showRemark();
    });
    connect(&m_parts.model, &DocumentModel::curvesChanged, this, &ShownStudy::showRemarkAtRest);
    connect(&m_parts.model, &DocumentModel::panesChanged, this, &ShownStudy::showRemarkAtRest);
    connect(&m_parts.model, &DocumentModel::panesChanged, this, &ShownStudy::showNumbers);
    connect(&m_parts.model, &DocumentModel::lookChanged, this, &ShownStudy::showRemarkAtRest);
    connect(&m_parts.model, &DocumentModel::boxChanged, this, &ShownStudy::showRemarkAtRest);
    for (const auto part : {&DocumentModel::frontChanged, &DocumentModel::beamChanged, &DocumentModel::poseChanged})
        connect(&m_parts.model, part, this, &ShownStudy::showFront);
}

/// Names in the title what the picture shows: the open study, or the one that is coming, while it is dimmed.
void ShownStudy::entitle() {
    const OpenStudy& openStudy = m_parts.openStudy;
    const Study* study = openStudy.study();
    QStringList title{tr("Echolucent")};
    QString name;
    if (m_asked)
        name = openStudy.asked().isEmpty() ? tr("simulated scan") : m_parts.names.nameOfAsked(openStudy.asked());
    else if (study != nullptr)
        name =
            openStudy.isSimulatedScan() ? QString::fromStdString(study->name) : m_parts.names.nameOf(openStudy.path());
    // Qt takes these letters for the place of the mark of a change; twice they stand for themselves.
    name.replace(QLatin1String("[*]"), QLatin1String("[*][*]"));
    if (m_asked) {
        title << tr("opening %1").arg(name);
    } else if (study != nullptr) {
        const VolumeGeometry& geometry = openStudy.volume()->geometry();
        title << name << QStringLiteral("%1×%2×%3").arg(geometry.size[0]).arg(geometry.size[1]).arg(geometry.size[2])
              << (geometry.spacingKnown ? tr("%1 mm").arg(geometry.unit(), 0, 'g', 3) : tr("spacing unknown"));
    }
    m_parts.window.setWindowTitle(title.join(QStringLiteral(" · ")) + QStringLiteral("[*]"));
}

/// Shows the study's name in the title and in the facts.
void ShownStudy::nameStudy() {
    entitle();
    showFacts();
}

void ShownStudy::showFacts() {
    const Study* study = m_parts.openStudy.study();
    if (study == nullptr) return;
    StudyNames& names = m_parts.names;
    QList<StudyFactRow> facts;
    const auto& finds = m_parts.openStudy.finds();
    for (const ImportFact& fact : finds ? importReport(*study, finds->beam) : study->facts)
        facts << StudyFactRow{QString::fromStdString(fact.name), names.shown(QString::fromStdString(fact.value)),
                              names.shown(QString::fromStdString(fact.source))};
    m_parts.facts.setStudy(studyRows(facts, *study, m_parts.model.document().beam), warnings());
}

QStringList ShownStudy::warnings() const {
    QStringList warnings;
    for (const std::string& warning : m_parts.openStudy.study()->warnings)
        warnings << withVolumesForPhases(m_parts.names.shownOfFile(QString::fromStdString(warning)));
    return warnings;
}

void ShownStudy::tellFacts() {
    m_asked = m_parts.openStudy.loading();  // another one may have been asked for since
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

    if (m_parts.openStudy.given()) return;  // whoever gave the document says what is seen
    if (m_parts.openStudy.isSimulatedScan())
        m_parts.messages.showMessage(MessageKind::info, tr("Open a volume, or drop it here. This is a simulated scan."),
                                     MessageEnd::withStudy(studyTopic));
    else if (const QStringList words = warnings(); !words.isEmpty())
        m_parts.messages.showMessage(MessageKind::warning, words.join(QStringLiteral(" ")),
                                     MessageEnd::withStudy(studyTopic));
}

void ShownStudy::takeVolume() {
    OpenStudy& openStudy = m_parts.openStudy;
    m_parts.editor.setHistogram(openStudy.histogram());
    const ValueWindow values = openStudy.volume()->valueWindow();
    m_parts.editor.setValueWindow(values);
    m_parts.status.setValueWindow(values);
    m_parts.designers.setValueWindow(values);
    m_parts.sliders.setValueWindow(values);
    m_parts.course.setValueWindow(values);
    // While a motion plays, clearing the numbers would make them flicker. Numbers of an OTF that is the newest stay
    // too.
    if (m_parts.player.isPlaying() || m_parts.otfs.isNewest(PaneOtfs::adaptiveOfScene)) return;
    m_parts.method.clearResult();
    m_parts.status.clearOtf();
}

void ShownStudy::beginDocument() {
    OpenStudy& openStudy = m_parts.openStudy;
    const Study& study = *openStudy.study();
    const int phases = std::exchange(m_phases, static_cast<int>(study.phases.size()));
    const std::optional<Kept> takenOver = std::exchange(m_takenOver, std::nullopt);
    m_parts.messages.endStudy();
    m_parts.messages.setRemark({});
    m_parts.method.clearResult();
    m_parts.status.clearOtf();
    if (const OtfEditorState& state = m_parts.editor.state(); state.designed)  // a design of the previous study
        m_parts.editor.setDesign(QString::fromStdString(state.designer), std::nullopt);
    m_parts.motion.setStudy(study);
    emit aboutToBegin();
    OpenedDocuments opened = openedDocuments(takenOver ? takenOver->document.document : m_parts.model.ownDocument(),
                                             {openStudy.reference(), openStudy.volume()->dataBox(), m_phases,
                                              takenOver ? takenOver->phases : phases, openStudy.finds()},
                                             m_parts.picture.aspect());
    m_opened = openStudy.given() ? *openStudy.given() : std::move(opened.found);
    if (const auto kept = std::exchange(m_broughtBack, std::nullopt)) {
        m_opened = kept->opened;
        m_parts.model.comeBack(kept->document);
    } else if (openStudy.given()) {
        m_parts.model.begin(m_opened);
    } else if (openStudy.saved()) {
        m_parts.model.begin(openStudy.saved()->session.document);
    } else {
        m_parts.model.begin(opened.plain);
        m_parts.model.edit(m_opened, tr("beam, side and front found on opening"));  // one step that can be undone
    }
    m_parts.motion.beginAtRest();
    showFront();
}

void ShownStudy::takeOtf(std::size_t place) {
    const bool designed = designerConfigOf(m_parts.model.document(), firstPane) != nullptr;
    if (place != PaneOtfs::adaptiveOfScene && !(place == firstPane && designed)) return;
    // A drag of a box or a cut brings one OTF after another, as a motion does.
    m_parts.player.isPlaying() || m_parts.model.previewing() ? m_numbers.tell() : m_numbers.tellNow();
    showRemarkAtRest();
}

void ShownStudy::showNumbers() {
    const auto otf = m_parts.otfs.adaptive();
    if (otf) m_parts.method.showResult(*otf);
    if (designerConfigOf(m_parts.model.document(), firstPane) != nullptr) {
        const auto made = m_parts.otfs.designOf(firstPane);
        made ? m_parts.status.setDesign(labelOf(made->asked.config), made->milliseconds) : m_parts.status.clearOtf();
    } else if (otf) {
        m_parts.status.setOtf(otf->times.total, otf->tubesWithWeight, otf->tubesMeetingVolume);
    }
}

/// The bar would come and go over the picture while a motion plays.
void ShownStudy::showRemarkAtRest() {
    if (!m_parts.player.isPlaying()) showRemark();
}

void ShownStudy::showRemark() {
    if (!m_parts.otfs.adaptive() || !m_parts.openStudy.volume() || m_parts.openStudy.beginning()) return;
    const Document& document = m_parts.model.document();
    const std::optional<OrientedBox> box = viewpointOf(document).box;
    if (box && !meets(*box, m_parts.openStudy.volume()->dataBox()))
        return m_parts.messages.setRemark(
            tr("Nothing is shown: the box lies beside the data. Drag its centre, or switch it off (B)."));
    m_parts.messages.setRemark(remarks().join(QLatin1Char(' ')));
}

/// The message of the rendered OTF, and, if the picture is black because of its curve, a sentence that says so.
QStringList ShownStudy::remarks() const {
    const Document& document = m_parts.model.document();
    const bool designed = designerConfigOf(document, firstPane) != nullptr;
    const auto made = designed ? m_parts.otfs.designOf(firstPane) : m_parts.otfs.of(PaneOtfs::adaptiveOfScene);
    if (!made || (!designed && !made->design.tubeCores)) return {};
    QString message = QString::fromStdString(made->design.message);
    if (designed && !message.isEmpty()) message = tr("%1: %2").arg(labelOf(made->asked.config), message);
    const ShownPane& shown = m_parts.panes.at(firstPane);
    const OpacityCurve curve =
        designed ? upperCurveOf(classificationOf(document, firstPane, {.designed = made->design.classification}))
                 : curveOf(document, firstPane, made->design.tubeCores->curve);
    QStringList remarks{message};
    if (document.scene.look.mode == RenderMode::direct)
        remarks << QString::fromStdString(whyNothingShows(curve, m_parts.openStudy.histogramOf(*shown.voxels)));
    remarks.removeAll(QString());
    return remarks;
}

/// The panel's slider moves the front along its own forward. Without a front it would make one across the view.
void ShownStudy::showFront() {
    if (!m_parts.openStudy.volume()) return;
    const Document& document = m_parts.model.document();
    const Front& front = document.scene.front;
    const VolumeGeometry& geometry = m_parts.openStudy.volume()->geometry();
    const Vec3 forward = cuts(front) ? forwardOf(front, document.beam.axis) : frameOf(viewpointOf(document)).forward;
    const auto depths = geometry.depthsAlong(forward);
    m_parts.controls.setFrontRange(depths.farthest - depths.nearest, geometry.spacingKnown);
    m_parts.controls.setFrontMm(depthOf(front, geometry));
}

}  // namespace echolucent
