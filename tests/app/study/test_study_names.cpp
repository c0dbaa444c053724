// What of a text are names of files, and what are words and numbers that must stay as they are.
#include <QTemporaryDir>
#include <QTest>

#include "app/settings/settings.h"
#include "app/study/study_names.h"
#include "tests/qt_program/test_classes.h"

using namespace echolucent;

class TestStudyNames : public QObject {
    Q_OBJECT

private slots:
    void numbersStandForNamesAndForNothingElse_data() {
        QTest::addColumn<QString>("study");
        QTest::addColumn<QStringList>("files");
        QTest::addColumn<QString>("text");
        QTest::addColumn<QString>("shown");
        const QStringList slices{"/data/3D/10.dcm", "/data/3D/100"};
        QTest::newRow("numbers") << "/data/3D" << slices << "spacing 0.10 mm, 10 slices, 100 x 10 x 10.5"
                                 << "spacing 0.10 mm, 10 slices, 100 x 10 x 10.5";
        QTest::newRow("short words") << "/data/US" << QStringList{"/data/US/MR.1.dcm"} << "US, 3D, MR: modality US"
                                     << "US, 3D, MR: modality US";
        QTest::newRow("words") << "/data/spacing.mha" << QStringList{} << "spacing 0.1 mm"
                               << "spacing 0.1 mm";
        QTest::newRow("a slice") << "/data/3D" << slices << "10.dcm cannot be read"
                                 << "Study 1 cannot be read";
        QTest::newRow("its folder") << "/data/3D" << slices << "3D/7 cannot be read"
                                    << "Study 1/7 cannot be read";
        QTest::newRow("a short name") << "/data/Doe" << QStringList{} << "Doe/7.dcm is short"
                                      << "Study 1/7.dcm is short";
        QTest::newRow("a name") << "/data/Muster.mha" << QStringList{} << "Muster, Muster-1.json"
                                << "Study 1, Study 1-1.json";
        QTest::newRow("a person's number") << "/data/20240131.mha" << QStringList{} << "20240131 and 0.20240131"
                                           << "Study 1 and 0.20240131";
    }
    void numbersStandForNamesAndForNothingElse() {
        QFETCH(QString, study);
        QFETCH(QStringList, files);
        QFETCH(QString, text);
        const QTemporaryDir folder;
        Settings settings(folder.filePath("settings.ini"));
        StudyNames names(settings);
        names.know(study, files);
        QCOMPARE(names.shown(text), text);
        names.showNumbers(true);
        QTEST(names.shown(text), "shown");
    }

    void whatWasGivenOutIsFoundWhereverItStood() {
        const QTemporaryDir folder;
        Settings settings(folder.filePath("settings.ini"));
        StudyNames names(settings);
        // Words, which in other texts stand for themselves.
        const QString said = names.nameOf("/data/slices") + " was not found; " +
                             names.nameOfOther("/data/Jane Doe 1.json") + " and " + names.nameOfOther("/data/note") +
                             " stay.";
        QCOMPARE(said, QString("slices was not found; Jane Doe 1.json and note stay."));
        QCOMPARE(names.shownBefore(said), said);
        names.showNumbers(true);
        QCOMPARE(names.shownBefore(said), QString("Study 1 was not found; *.json and … stay."));
        QCOMPARE(names.shownOfFile("note: 12 slices"), QString("note: 12 slices"));
    }

    void aLongNameLeavesRoomForWhatFollowsIt() {
        const QTemporaryDir folder;
        Settings settings(folder.filePath("settings.ini"));
        StudyNames names(settings);
        QCOMPARE(names.beginningFor("/data/" + QString(200, 'n') + ".mha"), QString(200, 'n'));
        QCOMPARE(names.beginningFor("/data/" + QString(251, 'n') + ".mha"), QString(200, 'n'));
        QCOMPARE(names.beginningFor("/data/" + QString(83, QChar(0x8d85)) + ".mha"), QString(66, QChar(0x8d85)));
        QCOMPARE(names.nameOf("/data/two\nlines.mha"), QString("two lines.mha"));
    }

    void aSessionIsCalledByItsStudyAtEveryStart() {
        const QTemporaryDir folder;
        const QString file = folder.filePath("settings.ini"), session = "/data/Doe.session.json";
        for (int start = 0; start < 2; ++start) {
            Settings settings(file);
            StudyNames names(settings);
            names.showNumbers(true);
            if (start == 0) {
                QCOMPARE(names.nameOf("/data/other.mha"), QString("Study 1"));
                QCOMPARE(names.nameOf(session), QString("Study 2"));  // not known to be one
                names.know("/data/Doe.mha");
                names.knowSession(session, "/data/Doe.mha");
                names.knowSession("/data/scan.session.json", {});
            }
            QCOMPARE(names.nameOf("/data/Doe.mha"), QString("Study 3"));
            QCOMPARE(names.nameOf(session), QString("Study 3 (session)"));
            QCOMPARE(names.beginningFor(session), QString("study-3"));
            QCOMPARE(names.nameOf("/data/scan.session.json"), QString("Study 4 (session)"));
            QVERIFY(settings.save());
        }
        QFile written(file);
        QVERIFY(written.open(QIODevice::ReadOnly));
        QVERIFY(!written.readAll().contains("Doe"));
    }
};

ECHOLUCENT_TEST_CLASS(TestStudyNames)
#include "test_study_names.moc"
