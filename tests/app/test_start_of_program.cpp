// The window's program where there is no display: one sentence, no crash, and help and version all the same.
#include <QProcess>
#include <QTest>

#include "tests/qt_program/test_classes.h"

using namespace echolucent;

namespace {

struct Ended {
    QProcess::ExitStatus how = QProcess::CrashExit;
    int status = -1;
    QString output, errors;
};

Ended run(const QStringList& arguments, const QString& display, const QString& platform) {
    QProcess process;
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"}) environment.remove(name);
    if (!display.isEmpty()) environment.insert("DISPLAY", display);
    if (!platform.isEmpty()) environment.insert("QT_QPA_PLATFORM", platform);
    process.setProcessEnvironment(environment);
    process.start(ECHOLUCENT_PROGRAM, arguments);
    if (!process.waitForFinished(patience)) qFatal("the program goes on");
    return {process.exitStatus(), process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

}  // namespace

class TestStartOfProgram : public QObject {
    Q_OBJECT

private slots:
    void oneSentenceNamesTheCommandLine_data() {
        QTest::addColumn<QString>("display");
        QTest::addColumn<QString>("platform");
        QTest::newRow("none") << ""
                              << "";
        QTest::newRow("nowhere") << ":7654"
                                 << "";
        QTest::newRow("a platform that is none") << ""
                                                 << "nowhere";
    }
    void oneSentenceNamesTheCommandLine() {
        QFETCH(QString, display);
        QFETCH(QString, platform);
        const Ended ended = run({"volume.mha"}, display, platform);
        QCOMPARE(ended.how, QProcess::NormalExit);
        QCOMPARE(ended.status, 1);
        QVERIFY2(ended.errors.startsWith("Echolucent needs a display, and none could be opened"),
                 qPrintable(ended.errors));
        QVERIFY2(ended.errors.contains("echolucent-cli"), qPrintable(ended.errors));
        QCOMPARE(ended.errors.count('\n'), 1);
    }

    void helpAndVersionNeedNone() {
        const Ended version = run({"--version"}, {}, {});
        QCOMPARE(version.status, 0);
        QVERIFY2(version.output.startsWith("Echolucent "), qPrintable(version.output));
        QCOMPARE(version.errors, QString());
        for (const char* qtOption : {"offscreen", "nowhere"}) {  // an application with a display takes these itself
            const Ended beside = run({"-platform", qtOption, "--version"}, {}, {});
            QCOMPARE(beside.status, 0);
            QCOMPARE(beside.output, version.output);
            QCOMPARE(beside.errors, QString());
        }
        const Ended help = run({"-h"}, {}, {});
        QCOMPARE(help.status, 0);
        QVERIFY2(help.output.contains("[FILE]"), qPrintable(help.output));
        QCOMPARE(help.errors, QString());
    }
};

ECHOLUCENT_TEST_CLASS(TestStartOfProgram)
#include "test_start_of_program.moc"
