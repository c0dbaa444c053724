// The case report that the window saves: what it holds, what it leaves out, and what ends it.
#include <QCheckBox>
#include <QDir>
#include <QFileDialog>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QTimer>

#include "app/report/report_saving.h"
#include "app/window/review_room.h"
#include "io/writers/enhanced_us_writer.h"
#include "processing/picture/look.h"
#include "tests/app/report_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/casting/picture_image.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/run_status.h"
#include "widgets/dialogs/report_dialog.h"
#include "widgets/picture_labels/measurement_drawing.h"
#include "widgets/planes/pane_grid.h"
#include "widgets/planes/plane_pane.h"

using namespace echolucent;

class TestCaseReport : public QObject, private ReportFixture {
    Q_OBJECT

    QString m_file, m_dicom;

private slots:
    void initTestCase() {
        const auto scan = smallPhantom(PhantomScene::shapes, 5);
        m_file = file("visit.7.mha", {scan});
        m_dicom = temporaryFolder().filePath("visit.dcm");
        QVERIFY(writeEnhancedUs(m_dicom.toStdString(), {scan}, {}));
    }
    void init() {
        show();
        useLook(Look{});
        open(m_file);
        QFile::remove(reportPath());
    }
    void cleanup() { close(); }

    void theReportHoldsAllThatWasSet() {
        Document next = window().document().document();
        next.measurements = {{.id = 4, .placesMm = {{10, 10, 10}, {22, 26, 10}}},
                             {.id = 5,
                              .kind = MeasurementKind::angle,
                              .ground = MeasurementGround::surface,
                              .placesMm = {{10, 10, 10}, {20, 10, 10}, {20, 20, 10}}}};
        window().document().edit(next, "measure");
        waitUntilIdle();
        const QString text = saved(true);
        for (const QString words :
             {"Case report: visit.7.mha", "not a medical device", "What the picture shows", "Measurements", "Curves",
              "Parameters", "Import report", "Timings", "adaptive (rendered)", "voxels (logarithm)", "60 × 56 × 58",
              "20.0 mm", "90.0°", "surface"})
            QVERIFY2(text.contains(words, Qt::CaseInsensitive) ||
                         text.contains(QString(words).replace(u'×', u'x'), Qt::CaseInsensitive),
                     qPrintable(words));
        QVERIFY(!text.contains("Patient:"));
        QCOMPARE(child<MessageBar>("message")->text(), "The case report was saved as report.html.");
        // They are drawn over the 3D view too, in their one colour.
        const QImage picture = picturesOf(text)["3D view"];
        int marked = 0;
        for (int y = 0; y < picture.height(); ++y)
            for (int x = 0; x < picture.width(); ++x)
                marked += QColor(picture.pixel(x, y)) == measurementColour ? 1 : 0;
        QVERIFY2(marked > 30, qPrintable(QString::number(marked)));
        // Each parameter of the method and of the look has its row.
        for (const Parameter<Look>& row : lookParameters())
            QVERIFY2(text.contains(QString::fromUtf8(row.label.data(), static_cast<int>(row.label.size()))),
                     row.name.data());
    }

    void thePageNeedsNothingBesideIt() {
        const QString text = saved(true);
        // An address is one of the page itself or the name of a language of markup.
        static const QRegularExpression address("(?:src|href|url|@import)\\s*[=(]\\s*[\"']?([^\"')\\s]{0,40})");
        int addresses = 0;
        for (const auto& found : address.globalMatch(text)) {
            ++addresses;
            QVERIFY2(found.captured(1).startsWith("data:image/png;base64,"), qPrintable(found.captured(1)));
        }
        QVERIFY(addresses > 0);
        QVERIFY(!text.contains("<script"));
        QVERIFY(!text.contains("<link"));
        QString withoutNames = text;
        withoutNames.remove("http://www.w3.org/2000/svg");
        QVERIFY(!withoutNames.contains("http"));
    }

