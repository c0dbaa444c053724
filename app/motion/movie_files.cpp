#include "app/motion/movie_files.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QWidget>
#include <algorithm>
#include <new>
#include <utility>

#include "widgets/panels/message_bar.h"
#include "widgets/panels/panel_controls.h"

namespace echolucent {

namespace {

/// "heart.mp4", or "heart-0001.png to heart-0020.png".
QString namesOf(const std::vector<std::string>& files) {
    const auto name = [](const std::string& path) { return QFileInfo(QString::fromStdString(path)).fileName(); };
    return files.size() == 1 ? name(files.front())
                             : QObject::tr("%1 to %2").arg(name(files.front()), name(files.back()));
}

}  // namespace

MovieFiles::MovieFiles(Parts parts)
    : QObject(&parts.window), m_parts(std::move(parts)), m_thread(QStringLiteral("movie")) {
    connect(&m_thread, &NewestWinsThread::busyChanged, this, &MovieFiles::busyChanged);
    connect(&m_thread, &NewestWinsThread::progressed, this, &MovieFiles::progressed);
}

MovieFiles::~MovieFiles() {
    if (m_cancel) *m_cancel = true;
}

void MovieFiles::ask(FrameOutput output) {
    if (!m_parts.session.study()) return;
    if (busy()) {
        m_parts.messages.showMessage(MessageKind::info, tr("A movie is being written. Wait for it, or cancel it."));
        return;
    }
    auto* dialog =
        new MovieDialog(output,
                        {.plays = whatPlays(),
                         .frames = frameCount(),
                         .ofView = m_parts.viewPixels(),
                         .choice = proposal(output),
                         .hindrance = [this, output](const MovieChoice& choice) { return hindrance(output, choice); },
                         .choosePath = [this, output](const QString& path) { return choosePath(output, path); }},
                        &m_parts.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, output] { begin(output, dialog->choice()); });
    // Another study has other frames.
    connect(&m_parts.session, &Session::studyOpened, dialog, &QDialog::reject);
    dialog->open();
}

int MovieFiles::frameCount() const {
    const Document& document = m_parts.model.document();
    const int phases = static_cast<int>(m_parts.session.study()->phases.size());
    return static_cast<int>(turnOf(document, m_parts.view, phases).size());
}

QString MovieFiles::whatPlays() const {
    const MotionChoice& motion = m_parts.model.document().motion;
    const PhaseRange range = playedPhases(motion, static_cast<int>(m_parts.session.study()->phases.size()));
    const auto order = [](const QString& what, bool pingPong) {
        return pingPong ? tr("%1, and back").arg(what) : what;
    };
    QStringList words;
    if (movesProbe(motion.scenario))
        words << order(tr("probe from %1 to %2 about %3")
                           .arg(angleText(firstMotionAngle), angleText(lastMotionAngle), textOf(nameOf(motion.axis))),
                       motion.pingPong);
    if (movesObject(motion.scenario))
        words << order(tr("phases %1 to %2").arg(range.first + 1).arg(range.last + 1), motion.phasesPingPong);
    return words.join(QStringLiteral("; "));
}

MovieChoice MovieFiles::proposal(FrameOutput output) const {
    const MotionChoice& motion = m_parts.model.document().motion;
    MovieChoice choice = m_last;
    const QString name = output == FrameOutput::movie ? m_parts.proposedName(QStringLiteral("movie")) + ".mp4"
                                                      : m_parts.proposedName(QStringLiteral("frame")) + ".png";
    const QString folder = m_parts.settings.lastSaveFolder();
    choice.path = QDir(folder.isEmpty() ? QDir::homePath() : folder).filePath(name);
    choice.framesPerSecond = std::clamp(1.0 / frameSeconds(motion, m_parts.session.study()->phaseSeconds),
                                        MovieDialog::leastRate, MovieDialog::largestRate);
    choice.replace = false;
    return choice;
}

