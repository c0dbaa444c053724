// The bar of messages: what it shows, for how long, and where it lies.
#include <QCoreApplication>
#include <QImage>
#include <QLabel>
#include <QObject>
#include <QPushButton>
#include <QRect>
#include <QSignalSpy>
#include <QStringList>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>

#include "tests/qt_program/test_classes.h"
#include "tests/widgets/panel_controls.h"
#include "widgets/controls/message_bar.h"
#include "widgets/theme_colours.h"

using namespace echolucent;

class TestMessageBar : public QObject {
    Q_OBJECT

private slots:
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
};

ECHOLUCENT_TEST_CLASS(TestMessageBar)
#include "test_message_bar.moc"
