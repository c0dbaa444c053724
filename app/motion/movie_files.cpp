#include "app/motion/movie_files.h"

#include <QDir>
#include <QFileInfo>
#include <QWidget>
#include <algorithm>
#include <utility>

#include "app/files/save_dialog.h"
#include "app/study/study_names.h"
#include "io/study/import_report.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/panel_controls.h"
#include "widgets/motion/motion_words.h"

namespace echolucent {

namespace {
constexpr const char* movieTopic = "movie";
}  // namespace

MovieFiles::MovieFiles(Parts parts)
    : QObject(&parts.window),
      m_parts(std::move(parts)),
      m_writing(m_parts.works, QStringLiteral("movie"), {.urgency = Urgency::movie}) {}

/// "heart.mp4", or "heart-0001.png to heart-0020.png". If names are hidden, "*.png" for all of them.
QString MovieFiles::namesOf(const std::vector<std::string>& files) const {
    const QString first = m_parts.names.nameOfOther(QString::fromStdString(files.front())),
                  last = m_parts.names.nameOfOther(QString::fromStdString(files.back()));
    return first == last ? first : tr("%1 to %2").arg(first, last);
}

void MovieFiles::ask(FrameOutput output) {
    if (!m_parts.openStudy.study()) return;
    if (busy()) {
        m_parts.messages.showMessage(MessageKind::info, tr("A movie is being written. Wait for it, or cancel it."),
                                     MessageEnd::whenTakenBack(movieTopic));
        return;
    }
    auto* dialog =
        new MovieDialog(output,
                        {.plays = whatPlays(),
                         .held = heldInMovie(),
                         .ofView = m_parts.viewPixels(),
                         .choice = proposal(output),
                         .note = QString::fromStdString(burnedInTextNote(*m_parts.openStudy.study())),
                         .folderShown = !m_parts.names.showsNumbers(),
                         .hindrance = [this, output](const MovieChoice& choice) { return hindrance(output, choice); },
                         .choosePath = [this, output](const QString& path) { return choosePath(output, path); }},
                        &m_parts.window);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this, [this, dialog, output] { begin(output, dialog->choice()); });
    // Another study has other frames.
    connect(&m_parts.openStudy, &OpenStudy::studyOpened, dialog, &QDialog::reject);
    dialog->open();
}

HeldFrames MovieFiles::heldInMovie() const {
    const Document& document = m_parts.model.document();
    const Study& study = *m_parts.openStudy.study();
    std::vector<int> phases;
    for (const MotionPosition& position : turnOf(document, firstPane, static_cast<int>(study.phases.size())))
        phases.push_back(position.phase);
    return heldFrames(document.motion, study.phaseTimes, phases, 1.0 / MovieDialog::largestRate);
}

int MovieFiles::frameCount() const { return static_cast<int>(heldInMovie().pictures.size()); }

QString MovieFiles::whatPlays() const {
    const MotionChoice& motion = m_parts.model.document().motion;
    const PhaseRange range = playedPhases(motion, static_cast<int>(m_parts.openStudy.study()->phases.size()));
    const auto order = [](const QString& what, bool pingPong) {
        return pingPong ? tr("%1, back and forth").arg(what) : what;
    };
    QStringList words;
    if (movesProbe(motion.scenario))
        words << order(
            tr("Rotation from %1 to %2 (%3)")
                .arg(angleText(firstMotionAngle), angleText(lastMotionAngle), axisText(motion.axis).toLower()),
            motion.pingPong);
    if (movesObject(motion.scenario))
        words << order(tr("Volumes in time, %1 to %2").arg(range.first + 1).arg(range.last + 1), motion.phasesPingPong);
    return words.join(QLatin1Char('\n'));
}

MovieChoice MovieFiles::proposal(FrameOutput output) const {
    MovieChoice choice = m_last;
    const QString last = m_parts.settings.lastSaveFolder(), folder = last.isEmpty() ? QDir::homePath() : last;
    const QString name = output == FrameOutput::movie
                             ? freeName(folder, m_parts.proposedName(QStringLiteral("movie")), "mp4")
                             : m_parts.proposedName(QStringLiteral("frame")) + ".png";
    choice.path = QDir(folder).filePath(name);
    choice.framesPerSecond =
        std::clamp(1.0 / heldInMovie().pictureSeconds, MovieDialog::leastRate, MovieDialog::largestRate);
    choice.replace = false;
    return choice;
}

