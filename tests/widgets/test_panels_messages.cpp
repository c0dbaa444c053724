// What the program tells: study facts and run status; and the names of every control.
#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QLocale>
#include <QObject>
#include <QProgressBar>
#include <QSet>
#include <QSignalSpy>
#include <QString>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>
#include <QWidget>

#include "tests/qt_program/test_classes.h"
#include "tests/widgets/panel_controls.h"
#include "widgets/controls/message_bar.h"
#include "widgets/controls/run_status.h"
#include "widgets/dialogs/raw_layout_dialog.h"
#include "widgets/panels/method_panel.h"
#include "widgets/panels/motion_panel.h"
#include "widgets/panels/study_panel.h"
#include "widgets/panels/view_panel.h"
#include "widgets/theme_colours.h"

using namespace echolucent;

namespace {

bool isControl(const QWidget* widget) {
    const bool input = qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QAbstractSlider*>(widget) ||
                       qobject_cast<const QComboBox*>(widget) || qobject_cast<const QAbstractSpinBox*>(widget);
    for (const QWidget* parent = widget->parentWidget(); parent; parent = parent->parentWidget()) {
        // Scroll bars, corner buttons and pop-up lists are parts of another control.
        if (qobject_cast<const QAbstractScrollArea*>(parent) || qobject_cast<const QComboBox*>(parent)) return false;
    }
    return input;
}

}  // namespace

