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

#include "app/files/save_dialog.h"
#include "app/settings/settings.h"
#include "app/study/study_names.h"
#include "io/document/session_file.h"
#include "widgets/controls/message_bar.h"
#include "widgets/otf_editor/otf_editor.h"

namespace echolucent {

namespace {

constexpr const char *sessionTopic = "session", *autosaveTopic = "autosave";

/// The document with the shown phase, frame and study checksum of `like`, so that only a person's work is compared.
Document comparable(Document document, const Document& like) {
    if (nameTheSame(document.study, like.study)) document.study = like.study;
    return withShown(std::move(document), like);
}

}  // namespace

SessionKeeping::SessionKeeping(const Parts& parts)
    : QObject(&parts.window),
      m_parts(parts),
      m_autosave(
          std::make_unique<Autosave>(parts.works, parts.settings.autosaveFolder(), [this] { return present(); })),
      m_left(std::make_unique<LeftUnsaved>(
          LeftUnsaved::Parts{parts.openStudy, parts.works, parts.settings, parts.messages, parts.names, *m_autosave})),
      m_underWay(parts.works,
                 {.words = tr("saving the session"), .urgency = Urgency::saving, .cancel = [this] { cancelSaving(); }}),
      m_saving(parts.works, QStringLiteral("session saving")) {
    connect(&m_parts.model, &DocumentModel::changed, this, &SessionKeeping::noteChange);
    connect(&m_snapshots, &Snapshots::changed, this, &SessionKeeping::noteChange);
    connect(&m_parts.shown, &ShownStudy::aboutToBegin, this, &SessionKeeping::leave);
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, this, &SessionKeeping::begin);
    connect(&m_parts.openStudy, &OpenStudy::studyNamed, this,
            [this] { m_parts.model.noteChecksum(m_parts.openStudy.reference()); });
    connect(m_autosave.get(), &Autosave::failed, this, [this](const QString& sentence) {
        m_parts.messages.showMessage(MessageKind::warning, m_parts.names.shownOfFile(sentence),
                                     MessageEnd::whenTakenBack(autosaveTopic));
    });
    connect(m_autosave.get(), &Autosave::written, this, [this] { m_parts.messages.takeBack(autosaveTopic); });
    connect(&m_parts.openStudy, &OpenStudy::takingChecksumChanged, this, [this](bool taking) {
        if (!taking) writeNext();
    });
    constexpr int lookEvery = 100;  // ms
    m_looking.setSingleShot(true);
    m_looking.setInterval(lookEvery);
    connect(&m_looking, &QTimer::timeout, this, &SessionKeeping::look);
    connect(&m_saving, &NewestWinsThread::busyChanged, this, &SessionKeeping::writeNext);
}

SessionKeeping::~SessionKeeping() {
    look();
    // The document still exists here; the window's other parts do not.
    m_left.reset();
    m_autosave->keepAtEnd(m_changed && m_parts.openStudy.study() != nullptr);
    m_autosave.reset();
}

SavedSession SessionKeeping::present() const {
    return {.document = m_parts.model.ownDocument(), .snapshots = m_snapshots.list(), .file = m_file.toStdString()};
}

bool SessionKeeping::holdsWork() const {
    const Document document = m_parts.model.ownDocument();
    const Document& opened = m_parts.shown.opened();
    if (!m_snapshots.list().empty() || !document.measurements.empty()) return true;
    if (!document.scene.strokes.empty() || document.scene.box.on) return true;
    return document.scene.front != opened.scene.front || document.panes.size() != opened.panes.size();
}

bool SessionKeeping::holdsSettings() const {
    const Document document = m_parts.model.ownDocument();
    const Document& opened = m_parts.shown.opened();
    return !m_inFile && (m_parts.editor.isManualModified() || document.curves != opened.curves ||
                         document.scene.look != opened.scene.look || document.method != opened.method ||
                         document.scene.side != opened.scene.side);
}

void SessionKeeping::noteChange() {
    if (m_between || m_parts.openStudy.study() == nullptr) return;
    if (!m_looking.isActive()) m_looking.start();
}