MovieHindrance MovieFiles::hindrance(FrameOutput output, const MovieChoice& choice) const {
    if (!m_parts.openStudy.study() || choice.path.isEmpty()) return {tr("Give the file a name."), false};
    const int frames = frameCount();
    if (const auto possible = checkFrameFiles(output, choice, frames, m_parts.openStudy.study()->files); !possible)
        return {m_parts.names.sentenceOf(possible.error()), false};
    const std::vector<std::string> files = filesOf(output, choice, frames);
    const auto there = std::ranges::count_if(
        files, [](const std::string& file) { return QFileInfo::exists(QString::fromStdString(file)); });
    const std::vector<std::string> longer = filesOfLongerSeries(output, choice, frames);
    if (there == 0 && longer.empty()) return {};
    if (output == FrameOutput::movie) return {tr("%1 is there already.").arg(namesOf(files)), true};
    if (there == 0)
        return {tr("A longer series left %1 there. Replacing removes what it left.").arg(namesOf(longer)), true};
    const QString some = there == 1 ? tr("one is") : tr("%1 are").arg(there);
    const QString sentence = tr("Of %1, %2 there already.").arg(namesOf(files), some);
    if (longer.empty()) return {sentence, true};
    return {sentence + ' ' + tr("Replacing also removes %1, which a longer series left.").arg(namesOf(longer)), true};
}

QString MovieFiles::choosePath(FrameOutput output, const QString& present) const {
    const bool movie = output == FrameOutput::movie;
    const QFileInfo proposed(present);
    return chooseFileToSave(m_parts.window, m_parts.settings, m_parts.openStudy,
                            {.title = movie ? tr("Save movie") : tr("Save picture series"),
                             .filter = movie ? tr("Movies (*.mp4 *.avi *.mkv)") : tr("Pictures (*.png)"),
                             .name = proposed.completeBaseName(),
                             .suffix = movie ? QStringLiteral("mp4") : QStringLiteral("png"),
                             .folder = proposed.absolutePath(),
                             .asksBeforeReplacing = false});  // the movie dialog asks
}

FrameOrder MovieFiles::orderOf(FrameOutput output, const MovieChoice& choice) const {
    const QuietPhases& quiet = m_parts.openStudy.quietPhases();
    const Study& study = *m_parts.openStudy.study();
    FrameOrder order{.document = m_parts.model.document(),
                     .phases = {.scans = study.phases, .quiet = {}, .reduction = quiet.reduction()},
                     .phaseTimes = study.phaseTimes,
                     .output = output,
                     .choice = choice,
                     .sides = m_parts.sides.finding(),
                     .curveIsTold = m_parts.settings.face() == Face::teach,
                     .compared = m_parts.compared(),
                     .letters = m_parts.window.font()};
    for (int phase = 0; phase < quiet.phaseCount(); ++phase) order.phases.quiet.push_back(quiet.of(phase));
    return order;
}

void MovieFiles::begin(FrameOutput output, const MovieChoice& choice) {
    if (busy() || !m_parts.openStudy.study()) return;
    const MovieHindrance inTheWay = hindrance(output, choice);
    if (!inTheWay.sentence.isEmpty() && !(inTheWay.replaces && choice.replace))
        return tell(false, MessageKind::error, inTheWay.sentence);
    m_last = choice;
    m_output = output;
    m_parts.settings.setLastSaveFolder(QFileInfo(choice.path).absolutePath());
    m_writing.setWords(output == FrameOutput::movie ? tr("writing the movie") : tr("writing the pictures"));
    m_writing.begin(
        choice.path,
        [order = std::make_shared<const FrameOrder>(orderOf(output, choice))](const Progress& progress) {
            return writeFrames(*order, progress);
        },
        [this, names = namesOf(filesOf(output, choice, frameCount()))](const Result<void>& written) {
            tell(names, written);
        });
}

void MovieFiles::tell(const QString& names, const Result<void>& written) {
    if (written) {
        const QString sentence = m_output == FrameOutput::movie ? tr("%1 was saved.") : tr("%1 were saved.");
        return tell(true, MessageKind::info, sentence.arg(names));
    }
    if (written.error().kind == FailureKind::cancelled) return tell(false, MessageKind::info, cancelledSentence(names));
    tell(false, MessageKind::error, m_parts.names.sentenceOf(written.error()));
}

void MovieFiles::tell(bool written, MessageKind kind, const QString& sentence) {
    m_parts.messages.showMessage(
        kind, sentence, kind == MessageKind::info ? MessageEnd::soon(movieTopic) : MessageEnd::withStudy(movieTopic));
    emit ended(written, sentence);
}

}  // namespace echolucent
