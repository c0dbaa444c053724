#include "app/sessions/autosave.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QUuid>
#include <algorithm>
#include <exception>
#include <utility>

#include "io/document/session_file.h"

namespace echolucent {

namespace {

/// Gives an empty text, or a sentence that says what went wrong.
QString writeWhole(const QString& file, const SavedSession& session) {
    try {
        const auto done = writeSession(file.toStdString(), session);
        return done ? QString() : QString::fromStdString(done.error().sentence());
    } catch (const std::exception& problem) {
        return Autosave::tr("%1 could not be written: %2.").arg(file, QString::fromUtf8(problem.what()));
    }
}

}  // namespace

Autosave::Autosave(const QString& folder, std::function<SavedSession()> present, QObject* parent)
    : QObject(parent), m_folder(folder), m_present(std::move(present)) {
    m_timer.setSingleShot(true);
    m_timer.setInterval(standardIntervalMilliseconds);
    connect(&m_timer, &QTimer::timeout, this, &Autosave::write);
    beginFile();
}

Autosave::~Autosave() {
    // What is being written is whole first.
    m_leaving.clear();
    m_thread.reset();
    if (m_keep && ownFile()) {
        if (!writeWhole(m_file, m_present()).isEmpty()) return;
    } else if (m_lock && m_lock->isLocked()) {
        QFile::remove(m_file);
    }
    if (m_earlier) QFile::remove(m_earlier->file);
}

void Autosave::beginFile() {
    // The folder's name may hold what QString::arg() replaces.
    m_file = m_folder + '/' + QString::number(QCoreApplication::applicationPid()) + '-' +
             QUuid::createUuid().toString(QUuid::Id128).left(8) + QStringLiteral(".autosave.json");
    m_lock.reset();
    m_written.reset();
    m_earlier.reset();
    // Of one thread's jobs only the newest waits, and what was left behind must not make room for what follows.
    std::erase_if(m_leaving, [](const auto& thread) { return !thread->busy(); });
    if (m_thread) m_leaving.push_back(std::move(m_thread));
    m_thread = std::make_unique<NewestWinsThread>(QStringLiteral("autosave"));
    connect(m_thread.get(), &NewestWinsThread::busyChanged, this, [this] { emit busyChanged(busy()); });
}

bool Autosave::busy() const {
    return m_thread->busy() || std::ranges::any_of(m_leaving, [](const auto& thread) { return thread->busy(); });
}

/// Made with the first change: a program in which nobody does anything leaves no trace.
bool Autosave::ownFile() {
    if (m_lock) return m_lock->isLocked();
    // A folder of one's own: what people look at is nobody else's business.
    if (!QDir(m_folder).exists() && QDir().mkpath(m_folder))
        QFile::setPermissions(m_folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    m_lock = std::make_shared<QLockFile>(lockOf(m_file));
    m_lock->setStaleLockTime(0);  // it is as old as this program
    return m_lock->tryLock(0);
}

void Autosave::noteChange() {
    if (!m_timer.isActive()) m_timer.start();
}

void Autosave::write() {
    SavedSession present = m_present();
    if (m_written) {
        SavedSession written = *m_written;
        written.document = withShown(std::move(written.document), present.document);
        if (written == present) return;
    }
    if (!ownFile()) {
        m_lock.reset();  // the folder may be there next time
        if (!std::exchange(m_failed, true))
            emit failed(tr("%1 cannot be written, so that nothing is kept of an unsaved session.").arg(m_folder));
        return;
    }
    m_written = present;
    m_thread->submit(
        [this, file = m_file, earlier = m_earlier,
         session = std::move(present)](const Progress&) -> NewestWinsThread::Deliver {
            const QString problem = writeWhole(file, session);
            if (problem.isEmpty()) {
                if (earlier) QFile::remove(earlier->file);
                return [this] {
                    m_failed = false;
                    emit written();
                };
            }
            return [this, file, sentence = problem] {
                if (file == m_file) m_written.reset();
                if (!std::exchange(m_failed, true)) emit failed(sentence);
            };
        },
        NewestWinsThread::WhenSuperseded::finish);
}

void Autosave::forget() {
    m_timer.stop();
    if (!m_written && !m_earlier) return;
    m_written.reset();
    m_thread->submit(
        [file = m_file,
         earlier = std::exchange(m_earlier, std::nullopt)](const Progress&) -> NewestWinsThread::Deliver {
            QFile::remove(file);
            if (earlier) QFile::remove(earlier->file);
            return {};
        },
        NewestWinsThread::WhenSuperseded::finish);
}

Autosave::Left Autosave::leaveBehind() {
    m_timer.stop();
    write();
    Left left{m_file, m_lock};
    beginFile();
    return left;
}

}  // namespace echolucent