    void thePicturesAreThoseOfThePanes() {
        showPanes(PaneLayout::quad);
        const QMap<QString, QImage> pictures = picturesOf(saved());
        QCOMPARE(pictures.keys(), (QStringList{"3D view", "Plane A", "Plane B", "Plane C"}));
        // The 3D view as it is saved by itself, and a plane as it stands on the screen.
        QVERIFY(rgbBytesOf(pictures["3D view"]) == rgbBytesOf(window().volumeView().convergedImage()));
        const auto* pane = child<PlanePane>("planes.b");
        const QImage& plane = pictures["Plane B"];
        QCOMPARE(plane.size(), pane->size() * pane->devicePixelRatioF());
        int equal = 0, all = 0;
        const QImage samples = pane->image().convertToFormat(plane.format());
        for (int y = 0; y < plane.height(); ++y)
            for (int x = 0; x < plane.width(); ++x, ++all) equal += plane.pixel(x, y) == samples.pixel(x, y) ? 1 : 0;
        QVERIFY2(equal > all * 9 / 10 && equal < all, qPrintable(QString("%1 of %2").arg(equal).arg(all)));  // lines
        showPanes(PaneLayout::only3d);
        QCOMPARE(picturesOf(saved()).keys(), QStringList{"3D view"});
    }

    void thePicturesOfA4DStudyNameTheirVolume() {
        const auto scan = smallPhantom(PhantomScene::shapes, 5);
        open(file("beating.mha", {scan, scan, scan}));
        showPanes(PaneLayout::quad);
        window().document().showPhase(1);
        waitUntilIdle();
        QCOMPARE(picturesOf(saved()).keys(),
                 (QStringList{"3D view, volume 2", "Plane A, volume 2", "Plane B, volume 2", "Plane C, volume 2"}));
    }

    void theDialogAsksForThePatientEachTime() {
        for (const bool dicom : {false, true}) {
            if (dicom) open(m_dicom);
            for (int time = 0; time < 2; ++time) {
                QStringList cut;
                QString proposed;
                bool enabled = false, checkedAtFirst = true, checked = false;
                QTimer::singleShot(0, this, [&] {
                    auto* dialog = window().findChild<ReportDialog*>("report");
                    if (dialog == nullptr) qFatal("no dialog");
                    auto* patient = dialog->findChild<QCheckBox*>("report.patient");
                    enabled = patient->isEnabled();
                    checkedAtFirst = dialog->withPatient();
                    QTest::mouseClick(patient, Qt::LeftButton, {}, QPoint(10, patient->height() / 2));
                    checked = dialog->withPatient();
                    for (QAbstractButton* button : dialog->findChildren<QAbstractButton*>())
                        if (button->width() < button->sizeHint().width()) cut << button->text();
                    QTimer::singleShot(0, this, [&] {
                        auto* files = window().findChild<QFileDialog*>("saveFile");
                        if (files == nullptr) qFatal("no dialog of files");
                        proposed = QFileInfo(files->selectedFiles().value(0)).fileName();
                        files->reject();
                    });
                    QTest::mouseClick(dialog->findChild<QPushButton*>("report.save"), Qt::LeftButton);
                });
                child<QAction>("file.saveReport")->trigger();
                QCOMPARE(proposed, dicom ? "visit-report.html" : "visit.7-report.html");
                QVERIFY(enabled);
                QVERIFY(!checkedAtFirst);
                QVERIFY(checked);
                QCOMPARE(cut, QStringList());
            }
        }
        QVERIFY(!QFile::exists(reportPath()));
    }