void SessionKeeping::look() {
    if (m_between || m_parts.openStudy.study() == nullptr) return;
    m_looking.stop();
    if (m_aside) return;
    const Document document = m_parts.model.ownDocument();
    const bool changed =
        m_inFile ? m_inFile->snapshots != m_snapshots.list() || comparable(m_inFile->document, document) != document
                 : m_fromLeft || !m_file.isEmpty() || holdsWork();
    const bool touched =
        changed || comparable(m_inFile ? m_inFile->document : m_parts.shown.opened(), document) != document;
    if (touched || m_autosave->keeps()) m_autosave->noteChange();
    m_changed = changed;
    m_parts.window.setWindowModified(m_changed);
}

void SessionKeeping::leave() {
    const bool first = std::holds_alternative<std::monostate>(m_parts.model.document().study);
    if (!first) look();
    m_between = true;
    const int number = m_number++;
    if (first) {
        if (std::exchange(m_puttingAside, false)) m_aside.emplace();
        return;
    }
    writeNext();  // the study that is left gets no checksum any more
    if (m_aside) return leaveAside();
    if (std::exchange(m_puttingAside, false)) {
        m_aside = Aside{m_snapshots.list(), m_file, m_inFile, m_fromLeft, m_fileTime, {}, m_changed};
        if (!m_changed && !holdsSettings()) return m_autosave->forget();
        const Autosave::Left left = m_autosave->leaveBehind();
        m_aside->left =
            Leftover{left.file, left.lock, QDateTime::currentDateTime(), studyPathOf(m_parts.model.document()), {}};
        return;
    }
    // Another study takes over curves, look and method; a session brings its own.
    const Document document = m_parts.model.ownDocument();
    if (!m_changed && !(m_parts.openStudy.saved() && holdsSettings())) return m_autosave->forget();
    const Autosave::Left left = m_autosave->leaveBehind();
    Leftover leftover{left.file, left.lock, QDateTime::currentDateTime(), studyPathOf(m_parts.model.document()), {}};
    const bool onItsWay = std::ranges::any_of(m_orders, [&](const Order& order) {
        return order.number == number && order.session.snapshots == m_snapshots.list() &&
               comparable(order.session.document, document) == document;
    });
    if (onItsWay)
        m_leftWhileSaving.emplace_back(number, std::move(leftover));
    else
        m_left->add(std::move(leftover));
}

/// Another study takes the place of the one that was looked at for a while.
void SessionKeeping::leaveAside() {
    if (m_takingBack || m_puttingAside) return;  // from one lesson to the next the session stays aside
    // As in leave(): a study takes over what an opened session replaces.
    if (m_aside->left && (m_aside->changed || m_parts.openStudy.saved()))
        m_left->add(std::move(*m_aside->left));
    else if (m_aside->left)
        m_autosave->discard({m_aside->left->file, m_aside->left->lock});
    m_aside.reset();
}

/// The session that was put aside goes on.
void SessionKeeping::goOn() {
    Aside aside = std::move(*m_aside);
    m_aside.reset();
    m_file = aside.file;
    m_inFile = std::move(aside.inFile);
    m_fromLeft = aside.fromLeft;
    m_fileTime = aside.fileTime;
    if (aside.left) m_autosave->replace({aside.left->file, aside.left->lock});
    m_snapshots.begin(std::move(aside.snapshots));
    look();
}

bool SessionKeeping::isOnItsWay(int number) const {
    return std::ranges::any_of(m_orders, [&](const Order& order) { return order.number == number; });
}

void SessionKeeping::begin() {
    const auto& saved = m_parts.openStudy.saved();
    // What could not be saved is offered like any other.
    for (auto& [number, left] : m_leftWhileSaving)
        if (!isOnItsWay(number)) m_left->add(std::move(left));
    std::erase_if(m_leftWhileSaving, [&](const auto& left) { return !isOnItsWay(left.first); });
    m_between = false;
    m_changed = false;
    m_fromLeft = false;
    m_then = Then::goOn;
    m_file.clear();
    m_inFile.reset();
    m_puttingAside = false;
    const bool back = std::exchange(m_takingBack, false);
    if (m_aside) {
        if (back) return goOn();
        m_snapshots.begin({});
        m_parts.window.setWindowModified(false);
        return;
    }
    const QString opened = saved ? QString::fromStdString(saved->file) : QString();
    if (const auto left = m_left->take(opened)) {
        m_file = QString::fromStdString(saved->session.file);
        m_fileTime = left->time;
        m_fromLeft = true;
        m_autosave->replace({left->file, left->lock});
    } else if (saved) {
        m_file = opened;
        m_fileTime = QFileInfo(opened).lastModified();
        m_inFile = saved->session;
    }
    if (!m_file.isEmpty()) m_parts.names.knowSession(m_file, m_parts.openStudy.path());
    m_snapshots.begin(saved ? saved->session.snapshots : std::vector<Snapshot>{});
    if (m_inFile) m_parts.editor.setManualSaved();
    look();
    m_left->offer();
}

