#include "app/sessions/session_keeping.h"

#include <QDir>
#include <QFileInfo>
#include <QMainWindow>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>
#include <algorithm>
#include <exception>
#include <utility>

#include "app/study/study_names.h"
#include "app/window/save_dialog.h"
#include "app/window/settings.h"
#include "io/document/session_file.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/message_bar.h"

namespace echolucent {

namespace {

/// Without what plays, and what is known of the study's bytes.
Document comparable(Document document, const Document& like) {
    if (nameTheSame(document.study, like.study)) document.study = like.study;
    return withShown(std::move(document), like);
}

}  // namespace

SessionKeeping::SessionKeeping(const Parts& parts)
    : QObject(&parts.window),
      m_parts(parts),
      m_autosave(std::make_unique<Autosave>(parts.settings.autosaveFolder(), [this] { return present(); })),
      m_taking(QStringLiteral("left sessions")),
      m_saving(QStringLiteral("session saving")) {
    connect(&m_parts.model, &DocumentModel::changed, this, &SessionKeeping::noteChange);
    connect(&m_snapshots, &Snapshots::changed, this, &SessionKeeping::noteChange);
    connect(&m_parts.shown, &ShownStudy::aboutToBegin, this, &SessionKeeping::leave);
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, this, &SessionKeeping::begin);
    connect(&m_parts.openStudy, &OpenStudy::studyNamed, this,
            [this] { m_parts.model.noteChecksum(m_parts.openStudy.reference()); });
    connect(m_autosave.get(), &Autosave::busyChanged, this, &SessionKeeping::busyChanged);
    connect(m_autosave.get(), &Autosave::failed, this, [this](const QString& sentence) {
        m_parts.messages.showMessage(MessageKind::warning, m_parts.names.shownOfFile(sentence));
    });
    connect(&m_parts.openStudy, &OpenStudy::takingChecksumChanged, this, [this](bool taking) {
        if (!taking) writeWaiting();
    });
    constexpr int lookEvery = 100;  // ms
    m_looking.setSingleShot(true);
    m_looking.setInterval(lookEvery);
    connect(&m_looking, &QTimer::timeout, this, &SessionKeeping::look);
    connect(&m_taking, &NewestWinsThread::busyChanged, this, &SessionKeeping::busyChanged);
    connect(&m_saving, &NewestWinsThread::busyChanged, this, &SessionKeeping::busyChanged);
    m_taking.submit([this, folder = m_parts.settings.autosaveFolder()](const Progress&) -> NewestWinsThread::Deliver {
        auto found = takeLeftovers(folder);
        return [this, left = std::move(found)] {
            m_leftovers.insert(m_leftovers.end(), left.begin(), left.end());
            if (m_parts.openStudy.study() != nullptr) offerLeftovers();
        };
    });
}

SessionKeeping::~SessionKeeping() {
    look();
    // The document is still there, the window's other parts are not.
    m_autosave->keepAtEnd(m_changed && m_parts.openStudy.study() != nullptr);
    m_autosave.reset();
}

SavedSession SessionKeeping::present() const {
    return {.document = m_parts.model.document(), .snapshots = m_snapshots.list(), .file = m_file.toStdString()};
}

bool SessionKeeping::holdsWork() const {
    const Document& document = m_parts.model.document();
    const Document& opened = m_parts.shown.opened();
    if (!m_snapshots.list().empty() || !document.measurements.empty()) return true;
    for (const auto& strokes : document.strokes)
        if (!strokes.value.list.empty()) return true;
    for (const auto& box : document.boxes)
        if (box.value.on) return true;
    return document.cuts != opened.cuts || document.views.size() != opened.views.size();
}

void SessionKeeping::noteChange() {
    if (m_between || m_parts.openStudy.study() == nullptr) return;
    if (!m_looking.isActive()) m_looking.start();
}

void SessionKeeping::look() {
    if (m_between || m_parts.openStudy.study() == nullptr) return;
    m_looking.stop();
    const Document& document = m_parts.model.document();
    const bool changed =
        m_inFile ? m_inFile->snapshots != m_snapshots.list() || comparable(m_inFile->document, document) != document
                 : m_left || !m_file.isEmpty() || holdsWork();
    const bool touched =
        changed || comparable(m_inFile ? m_inFile->document : m_parts.shown.opened(), document) != document;
    if (touched || m_autosave->keeps()) m_autosave->noteChange();
    m_changed = changed;
    m_parts.window.setWindowModified(m_changed);
}