    void theFirstPageHoldsWhatWasFoundAndTheAppendixTheRest() {
        showPanes(PaneLayout::quad);
        Document next = window().document().document();
        next.measurements = {
            {.id = 4, .placesMm = {{10, 10, 10}, {22, 26, 10}}, .name = "BPD", .comment = "outer <b>"},
            {.id = 5, .kind = MeasurementKind::angle, .placesMm = {{10, 10, 10}, {20, 10, 10}, {20, 20, 10}}}};
        window().document().edit(next, "measure");
        waitUntilIdle();
        answerDialog([](ReportDialog* dialog) {
            QTest::keyClicks(textOf(dialog, "impression"), "No finding.");
            textOf(dialog, "comment")->setPlainText("Seen twice.\nLies still.");
            dialog->findChild<QCheckBox*>("report.appendix")->click();
        });
        const QStringList parts = page().split("<section class=\"appendix\">");
        QCOMPARE(parts.size(), 2);
        for (const QString& part : parts) QVERIFY(part.contains("not a medical device", Qt::CaseInsensitive));
        const QString& first = parts[0];
        QCOMPARE(picturesOf(first).size(), 4);
        QVERIFY(picturesOf(parts[1]).isEmpty());
        QVERIFY(first.indexOf("alt=\"3D view\"") < first.indexOf("alt=\"Plane A\""));
        for (const QString words : {"<td>BPD</td><td class=\"number\">20.0</td><td>mm</td><td>outer &lt;b&gt;</td>",
                                    "<td>angle 5</td><td class=\"number\">90.0</td><td>°</td><td></td>",
                                    "<h2>Impression</h2>\n<p class=\"lines\">No finding.</p>",
                                    "<h2>Comment</h2>\n<p class=\"lines\">Seen twice.\nLies still.</p>"})
            QVERIFY2(first.contains(words), qPrintable(words));
        for (const QString words :
             {"Curves</h2>", "Parameters</h2>", "Import report</h2>", "Timings</h2>", "(10.00, "}) {
            QVERIFY2(!first.contains(words), qPrintable(words));
            QVERIFY2(parts[1].contains(words), qPrintable(words));
        }
        QVERIFY(!page().contains("Continued in the appendix"));
    }

    void withoutAnAppendixOnlyWhatHasNoRoomFollowsTheFirstPage() {
        const QString short1 = saved();
        QVERIFY(short1.contains("Nothing was measured."));
        QVERIFY(!short1.contains("class=\"appendix\"") && !short1.contains("Parameters</h2>"));
        answerDialog([](ReportDialog* dialog) {
            textOf(dialog, "impression")->setPlainText(QString("A long impression. ").repeated(300));
        });
        const QStringList parts = page().split("<section class=\"appendix\">");
        QCOMPARE(parts.size(), 2);
        QVERIFY(parts[0].contains("Continued on the next sheet: the impression."));
        QVERIFY(parts[1].contains("Impression, whole</h2>"));
        QVERIFY(!parts[1].contains("Parameters</h2>") && !parts[1].contains("Import report</h2>"));
    }

