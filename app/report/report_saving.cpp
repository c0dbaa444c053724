#include "app/report/report_saving.h"

#include <QApplication>
#include <QDateTime>
#include <QPainter>
#include <QPointer>
#include <utility>

#include "app/files/save_dialog.h"
#include "app/otf/editor_otfs.h"
#include "app/picture/picture_to_keep.h"
#include "app/settings/settings.h"
#include "app/study/study_names.h"
#include "io/output/atomic_file.h"
#include "io/output/overwriting.h"
#include "io/restricted/restricted_reader.h"
#include "io/study/import_report.h"
#include "widgets/controls/message_bar.h"
#include "widgets/dialogs/report_dialog.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/planes/pane_grid.h"
#include "widgets/planes/plane_pane.h"

namespace echolucent {

namespace {

constexpr const char* reportTopic = "report";

ReportPatient shownPatient(const Patient& patient) {
    return {QString::fromStdString(patient.name),      QString::fromStdString(patient.id),
            QString::fromStdString(patient.birthDate), QString::fromStdString(patient.sex),
            QString::fromStdString(patient.studyDate), QString::fromStdString(patient.gestationalAge)};
}

/// `source`: the files that say what nobody typed of the patient; none if nothing is read of them.
Result<void> writeReport(CaseReport report, const std::optional<PatientSource>& source,
                         const std::vector<std::string>& inputs, const std::string& path, const Progress& progress) {
    if (const auto allowed = refuseToOverwrite(inputs, {path}); !allowed) return allowed;
    if (source) {
        auto patient = restricted::readPatient(source->files, source->series, progress);
        // What was typed needs no file.
        const bool typed = report.patient && *report.patient != Patient{};
        if (!patient && !typed) return tl::unexpected(patient.error());
        if (patient) report.patient = withTyped(std::move(*patient), report.patient.value_or(Patient{}));
    }
    progress.at(0.2);
    const bool isPdf = QString::fromStdString(path).endsWith(QStringLiteral(".pdf"), Qt::CaseInsensitive);
    const Progress ofPage{[&progress](double share) { progress.at(0.2 + 0.7 * share); }, progress.cancel};
    const std::optional<std::string> page = isPdf ? caseReportPdf(report, ofPage) : caseReportPage(report);
    progress.at(0.9);
    if (!page || progress.cancelled()) return fail(FailureKind::cancelled, path, {}, "was not written: cancelled");
    return writeFileAtomically(path, *page);
}

QImage imageOfPane(const PlanePane& pane) {
    const qreal ratio = pane.devicePixelRatioF();
    QImage image(pane.size() * ratio, QImage::Format_RGB32);
    image.setDevicePixelRatio(ratio);
    image.fill(Qt::black);
    QPainter painter(&image);
    painter.drawImage(pane.rect(), pane.image());
    painter.drawImage(pane.rect(), pane.drawings(ratio));
    return image;
}

}  // namespace

ReportSaving::ReportSaving(const Parts& parts)
    : QObject(&parts.window),
      m_parts(parts),
      m_waits(parts.works, work()),
      m_reading(parts.works, QStringLiteral("patient"), {.urgency = Urgency::report}),
      m_writing(parts.works, QStringLiteral("case report"), work()) {
    connect(&m_parts.works, &Works::changed, this, &ReportSaving::followRest);
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, this, [this] {
        m_impression.clear();
        m_comment.clear();
        if (m_wanted)
            endUnwritten(tr("The case report %1 was not written, since another study was opened before it was taken.")
                             .arg(m_parts.names.nameOfOther(m_wanted->path)));
    });
    connect(&m_parts.picture, &VolumeViewWidget::pictureDelivered, this, [this](const PictureReport& made) {
        if (made.converged) m_converged = made;
    });
}

Work ReportSaving::work() {
    return {tr("making the report"), Urgency::report, false, [this] { cancel(); }};
}

