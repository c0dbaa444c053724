// What the program tells: study facts, run status, the message bar; and the names of every control.
#include <QAbstractButton>
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QImage>
#include <QLabel>
#include <QLocale>
#include <QObject>
#include <QProgressBar>
#include <QPushButton>
#include <QRect>
#include <QSet>
#include <QSignalSpy>
#include <QString>
#include <QStringList>
#include <QTableWidget>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>
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

    void messageWithWaysOut() {
        QWidget window;
        auto* bar = new MessageBar(&window);
        window.show();
        QVERIFY(!bar->isVisible());
        QStringList order;
        bar->showMessage(MessageKind::error, "cine.dcm: no geometry <b>", MessageEnd::withStudy("a topic"),
                         {{"As slices", [&] { order << (bar->isVisible() ? "too early" : "slices"); }},
                          {"Other file", [&] { order << "other"; }}});
        QVERIFY(bar->isVisible());
        QCOMPARE(child<QLabel>(window, "message.text")->text(), "cine.dcm: no geometry <b>");
        QCOMPARE(child<QLabel>(window, "message.text")->textFormat(), Qt::PlainText);
        QCOMPARE(bar->kind(), MessageKind::error);
        QCOMPARE(bar->accessibleDescription(), "cine.dcm: no geometry <b>");
        QTest::mouseClick(child<QPushButton>(window, "message.action.0"), Qt::LeftButton);
        QCOMPARE(order, QStringList{"slices"});
        QVERIFY(!bar->isVisible());
        QVERIFY(bar->text().isEmpty());
        QVERIFY(!window.findChild<QPushButton*>("message.action.0"));
    }

    void anActionMayShowTheNextMessage() {
        MessageBar bar;
        bar.showMessage(
            MessageKind::error, "first", MessageEnd::withStudy("a topic"),
            {{"go on", [&] {
                  bar.showMessage(MessageKind::info, "second", MessageEnd::withStudy("a topic"), {{"end", {}}});
              }}});
        QTest::mouseClick(child<QPushButton>(bar, "message.action.0"), Qt::LeftButton);
        QCOMPARE(bar.text(), "second");
        QVERIFY(bar.isVisible());
        QCOMPARE(child<QPushButton>(bar, "message.action.0")->text(), "end");
        QTest::mouseClick(child<QPushButton>(bar, "message.action.0"), Qt::LeftButton);
        QVERIFY(!bar.isVisible());
    }

    void newerMessageReplacesActions() {
        MessageBar bar;
        bool ran = false;
        bar.showMessage(MessageKind::error, "first", MessageEnd::withStudy("a topic"),
                        {{"a", [&] { ran = true; }}, {"b", {}}});
        bar.showMessage(MessageKind::info, "second", MessageEnd::withStudy("a topic"), {{"c", {}}});
        QCOMPARE(bar.findChildren<QPushButton*>().size(), 1);
        QTest::mouseClick(child<QPushButton>(bar, "message.action.0"), Qt::LeftButton);
        QVERIFY(!ran);
    }

    void aRemarkStandsBehindTheMessageOrAlone() {
        MessageBar bar;
        bar.setRemark("No surface found.");
        QVERIFY(bar.isVisible());
        QCOMPARE(bar.kind(), MessageKind::warning);
        QCOMPARE(bar.text(), "No surface found.");
        bar.showMessage(MessageKind::info, "Near cut at 4 mm.", MessageEnd::withStudy("a topic"), {{"Back", {}}});
        QCOMPARE(bar.text(), "Near cut at 4 mm. No surface found.");
        bar.setRemark({});
        QCOMPARE(bar.text(), "Near cut at 4 mm.");
        QVERIFY(bar.findChild<QPushButton*>("message.action.0") != nullptr);
        bar.setRemark("No surface found.");
        QVERIFY(bar.findChild<QPushButton*>("message.action.0") != nullptr);
        QTest::mouseClick(child<QToolButton>(bar, "message.close"), Qt::LeftButton);
        QVERIFY(!bar.isVisible());
        bar.setRemark("No surface found.");  // nobody wants to close it twice
        QVERIFY(!bar.isVisible());
        bar.showMessage(MessageKind::info, "Another message.", MessageEnd::withStudy("a topic"));
        QCOMPARE(bar.text(), "Another message.");
        bar.setRemark({});
        bar.setRemark("No surface found.");
        QCOMPARE(bar.text(), "Another message. No surface found.");
        bar.dismiss();
        bar.setRemark({});
        QVERIFY(!bar.isVisible());
    }

    void goodNewsStaysGoodNewsBesideARemark() {
        MessageBar bar;
        bar.setPalette(paletteOf(Theme::dark));
        bar.resize(420, 80);
        bar.showMessage(MessageKind::info, "Near cut at 4 mm.", MessageEnd::withStudy("a topic"));
        bar.setRemark("No surface found.");
        QCOMPARE(bar.kind(), MessageKind::info);
        const QImage both = bar.grab().toImage();
        const auto stripeBeside = [&](const char* line) {
            return both.pixelColor(1, child<QLabel>(bar, line)->geometry().center().y());
        };
        QCOMPARE(stripeBeside("message.text"), coloursOf(Theme::dark).accent);
        QCOMPARE(stripeBeside("message.remark"), coloursOf(Theme::dark).warning);
        bar.setRemark({});
        QCOMPARE(bar.kind(), MessageKind::info);
        QCOMPARE(bar.accessibleName(), "Information");
        bar.showMessage(MessageKind::warning, "The spacing is unknown.", MessageEnd::withStudy("a topic"));
        bar.setRemark("No surface found.");
        bar.setRemark({});
        QCOMPARE(bar.kind(), MessageKind::warning);
        bar.showMessage(MessageKind::error, "The file is gone.", MessageEnd::withStudy("a topic"));
        bar.setRemark("No surface found.");
        QCOMPARE(bar.kind(), MessageKind::error);
    }

    void theBarLiesOverTheLowerEdgeOfThePictureAndMovesNothing() {
        QWidget window;
        auto* layout = new QVBoxLayout(&window);
        layout->setContentsMargins(0, 0, 0, 0);
        auto* picture = new QWidget;
        auto* below = new QWidget;
        below->setFixedHeight(60);
        layout->addWidget(picture, 1);
        layout->addWidget(below);
        auto* bar = new MessageBar(&window);
        bar->lieOver(*picture);
        window.resize(900, 500);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        const QRect before = picture->geometry();
        bar->showMessage(MessageKind::info, "Near cut at 4 mm.", MessageEnd::withStudy("a topic"),
                         {{"Take it back", {}}});
        QCOMPARE(picture->geometry(), before);
        QVERIFY(picture->geometry().contains(bar->geometry()));
        QCOMPARE(bar->geometry().bottom(), picture->geometry().bottom() - 8);
        QVERIFY(bar->width() < 500 && qAbs(bar->geometry().center().x() - picture->geometry().center().x()) <= 1);
        const int line = bar->height();
        window.resize(420, 500);
        bar->showMessage(MessageKind::info, QString("A wall stands before the fluid. ").repeated(5),
                         MessageEnd::withStudy("a topic"));
        QTRY_VERIFY(picture->geometry().contains(bar->geometry()));
        QTRY_VERIFY(bar->height() > line + 10);  // the words are wrapped, and none is cut
        QVERIFY(child<QLabel>(*bar, "message.text")->heightForWidth(child<QLabel>(*bar, "message.text")->width()) <=
                child<QLabel>(*bar, "message.text")->height());
        QCOMPARE(bar->geometry().bottom(), picture->geometry().bottom() - 8);
    }

    void goodNewsLeavesBySoonAndTroubleIsSeenAgain() {
        MessageBar bar;
        // Without a display every window that is shown is said to be under the pointer, and then it stays.
        const auto showAside = [&bar](const auto&... message) {
            bar.showMessage(message...);
            bar.setAttribute(Qt::WA_UnderMouse, false);
        };
        bar.setConfirmationMilliseconds(0);
        showAside(MessageKind::warning, QString("The spacing is unknown."), MessageEnd::withStudy("study"));
        showAside(MessageKind::info, QString("The picture was saved."), MessageEnd::soon("file"));
        QCOMPARE(bar.text(), "The picture was saved.");
        QCOMPARE(bar.kind(), MessageKind::info);
        QTRY_COMPARE(bar.text(), "The spacing is unknown.");
        QCOMPARE(bar.kind(), MessageKind::warning);
        QVERIFY(bar.isVisible());
        QCoreApplication::processEvents();
        QCOMPARE(bar.text(), "The spacing is unknown.");
        bar.endStudy();
        QVERIFY(!bar.isVisible());
        showAside(MessageKind::info, QString("The preset was removed."), MessageEnd::soon(),
                  QList<MessageAction>{{"Take it back", {}}});
        QVERIFY(bar.isVisible());
        QTRY_VERIFY(!bar.isVisible());
        QVERIFY(!bar.findChild<QPushButton*>("message.action.0"));
    }

    void closingGoodNewsLeavesTheTroubleThatNobodyHasRead() {
        MessageBar bar;
        bar.showMessage(MessageKind::error, "a.png could not be written.", MessageEnd::whenTakenBack("file"));
        bar.showMessage(MessageKind::info, "The picture was copied.", MessageEnd::soon("copy"));
        child<QToolButton>(bar, "message.close")->click();
        QCOMPARE(bar.text(), "a.png could not be written.");
        child<QToolButton>(bar, "message.close")->click();
        QVERIFY(!bar.isVisible());
    }

    void eachKindOfTroubleHasOneMessageAndItsOwnEnd() {
        MessageBar bar;
        bar.showMessage(MessageKind::error, "a.mha is no volume.", MessageEnd::whenTakenBack("opening"));
        bar.showMessage(MessageKind::error, "No memory for the picture.", MessageEnd::withStudy("picture"));
        bar.showMessage(MessageKind::error, "b.mha is no volume.", MessageEnd::whenTakenBack("opening"));
        QCOMPARE(bar.text(), "b.mha is no volume.");
        bar.takeBack("picture");  // it lies below the one that is seen
        QCOMPARE(bar.text(), "b.mha is no volume.");
        bar.endStudy();
        QCOMPARE(bar.text(), "b.mha is no volume.");
        bar.takeBack("opening");
        QVERIFY(!bar.isVisible());
        // The button puts away all that is true.
        QSignalSpy putAway(&bar, &MessageBar::putAway);
        bar.showMessage(MessageKind::error, "one", MessageEnd::withStudy("one"));
        bar.showMessage(MessageKind::error, "two", MessageEnd::withStudy("two"));
        QTest::mouseClick(child<QToolButton>(bar, "message.close"), Qt::LeftButton);
        QVERIFY(!bar.isVisible());
        QCOMPARE(putAway.count(), 1);
        QCOMPARE(putAway.first().first().toString(), "two");
    }

    void aMessageIsTakenBackWhereItIsStillShown() {
        MessageBar bar;
        bar.showMessage(MessageKind::error, "first", MessageEnd::withStudy("a topic"), {{"Back", {}}});
        bar.setRemark("No surface found.");
        bar.takeBack("another topic");
        QCOMPARE(bar.text(), "first No surface found.");
        bar.takeBack("a topic");
        QCOMPARE(bar.text(), "No surface found.");
        QCOMPARE(bar.kind(), MessageKind::warning);
        QVERIFY(!bar.findChild<QPushButton*>("message.action.0"));
        bar.setRemark({});
        QVERIFY(!bar.isVisible());
        bar.showMessage(MessageKind::info, "second", MessageEnd::withStudy("a topic"));
        bar.takeBack("a topic");
        QVERIFY(!bar.isVisible());
        QVERIFY(bar.text().isEmpty());
    }

    void messageIsClosedByButtonKeyAndProgram() {
        MessageBar bar;
        bar.showMessage(MessageKind::info, "one", MessageEnd::withStudy("a topic"));
        QTest::mouseClick(child<QToolButton>(bar, "message.close"), Qt::LeftButton);
        QVERIFY(!bar.isVisible());
        bar.showMessage(MessageKind::info, "two", MessageEnd::withStudy("a topic"));
        QTest::keyClick(child<QToolButton>(bar, "message.close"), Qt::Key_Escape);
        QVERIFY(!bar.isVisible());
        bar.showMessage(MessageKind::info, "three", MessageEnd::withStudy("a topic"));
        bar.dismiss();
        QVERIFY(!bar.isVisible());
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
