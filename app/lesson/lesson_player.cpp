#include "app/lesson/lesson_player.h"

#include <QFileDialog>
#include <QMainWindow>
#include <algorithm>
#include <utility>

#include "app/compare/compare_room.h"
#include "app/explain/tube_core_choice.h"
#include "app/lesson/lesson_stage.h"
#include "app/lesson/shipped_lessons.h"
#include "app/motion/motion_player.h"
#include "app/otf/pane_otfs.h"
#include "app/sessions/session_keeping.h"
#include "io/document/document_paths.h"
#include "processing/document/panes.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/controls/message_bar.h"
#include "widgets/lesson/lessons_panel.h"

namespace echolucent {

namespace {

constexpr const char* lessonTopic = "lesson";
constexpr double percent = 100.0;
constexpr std::string_view tubeCoreName = "measured.tube_core";

QString words(const std::string& text) { return QString::fromStdString(text); }

/// The value of "measured.panes[N].KEY".
std::optional<DocumentValue> measuredOf(const CompareRow& row, std::string_view key) {
    if (key == "contrast") return row.contrast ? std::optional<DocumentValue>(*row.contrast) : std::nullopt;
    if (!row.depth) return std::nullopt;
    for (const auto& [name, shown] : {std::pair<std::string_view, ShownSurface>{"right", ShownSurface::right},
                                      {"early", ShownSurface::early},
                                      {"late", ShownSurface::late},
                                      {"never", ShownSurface::never}})
        if (name == key)
            if (const auto share = row.depth->share(shown)) return DocumentValue(percent * *share);
    return std::nullopt;
}

}  // namespace

LessonPlayer::LessonPlayer(const Parts& parts, QObject* parent) : QObject(parent), m_parts(parts) {
    connectPanel();
    connect(&m_parts.openStudy, &OpenStudy::loadingBegun, this, [this] {
        if (!m_asking) m_entering.reset();
    });
    connect(&m_parts.openStudy, &OpenStudy::openFailed, this, [this] { m_entering.reset(); });
    connect(&m_parts.openStudy, &OpenStudy::aboutToReplace, this, [this] {
        m_arriving = m_entering.has_value();
        if (m_arriving) return keepBefore();
        if (!m_before) return;
        m_parts.shown.takeOverFrom(m_before->document);  // the next study is the person's, not the lesson's
        if (!m_lesson) m_before.reset();
    });
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, this, [this] {
        if (std::exchange(m_arriving, false))
            begin();
        else if (m_lesson && !m_asking)
            end();  // another study was opened
    });
    // Queued: if the study came, it has been opened by then, else loading was cancelled.
    connect(
        &m_parts.openStudy, &OpenStudy::loadingChanged, this,
        [this] {
            if (m_parts.openStudy.loading()) return;
            m_entering.reset();
            if (m_leaving) leaveNow();
        },
        Qt::QueuedConnection);
    connect(&m_parts.model, &DocumentModel::changed, this, &LessonPlayer::look);
    // Queued: an OTF that was kept arrives before the numbers that were measured of the one before are gone.
    connect(&m_parts.otfs, &PaneOtfs::computed, this, &LessonPlayer::look, Qt::QueuedConnection);
    connect(&m_parts.tubeCore, &TubeCoreChoice::chosen, this, &LessonPlayer::look);
    // What is measured is there once a work has ended.
    connect(&m_parts.works, &Works::changed, this, &LessonPlayer::look, Qt::QueuedConnection);
}

void LessonPlayer::connectPanel() {
    LessonsPanel& panel = m_parts.panel;
    connect(&panel, &LessonsPanel::listWanted, this, [this] { (void)lessons(); });
    connect(&panel, &LessonsPanel::beginRequested, this, [this](int lesson) {
        if (lesson >= 0 && static_cast<std::size_t>(lesson) < lessons().size())
            enter(Lesson(lessons()[static_cast<std::size_t>(lesson)]));
    });
    connect(&panel, &LessonsPanel::openRequested, this, &LessonPlayer::chooseFolder);
    connect(&panel, &LessonsPanel::leaveRequested, this, &LessonPlayer::leave);
    connect(&panel, &LessonsPanel::nextRequested, this, &LessonPlayer::next);
    connect(&panel, &LessonsPanel::backRequested, this, &LessonPlayer::back);
    connect(&panel, &LessonsPanel::solveRequested, this, &LessonPlayer::solve);
    connect(&panel, &LessonsPanel::resetRequested, this, &LessonPlayer::reset);
    connect(&panel, &LessonsPanel::answeredRight, this, [this] { m_progress.at(m_step).answered = true; });
}

