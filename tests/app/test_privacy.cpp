// Nothing that a DICOM study says of its patient is in what the program writes, but in the report that was asked for
// it.
#include <fcntl.h>
#include <unistd.h>

#include <QAction>
#include <QCheckBox>
#include <QDir>
#include <QDirIterator>
#include <QFileDialog>
#include <QLineEdit>
#include <QProcess>
#include <QPushButton>
#include <QStandardPaths>
#include <QTextStream>
#include <QTimer>
#include <cstdio>

#include "app/motion/movie_files.h"
#include "app/sessions/session_keeping.h"
#include "io/writers/enhanced_us_writer.h"
#include "tests/app/marked_dicom.h"
#include "tests/app/telling_names.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/dialogs/report_dialog.h"
#include "widgets/panels/presets_panel.h"

using namespace echolucent;

/// What this process writes to its standard error goes into a file for as long as this lives.
class ErrorsInFile {
public:
    explicit ErrorsInFile(const QString& path)
        : m_before(dup(STDERR_FILENO)), m_handler(qInstallMessageHandler(nullptr)) {
        const int file = ::open(qPrintable(path), O_WRONLY | O_CREAT | O_APPEND, 0600);
        if (m_before < 0 || file < 0 || dup2(file, STDERR_FILENO) < 0) qFatal("errors cannot be kept");
        ::close(file);
    }
    ~ErrorsInFile() {
        std::fflush(stderr);
        dup2(m_before, STDERR_FILENO);
        ::close(m_before);
        qInstallMessageHandler(m_handler);
    }

private:
    Q_DISABLE_COPY_MOVE(ErrorsInFile)
    int m_before;
    QtMessageHandler m_handler;  ///< the test's own
};

class TestPrivacy : public QObject, private WindowFixture {
    Q_OBJECT

    QTemporaryDir m_home, m_scans;
    QString m_study;
    QList<Marker> m_markers;

