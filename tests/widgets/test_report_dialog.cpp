// The dialog of the case report: whose study it is said to be, and who says so.
#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QTest>

#include "tests/qt_program/test_classes.h"
#include "widgets/dialogs/report_dialog.h"

using namespace echolucent;

class TestReportDialog : public QObject {
    Q_OBJECT

private slots:
    void textsAreProposedAndTaken() {
        ReportDialog dialog({.comment = "asleep", .impression = "calm"});
        QCOMPARE(dialog.choice().impression, "calm");
        QCOMPARE(dialog.choice().comment, "asleep");
        QTest::keyClicks(dialog.findChild<QPlainTextEdit*>("report.impression"), "more ");
        QCOMPARE(dialog.choice().impression, "more calm");
        QVERIFY(!dialog.choice().withPatient);
    }

    void theAppendixIsOffAtFirst() {
        ReportDialog dialog({});
        QVERIFY(!dialog.choice().withAppendix);
        dialog.findChild<QCheckBox*>("report.appendix")->click();
        QVERIFY(dialog.choice().withAppendix);
    }

    void aPatientIsTypedWhereFilesNameNone() {
        ReportDialog dialog({.filesNamePatient = false});
        QSignalSpy asked(&dialog, &ReportDialog::patientAsked);
        for (const char* fact : facts) QVERIFY(!field(dialog, fact)->isEnabled());
        tick(dialog);
        for (const char* fact : facts) {
            QVERIFY(field(dialog, fact)->isEnabled());
            QTest::keyClicks(field(dialog, fact), fact);
        }
        QVERIFY(asked.isEmpty());
        QVERIFY(dialog.choice().withPatient && !dialog.choice().restFromFiles);
        QCOMPARE(dialog.choice().patient,
                 (ReportPatient{"Name", "Id", "BirthDate", "Sex", "ExamDate", "GestationalAge"}));
        tick(dialog);
        QCOMPARE(dialog.choice().patient, ReportPatient{});  // typed, and then not wanted
    }

    void whatFilesSayIsShownAndMayBeCorrected() {
        ReportDialog dialog({.filesNamePatient = true});
        QSignalSpy asked(&dialog, &ReportDialog::patientAsked);
        tick(dialog);
        QCOMPARE(asked.count(), 1);
        QVERIFY(dialog.choice().restFromFiles);  // not read yet
        QTest::keyClicks(field(dialog, "Id"), "4711");
        QVERIFY(dialog.choice().restFromFiles);
        dialog.showPatient({"Muster^Anna", "0815", "1990-02-03", "F", "2024-02-29", "22+4"});
        QCOMPARE(dialog.choice().patient,
                 (ReportPatient{"Muster^Anna", "4711", "1990-02-03", "F", "2024-02-29", "22+4"}));
        QVERIFY(!dialog.choice().restFromFiles);
        field(dialog, "BirthDate")->clear();
        QCOMPARE(dialog.choice().patient.birthDate, "");
        QVERIFY(!dialog.choice().restFromFiles);  // it is not wanted
        tick(dialog);
        tick(dialog);
        QCOMPARE(asked.count(), 1);
    }

    void theGestationalAgeOfTheFilesIsThatOfTheirDate() {
        const ReportPatient ofFiles{"Muster^Anna", "0815", "1990-02-03", "F", "2024-02-29", "22+4"};
        ReportDialog corrected({.filesNamePatient = true});
        tick(corrected);
        corrected.showPatient(ofFiles);
        field(corrected, "ExamDate")->selectAll();
        QTest::keyClicks(field(corrected, "ExamDate"), "2024-03-07");
        QCOMPARE(corrected.choice().patient.gestationalAge, "");
        QTest::keyClicks(field(corrected, "GestationalAge"), "23+4");
        QTest::keyClicks(field(corrected, "ExamDate"), "!");
        QCOMPARE(corrected.choice().patient.gestationalAge, "23+4");  // typed
        ReportDialog typed({.filesNamePatient = true});
        tick(typed);
        QTest::keyClicks(field(typed, "ExamDate"), "2024-03-07");
        typed.showPatient(ofFiles);
        QCOMPARE(typed.choice().patient.gestationalAge, "");
        QCOMPARE(typed.choice().patient.birthDate, "1990-02-03");
    }

    void namesThatAreHiddenAreNotShown() {
        ReportDialog dialog({.filesNamePatient = true, .patientIsShown = false});
        QSignalSpy asked(&dialog, &ReportDialog::patientAsked);
        tick(dialog);
        QVERIFY(asked.isEmpty());
        QCOMPARE(field(dialog, "Name")->placeholderText(), "as the files say");
        QVERIFY(dialog.choice().restFromFiles);
    }

    void filesOfTwoPatientsLeaveRoomForAHand() {
        ReportDialog dialog({.filesNamePatient = true});
        tick(dialog);
        dialog.showPatientProblem("The files are of two patients.");
        QCOMPARE(dialog.findChild<QLabel*>("report.patientLine")->text(), "The files are of two patients.");
        QVERIFY(dialog.choice().restFromFiles);  // then saving says so as well
        QTest::keyClicks(field(dialog, "Name"), "Anna");
        QVERIFY(!dialog.choice().restFromFiles);
    }

private:
    static constexpr std::array facts{"Name", "Id", "BirthDate", "Sex", "ExamDate", "GestationalAge"};
    static QLineEdit* field(ReportDialog& dialog, const char* fact) {
        return dialog.findChild<QLineEdit*>(QStringLiteral("report.patient") + fact);
    }
    static void tick(ReportDialog& dialog) { dialog.findChild<QCheckBox*>("report.patient")->toggle(); }
};

ECHOLUCENT_TEST_CLASS(TestReportDialog)
#include "test_report_dialog.moc"
