#include "app/lesson/lesson_author.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMainWindow>
#include <QStandardPaths>
#include <algorithm>
#include <utility>

#include "app/compare/compare_room.h"
#include "app/lesson/lesson_handouts.h"
#include "app/lesson/lesson_player.h"
#include "app/lesson/shipped_lessons.h"
#include "app/sessions/snapshots.h"
#include "app/settings/settings.h"
#include "app/study/study_names.h"
#include "io/document/document_paths.h"
#include "io/lesson/lesson_file.h"
#include "io/lesson/lesson_text.h"
#include "processing/document/panes.h"
#include "widgets/controls/message_bar.h"
#include "widgets/lesson/lesson_editor.h"
#include "widgets/lesson/lesson_step_editor.h"
#include "widgets/lesson/lessons_panel.h"

namespace echolucent {

namespace {

constexpr const char* authorTopic = "lesson that is written";
constexpr int keepingMilliseconds = 1000;

/// The desktop's language without its country, as it names a file of texts.
std::string languageOfTexts() {
    const std::string language = QLocale().name().section('_', 0, 0).toLower().toStdString();
    return isLessonLanguage(language) ? language : "en";
}

bool asksMeasures(const LessonCondition& condition) {
    return std::ranges::any_of(namesIn(condition), [](const std::string& name) { return isLessonMeasure(name); });
}

bool holdsIn(const Document& document, const LessonCondition& condition) {
    const std::vector<std::string> names = namesIn(condition);
    const auto values = valuesAt(document, names);
    return holds(condition, [&](std::string_view name) {
        return values[static_cast<std::size_t>(std::ranges::find(names, name) - names.begin())];
    });
}

/// Every name that a condition may ask for, of the document and measured.
QStringList namesFor(const Document& document) {
    QStringList names;
    for (const std::string& path : pathsOf(document)) names << QString::fromStdString(path);
    for (const LessonMeasure& measure : lessonMeasures()) {
        const QString name = QString::fromUtf8(measure.name.data(), static_cast<qsizetype>(measure.name.size()));
        if (!name.contains("[N]"))
            names << name;
        else
            for (std::size_t pane = 0; pane < mostPanes; ++pane)
                names << QString(name).replace("[N]", QStringLiteral("[%1]").arg(pane));
    }
    return names;
}

}  // namespace

LessonAuthor::LessonAuthor(const Parts& parts, QObject* parent)
    : QObject(parent), m_parts(parts), m_drafts(parts.settings.dataFolder() + QStringLiteral("/lesson-drafts")) {
    m_keeping.setSingleShot(true);
    m_keeping.setInterval(keepingMilliseconds);
    connect(&m_keeping, &QTimer::timeout, this, &LessonAuthor::keep);
    LessonsPanel& panel = m_parts.panel;
    connect(&panel, &LessonsPanel::listWanted, this, [this] { m_parts.panel.setDrafts(m_drafts.list()); });
    connect(&panel, &LessonsPanel::newRequested, this, &LessonAuthor::beginNew);
    connect(&panel, &LessonsPanel::editCopyRequested, this, [this](int lesson) {
        if (lesson >= 0 && static_cast<std::size_t>(lesson) < m_parts.player.lessons().size())
            editCopy(m_parts.player.lessons()[static_cast<std::size_t>(lesson)]);
    });
    connect(&panel, &LessonsPanel::editFolderRequested, this, [this] {
        const QString folder =
            QFileDialog::getExistingDirectory(&m_parts.window, tr("Edit a lesson"), m_parts.settings.lastSaveFolder());
        if (!folder.isEmpty()) editFolder(folder);
    });
    connect(&panel, &LessonsPanel::handoutRequested, this, [this](int lesson) {
        if (lesson >= 0 && static_cast<std::size_t>(lesson) < m_parts.player.lessons().size())
            m_parts.handouts.choose(m_parts.player.lessons()[static_cast<std::size_t>(lesson)], languageOfDesktop());
    });
    // Queued: the menu that asks for a draft is filled again.
    connect(&panel, &LessonsPanel::draftRequested, this, &LessonAuthor::continueDraft, Qt::QueuedConnection);
    connectEditor();
    connect(&m_parts.snapshots, &Snapshots::changed, this, &LessonAuthor::followStudy);
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, this, &LessonAuthor::followStudy);
    connect(&m_parts.player, &LessonPlayer::playingChanged, this, [this](bool playing) {
        followStudy();
        if (!playing && m_draft) m_parts.panel.showEditor();
    });
    followStudy();
}