    void aNameThatEndsWithPdfMakesAPdf() {
        showPanes(PaneLayout::quad);
        const QString path = temporaryFolder().filePath("report.PDF");
        const auto pdf = [&](bool withAppendix) {
            window().saveReport(path, false, withAppendix);
            waitUntilIdle();
            QFile file(path);
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        static const QRegularExpression side("/Type /Page\\b"), image("/Subtype /Image\\b");
        const auto count = [](const QByteArray& bytes, const QRegularExpression& what) {
            int found = 0;
            for (auto all = what.globalMatch(QString::fromLatin1(bytes)); all.hasNext(); all.next()) ++found;
            return found;
        };
        const QByteArray one = pdf(false);
        QVERIFY(one.startsWith("%PDF-"));
        QCOMPARE(child<MessageBar>("message")->text(), "The case report was saved as report.PDF.");
        QCOMPARE(count(one, side), 1);
        QCOMPARE(count(one, image), 4);  // three planes and the 3D view
        const QByteArray all = pdf(true);
        QVERIFY2(count(all, side) >= 3, qPrintable(QString::number(count(all, side))));
        QCOMPARE(count(all, image), 5);  // and the plot of the curves
        // Beside what is drawn, the title says whose file it is: in UTF-16, as PDF wants it.
        const auto says = [](const QByteArray& bytes, const QString& words) {
            QByteArray stored;
            for (const QChar letter : words) stored.append(letter.row()).append(letter.cell());
            return bytes.contains(stored);
        };
        QVERIFY(says(one, "visit"));
        child<QAction>("view.numbersForNames")->trigger();
        const QByteArray numbered = pdf(false);
        child<QAction>("view.numbersForNames")->trigger();
        QVERIFY(says(numbered, "Study 1") && !says(numbered, "visit") && !numbered.contains("visit"));
    }

    void impressionAndCommentStayUntilAnotherStudyOpens() {
        const auto texts = [this](const std::function<void(ReportDialog*)>& edit = {}) {
            QStringList found;
            QTimer::singleShot(0, this, [&] {
                auto* dialog = theDialog();
                found =
                    QStringList{textOf(dialog, "impression")->toPlainText(), textOf(dialog, "comment")->toPlainText()};
                if (edit) edit(dialog);
                dialog->reject();
            });
            child<QAction>("file.saveReport")->trigger();
            return found;
        };
        QCOMPARE(texts([](ReportDialog* dialog) {
                     textOf(dialog, "impression")->setPlainText("calm");
                     textOf(dialog, "comment")->setPlainText("asleep");
                 }),
                 (QStringList{"", ""}));
        QCOMPARE(texts(), (QStringList{"calm", "asleep"}));
        QVERIFY(!saved().contains("asleep"));  // only the dialog asks for it
        open(m_dicom);
        QCOMPARE(texts(), (QStringList{"", ""}));
    }

    void aPatientIsTypedForFilesThatNameNone() {
        answerDialog([](ReportDialog* dialog) {
            auto* name = fieldOf(dialog, "Name");
            QVERIFY(!name->isEnabled());
            tickPatient(dialog);
            QVERIFY(name->isEnabled());
            QCOMPARE(name->placeholderText(), "");
            QTest::keyClicks(name, "Anna Muster");
            QTest::keyClicks(fieldOf(dialog, "Id"), "4711");
            QTest::keyClicks(fieldOf(dialog, "BirthDate"), "1990-02-03");
            QCOMPARE(fieldOf(dialog, "GestationalAge")->placeholderText(), "weeks+days (22+4)");
            QTest::keyClicks(fieldOf(dialog, "ExamDate"), "2024-02-29");
            QTest::keyClicks(fieldOf(dialog, "GestationalAge"), "22+4");
        });
        QVERIFY2(page().contains("<p>Patient: Anna Muster · patient ID 4711 · born 1990-02-03 · exam of 2024-02-29 · "
                                 "gestational age 22+4</p>"),
                 qPrintable(page().left(6000)));
        QVERIFY(!saved().contains("Muster"));
    }

    void aFileOfTheStudyIsNeverOverwritten() {
        const auto bytes = [this] {
            QFile file(m_file);
            return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
        };
        const QByteArray before = bytes();
        window().saveReport(m_file, false);
        waitUntilIdle();
        QCOMPARE(child<MessageBar>("message")->kind(), MessageKind::error);
        QCOMPARE(bytes(), before);
        window().saveReport("/nowhere/at/all/report.html", false);
        waitUntilIdle();
        QVERIFY2(child<MessageBar>("message")->text().contains("report.html"),
                 qPrintable(child<MessageBar>("message")->text()));
        QCOMPARE(child<MessageBar>("message")->kind(), MessageKind::error);
    }

    void aReportThatIsCancelledLeavesNoFile() {
        lookFrom(window(), {.beamAxis = BeamAxis::plusZ, .azimuthDegrees = 70, .elevationDegrees = 0});
        window().saveReport(reportPath(), false);
        QVERIFY(!window().idle());
        emit child<RunStatus>("status")->cancelRequested();
        waitUntilIdle();
        QVERIFY(!QFile::exists(reportPath()));
        QVERIFY(!saved().isEmpty());
    }

    void cancelIsToldWheneverItComes() {
        for (const bool writing : {false, true}) {
            QFile::remove(reportPath());
            lookFrom(window(), {.beamAxis = BeamAxis::plusZ, .azimuthDegrees = writing ? 30.0 : 70.0});
            window().saveReport(reportPath(), false);
            if (writing) {
                QSignalSpy progressed(&window().works(), &Works::progressed);
                QVERIFY(progressed.wait(30000));
            }
            emit child<RunStatus>("status")->cancelRequested();
            waitUntilIdle();
            const QString said = child<MessageBar>("message")->text();
            if (QFile::exists(reportPath())) {
                QVERIFY(writing);
                QCOMPARE(said, "The case report was saved as report.html.");
            } else {
                QCOMPARE(said, "Writing report.html was cancelled; no file is left of it.");
            }
        }
    }

    void anotherStudyEndsAReportThatWaits() {
        // The report of one study must not be made of the panes of the next.
        lookFrom(window(), {.beamAxis = BeamAxis::plusZ, .azimuthDegrees = 70, .elevationDegrees = 0});
        QSignalSpy opened(&window().openStudy(), &OpenStudy::studyOpened);
        window().open(m_dicom);
        window().saveReport(reportPath(), false);
        QVERIFY(opened.count() == 1 || opened.wait(30000));
        waitUntilIdle();
        QVERIFY(!QFile::exists(reportPath()));
        QVERIFY2(child<MessageBar>("message")->text().contains("report.html was not written"),
                 qPrintable(child<MessageBar>("message")->text()));
        QVERIFY(saved().contains("Case report: visit.dcm"));
    }

    void anotherStudyClosesTheDialogs() {
        for (const bool ofFiles : {false, true}) {
            const QString other = window().openStudy().path() == m_file ? m_dicom : m_file;
            QTimer::singleShot(0, this, [&, ofFiles] {
                auto* dialog = window().findChild<ReportDialog*>("report");
                if (dialog == nullptr) qFatal("no dialog");
                if (ofFiles) {
                    QTimer::singleShot(0, this, [&] { window().open(other); });
                    QTest::mouseClick(dialog->findChild<QPushButton*>("report.save"), Qt::LeftButton);
                } else {
                    window().open(other);
                }
            });
            child<QAction>("file.saveReport")->trigger();  // it comes back once the dialogs are closed
            QCOMPARE(window().openStudy().path(), other);
            waitUntilIdle();
        }
        QVERIFY(!QFile::exists(reportPath()));
    }

    void closingTheWindowEndsTheReport() {
        lookFrom(window(), {.beamAxis = BeamAxis::plusZ, .azimuthDegrees = 70, .elevationDegrees = 0});
        window().saveReport(reportPath(), false);
        QVERIFY(window().close());
        waitUntilIdle();
        QVERIFY(!QFile::exists(reportPath()));
    }

    void aReportWaitsForThePictureThatIsOnItsWay() {
        lookFrom(window(), {.beamAxis = BeamAxis::plusZ, .azimuthDegrees = 70, .elevationDegrees = 0});
        const QImage picture = picturesOf(saved())["3D view"];
        QVERIFY(window().volumeView().pictureIsFine());
        QVERIFY(rgbBytesOf(picture) == rgbBytesOf(window().volumeView().convergedImage()));
    }

    void theReportCallsTheStudyByItsNumber() {
        child<QAction>("view.numbersForNames")->trigger();
        const QString text = saved();
        QVERIFY(text.contains("Case report: Study 1"));
        QVERIFY(!text.contains("visit"));
    }

    void theSimulatedScanHasAReportToo() {
        window().openSimulatedScan();
        QTRY_VERIFY_WITH_TIMEOUT(window().openStudy().isSimulatedScan() && window().idle(), 60000);
        QVERIFY(saved().contains("Case report: simulated scan"));
    }
};

ECHOLUCENT_TEST_CLASS(TestCaseReport)
#include "test_case_report.moc"