const std::vector<Lesson>& LessonPlayer::lessons() {
    if (m_lessons) return *m_lessons;
    m_lessons.emplace();
    QList<LessonEntry> entries;
    for (const QString& name : shippedLessons()) {
        auto lesson = lessonFrom(filesOfShipped(name));
        if (!lesson) {  // a test reads them all
            m_parts.messages.showMessage(MessageKind::error, words(lesson.error().sentence()),
                                         MessageEnd::soon(lessonTopic));
            continue;
        }
        const LessonText& text = textIn(*lesson, languageOfDesktop());
        entries << LessonEntry{words(text.title), words(text.summary), lesson->minutes};
        m_lessons->push_back(std::move(*lesson));
    }
    m_parts.panel.setLessons(entries);
    return *m_lessons;
}

void LessonPlayer::chooseFolder() {
    const QString folder = QFileDialog::getExistingDirectory(&m_parts.window, tr("Open a lesson"));
    if (!folder.isEmpty()) enterFolder(folder);
}

void LessonPlayer::enterFolder(const QString& folder) {
    auto lesson = readLesson(folder.toStdString());
    if (lesson) return enter(*lesson);
    m_parts.messages.showMessage(MessageKind::error, words(lesson.error().sentence()),
                                 MessageEnd::withStudy(lessonTopic));
}

void LessonPlayer::enter(const Lesson& lesson, std::size_t first) {
    if (m_parts.sessions.saving()) {
        m_parts.messages.showMessage(MessageKind::info,
                                     tr("The session is being saved. Begin the lesson once that is done."),
                                     MessageEnd::soon(lessonTopic));
        return;
    }
    // If no study was open before a lesson, its scan stays until that of the next lesson comes.
    if (!m_before || m_before->study) leaveNow();
    m_parts.messages.takeBack(lessonTopic);
    m_entering = lesson;
    m_first = first;
    m_asking = true;
    m_parts.openStudy.openSimulatedScan(lesson.begins);
    m_asking = false;
}

/// The lesson's scan is made and is about to take the place of the person's study.
void LessonPlayer::keepBefore() {
    const bool compares = m_parts.compare.shown();
    m_parts.compare.setShown(false);
    if (!m_before)  // else a lesson's own scan is shown
        m_before = Before{m_parts.openStudy.keep(), m_parts.shown.keep(), m_parts.face(), compares};
    m_parts.sessions.putAside();
}

void LessonPlayer::begin() {
    emit aboutToArrange();
    m_lesson = std::exchange(m_entering, std::nullopt);
    m_progress.assign(m_lesson->steps.size(), {});
    m_parts.chooseFace(Face::teach);
    m_parts.stage.enter();
    goTo(m_first, m_first > 0 ? std::optional(documentBefore(*m_lesson, m_first)) : std::nullopt);
    emit playingChanged(true);
}

void LessonPlayer::leave() {
    m_leaving = m_lesson && !m_entering && m_parts.openStudy.loading();
    if (!m_leaving) leaveNow();
}

void LessonPlayer::leaveNow() {
    m_entering.reset();
    m_leaving = false;
    if (!m_lesson) return;
    std::optional<Before> before = std::exchange(m_before, std::nullopt);
    end();
    m_parts.player.pause();
    m_parts.compare.setShown(false);
    if (before && before->study) {
        m_parts.shown.bringBack(before->document);
        m_parts.sessions.takeBack();
        m_parts.openStudy.comeBack(*before->study);
        m_parts.compare.setShown(before->compares);
    } else if (before) {
        m_parts.openStudy.openSimulatedScan();  // nothing was open, as at a start
    }
    if (before) m_parts.chooseFace(before->face);
    if (before && !before->study) m_before = std::move(before);  // until the scan of the start comes
}

void LessonPlayer::end() {
    emit aboutToArrange();
    m_lesson.reset();
    m_before.reset();
    m_progress.clear();
    m_step = 0;
    m_leaving = false;
    m_parts.stage.leave();
    m_parts.panel.showList();
    emit playingChanged(false);
}

void LessonPlayer::next() {
    if (!m_lesson) return;
    if (m_step + 1 == m_lesson->steps.size()) return leave();
    const std::optional<Document>& set = m_lesson->steps[m_step + 1].set;
    if (!isDone()) set ? chooseTubeCore() : solve();
    goTo(m_step + 1, set);
}

void LessonPlayer::back() {
    if (!m_lesson || m_step == 0) return;
    const auto& began = m_progress.at(m_step - 1).began;
    goTo(m_step - 1, began ? *began : documentBefore(*m_lesson, m_step - 1));
}

void LessonPlayer::solve() {
    if (!m_lesson) return;
    if (const auto& solved = m_lesson->steps.at(m_step).solved) showOfStep(*solved);
    chooseTubeCore();
}