void ReportSaving::choose() {
    const Study* study = m_parts.openStudy.study();
    if (study == nullptr) return;
    ReportDialog dialog({.filesNamePatient = areDicomFiles(study->files),
                         .patientIsShown = !m_parts.names.showsNumbers(),
                         .note = QString::fromStdString(burnedInTextNote(*study)),
                         .comment = m_comment,
                         .impression = m_impression},
                        &m_parts.window);
    bool isOfOther = false;
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, &dialog, [&] {
        isOfOther = true;
        dialog.reject();
    });
    connect(&dialog, &ReportDialog::patientAsked, this, [&] { showPatientOfFiles(dialog); });
    const bool isAccepted = dialog.exec() == QDialog::Accepted;
    m_reading.cancel();
    if (isOfOther) return;
    const ReportChoice choice = dialog.choice();
    m_impression = choice.impression;
    m_comment = choice.comment;
    if (!isAccepted) return;
    const QString path = chooseFileToSave(m_parts.window, m_parts.settings, m_parts.openStudy,
                                          {.title = tr("Save case report"),
                                           .filter = tr("Web page or PDF (*.html *.pdf)"),
                                           .name = m_parts.proposedName(QStringLiteral("report")),
                                           .suffix = QStringLiteral("html")});
    if (path.isEmpty()) return;
    save(path, {.impression = choice.impression.toStdString(),
                .comment = choice.comment.toStdString(),
                .withPatient = choice.withPatient,
                .patient = {.name = choice.patient.name.toStdString(),
                            .id = choice.patient.id.toStdString(),
                            .birthDate = choice.patient.birthDate.toStdString(),
                            .sex = choice.patient.sex.toStdString(),
                            .studyDate = choice.patient.examDate.toStdString(),
                            .gestationalAge = choice.patient.gestationalAge.toStdString()},
                .restFromFiles = choice.restFromFiles,
                .withAppendix = choice.withAppendix});
}

std::optional<PatientSource> ReportSaving::patientSource() const {
    const Study* study = m_parts.openStudy.study();
    if (study == nullptr) return std::nullopt;
    const auto* file = std::get_if<StudyFile>(&m_parts.openStudy.reference());
    return PatientSource{study->files, file ? file->options.series : std::string()};
}

/// Reads the patient for the dialog, which may be gone before that has ended.
void ReportSaving::showPatientOfFiles(ReportDialog& dialog) {
    m_reading.submit([this, source = *patientSource(),
                      asking = QPointer(&dialog)](const Progress& progress) -> NewestWinsThread::Deliver {
        const auto patient = restricted::readPatient(source.files, source.series, progress);
        return [this, patient, asking] {
            if (!asking) return;
            if (!patient) return asking->showPatientProblem(m_parts.names.sentenceOf(patient.error()));
            asking->showPatient(shownPatient(*patient));
        };
    });
}

void ReportSaving::save(const QString& path, const ReportWords& words) {
    if (m_parts.openStudy.study() == nullptr) return;
    if (m_wanted || m_writing.busy()) {
        m_parts.messages.showMessage(MessageKind::info, tr("A report is being made. Wait for it, or cancel it."),
                                     MessageEnd::withStudy(reportTopic));
        return;
    }
    m_parts.player.pause();
    m_wanted = Wanted{path, words};
    m_taken.reset();
    m_waits.begin();
}

void ReportSaving::cancel() {
    m_writing.cancel();
    if (m_wanted) endUnwritten(cancelledSentence(m_parts.names.nameOfOther(m_wanted->path)));
}

/// Ends a report that waits for its panes.
void ReportSaving::endUnwritten(const QString& sentence) {
    m_wanted.reset();
    m_taken.reset();
    m_parts.messages.showMessage(MessageKind::info, sentence, MessageEnd::soon(reportTopic));
    m_waits.end();
}

/// Takes the panes while they are at rest. Begins anew if that ends before all are taken.
void ReportSaving::followRest() {
    if (!m_parts.works.atRest()) return m_taken.reset();
    if (!m_wanted || m_taken) return;
    m_taken = Taken{windowState(), 0};
    takeNextSoon();
}

void ReportSaving::takeNextSoon() {
    if (std::exchange(m_takesSoon, true)) return;
    QMetaObject::invokeMethod(this, &ReportSaving::takeNext, Qt::QueuedConnection);
}

void ReportSaving::takeNext() {
    m_takesSoon = false;
    if (!m_wanted || !m_taken) return;
    if (m_taken->panes == paneCount) return write();
    if (auto taken = pane(m_taken->panes++)) m_taken->report.panes.push_back(std::move(*taken));
    takeNextSoon();
}