void SessionKeeping::leave() {
    look();
    m_between = true;
    writeWaiting();  // of the study that is left there will be no checksum
    // Another study takes over curves, look and method; a session brings its own.
    const Document& document = m_parts.model.document();
    const Document& opened = m_parts.shown.opened();
    const bool replaced = m_parts.openStudy.saved() && !m_inFile &&
                          (m_parts.editor.isManualModified() || document.curves != opened.curves ||
                           document.looks != opened.looks || document.method != opened.method);
    if (!m_changed && !replaced) return m_autosave->forget();
    const Autosave::Left left = m_autosave->leaveBehind();
    m_leftovers.push_back(
        {left.file, left.lock, QDateTime::currentDateTime(), studyPathOf(m_parts.model.document()), {}});
}

void SessionKeeping::begin() {
    const auto& saved = m_parts.openStudy.saved();
    m_between = false;
    m_changed = false;
    m_left = false;
    m_then = Then::goOn;
    m_file.clear();
    m_inFile.reset();
    const QString opened = saved ? QString::fromStdString(saved->file) : QString();
    const auto left =
        std::find_if(m_leftovers.begin(), m_leftovers.end(), [&](const Leftover& each) { return each.file == opened; });
    if (left != m_leftovers.end()) {
        m_file = QString::fromStdString(saved->session.file);
        m_left = true;
        m_autosave->replace({left->file, left->lock});
        m_leftovers.erase(left);
    } else if (saved) {
        m_file = opened;
        m_inFile = saved->session;
    }
    if (!m_file.isEmpty()) m_parts.names.knowSession(m_file, m_parts.openStudy.path());
    m_snapshots.begin(saved ? saved->session.snapshots : std::vector<Snapshot>{});
    if (m_inFile) m_parts.editor.setManualSaved();
    look();
    offerLeftovers();
}

/// Where the session is already, else beside the study's file or folder, never in that; empty for a simulated scan.
QString SessionKeeping::proposedFolder() const {
    const QString beside = m_file.isEmpty() ? QDir::cleanPath(m_parts.openStudy.path()) : m_file;
    return beside.isEmpty() ? QString() : QFileInfo(beside).absolutePath();
}

void SessionKeeping::save() {
    if (m_parts.openStudy.study() == nullptr) return;
    m_file.isEmpty() ? chooseAndSave() : saveAs(m_file);
}

void SessionKeeping::chooseAndSave(const QString& folder) {
    if (m_parts.openStudy.study() == nullptr) return;
    const QString named = m_file.isEmpty() ? m_parts.openStudy.path() : m_file;
    const QString path = chooseFileToSave(m_parts.window, m_parts.settings, m_parts.openStudy,
                                          {.title = tr("Save session"),
                                           .filter = tr("Sessions (*.session.json *.json);;All files (*)"),
                                           .name = m_parts.names.beginningFor(named),
                                           .suffix = QStringLiteral("session.json"),
                                           .folder = folder.isEmpty() ? proposedFolder() : folder});
    if (!path.isEmpty()) saveAs(path);
}

void SessionKeeping::saveAs(const QString& file, Then then) {
    const Study* study = m_parts.openStudy.study();
    if (study == nullptr) return;
    const QString whole = QFileInfo(file).absoluteFilePath();
    if (auto allowed = refuseSessionInside(m_parts.openStudy.path().toStdString(), study->files, whole.toStdString());
        !allowed)
        return offerAnotherPlace(m_parts.names.sentenceOf(allowed.error()));
    Order order{whole, present()};
    order.session.file.clear();
    m_then = then;
    if (!m_parts.openStudy.takingChecksum()) return write(std::move(order));
    m_waiting = std::move(order);
    emit busyChanged();
}

void SessionKeeping::cancelSaving() {
    if (!m_waiting) return;
    const QString file = std::exchange(m_waiting, std::nullopt)->file;
    m_then = Then::goOn;
    m_parts.messages.showMessage(MessageKind::info,
                                 tr("Saving %1 was cancelled; it is as it was.").arg(m_parts.names.nameOfOther(file)));
    emit busyChanged();
}

void SessionKeeping::writeWaiting() {
    if (!m_waiting) return;
    Order order = *std::exchange(m_waiting, std::nullopt);
    if (nameTheSame(order.session.document.study, m_parts.openStudy.reference()))
        order.session.document.study = m_parts.openStudy.reference();
    write(std::move(order));
}