LessonAuthor::~LessonAuthor() {
    m_parts.panel.editor().stepEditor().setPresentValue({});
    if (m_draft && !isUnsaved())
        m_drafts.discard();
    else
        keep();
}

void LessonAuthor::connectEditor() {
    LessonEditor& editor = m_parts.panel.editor();
    LessonStepEditor& step = editor.stepEditor();
    step.setWindow(m_parts.window);
    step.setPresentValue([this](std::string_view name) -> std::optional<DocumentValue> {
        if (isLessonMeasure(name)) return m_parts.player.measured(name);
        return valuesAt(m_parts.model.document(), {std::string(name)}).front();
    });
    connect(&editor, &LessonEditor::edited, this, &LessonAuthor::takeEdited);
    connect(&editor, &LessonEditor::addRequested, this, [this] {
        edit([this](Lesson& lesson, std::size_t& chosen) {
            const std::size_t place = std::min(chosen + 1, lesson.steps.size());
            insertStep(lesson, place, tr("New step").toStdString(), presentView());
            chosen = place;
        });
    });
    connect(&editor, &LessonEditor::takeViewRequested, this, [this] {
        edit([this](Lesson& lesson, std::size_t& chosen) { lesson.steps.at(chosen).set = presentView(); });
    });
    connect(&editor, &LessonEditor::solveRequested, this, [this] {
        edit([this](Lesson& lesson, std::size_t& chosen) { lesson.steps.at(chosen).solved = presentView(); });
    });
    connect(&editor, &LessonEditor::showRequested, this, &LessonAuthor::show);
    connect(&editor, &LessonEditor::playRequested, this, &LessonAuthor::play);
    connect(&editor, &LessonEditor::saveRequested, this, &LessonAuthor::chooseAndSave);
    connect(&editor, &LessonEditor::handoutRequested, this, [this] {
        if (m_draft)
            m_parts.handouts.choose(trimmed(m_draft->lesson), m_draft->lesson.texts.at(m_draft->language).language);
    });
    connect(&editor, &LessonEditor::discardRequested, this, &LessonAuthor::discard);
    connect(&editor, &LessonEditor::closeRequested, this, &LessonAuthor::close);
}

void LessonAuthor::beginNew() {
    const StudyReference study = m_parts.openStudy.reference();
    const std::vector<Snapshot>& snapshots = m_parts.snapshots.list();
    if (!whyNoLesson(study, snapshots.size()).empty()) return;
    const Lesson lesson = lessonOfSnapshots(std::get<SimulatedScan>(study), snapshots, languageOfTexts());
    m_drafts.begin();
    LessonDraft draft;
    draft.lesson = lesson;
    showDraft(draft, lesson);
}

void LessonAuthor::editCopy(const Lesson& lesson) {
    LessonDraft draft;
    draft.lesson = lesson;
    const LessonText& shown = textIn(lesson, languageOfTexts());
    draft.language = static_cast<std::size_t>(&shown - lesson.texts.data());
    m_drafts.begin();
    showDraft(draft, lesson);
}

void LessonAuthor::editFolder(const QString& folder) {
    const auto lesson = readLesson(folder.toStdString());
    if (!lesson)
        return m_parts.messages.showMessage(MessageKind::error, QString::fromStdString(lesson.error().sentence()),
                                            MessageEnd::withStudy(authorTopic));
    m_drafts.begin();
    LessonDraft draft;
    draft.lesson = *lesson;
    draft.folder = QFileInfo(folder).absoluteFilePath().toStdString();
    showDraft(draft, *lesson);
}

void LessonAuthor::continueDraft(const QString& folder) {
    keep();
    const auto draft = m_drafts.goOn(folder);
    if (!draft)
        return m_parts.messages.showMessage(MessageKind::error, QString::fromStdString(draft.error().sentence()),
                                            MessageEnd::withStudy(authorTopic));
    std::optional<Lesson> elsewhere;
    if (!draft->folder.empty())
        if (const auto saved = readLesson(draft->folder)) elsewhere = *saved;
    showDraft(*draft, elsewhere);
}