/// The folder of the session's file, else the folder beside the study's file or folder, never inside it. Empty for a
/// simulated scan.
QString SessionKeeping::proposedFolder() const {
    const QString beside = m_file.isEmpty() ? QDir::cleanPath(m_parts.openStudy.path()) : m_file;
    return beside.isEmpty() ? QString() : QFileInfo(beside).absolutePath();
}

void SessionKeeping::save() {
    if (m_parts.openStudy.study() == nullptr) return;
    if (m_file.isEmpty()) return chooseAndSave();
    if (mayReplace()) saveAs(m_file);
}

bool SessionKeeping::mayReplace() {
    const QDateTime now = QFileInfo(m_file).lastModified();
    if (!now.isValid() || now <= m_fileTime) return true;
    QMessageBox box(QMessageBox::NoIcon, tr("Save session"),
                    tr("%1 was saved since, and not from here. Saving replaces what it holds now.")
                        .arg(m_parts.names.nameOf(m_file)),
                    QMessageBox::NoButton, &m_parts.window);
    box.setObjectName("newerSession");
    box.setTextFormat(Qt::PlainText);  // file names may hold anything
    QPushButton* replace = box.addButton(tr("Replace it"), QMessageBox::AcceptRole);
    QPushButton* elsewhere = box.addButton(tr("Save session as…"), QMessageBox::AcceptRole);
    box.addButton(QMessageBox::Cancel);
    box.setDefaultButton(elsewhere);
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, &box, &QDialog::reject);
    box.exec();
    if (static_cast<QAbstractButton*>(elsewhere) == box.clickedButton()) chooseAndSave();
    return static_cast<QAbstractButton*>(replace) == box.clickedButton();
}

QString SessionKeeping::chosenFile(const QString& named, const QString& folder) {
    return chooseFileToSave(m_parts.window, m_parts.settings, m_parts.openStudy,
                            {.title = tr("Save session"),
                             .filter = tr("Sessions (*.session.json *.json);;All files (*)"),
                             .name = m_parts.names.beginningFor(named),
                             .suffix = QStringLiteral("session.json"),
                             .folder = folder,
                             .proposesAgain = true});
}

void SessionKeeping::chooseAndSave() {
    if (m_parts.openStudy.study() == nullptr) return;
    const QString path = chosenFile(m_file.isEmpty() ? m_parts.openStudy.path() : m_file, proposedFolder());
    if (!path.isEmpty()) saveAs(path);
}

void SessionKeeping::saveAs(const QString& file, Then then) {
    const Study* study = m_parts.openStudy.study();
    if (study == nullptr) return;
    Order order{file, present(), study->files, m_number};
    order.session.file.clear();
    m_then = then;
    send(std::move(order));
}

void SessionKeeping::send(Order order) {
    order.file = QFileInfo(order.file).absoluteFilePath();
    const QString study = studyPathOf(order.session.document);
    if (auto allowed = refuseSessionInside(study.toStdString(), order.studyFiles, order.file.toStdString()); !allowed)
        return offerAnotherPlace(order, m_parts.names.sentenceOf(allowed.error()));
    // Of the orders that are not begun, only the newest for a file is needed.
    const auto notBegun = m_orders.begin() + (m_saving.busy() ? 1 : 0);
    m_orders.erase(std::remove_if(notBegun, m_orders.end(), [&](const Order& each) { return each.file == order.file; }),
                   m_orders.end());
    m_orders.push_back(std::move(order));
    writeNext();
}

void SessionKeeping::cancelSaving() {
    const auto notBegun = m_orders.begin() + (m_saving.busy() ? 1 : 0);
    if (notBegun == m_orders.end()) return;
    QStringList names;
    for (auto order = notBegun; order != m_orders.end(); ++order) names << m_parts.names.nameOfOther(order->file);
    m_orders.erase(notBegun, m_orders.end());
    m_then = Then::goOn;
    m_parts.messages.showMessage(MessageKind::info,
                                 tr("Saving %1 was cancelled; it is as it was.").arg(names.join(QStringLiteral(", "))),
                                 MessageEnd::soon(sessionTopic));
    m_underWay.set(saving());
}