class TestPanelsMessages : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void everyControlHasItsNames_data() {
        QTest::addColumn<QString>("prefix");
        QTest::addColumn<int>("leastControls");
        for (const auto& [prefix, count] : {std::pair{"adaptive", 21},
                                            {"view", 11},
                                            {"motion", 9},
                                            {"status", 1},
                                            {"message", 3},
                                            {"rawLayout", 13}}) {
            QTest::newRow(prefix) << prefix << count;
        }
    }
    void everyControlHasItsNames() {
        QFETCH(QString, prefix);
        QFETCH(int, leastControls);
        const std::unique_ptr<QWidget> panel = create(prefix);
        QCOMPARE(panel->objectName(), prefix);
        QSet<QString> names;
        for (const QWidget* widget : panel->findChildren<QWidget*>()) {
            if (!isControl(widget)) continue;
            const QString name = widget->objectName();
            QVERIFY2(name.startsWith(prefix + '.'), qPrintable(name + " of " + widget->metaObject()->className()));
            QVERIFY2(!widget->accessibleName().isEmpty(), qPrintable(name));
            QVERIFY2(widget->focusPolicy() & Qt::TabFocus, qPrintable(name));
            QVERIFY2(!names.contains(name), qPrintable(name));
            names.insert(name);
        }
        QVERIFY2(names.size() >= leastControls, qPrintable(QString::number(names.size())));
    }

    void studyFactsAreShownAndCannotBeEdited() {
        StudyPanel panel;
        panel.setStudy({{"size", "2 x 3 x 4", "DimSize"}, {"<b>spacing</b>", "0.30 mm", "assumed"}},
                       {"Spacing guessed."});
        panel.show();
        auto* table = child<QTableWidget>(panel, "study.facts");
        auto* warnings = child<QLabel>(panel, "study.warnings");
        QCOMPARE(table->rowCount(), 4);
        QCOMPARE(table->item(2, 0)->text(), "<b>spacing</b>");
        QCOMPARE(table->item(2, 1)->text(), "0.30 mm");
        QCOMPARE(table->item(3, 1)->text(), "assumed");
        QVERIFY(warnings->text().contains("Spacing guessed."));
        table->setCurrentCell(2, 1);
        QTest::keyClicks(table, "9");
        QTest::keyClick(table, Qt::Key_Return);
        QCOMPARE(table->item(2, 1)->text(), "0.30 mm");
        panel.setStudy({}, {});
        QCOMPARE(table->rowCount(), 0);
        QVERIFY(!warnings->isVisible());
    }

    void statusLine() {
        RunStatus status;
        status.show();
        status.setRenderer("software renderer");
        QCOMPARE(child<QLabel>(status, "status.renderer")->text(), "software renderer");
        status.setRenderer("software renderer", 23.7);
        QCOMPARE(child<QLabel>(status, "status.renderer")->text(), "software renderer");
        status.setRenderer("software renderer", 14, "converged");
        QCOMPARE(child<QLabel>(status, "status.renderer")->text(), "software renderer");
        QCOMPARE(child<QLabel>(status, "status.renderer")->toolTip(), "picture 14 ms\nconverged");
        auto* otf = child<QLabel>(status, "status.otf");
        status.setOtf(1.62, 176, 225);
        QVERIFY(!otf->isVisible());
        QCOMPARE(child<QLabel>(status, "status.renderer")->toolTip(),
                 "picture 14 ms\nconverged\nOTF 1.6 ms, 176 of 225 tube cores");
        status.setDetailed(true);
        QCOMPARE(child<QLabel>(status, "status.renderer")->text(), "software renderer · 14 ms");
        QCOMPARE(otf->text(), "OTF 1.6 ms, 176 of 225 tube cores");
        QVERIFY(otf->isVisible());
        status.clearOtf();
        QVERIFY(!otf->isVisible());
        QCOMPARE(child<QLabel>(status, "status.renderer")->toolTip(), "picture 14 ms\nconverged");
        status.setNotes({"lossy compression", "spacing unknown"});
        QCOMPARE(child<QLabel>(status, "status.notes")->text(), "lossy compression · spacing unknown");
        auto* pointed = child<QLabel>(status, "status.pointed");
        status.setPointed(0.424, 0.176);
        QCOMPARE(pointed->text(), "intensity 0.42  opacity 0.18");
        status.setPointed(std::nullopt, std::nullopt);
        QVERIFY(!pointed->isVisible());
    }

    void progressIsShownOnlyAfterTheDelay() {
        RunStatus status;
        status.show();
        auto* progress = child<QProgressBar>(status, "status.progress");
        auto* cancel = child<QToolButton>(status, "status.cancel");
        status.beginProgress("Loading");
        QVERIFY(!progress->isVisible());
        status.endProgress();

        status.setProgressDelay(0);
        status.beginProgress("Loading");
        QTRY_VERIFY(progress->isVisible());
        QVERIFY(cancel->isVisible());
        QCOMPARE(child<QLabel>(status, "status.activity")->text(), "Loading");
        QCOMPARE(progress->maximum(), 0);  // busy: no share is known yet
        status.setProgress(0.25);
        QCOMPARE(4 * progress->value(), progress->maximum());
        status.setProgress(7);
        QCOMPARE(progress->value(), progress->maximum());
        QSignalSpy spy(&status, &RunStatus::cancelRequested);
        QTest::mouseClick(cancel, Qt::LeftButton);
        QCOMPARE(spy.count(), 1);
        status.endProgress();
        QVERIFY(!progress->isVisible());
        status.setProgress(0.5);  // a late report of what has ended
        QVERIFY(!progress->isVisible());
    }

    void theLineIsAsHighAtRestAsWhileSomethingRuns() {
        RunStatus status;
        status.show();
        status.setProgressDelay(0);
        const int atRest = status.minimumSizeHint().height();
        status.setOtf(12.0, 3, 4);
        QCOMPARE(status.minimumSizeHint().height(), atRest);
        status.beginProgress("Loading");
        QTRY_VERIFY(child<QProgressBar>(status, "status.progress")->isVisible());
        QVERIFY2(status.minimumSizeHint().height() == atRest, "the panes above it would make their pictures anew");
        status.endProgress();
        QCOMPARE(status.minimumSizeHint().height(), atRest);
    }

    void endedBeforeTheDelayIsNeverShown() {
        RunStatus status;
        status.show();
        status.setProgressDelay(0);
        status.beginProgress("Loading");
        status.endProgress();
        QCoreApplication::processEvents();
        QVERIFY(!child<QProgressBar>(status, "status.progress")->isVisible());
    }

private:
    static std::unique_ptr<QWidget> create(const QString& prefix) {
        if (prefix == "adaptive") return std::make_unique<MethodPanel>();
        if (prefix == "view") return std::make_unique<ViewPanel>();
        if (prefix == "motion") return std::make_unique<MotionPanel>();
        if (prefix == "status") return std::make_unique<RunStatus>();
        if (prefix == "rawLayout") return std::make_unique<RawLayoutDialog>("a.raw", 100);
        auto bar = std::make_unique<MessageBar>();
        bar->showMessage(MessageKind::info, "text", MessageEnd::withStudy("a topic"), {{"one", {}}, {"two", {}}});
        return bar;
    }
};

ECHOLUCENT_TEST_CLASS(TestPanelsMessages)
#include "test_panels_messages.moc"