void ReportSaving::write() {
    const Wanted wanted = *std::exchange(m_wanted, std::nullopt);
    CaseReport taken = std::move(std::exchange(m_taken, std::nullopt)->report);
    const Study& study = *m_parts.openStudy.study();
    taken.impression = wanted.words.impression;
    taken.comment = wanted.words.comment;
    taken.withAppendix = wanted.words.withAppendix;
    std::optional<PatientSource> source;
    if (wanted.words.withPatient) {
        taken.patient = wanted.words.patient;
        if (wanted.words.restFromFiles) source = patientSource();
    }
    m_writing.begin(
        wanted.path,
        [source, report = std::move(taken), inputs = study.files, path = wanted.path.toStdString()](
            const Progress& progress) { return writeReport(report, source, inputs, path, progress); },
        [this, path = wanted.path](const Result<void>& written) { tell(path, written); });
    m_waits.end();
}

CaseReport ReportSaving::windowState() const {
    const OpenStudy& openStudy = m_parts.openStudy;
    const Study& study = *openStudy.study();
    StudyNames& names = m_parts.names;
    const auto shown = [&](const std::string& text) { return names.shown(QString::fromStdString(text)).toStdString(); };
    CaseReport report;
    report.study = openStudy.isSimulatedScan() ? tr("simulated scan") : names.nameOf(openStudy.path());
    report.made = QDateTime::currentDateTime().toString(Qt::ISODate).replace('T', ' ');
    report.version = QApplication::applicationVersion();
    report.explanation = m_parts.explanation().split(QStringLiteral("\n\n"), Qt::SkipEmptyParts);
    report.document = m_parts.model.document();
    report.adaptive = m_parts.editor.state().adaptive;
    if (m_parts.editor.state().designed) {
        report.designer = m_parts.editor.state().designer;
        report.designed = m_parts.editor.state().design;
        if (const auto made = m_parts.otfs.designOf(firstPane)) report.designedWith = made->asked.config;
    }
    report.histogram = openStudy.histogram();
    report.geometry = openStudy.volume()->geometry();
    report.phases = study.phases.size();
    const auto& finds = openStudy.finds();
    for (const ImportFact& fact : finds ? importReport(study, finds->beam) : study.facts)
        report.facts.push_back({fact.name, shown(fact.value), shown(fact.source)});
    for (const std::string& warning : study.warnings)
        report.warnings.push_back(names.shownOfFile(QString::fromStdString(warning)).toStdString());
    report.times = times();
    return report;
}

std::optional<ReportPane> ReportSaving::pane(std::size_t index) const {
    const std::array captions{tr("Plane A"), tr("Plane B"), tr("Plane C"), tr("3D view")};
    if (index < m_parts.planes.size()) {
        PlanePane& plane = *m_parts.planes[index];
        if (!plane.isVisible() || !plane.scene()) return std::nullopt;
        return ReportPane{captions[index], imageOfPane(plane)};
    }
    if (!m_parts.picture.isVisible()) return std::nullopt;
    return ReportPane{captions[index], pictureToKeep(m_parts.picture, m_parts.openStudy, m_parts.model.document()),
                      true};
}

std::vector<ReportTime> ReportSaving::times() const {
    std::vector<ReportTime> times;
    const OpenStudy& openStudy = m_parts.openStudy;
    if (const auto loading = openStudy.loadingMilliseconds())
        times.push_back({tr("opening: reading the files, looking for beam and cut"), *loading});
    if (const auto quietening = openStudy.quieteningMilliseconds())
        times.push_back({tr("speckle reduction of all volumes that are kept"), *quietening});
    if (const auto otf = m_parts.otfs.adaptive()) times.push_back({tr("adaptive OTF"), otf->times.total});
    if (const auto made = m_parts.otfs.designOf(firstPane))
        times.push_back({tr("OTF of the designer %1").arg(labelOf(made->asked.config)), made->milliseconds});
    if (m_converged)
        times.push_back({tr("converged picture of the 3D view, %1 × %2 rays")
                             .arg(m_converged->rays.width())
                             .arg(m_converged->rays.height()),
                         m_converged->castMilliseconds});
    return times;
}

void ReportSaving::tell(const QString& path, const Result<void>& written) {
    const QString name = m_parts.names.nameOfOther(path);
    if (written)
        m_parts.messages.showMessage(MessageKind::info, tr("The case report was saved as %1.").arg(name),
                                     MessageEnd::soon(reportTopic));
    else if (written.error().kind == FailureKind::cancelled)
        m_parts.messages.showMessage(MessageKind::info, cancelledSentence(name), MessageEnd::soon(reportTopic));
    else
        m_parts.messages.showMessage(MessageKind::error, m_parts.names.sentenceOf(written.error()),
                                     MessageEnd::withStudy(reportTopic));
}

}  // namespace echolucent