/// Shows a draft to be written on. Its folder is that of m_drafts.
void LessonAuthor::showDraft(const LessonDraft& draft, const std::optional<Lesson>& elsewhere) {
    m_parts.messages.takeBack(authorTopic);
    m_draft = draft;
    m_elsewhere = elsewhere;
    m_keeping.stop();
    LessonEditor& editor = m_parts.panel.editor();
    editor.stepEditor().setTargets(lessonTargets(m_parts.window));
    editor.setDraft(draft);
    showNames();
    check();
    followStudy();
    if (!m_parts.player.playing()) m_parts.panel.showEditor();
}

void LessonAuthor::end() {
    m_draft.reset();
    m_keeping.stop();
    m_parts.panel.setDrafts(m_drafts.list());
    if (!m_parts.player.playing()) m_parts.panel.showList();
}

bool LessonAuthor::isUnsaved() const { return m_draft && (!m_elsewhere || trimmed(m_draft->lesson) != *m_elsewhere); }

void LessonAuthor::keep() {
    m_keeping.stop();
    if (!m_draft || !isUnsaved()) return;
    if (const auto written = m_drafts.write(*m_draft); !written)
        m_parts.messages.showMessage(MessageKind::warning, QString::fromStdString(written.error().sentence()),
                                     MessageEnd::whenTakenBack(authorTopic));
}

void LessonAuthor::close() {
    if (isUnsaved()) {
        keep();
        m_drafts.leave();
    } else {
        m_drafts.discard();
    }
    end();
}

void LessonAuthor::discard() {
    if (!m_draft) return;
    const bool unsaved = isUnsaved();
    const LessonDraft draft = *m_draft;
    const auto elsewhere = m_elsewhere;
    m_drafts.discard();
    end();
    if (unsaved)
        m_parts.messages.showMessage(MessageKind::info, tr("What was written of the lesson was thrown away."),
                                     MessageEnd::soon(authorTopic), {{tr("Bring back"), [this, draft, elsewhere] {
                                                                          if (m_draft) close();
                                                                          m_drafts.begin();
                                                                          showDraft(draft, elsewhere);
                                                                          m_keeping.start();
                                                                      }}});
}

/// A change that no field of the editor made.
void LessonAuthor::edit(const std::function<void(Lesson& lesson, std::size_t& step)>& change) {
    if (!m_draft || !scanIsOpen()) return;
    change(m_draft->lesson, m_draft->step);
    m_parts.panel.editor().setDraft(*m_draft);
    m_keeping.start();
    showNames();
    check();
}

void LessonAuthor::takeEdited() {
    if (!m_draft) return;
    const std::size_t before = m_draft->step;
    m_draft = m_parts.panel.editor().draft();
    if (!m_keeping.isActive()) m_keeping.start();
    if (m_draft->step != before) showNames();
    check();
}

void LessonAuthor::check() {
    const Lesson& lesson = m_draft->lesson;
    LessonNames names;
    names.isControl = [this](const std::string& name) {
        return m_parts.window.findChild<QWidget*>(QString::fromStdString(name)) != nullptr;
    };
    names.isValue = [&lesson](std::size_t step, const std::string& name) {
        return isLessonMeasure(name) || valueAt(documentBefore(lesson, step), name) ||
               valueAt(documentAfter(lesson, step), name);
    };
    std::vector<LessonProblem> problems = problemsOf(lesson, names);
    std::ranges::copy(problemsOfMarkdown(trimmed(lesson)), std::back_inserter(problems));
    m_parts.panel.editor().setProblems(problems);
    showSolution();
}

void LessonAuthor::showNames() {
    const Lesson& lesson = m_draft->lesson;
    if (m_draft->step < lesson.steps.size())
        m_parts.panel.editor().stepEditor().setNames(namesFor(documentBefore(lesson, m_draft->step)));
}

/// Says whether the solution solves the step, as far as documents alone can say it.
void LessonAuthor::showSolution() {
    const Lesson& lesson = m_draft->lesson;
    if (m_draft->step >= lesson.steps.size()) return;
    const auto& until = lesson.steps[m_draft->step].until;
    QString sentence;
    if (until && problemOf(*until).empty() && !asksMeasures(*until)) {
        if (holdsIn(documentBefore(lesson, m_draft->step), *until))
            sentence = tr("The condition holds already as the step begins.");
        else if (lesson.steps[m_draft->step].solved)
            sentence = holdsIn(documentAfter(lesson, m_draft->step), *until) ? tr("The condition holds there.")
                                                                             : tr("The condition does not hold there.");
    }
    m_parts.panel.editor().stepEditor().setSolutionSentence(sentence);
}

