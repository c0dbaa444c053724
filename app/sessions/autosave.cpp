#include "app/sessions/autosave.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QUuid>
#include <utility>

#include "io/document/session_file.h"

namespace echolucent {

Autosave::Autosave(const QString& folder, std::function<SavedSession()> present, QObject* parent)
    : QObject(parent),
      m_folder(folder),
      m_present(std::move(present)),
      m_thread(std::make_unique<NewestWinsThread>(QStringLiteral("autosave"))) {
    m_timer.setSingleShot(true);
    m_timer.setInterval(standardIntervalMilliseconds);
    connect(&m_timer, &QTimer::timeout, this, &Autosave::write);
    connect(m_thread.get(), &NewestWinsThread::busyChanged, this, &Autosave::busyChanged);
    beginFile();
}

Autosave::~Autosave() {
    m_thread.reset();  // what is being written is whole first
    if (m_keep && ownFile())
        (void)writeSession(m_file.toStdString(), m_present());
    else if (m_lock && m_lock->isLocked())
        QFile::remove(m_file);
}

void Autosave::beginFile() {
    m_file = QStringLiteral("%1/%2-%3.autosave.json")
                 .arg(m_folder)
                 .arg(QCoreApplication::applicationPid())
                 .arg(QUuid::createUuid().toString(QUuid::Id128).left(8));
    m_lock.reset();
    m_written.reset();
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
    if (m_written == present) return;
    if (!ownFile()) {
        m_lock.reset();  // the folder may be there next time
        if (!std::exchange(m_failed, true))
            emit failed(tr("%1 cannot be written, so that nothing is kept of an unsaved session.").arg(m_folder));
        return;
    }
    m_written = present;
    m_thread->submit(
        [this, file = m_file.toStdString(),
         session = std::move(present)](const Progress&) -> NewestWinsThread::Deliver {
            const auto done = writeSession(file, session);
            if (done) {
                return [this] {
                    m_failed = false;
                    emit written();
                };
            }
            return [this, sentence = QString::fromStdString(done.error().sentence())] {
                m_written.reset();
                if (!std::exchange(m_failed, true)) emit failed(sentence);
            };
        },
        NewestWinsThread::WhenSuperseded::finish);
}

void Autosave::forget() {
    m_timer.stop();
    if (!m_written) return;
    m_written.reset();
    m_thread->submit(
        [file = m_file](const Progress&) -> NewestWinsThread::Deliver {
            QFile::remove(file);
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