void SessionKeeping::write(Order order) {
    m_saving.submit(
        [this, order = std::move(order)](const Progress&) -> NewestWinsThread::Deliver {
            const std::string file = order.file.toStdString();
            try {
                const auto written = writeSession(file, asNamedFrom(file, order.session));
                if (written) return [this, order] { takeSaved(order); };
                return [this, failure = written.error()] { offerAnotherPlace(m_parts.names.sentenceOf(failure)); };
            } catch (const std::exception& problem) {
                const Failure failure{
                    FailureKind::unwritable, file, {}, std::string("could not be written: ") + problem.what(), {}};
                return [this, failure] { offerAnotherPlace(m_parts.names.sentenceOf(failure)); };
            }
        },
        NewestWinsThread::WhenSuperseded::finish);
}

void SessionKeeping::takeSaved(const Order& order) {
    m_parts.names.knowSession(order.file, studyPathOf(order.session.document));
    m_parts.settings.addRecentFile(order.file);
    m_parts.settings.setLastSaveFolder(QFileInfo(order.file).absolutePath());
    m_parts.messages.showMessage(MessageKind::info,
                                 tr("The session was saved as %1.").arg(m_parts.names.nameOf(order.file)));
    // Meanwhile another study may have been opened, with which the window stays.
    const bool same = nameTheSame(order.session.document.study, m_parts.model.document().study);
    if (same) {
        m_file = order.file;
        m_inFile = order.session;
        m_left = false;
        m_parts.editor.setManualSaved();
        look();
        if (!m_changed) m_autosave->forget();
    }
    emit saved();
    if (same && std::exchange(m_then, Then::goOn) == Then::closeWindow) m_parts.window.close();
}

void SessionKeeping::offerAnotherPlace(const QString& sentence) {
    m_then = Then::goOn;
    m_parts.messages.showMessage(MessageKind::error, sentence, {{tr("Save it elsewhere…"), [this] {
                                                                     QString folder = QStandardPaths::writableLocation(
                                                                         QStandardPaths::DocumentsLocation);
                                                                     if (!QFileInfo(folder).isWritable())
                                                                         folder = QDir::homePath();
                                                                     chooseAndSave(folder);
                                                                 }}});
}

bool SessionKeeping::mayClose() {
    look();
    if (saving()) {
        m_then = Then::closeWindow;
        return false;
    }
    if (m_file.isEmpty() || !m_changed) return true;
    QMessageBox box(QMessageBox::NoIcon, tr("Changed session"),
                    tr("%1 was changed and is not saved.").arg(m_parts.names.nameOf(m_file)), QMessageBox::NoButton,
                    &m_parts.window);
    box.setObjectName("unsavedSession");
    QPushButton* save = box.addButton(tr("Save session"), QMessageBox::AcceptRole);
    QPushButton* discard = box.addButton(tr("Discard the changes"), QMessageBox::DestructiveRole);
    box.addButton(QMessageBox::Cancel);
    box.setDefaultButton(save);
    // The question is about the session that is open.
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, &box, &QDialog::reject);
    box.exec();
    if (static_cast<QAbstractButton*>(save) == box.clickedButton()) {
        saveAs(m_file, Then::closeWindow);
        return false;
    }
    if (static_cast<QAbstractButton*>(discard) != box.clickedButton()) return false;
    m_inFile = present();  // nothing of it is to be kept
    m_left = false;
    look();
    m_autosave->forget();
    m_parts.editor.setManualSaved();
    return true;
}

void SessionKeeping::offerLeftovers() {
    while (!m_leftovers.empty() && !m_leftovers.front().damaged.isEmpty()) {
        m_parts.messages.showMessage(MessageKind::warning,
                                     tr("What was kept of an unsaved session is damaged and was put aside. %1")
                                         .arg(m_parts.names.shownOfFile(m_leftovers.front().damaged)));
        m_leftovers.pop_front();
        if (!m_leftovers.empty()) return;  // the others are offered with the next study
    }
    if (m_leftovers.empty()) return;
    const Leftover& left = m_leftovers.front();
    m_parts.messages.showMessage(
        MessageKind::warning,
        tr("A session of %1 was not saved (%2).")
            .arg(left.study.isEmpty() ? tr("the simulated scan") : m_parts.names.nameOf(left.study),
                 QLocale::c().toString(left.time, QStringLiteral("d MMM, HH:mm"))),
        {{tr("Open it"), [this] { openLeftover(); }}, {tr("Discard it"), [this] {
                                                           if (m_leftovers.empty()) return;
                                                           QFile::remove(m_leftovers.front().file);
                                                           m_leftovers.pop_front();
                                                           offerLeftovers();
                                                       }}});
}

void SessionKeeping::openLeftover() {
    if (!m_leftovers.empty()) m_parts.openStudy.openSaved(m_leftovers.front().file, {});
}

}  // namespace echolucent
