#include <malloc.h>
#include <QApplication>
#include <QCommandLineParser>
#include <QFileInfo>
#include <QIcon>
#include <QUrl>

#include "app/study/open_study.h"
#include "app/study/study_opening.h"
#include "app/window/main_window.h"
#include "app/window/start_of_program.h"
#include "app/window/start_timer.h"
#include "io/output/interruption.h"
#include "io/restricted/restricted_reader.h"
#include "widgets/volume_view/volume_view_widget.h"

namespace {

/// Gives freed arrays of 4 MiB or more back to the system. The C library alone would raise that limit to 32 MiB and
/// keep the memory of freed light volumes: 50 MiB for a volume of 512³ voxels.
void giveBackLargeArrays() {
    mallopt(M_MMAP_THRESHOLD, 4 << 20);
    mallopt(M_TRIM_THRESHOLD, 8 << 20);
}

void nameProgram() {
    QCoreApplication::setApplicationName(QStringLiteral("Echolucent"));
    QCoreApplication::setOrganizationName(QStringLiteral("Echolucent"));
    QCoreApplication::setApplicationVersion(QStringLiteral(ECHOLUCENT_VERSION));
}

/// Returns the hidden option --first-picture.
QCommandLineOption addOptions(QCommandLineParser& parser) {
    parser.setApplicationDescription(QStringLiteral("3D ultrasound workstation. Not a medical device."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument(
        QStringLiteral("FILE"),
        QStringLiteral("A volume, a session, a lesson, or a folder of DICOM slices; none: a simulated scan."),
        QStringLiteral("[FILE]"));
    QCommandLineOption firstPicture(
        QStringLiteral("first-picture"),
        QStringLiteral("Print the milliseconds to each picture up to the converged one, then quit."));
    firstPicture.setFlags(QCommandLineOption::HiddenFromHelp);
    parser.addOption(firstPicture);
    return firstPicture;
}

/// The path of FILE. Desktops may give the address of a file instead.
QString pathNamed(const QString& file) {
    return file.startsWith(QLatin1String("file://")) ? QUrl(file).path(QUrl::FullyDecoded) : file;
}

/// Prints the help or the version, without a display. Options beside these do not count: Qt has some of its own, which
/// only an application with a display takes.
int printWords(int count, char** arguments) {
    const QCoreApplication application(count, arguments);
    nameProgram();
    QCommandLineParser parser;
    addOptions(parser);
    parser.setSingleDashWordOptionMode(QCommandLineParser::ParseAsLongOptions);    // there is a "v" in "-reverse"
    if (parser.parse(QCoreApplication::arguments())) parser.process(application);  // ends the program, as the next two
    if (parser.isSet(QStringLiteral("version"))) parser.showVersion();
    parser.showHelp();
}

/// If the lesson is refused, the window begins as ever, and says then why.
void beginLesson(echolucent::MainWindow& window, const QString& folder) {
    window.open(folder);
    if (window.openStudy().loading()) return;
    window.openSimulatedScan();
    QObject::connect(
        &window.openStudy(), &echolucent::OpenStudy::studyOpened, &window, [&window, folder] { window.open(folder); },
        static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection));
}

}  // namespace

int main(int count, char** arguments) {
    using namespace echolucent;
    if (asksForWordsOnly(count, arguments)) return printWords(count, arguments);
    giveBackLargeArrays();
    // Call this before any other thread starts. It keeps a signal from leaving half a movie.
    removeUnfinishedOnSignals();
    restricted::prepareReader(restricted::Readiness::always);
    VolumeViewWidget::prepareApplication();
    const auto application = applicationOnDisplay(count, arguments);
    writeNumbersAlike();
    nameProgram();
    QApplication::setDesktopFileName(QStringLiteral("echolucent"));
    QApplication::setWindowIcon(QIcon(QStringLiteral(":/desktop/echolucent.png")));

    QCommandLineParser parser;
    const QCommandLineOption firstPicture = addOptions(parser);
    parser.process(*application);

    const QString file = pathNamed(parser.positionalArguments().value(0));
    const bool isLesson = !file.isEmpty() && StudyOpening::isLesson(file);
    // The study is read while the window is made: neither waits for the other.
    MainWindow window({}, [&file, isLesson](OpenStudy& openStudy) {
        if (isLesson) return;
        file.isEmpty() ? openStudy.openSimulatedScan() : openStudy.open(QFileInfo(file).absoluteFilePath());
    });
    if (isLesson) beginLesson(window, file);
    if (parser.isSet(firstPicture)) printStartTimes(window);
    window.show();
    return QApplication::exec();
}