void LessonAuthor::followStudy() {
    m_parts.panel.setWhyNoLesson(
        QString::fromStdString(whyNoLesson(m_parts.openStudy.reference(), m_parts.snapshots.list().size())));
    if (m_draft) m_parts.panel.editor().setViewIsOfLesson(scanIsOpen());
}

bool LessonAuthor::scanIsOpen() const {
    return m_draft && !m_parts.player.playing() && m_parts.openStudy.reference() == m_draft->lesson.begins.study;
}

Document LessonAuthor::presentView() const {
    Document view = m_parts.model.ownDocument();
    view.study = m_draft->lesson.begins.study;
    return view;
}

void LessonAuthor::show() {
    if (!m_draft || m_draft->step >= m_draft->lesson.steps.size()) return;
    const Document document = documentBefore(m_draft->lesson, m_draft->step);
    if (!scanIsOpen()) return m_parts.openStudy.openSimulatedScan(document);
    m_parts.player.show(document, tr("step of a lesson"));
}

void LessonAuthor::play() {
    if (!m_draft) return;
    keep();
    m_parts.player.enter(trimmed(m_draft->lesson), m_draft->step);
}

void LessonAuthor::chooseAndSave() {
    if (!m_draft) return;
    if (!m_draft->folder.empty()) return saveTo(QString::fromStdString(m_draft->folder));
    const Lesson none;
    const std::string name = freeLessonId(none, m_draft->lesson.texts.at(m_draft->language).title);
    const QString last = m_parts.settings.lastSaveFolder();
    const QString folder = last.isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation) : last;
    QFileDialog dialog(&m_parts.window, tr("Save lesson"), QFileInfo(folder).isWritable() ? folder : QDir::homePath());
    dialog.setObjectName("saveLesson");
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setOption(QFileDialog::DontConfirmOverwrite);
    dialog.setLabelText(QFileDialog::FileName, tr("Name of its folder:"));
    dialog.selectFile(QString::fromStdString(name));
    if (dialog.exec() != QDialog::Accepted || !m_draft) return;
    saveTo(dialog.selectedFiles().first());
}

void LessonAuthor::saveTo(const QString& folder) {
    if (!m_draft) return;
    const auto told = [&](MessageKind kind, const QString& sentence) {
        m_parts.messages.showMessage(
            kind, sentence,
            kind == MessageKind::info ? MessageEnd::soon(authorTopic) : MessageEnd::withStudy(authorTopic));
    };
    const std::string path = QFileInfo(folder).absoluteFilePath().toStdString();
    const bool isOwn = path == m_draft->folder;
    if (!isOwn && QFileInfo::exists(folder) && !(QFileInfo(folder).isDir() && QDir(folder).isEmpty()))
        return told(MessageKind::warning,
                    tr("%1 is there already. Choose another name.").arg(m_parts.names.nameOfOther(folder)));
    const Lesson lesson = trimmed(m_draft->lesson);
    if (const auto there = readLesson(path); isOwn && (!there || !m_elsewhere || *there != *m_elsewhere)) {
        m_draft->folder.clear();
        return told(MessageKind::warning, tr("%1 was changed since it was opened here, and stays as it is. Save the "
                                             "lesson again, under another name.")
                                              .arg(m_parts.names.nameOfOther(folder)));
    }
    if (const auto written = writeLesson(path, lesson); !written)
        return told(MessageKind::error, QString::fromStdString(written.error().sentence()));
    m_parts.settings.setLastSaveFolder(QFileInfo(folder).absolutePath());
    m_drafts.discard();
    m_drafts.begin();
    m_draft->folder = path;
    m_parts.panel.editor().setDraft(*m_draft);
    m_elsewhere = lesson;
    m_keeping.stop();
    told(MessageKind::info,
         tr("The lesson was saved in %1. \"Open a lesson…\" plays it.").arg(m_parts.names.nameOfOther(folder)));
}

}  // namespace echolucent