/// The one that the step asks for, if it does.
void LessonPlayer::chooseTubeCore() {
    const auto& until = m_lesson->steps.at(m_step).until;
    if (until && until->kind == ConditionKind::equal && until->name == tubeCoreName)
        if (const auto* number = std::get_if<double>(&until->value)) m_parts.tubeCore.choose(static_cast<int>(*number));
}

void LessonPlayer::reset() {
    if (!m_lesson || !m_progress.at(m_step).began) return;
    showOfStep(*m_progress[m_step].began);
    m_parts.stage.resetStep();
}

void LessonPlayer::goTo(std::size_t step, const std::optional<Document>& document) {
    m_step = step;
    const auto& set = m_lesson->steps.at(step).set;
    if (document)
        showOfStep(*document);
    else if (step == 0 && set)
        showOfStep(*set);
    m_progress.at(step).began = m_parts.model.ownDocument();
    showPage();
    m_parts.stage.beginStep(words(m_lesson->steps[step].lookAt));
    look();
    emit stepChanged(step);
}

void LessonPlayer::showOfStep(const Document& document) {
    show(document, tr("lesson: %1").arg(words(textIn(*m_lesson, languageOfDesktop()).steps.at(m_step).title)));
}

void LessonPlayer::show(const Document& document, const QString& step) {
    m_parts.player.pause();
    Document wanted = document;
    wanted.study = m_parts.openStudy.reference();
    if (!isCompared(document)) m_parts.compare.setShown(false);  // panes that are only looked at go too
    m_parts.model.editWithFrame(wanted, step);
    m_parts.model.showFrame(wanted.scene.motionAngle, wanted.scene.phase);  // another axis begins the motion anew
    m_parts.compare.setShown(isCompared(document));
}

void LessonPlayer::showPage() {
    const LessonText& text = textIn(*m_lesson, languageOfDesktop());
    const LessonStepText& said = text.steps.at(m_step);
    const LessonStep& step = m_lesson->steps[m_step];
    LessonPage page{words(text.title), words(said.title),    words(said.text),
                    words(said.hint),  words(said.question), words(said.explanation)};
    for (const std::string& answer : said.answers) page.answers << words(answer);
    page.number = static_cast<int>(m_step) + 1;
    page.count = static_cast<int>(m_lesson->steps.size());
    page.right = static_cast<int>(step.right);
    page.task = step.until.has_value();
    page.done = isDone();
    page.answered = m_progress.at(m_step).answered;
    for (const auto& [name, bytes] : m_lesson->images)
        page.images.insert(words(name), QByteArray::fromStdString(bytes));
    m_parts.panel.showPage(page);
}

bool LessonPlayer::isDone() const {
    return m_lesson && (!m_lesson->steps.at(m_step).until || m_progress.at(m_step).done);
}

/// Finds out whether the step is done now.
void LessonPlayer::look() {
    if (!m_lesson || isDone() || m_parts.openStudy.beginning()) return;
    const LessonCondition& until = *m_lesson->steps[m_step].until;
    std::vector<std::string> paths = namesIn(until);
    std::erase_if(paths, [](const std::string& name) { return isLessonMeasure(name); });
    const auto values = valuesAt(m_parts.model.document(), paths);
    const auto valueOf = [&](std::string_view name) {
        if (isLessonMeasure(name)) return measured(name);
        return values[static_cast<std::size_t>(std::ranges::find(paths, name) - paths.begin())];
    };
    if (!holds(until, valueOf)) return;
    m_progress[m_step].done = true;
    m_parts.panel.setDone(true);
}

std::optional<DocumentValue> LessonPlayer::measured(std::string_view name) const {
    if (const auto open = name.find('['); open != std::string_view::npos) {
        const std::vector<CompareRow>& rows = m_parts.measured.rows();
        const auto pane = static_cast<std::size_t>(name[open + 1] - '0');
        if (!m_parts.compare.shown() || pane >= rows.size()) return std::nullopt;
        return measuredOf(rows[pane], name.substr(name.rfind('.') + 1));
    }
    if (name == tubeCoreName) {
        const auto number = m_parts.tubeCore.number();
        return number ? std::optional(DocumentValue(static_cast<double>(*number))) : std::nullopt;
    }
    const auto otf = m_parts.otfs.adaptive();
    if (!otf || !m_parts.otfs.isNewest(PaneOtfs::adaptiveOfScene)) return std::nullopt;
    return DocumentValue(
        static_cast<double>(name == "measured.tubes" ? otf->tubesMeetingVolume : otf->tubesWithWeight));
}

}  // namespace echolucent