    [[nodiscard]] QString path(const QString& name) const { return m_home.filePath(name); }
    /// All that was written below the home folder.
    [[nodiscard]] QStringList foundAtHome(int* files = nullptr) const {
        QStringList found;
        QDirIterator below(m_home.path(), QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
        while (below.hasNext()) {
            QFile file(below.next());
            if (!file.open(QIODevice::ReadOnly)) qFatal("%s", qPrintable(file.fileName()));
            found << foundIn(file.readAll() + file.fileName().toUtf8(), m_markers, below.fileName());
            if (files != nullptr) ++*files;
        }
        return found;
    }
    /// A snapshot, a measurement, and the file that keeps both by itself.
    void keepSomething() {
        Document next = window().document().document();
        next.measurements.push_back({.id = 1, .placesMm = {{10, 10, 10}, {20, 20, 10}}});
        window().document().edit(next, "measure");
        QVERIFY(window().sessionKeeping().snapshots().keep("mine", next).isEmpty());
        QTRY_VERIFY(QFile::exists(window().sessionKeeping().autosave().file()));
    }
    void writeEverything() {
        using Write = std::pair<QString, std::function<void()>>;
        // Whatever a window can write has its line here; each leaves a file of that name.
        const std::vector<Write> writers{
            {"picture.png", [this] { QVERIFY(window().savePicture(path("picture.png"))); }},
            {"curve.json", [this] { QVERIFY(window().saveCurve(path("curve.json"))); }},
            {"report.html", [this] { window().saveReport(path("report.html"), false); }},
            {"movie.mp4",
             [this] {
                 window().movieFiles().begin(FrameOutput::movie, {.path = path("movie.mp4"), .size = {64, 64}});
             }},
            {"frame-0001.png",
             [this] {
                 window().movieFiles().begin(FrameOutput::series, {.path = path("frame.png"), .size = {64, 64}});
             }},
            {QFileInfo(window().sessionKeeping().autosave().file()).fileName(), [this] { keepSomething(); }},
            {"scan.session.json", [this] { window().sessionKeeping().saveAs(path("scan.session.json")); }},
            {"settings-presets.json", [this] { emit child<PresetsPanel>("presets")->saveRequested(); }},
        };
        window().sessionKeeping().autosave().setInterval(1);
        for (const auto& [name, write] : writers) {
            write();
            waitUntilIdle();
            QDirIterator below(m_home.path(), {name}, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
            QVERIFY2(below.hasNext(), qPrintable(name));
            const QStringList found = foundAtHome();  // some files go with the window
            QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
        }
    }

private slots:
    void initTestCase() {
        lookAtNoPicture();
        // Settings, data and caches of this program and of Qt's dialogs go where they are searched.
        for (const char* variable : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_CACHE_HOME", "XDG_STATE_HOME"})
            qputenv(variable, m_home.path().toUtf8());
        m_study = m_scans.filePath("scan.dcm");
        QVERIFY(writeEnhancedUs(m_study.toStdString(), {smallPhantom(PhantomScene::shapes, 5)}, {}));
        m_markers = mark(m_study);
        QVERIFY(m_markers.size() > 50);
        QFile file(m_study);
        QVERIFY(file.open(QIODevice::ReadOnly));
        // The search finds what is there.
        QCOMPARE(foundIn(file.readAll(), m_markers, "study").size(), m_markers.size());
        for (const Marker& marker : m_markers) {
            const QString text = QString::fromLatin1(marker.text);
            const QByteArray utf16(reinterpret_cast<const char*>(text.utf16()), 2 * text.size());
            QCOMPARE(foundIn(utf16, {marker}, "utf-16").size(), 1);
            for (const char* before : {"", "a", "ab"})
                QCOMPARE(foundIn((before + marker.text + "tail").toBase64(), {marker}, "base 64").size(), 1);
        }
    }
    void cleanup() { close(); }

    void theWindowWritesNothingOfThePatient() {
        const ErrorsInFile errors(path("errors.txt"));
        qWarning("This line is searched as well.");
        showWithSettings(path("settings.ini"));
        useLook(Look{});
        open(m_study);
        QVERIFY(foundIn(allWords().join('\n').toUtf8(), m_markers, "window").isEmpty());
        writeEverything();
        window().close();
        close();
        int files = 0;
        const QStringList found = foundAtHome(&files);
        QVERIFY2(found.isEmpty(), qPrintable(found.join('\n')));
        QVERIFY2(files >= 10, qPrintable(QString::number(files)));
        QVERIFY(QFileInfo(path("errors.txt")).size() > 0);
        QVERIFY(QFile::exists(path("settings.ini")));
        QTRY_VERIFY_WITH_TIMEOUT(!QDir(path("settings-data/recent")).isEmpty(), patience);
        // A start with what was written leads to the same.
        showWithSettings(path("settings.ini"));
        QVERIFY(foundIn(allWords().join('\n').toUtf8(), m_markers, "window").isEmpty());
    }

    void thePatientIsWhereItWasAskedFor() {
        showWithSettings(path("settings.ini"));
        useLook(Look{});
        open(m_study);
        window().saveReport(path("patient.html"), true);
        waitUntilIdle();
        QFile report(path("patient.html"));
        QVERIFY(report.open(QIODevice::ReadOnly));
        QStringList found = foundIn(report.readAll(), m_markers, "report");
        found.sort();
        QCOMPARE(found, (QStringList{"report: PatientBirthDate", "report: PatientID", "report: PatientName",
                                     "report: StudyDate"}));
        // It is nowhere else, and not in the next report.
        window().saveReport(path("next.html"), false);
        waitUntilIdle();
        window().close();
        close();
        QVERIFY(report.remove());
        const QStringList left = foundAtHome();
        QVERIFY2(left.isEmpty(), qPrintable(left.join('\n')));
    }

    void aPatientThatIsTypedIsInItsReportAlone() {
        showWithSettings(path("settings.ini"));
        useLook(Look{});
        open(m_study);
        QTimer::singleShot(0, this, [this] {
            auto* dialog = window().findChild<ReportDialog*>("report");
            QVERIFY(dialog != nullptr);
            auto* patient = dialog->findChild<QCheckBox*>("report.patient");
            auto* name = dialog->findChild<QLineEdit*>("report.patientName");
            auto* id = dialog->findChild<QLineEdit*>("report.patientId");
            QTest::mouseClick(patient, Qt::LeftButton, {}, QPoint(10, patient->height() / 2));
            // The fields show what the files say, and take something else.
            QTRY_VERIFY(!id->text().isEmpty());
            QCOMPARE(foundIn((name->text() + ' ' + id->text()).toUtf8(), m_markers, "fields").size(), 2);
            name->selectAll();
            QTest::keyClicks(name, "Typed Name");
            QTimer::singleShot(0, this, [this] {
                auto* files = window().findChild<QFileDialog*>("saveFile");
                QVERIFY(files != nullptr);
                files->selectFile(path("typed.html"));
                static_cast<QDialog*>(files)->done(QDialog::Accepted);
            });
            QTest::mouseClick(dialog->findChild<QPushButton*>("report.save"), Qt::LeftButton);
        });
        child<QAction>("file.saveReport")->trigger();
        waitUntilIdle();
        QFile report(path("typed.html"));
        QVERIFY(report.open(QIODevice::ReadOnly));
        const QByteArray page = report.readAll();
        QVERIFY(page.contains("Patient: Typed Name · "));
        QStringList found = foundIn(page, m_markers, "report");
        found.sort();
        QCOMPARE(found, (QStringList{"report: PatientBirthDate", "report: PatientID", "report: StudyDate"}));
        window().close();
        close();
        QVERIFY(report.remove());
        m_markers.append(Marker{"Typed", "Typed Name"});
        const QStringList left = foundAtHome();
        m_markers.removeLast();
        QVERIFY2(left.isEmpty(), qPrintable(left.join('\n')));
    }

    void theCommandLineTellsNothingOfThePatient_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::newRow("info") << QStringList{"info", m_study};
        QTest::newRow("info as JSON") << QStringList{"info", m_study, "--json"};
        QTest::newRow("files") << QStringList{"files", m_scans.path()};
        QTest::newRow("otf") << QStringList{"otf", m_study, "--json", path("otf.json")};
        QTest::newRow("render") << QStringList{"render", m_study, "-o", path("render.png"), "--size", "64x64"};
        QTest::newRow("sweep") << QStringList{
            "sweep", m_study, "--movie", path("sweep.mp4"), "--size", "64x64", "--from", "0", "--to", "2"};
    }
    void theCommandLineTellsNothingOfThePatient() {
        QFETCH(QStringList, arguments);
        QProcess program;
        program.start(ECHOLUCENT_CLI, arguments);
        QVERIFY(program.waitForFinished(60000));
        const QByteArray said = program.readAllStandardOutput() + program.readAllStandardError();
        QVERIFY2(program.exitCode() == 0, said.constData());
        QCOMPARE(foundIn(said, m_markers, "said"), QStringList());
        QCOMPARE(foundAtHome(), QStringList());
    }

    /// A session of one of a folder's series, what is kept by itself, and its small picture.
    void aSeriesOfAFolderTellsNothingOfThePatient() {
        const QString folder = m_scans.filePath("slices");
        QVERIFY(QDir().mkpath(folder));
        for (const char* series : {firstSeriesUid, secondSeriesUid})
            for (int number = 0; number < (series == firstSeriesUid ? 24 : 20); ++number) {
                const QString slice = QString("%1/%2-%3.dcm").arg(folder, QString(series).right(1)).arg(number);
                writeSlice(slice, series, number);
                m_markers = mark(slice);
            }
        for (const char* uid : {studyUid, frameUid, imageUid}) m_markers.append(Marker{"UID", uid});
        QFile first(folder + "/4-0.dcm");
        QVERIFY(first.open(QIODevice::ReadOnly));
        QCOMPARE(foundIn(first.readAll(), {m_markers.last()}, "slice").size(), 1);

        showWithSettings(path("settings.ini"));
        useLook(Look{});
        QSignalSpy computed(&window().otfs(), &PaneOtfs::computed);
        window().open(folder);
        QTRY_VERIFY(window().findChild<QDialog*>("series") && window().idle());
        QVERIFY(foundIn(allWords().join('\n').toUtf8(), m_markers, "choice").isEmpty());
        QTest::keyClick(child<QWidget>("series.list"), Qt::Key_Down);
        QTest::keyClick(child<QDialog>("series"), Qt::Key_Return);
        QVERIFY(computed.wait(patience));
        waitUntilIdle();
        const QString recent = path("settings-data/recent/") + Settings::hashOf(folder) + ".png";
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(recent), patience);  // once its picture is fine
        window().sessionKeeping().autosave().setInterval(1);
        keepSomething();
        QCOMPARE(foundAtHome().join('\n'), QString());
        const QString session = path("slices.session.json");
        window().sessionKeeping().saveAs(session);
        waitUntilIdle();
        QCOMPARE(foundAtHome().join('\n'), QString());
        QFile saved(session);
        QVERIFY(saved.open(QIODevice::ReadOnly));
        const QByteArray text = saved.readAll();
        QVERIFY(text.contains(secondSeriesUid) && !text.contains(firstSeriesUid));
        window().close();
        close();
        showWithSettings(path("settings.ini"));
        open(session);
        QCOMPARE(window().openStudy().volume()->geometry().size[2], std::int64_t{20});
        QVERIFY(foundIn(allWords().join('\n').toUtf8(), m_markers, "window").isEmpty());
        window().close();
        close();
        QCOMPARE(foundAtHome().join('\n'), QString());
    }
};

ECHOLUCENT_TEST_CLASS(TestPrivacy)
#include "test_privacy.moc"
