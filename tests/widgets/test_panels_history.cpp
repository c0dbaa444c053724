// The panel of steps and snapshots: a name that is typed goes to the snapshot that it was typed for, or to none.
#include <QApplication>
#include <QCoreApplication>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QListWidget>
#include <QObject>
#include <QSignalSpy>
#include <QString>
#include <QStringList>
#include <QTest>
#include <QVariant>
#include <QVariantList>

#include "tests/qt_program/test_classes.h"
#include "widgets/document/document_model.h"
#include "widgets/panels/history_panel.h"

using namespace echolucent;

class TestPanelsHistory : public QObject {
    Q_OBJECT

private slots:
    void init() {
        // Of about eight steps.
        m_model = std::make_unique<DocumentModel>(nullptr, 8 * sizeof(Document));
        m_panel = std::make_unique<HistoryPanel>(m_model->steps());
        m_panel->setSnapshots({"first", "second", "third"});
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
        // A virtual display has no window manager that would make it the active window, in which fields have a focus.
        QApplication::setActiveWindow(m_panel.get());
    }
    void cleanup() { m_panel.reset(); }

    void aNameThatIsTypedIsAskedFor() {
        QSignalSpy renamed(m_panel.get(), &HistoryPanel::renameRequested);
        type(1, "face");
        QTRY_COMPARE(renamed.count(), 1);
        QCOMPARE(renamed.first(), (QVariantList{1, "face"}));
    }

    /// A rename is told later than it is typed; meanwhile the list may have become another.
    void aNameThatWasTypedForAnotherListIsAskedForNever_data() {
        QTest::addColumn<QStringList>("then");
        QTest::newRow("the row is gone") << QStringList{"first"};
        QTest::newRow("the list is empty") << QStringList{};
        QTest::newRow("another snapshot stands there") << QStringList{"first", "third"};
    }
    void aNameThatWasTypedForAnotherListIsAskedForNever() {
        QFETCH(QStringList, then);
        QSignalSpy renamed(m_panel.get(), &HistoryPanel::renameRequested);
        type(1, "face");
        QCOMPARE(renamed.count(), 0);
        m_panel->setSnapshots(then);
        QCoreApplication::processEvents();  // what was to be told later is told now
        QCOMPARE(renamed.count(), 0);
    }

    void aNameGoesToTheSnapshotThatStandsWhereItStoodBefore() {
        QSignalSpy renamed(m_panel.get(), &HistoryPanel::renameRequested);
        type(1, "face");
        m_panel->setSnapshots({"first", "second", "third", "fourth"});
        QTRY_COMPARE(renamed.count(), 1);
        QCOMPARE(renamed.first(), (QVariantList{1, "face"}));
    }

    void stepsAreListedAndItIsSaidThatOlderOnesWereDropped() {
        DocumentModel& model = *m_model;
        auto* list = m_panel->findChild<QListView*>("history.list");
        auto* dropped = m_panel->findChild<QLabel*>("history.dropped");
        QVERIFY(list && dropped);
        const auto text = [&](int row) { return list->model()->index(row, 0).data().toString(); };
        const auto turnTo = [&](int azimuth) {
            Document next = model.document();
            next.scene.pose.direction.azimuth = azimuth;
            model.edit(next, QString("turn to %1").arg(azimuth));
        };
        turnTo(1);
        turnTo(2);
        QCOMPARE(list->model()->rowCount(), 3);
        QCOMPARE(text(0), "as opened");
        QCOMPARE(text(2), "turn to 2");
        QCOMPARE(list->currentIndex().row(), 2);
        QVERIFY(dropped->isHidden());
        list->setCurrentIndex(list->model()->index(1, 0));
        QCOMPARE(model.document().scene.pose.direction.azimuth, 1.0);
        for (int azimuth = 3; azimuth < 20; ++azimuth) turnTo(azimuth);
        QVERIFY(!dropped->isHidden());
        QCOMPARE(dropped->text(), "Older steps were dropped: undo keeps 0 MB");
        QCOMPARE(list->model()->rowCount(), model.steps().count() + 1);
        QCOMPARE(text(0), "before these steps");
        QCOMPARE(text(model.steps().count()), "turn to 19");
        list->setCurrentIndex(list->model()->index(0, 0));
        QCOMPARE(model.document().scene.pose.direction.azimuth, 19.0 - model.steps().count());
        model.begin(Document{});
        QVERIFY(dropped->isHidden());
        QCOMPARE(list->model()->rowCount(), 1);
    }

private:
    /// The key Tab takes a name at once.
    void type(int snapshot, const QString& name) {
        m_panel->editName(snapshot);
        auto* field = m_panel->findChild<QListWidget*>("history.snapshots")->findChild<QLineEdit*>();
        QVERIFY(field);
        QTest::keyClicks(field, name);
        QTest::keyClick(field, Qt::Key_Tab);
    }

    std::unique_ptr<DocumentModel> m_model;
    std::unique_ptr<HistoryPanel> m_panel;
};

ECHOLUCENT_TEST_CLASS(TestPanelsHistory)
#include "test_panels_history.moc"