/// Writes the orders one after the other. An order for the open study waits for its checksum.
void SessionKeeping::writeNext() {
    m_underWay.set(saving());
    if (m_orders.empty() || m_saving.busy()) return;
    Order& next = m_orders.front();
    if (next.number == m_number) {
        if (m_parts.openStudy.takingChecksum()) return;
        next.session.document.study = m_parts.openStudy.reference();
    }
    m_saving.submit([this, order = next](const Progress&) -> NewestWinsThread::Deliver {
        const std::string file = order.file.toStdString();
        try {
            const auto written = writeSession(file, asNamedFrom(file, order.session));
            if (written) return [this, time = QFileInfo(order.file).lastModified()] { takeSaved(time); };
            return [this, failure = written.error()] { takeUnsaved(m_parts.names.sentenceOf(failure)); };
        } catch (const std::exception& problem) {
            const Failure failure{
                FailureKind::unwritable, file, {}, std::string("could not be written: ") + problem.what(), {}};
            return [this, failure] { takeUnsaved(m_parts.names.sentenceOf(failure)); };
        }
    });
}

SessionKeeping::Order SessionKeeping::takeFirst() {
    Order order = std::move(m_orders.front());
    m_orders.pop_front();
    return order;
}

void SessionKeeping::takeSaved(const QDateTime& time) {
    const Order order = takeFirst();
    m_parts.names.knowSession(order.file, studyPathOf(order.session.document));
    m_parts.settings.addRecentFile(order.file);
    m_parts.settings.setLastSaveFolder(QFileInfo(order.file).absolutePath());
    m_parts.messages.showMessage(MessageKind::info,
                                 tr("The session was saved as %1.").arg(m_parts.names.nameOf(order.file)),
                                 MessageEnd::soon(sessionTopic));
    for (const auto& [number, left] : m_leftWhileSaving)
        if (number == order.number) m_autosave->discard({left.file, left.lock});
    std::erase_if(m_leftWhileSaving, [&](const auto& left) { return left.first == order.number; });
    // If another study or session was opened meanwhile, the window stays with it.
    const bool same = order.number == m_number;
    if (same) {
        m_file = order.file;
        m_fileTime = time;
        m_inFile = order.session;
        m_fromLeft = false;
        m_parts.editor.setManualSaved();
        look();
        if (!m_changed) m_autosave->forget();
    }
    emit saved();
    if (m_orders.empty() && std::exchange(m_then, Then::goOn) == Then::closeWindow) m_parts.window.close();
}

void SessionKeeping::takeUnsaved(const QString& sentence) {
    const Order order = takeFirst();
    offerAnotherPlace(order, sentence);
}

void SessionKeeping::offerAnotherPlace(const Order& order, const QString& sentence) {
    m_then = Then::goOn;
    m_parts.messages.showMessage(MessageKind::error, sentence, MessageEnd::whenTakenBack(sessionTopic),
                                 {{tr("Save it elsewhere…"), [this, order] { saveElsewhere(order); }}});
}

void SessionKeeping::saveElsewhere(Order order) {
    const bool open = order.number == m_number;
    const QString named = open && !m_file.isEmpty() ? m_file : studyPathOf(order.session.document);
    order.file = chosenFile(named, QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    if (order.file.isEmpty()) return;
    if (open) order.session = present();
    order.session.file.clear();
    send(std::move(order));
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
    box.setTextFormat(Qt::PlainText);  // file names may hold anything
    QPushButton* save = box.addButton(tr("Save session"), QMessageBox::AcceptRole);
    QPushButton* discard = box.addButton(tr("Discard the changes"), QMessageBox::DestructiveRole);
    box.addButton(QMessageBox::Cancel);
    box.setDefaultButton(save);
    // The question is about the session that is open.
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, &box, &QDialog::reject);
    box.exec();
    if (static_cast<QAbstractButton*>(save) == box.clickedButton()) {
        if (mayReplace()) saveAs(m_file, Then::closeWindow);
        return false;
    }
    if (static_cast<QAbstractButton*>(discard) != box.clickedButton()) return false;
    m_inFile = present();  // nothing of the changes is kept
    m_fromLeft = false;
    look();
    m_autosave->forget();
    m_parts.editor.setManualSaved();
    return true;
}

}  // namespace echolucent
