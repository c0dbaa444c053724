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
QString writeWhole(const Autosave::Write& write, const QString& file, const SavedSession& session) {
    try {
        const auto done = write(file.toStdString(), session);
        return done ? QString() : QString::fromStdString(done.error().sentence());
    } catch (const std::exception& problem) {
        return Autosave::tr("%1 could not be written: %2.").arg(file, QString::fromUtf8(problem.what()));
    }
}

}  // namespace

/// Runs in any thread. Writes the order's session to `file`, or removes `file` if the order has none. Then removes the
/// order's earlier files. If writing fails, removes nothing and returns a sentence that says why. Else the text is
/// empty.
QString Autosave::carriedOut(const Write& write, const QString& file, const Order& order) {
    if (!order.session) {
        QFile::remove(file);
    } else if (QString problem = writeWhole(write, file, *order.session); !problem.isEmpty()) {
        return problem;
    }
    for (const Left& earlier : order.earlier) QFile::remove(earlier.file);
    return {};
}

Autosave::Autosave(Works& works, const QString& folder, std::function<SavedSession()> present, QObject* parent)
    : QObject(parent), m_works(works), m_folder(folder), m_present(std::move(present)), m_write(&writeSession) {
    for (QTimer* timer : {&m_timer, &m_again}) timer->setSingleShot(true);
    setInterval(standardIntervalMilliseconds);
    connect(&m_timer, &QTimer::timeout, this, &Autosave::write);
    connect(&m_again, &QTimer::timeout, this, &Autosave::tryAgain);
    beginFile();
}

Autosave::~Autosave() {
    // A thread that ends drops its waiting job, and nobody hears how its last job ended. So what is due is done here,
    // if need be a second time.
    for (const auto& left : m_leftBehind) {
        left->thread.reset();
        const auto lock = left->lock.lock();
        if (left->due && lock && own(lock)) carriedOut(m_write, left->name, *left->due);
    }
    m_file->thread.reset();
    if (!m_keep || own(m_lock))
        carriedOut(m_write, m_file->name, newOrder(m_keep ? std::optional(m_present()) : std::nullopt));
}

void Autosave::setInterval(int milliseconds) {
    for (QTimer* timer : {&m_timer, &m_again}) timer->setInterval(milliseconds);
}

void Autosave::beginFile() {
    // Only the newest job of a thread waits. The next file gets a thread of its own, so that its jobs do not drop a job
    // of the present file.
    std::erase_if(m_leftBehind, [](const auto& left) { return !left->due && !left->thread->busy(); });
    if (m_file) m_leftBehind.push_back(std::move(m_file));
    m_file = std::make_unique<File>();
    // Not with QString::arg(): the folder's name may hold its place markers.
    m_file->name = m_folder + '/' + QString::number(QCoreApplication::applicationPid()) + '-' +
                   QUuid::createUuid().toString(QUuid::Id128).left(8) + QStringLiteral(".autosave.json");
    m_lock = std::make_shared<QLockFile>(lockOf(m_file->name));
    m_lock->setStaleLockTime(0);  // the lock may grow as old as this program
    m_file->lock = m_lock;
    m_written.reset();
    m_file->thread = std::make_unique<NewestWinsThread>(m_works, QStringLiteral("autosave"));
}

bool Autosave::busy() const {
    return m_file->thread->busy() ||
           std::ranges::any_of(m_leftBehind, [](const auto& left) { return left->thread->busy(); });
}

/// Whether this program holds the lock. Takes it, and makes the folder, if need be. Nobody calls this before the first
/// change, so that a program in which nobody does anything leaves no trace.
bool Autosave::own(const std::shared_ptr<QLockFile>& lock) const {
    if (lock->isLocked()) return true;
    // Only the person may read the folder: what people look at is private.
    if (!QDir(m_folder).exists() && QDir().mkpath(m_folder))
        QFile::setPermissions(m_folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    return lock->tryLock(0);
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
    m_written = present;
    order(std::move(present));
}

void Autosave::tryAgain() {
    for (const auto& left : m_leftBehind)
        if (left->due && !left->thread->busy()) carryOut(*left);
    if (m_file->due && !m_file->thread->busy()) carryOut(*m_file);
}

/// Gives an order with all files to remove that are not known to be gone.
Autosave::Order Autosave::newOrder(std::optional<SavedSession> session) {
    Order next{std::move(session), std::exchange(m_earlier, {}), {}};
    if (const auto& due = m_file->due)
        next.earlier.insert(next.earlier.end(), due->earlier.begin(), due->earlier.end());
    return next;
}

void Autosave::order(std::optional<SavedSession> session) {
    m_file->due = std::make_shared<const Order>(newOrder(std::move(session)));
    carryOut(*m_file);
}

void Autosave::carryOut(File& file) {
    const auto lock = file.lock.lock();
    if (!lock) return file.due.reset();
    if (file.due->session && !own(lock))  // the folder may be there next time
        return ended(file, file.due,
                     tr("%1 cannot be written, so that nothing is kept of an unsaved session. Save it to keep it.")
                         .arg(m_folder));
    file.thread->submit(
        [this, &file, name = file.name, order = file.due,
         write = m_write](const Progress&) -> NewestWinsThread::Deliver {
            return [this, &file, order, problem = carriedOut(write, name, *order)] { ended(file, order, problem); };
        },
        NewestWinsThread::WhenSuperseded::finish);
}

void Autosave::ended(File& file, const std::shared_ptr<const Order>& order, const QString& problem) {
    const bool newest = file.due == order;
    if (problem.isEmpty()) {
        if (newest) file.due.reset();
        if (!order->session) return;
        m_failed = false;
        emit written();
    } else {
        if (newest) m_again.start();
        if (!std::exchange(m_failed, true)) emit failed(problem);
    }
}

void Autosave::forget() {
    m_timer.stop();
    if (!m_written && m_earlier.empty()) return;
    m_written.reset();
    order(std::nullopt);
}

Autosave::Left Autosave::leaveBehind() {
    m_timer.stop();
    write();
    Left left{m_file->name, m_lock};
    beginFile();
    return left;
}

void Autosave::discard(const Left& left) {
    const auto own = std::ranges::find_if(m_leftBehind, [&](const auto& each) { return each->name == left.file; });
    if (own == m_leftBehind.end()) {
        QFile::remove(left.file);
    } else {
        // The removal waits until an earlier order for the file is carried out.
        const auto& due = (*own)->due;
        (*own)->due =
            std::make_shared<const Order>(Order{std::nullopt, due ? due->earlier : std::vector<Left>(), left.lock});
        carryOut(**own);
    }
}

}  // namespace echolucent