MovieHindrance MovieFiles::hindrance(FrameOutput output, const MovieChoice& choice) const {
    if (!m_parts.session.study() || choice.path.isEmpty()) return {tr("Give the file a name."), false};
    const int frames = frameCount();
    if (const auto possible = checkFrameFiles(output, choice, frames, m_parts.session.study()->files); !possible)
        return {QString::fromStdString(possible.error().sentence()), false};
    const std::vector<std::string> files = filesOf(output, choice, frames);
    const auto there = std::ranges::count_if(
        files, [](const std::string& file) { return QFileInfo::exists(QString::fromStdString(file)); });
    if (there == 0) return {};
    if (output == FrameOutput::movie) return {tr("%1 is there already.").arg(namesOf(files)), true};
    const QString some = there == 1 ? tr("one is") : tr("%1 are").arg(there);
    return {tr("Of %1, %2 there already.").arg(namesOf(files), some), true};
}

QString MovieFiles::choosePath(FrameOutput output, const QString& present) const {
    const bool movie = output == FrameOutput::movie;
    QFileDialog dialog(&m_parts.window, movie ? tr("Save movie") : tr("Save picture series"),
                       QFileInfo(present).absolutePath(),
                       movie ? tr("Movies (*.mp4 *.avi *.mkv)") : tr("Pictures (*.png)"));
    dialog.setObjectName("saveFile");
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setOption(QFileDialog::DontConfirmOverwrite);  // that is asked where the choice is made
    dialog.setDefaultSuffix(movie ? QStringLiteral("mp4") : QStringLiteral("png"));
    dialog.selectFile(QFileInfo(present).fileName());
    return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().first() : QString();
}

FrameOrder MovieFiles::orderOf(FrameOutput output, const MovieChoice& choice) const {
    const QuietPhases& quiet = m_parts.session.quietPhases();
    const Study& study = *m_parts.session.study();
    FrameOrder order{.document = m_parts.model.document(),
                     .view = m_parts.view,
                     .phases = {.scans = study.phases, .quiet = {}, .reduction = quiet.reduction()},
                     .phaseSeconds = study.phaseSeconds,
                     .output = output,
                     .choice = choice};
    for (int phase = 0; phase < quiet.phaseCount(); ++phase) order.phases.quiet.push_back(quiet.of(phase));
    return order;
}

void MovieFiles::begin(FrameOutput output, const MovieChoice& choice) {
    if (busy() || !m_parts.session.study()) return;
    const MovieHindrance inTheWay = hindrance(output, choice);
    if (!inTheWay.sentence.isEmpty() && !(inTheWay.replaces && choice.replace))
        return tell(false, MessageKind::error, inTheWay.sentence);
    m_last = choice;
    m_output = output;
    m_parts.settings.setLastSaveFolder(QFileInfo(choice.path).absolutePath());
    m_cancel = std::make_shared<std::atomic<bool>>(false);
    const QString names = namesOf(filesOf(output, choice, frameCount()));
    const auto order = std::make_shared<const FrameOrder>(orderOf(output, choice));
    // A flag of its own: of a movie that was whole before it was cancelled it is told that it was written.
    m_thread.submit([this, order, names, cancel = m_cancel](const Progress& progress) -> NewestWinsThread::Deliver {
        bool done = false;
        QString sentence =
            (order->output == FrameOutput::movie ? tr("%1 was saved.") : tr("%1 were saved.")).arg(names);
        try {
            const auto written = writeFrames(*order, {progress.report, cancel.get()});
            done = written.has_value();
            if (!done && written.error().kind == FailureKind::cancelled)
                sentence = tr("Writing %1 was cancelled; no file is left of it.").arg(names);
            else if (!done)
                sentence = QString::fromStdString(written.error().sentence());
        } catch (const std::bad_alloc&) {
            sentence = tr("Writing %1 needs more memory than this machine has.").arg(names);
        }
        const bool byHand = *cancel;
        return
            [this, done, byHand, sentence] { tell(done, byHand ? MessageKind::info : MessageKind::error, sentence); };
    });
}

void MovieFiles::tell(bool written, MessageKind ofTrouble, const QString& sentence) {
    m_parts.messages.showMessage(written ? MessageKind::info : ofTrouble, sentence);
    emit ended(written, sentence);
}

void MovieFiles::cancel() {
    if (m_cancel) *m_cancel = true;
}

QString MovieFiles::activity() const {
    return m_output == FrameOutput::movie ? tr("writing the movie") : tr("writing the pictures");
}

}  // namespace echolucent
