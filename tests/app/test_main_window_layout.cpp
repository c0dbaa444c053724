// The window at 1280 x 720: one column of tabs, nothing clipped, messages over the picture, the full screen.
#include <QAbstractScrollArea>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QStatusBar>
#include <QTabBar>
#include <QTableWidget>
#include <QWindow>
#include <cmath>

#include "app/window/theme.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/controls/message_bar.h"

using namespace echolucent;

namespace {

/// Colour of a place of the screen, other windows above it included.
QColor onScreen(const QWidget& widget, const QPoint& place) {
    const QPoint global = widget.mapToGlobal(place);
    return QColor(widget.screen()->grabWindow(0, global.x(), global.y(), 1, 1).toImage().pixelColor(0, 0));
}

}  // namespace

class TestMainWindowLayout : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        lookAtNoPicture();
        wearTheme(Theme::dark);
        const auto still = smallPhantom(PhantomScene::shapes, 5);
        m_file = file("still.mha", {still});
        VolumeGeometry unknown = still->geometry();
        unknown.spacingKnown = false;
        m_unknown = file("unknown.mha", {std::make_shared<const Volume>(unknown, still->voxels())});
    }
    void init() {
        show();
        window().resize(1280, 720);
        open(m_file);
    }
    void cleanup() { close(); }

    void theColumnIs340WideAndThePictureKeepsItsShare() {
        QCOMPARE(window().size(), QSize(1280, 720));
        QCOMPARE(child<QDockWidget>("dock.view")->width(), 340);
        QVERIFY(window().volumeView().width() >= 0.6 * 1280);
        QVERIFY2(window().minimumSizeHint().width() < 984,
                 qPrintable(QString::number(window().minimumSizeHint().width())));
        window().resize(900, 600);
        QTRY_COMPARE(window().width(), 900);
    }

    void theMethodsChoicesMoveNothing() {
        child<QDockWidget>("dock.method")->raise();
        const int picture = window().volumeView().width();
        QTest::mouseClick(child<QAbstractButton>("adaptive.advanced"), Qt::LeftButton);
        auto* form = child<QComboBox>("adaptive.form");
        for (int choice = 0; choice < form->count(); ++choice) {
            form->setFocus();
            QTest::keyClick(form, choice == 0 ? Qt::Key_Home : Qt::Key_Down);
            QCOMPARE(form->currentIndex(), choice);
            waitUntilIdle();
            QCOMPARE(child<QDockWidget>("dock.method")->width(), 340);
            QCOMPARE(window().volumeView().width(), picture);
        }
    }

    void onePanelIsInFrontOfTheOthersOfItsColumn() {
        const auto titles = [this] {
            QStringList texts;
            const QTabBar* tabs = tabBar();
            for (int i = 0; tabs != nullptr && i < tabs->count(); ++i) texts << tabs->tabText(i);
            return texts;
        };
        const QStringList atStart{"Picture", "Curve", "Planes", "Method", "Designers", "Study"};
        QCOMPARE(titles(), atStart);
        // No title is cut of those that are there at the start.
        const QTabBar* tabs = tabBar();
        for (int i = 0; i < tabs->count(); ++i)
            QVERIFY2(tabs->tabRect(i).width() >= tabs->fontMetrics().horizontalAdvance(atStart[i]) + 8 &&
                         tabs->rect().contains(tabs->tabRect(i)),
                     qPrintable(atStart[i]));
        const QList<QDockWidget*> docks = window().findChildren<QDockWidget*>();
        for (QDockWidget* dock : docks) dock->show();
        QCOMPARE(titles(), QStringList({"Picture", "Curve", "Planes", "Method", "Designers", "Compare", "Study",
                                        "Motion", "Explain"}));
    }

    void everyPanelScrollsInsideItselfAndShowsAllOfItsWidth_data() { whetherSpacingIsKnown(); }
    void everyPanelScrollsInsideItselfAndShowsAllOfItsWidth() {
        openAsSaid();
        for (QDockWidget* dock : window().findChildren<QDockWidget*>()) {
            const int picture = window().volumeView().width();
            dock->show();
            dock->raise();
            QCoreApplication::processEvents();
            QVERIFY2(window().volumeView().width() == picture, qPrintable(dock->objectName()));
            auto* area = qobject_cast<QScrollArea*>(dock->widget());
            QVERIFY(area != nullptr);
            QVERIFY(!area->horizontalScrollBar()->isVisible());
            QVERIFY2(area->widget()->width() <= area->viewport()->width(), qPrintable(dock->objectName()));
            for (const QWidget* control : area->widget()->findChildren<QWidget*>()) {
                if (!control->isVisible() ||
                    qobject_cast<QAbstractScrollArea*>(control->parentWidget()->parentWidget()))
                    continue;
                const int left = control->mapTo(area->widget(), QPoint(0, 0)).x();
                QVERIFY2(left >= 0 && left + control->width() <= area->widget()->width(),
                         qPrintable(dock->objectName() + ": " + control->objectName()));
            }
        }
    }

    void noWordOfAPanelIsCut_data() { whetherSpacingIsKnown(); }
    void noWordOfAPanelIsCut() {
        openAsSaid();
        for (QDockWidget* dock : window().findChildren<QDockWidget*>()) {
            dock->show();
            dock->raise();
            QCoreApplication::processEvents();
            for (const QLabel* label : dock->findChildren<QLabel*>()) {
                if (!label->isVisible() || label->text().isEmpty()) continue;
                const int needed =
                    label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
                QVERIFY2(label->height() >= needed, qPrintable(label->text()));
                if (!label->wordWrap() && label->sizePolicy().horizontalPolicy() != QSizePolicy::Ignored)
                    QVERIFY2(label->width() >= label->sizeHint().width(), qPrintable(label->text()));
            }
            for (const QAbstractButton* button : dock->widget()->findChildren<QAbstractButton*>())
                if (button->isVisible() && !button->text().isEmpty())
                    QVERIFY2(button->width() >= button->minimumSizeHint().width(), qPrintable(button->text()));
        }
    }

    void theSourceOfAFactIsInSight() {
        auto* dock = child<QDockWidget>("dock.study");
        dock->raise();
        auto* facts = child<QTableWidget>("study.facts");
        QTRY_VERIFY(facts->isVisible());
        QTRY_VERIFY(facts->columnWidth(0) + facts->columnWidth(1) <= facts->viewport()->width());
        bool found = false;
        for (int row = 0; row < facts->rowCount(); ++row) {
            if (facts->item(row, 1)->text() != "ElementSpacing") continue;
            found = true;
            const QRect place = facts->visualRect(facts->model()->index(row, 1));
            QVERIFY(facts->viewport()->rect().contains(place));
            QVERIFY(place.width() >= facts->fontMetrics().horizontalAdvance("ElementSpacing"));
        }
        QVERIFY(found);
    }

    void messagesLieOverThePictureAndPushNothing() {
        const QRect picture = window().volumeView().geometry();
        auto* bar = child<MessageBar>("message");
        bar->showMessage(MessageKind::warning, "A sentence.", MessageEnd::withStudy("a topic"));
        QCOMPARE(window().volumeView().geometry(), picture);
        QVERIFY(picture.contains(bar->geometry()));
        // It is seen over the OpenGL window too.
        QTRY_COMPARE(onScreen(*bar, {1, bar->height() / 2}), QColor(0xe8, 0xb0, 0x4b));
        bar->showMessage(MessageKind::info, "Good news.", MessageEnd::withStudy("a topic"));
        QTRY_COMPARE(onScreen(*bar, {1, bar->height() / 2}), QColor(0x4f, 0xb3, 0xbf));
        // A tab that comes to the front raises the picture's window as well, and the bar stays above it.
        child<QDockWidget>("dock.study")->raise();
        QTRY_VERIFY(child<QWidget>("study.facts")->isVisible());
        QTRY_COMPARE(onScreen(*bar, {1, bar->height() / 2}), QColor(0x4f, 0xb3, 0xbf));
        QTest::mouseClick(child<QAbstractButton>("message.close"), Qt::LeftButton);
        QVERIFY(!bar->isVisible());
        QCOMPARE(window().volumeView().geometry(), picture);
    }

    void theFullScreenShowsThePictureAloneAndBringsAllBack() {
        child<QDockWidget>("dock.study")->raise();
        window().resizeDocks({child<QDockWidget>("dock.study")}, {380}, Qt::Horizontal);
        QTRY_COMPARE(child<QDockWidget>("dock.study")->width(), 380);
        child<QDockWidget>("dock.method")->close();
        const QSize before = window().size();
        const auto seen = [this] {
            QStringList names;
            for (const char* name : {"dock.view", "dock.otfEditor", "dock.method", "dock.study", "dock.motionMap",
                                     "dock.explain", "motion", "study.facts", "adaptive.strength"})
                if (child<QWidget>(name)->isVisible()) names << name;
            if (window().menuBar()->isVisible()) names << "menu";
            if (window().statusBar()->isVisible()) names << "status";
            return names;
        };
        const QStringList seenBefore = seen();
        QVERIFY(seenBefore.contains("study.facts") && !seenBefore.contains("dock.method"));
        for (const Qt::Key leave : {Qt::Key_F, Qt::Key_Escape}) {
            QTest::keyClick(&window(), Qt::Key_F);
            QVERIFY(window().isFullScreen());
            QCOMPARE(seen(), QStringList());
            QTRY_COMPARE(window().volumeView().size(), window().size());
            QTest::keyClick(&window(), leave);
            QVERIFY(!window().isFullScreen());
            window().resize(before);  // a virtual display has no window manager that would do it
            QTRY_COMPARE(seen(), seenBefore);
            QTRY_COMPARE(child<QDockWidget>("dock.study")->width(), 380);
        }
        waitUntilIdle();
    }

    void keysWorkOnTheFullScreenAndClosingThereLosesNoPanel() {
        QTest::keyClick(&window(), Qt::Key_F);
        QTest::keyClick(&window(), Qt::Key_3);
        QCOMPARE(window().document().document().panes.at(firstPane).curve, CurveKind::linear);
        QTest::keyClick(&window(), Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(window().document().document().panes.at(firstPane).curve, CurveKind::adaptive);
        window().close();
        MainWindow next(settingsFile());
        next.show();
        QVERIFY(!next.isFullScreen());
        QVERIFY(next.findChild<QDockWidget*>("dock.view")->isVisible());
        QVERIFY(next.menuBar()->isVisible());
    }

    void escapeEndsADragBeforeTheFullScreen() {
        QTest::keyClick(&window(), Qt::Key_F);
        const Pose before = window().document().document().scene.pose;
        auto* inner = pictureWindow();
        const QPoint from(inner->width() / 2, inner->height() / 2);
        QTest::mousePress(inner, Qt::LeftButton, {}, from);
        QTest::mouseMove(inner, from + QPoint(60, 0));
        QTRY_VERIFY(window().document().document().scene.pose != before);
        QTest::keyClick(&window().volumeView(), Qt::Key_Escape);
        QCOMPARE(window().document().document().scene.pose, before);
        QVERIFY(window().isFullScreen());
        QTest::mouseRelease(inner, Qt::LeftButton, {}, from);
        int lassos = 1;
        window().escapeOrder().add(EscapeStep::lasso, [&lassos] { return lassos-- > 0; });
        QTest::keyClick(&window().volumeView(), Qt::Key_Escape);
        QCOMPARE(lassos, 0);
        QVERIFY(window().isFullScreen());
        QTest::keyClick(&window().volumeView(), Qt::Key_Escape);
        QVERIFY(!window().isFullScreen());
        waitUntilIdle();
    }

    void f1OpensOnePanelThatFollowsThePicture() {
        const QRect picture = window().volumeView().geometry();
        QTest::keyClick(&window(), Qt::Key_F1);
        QTest::keyClick(&window(), Qt::Key_F1);
        auto* text = child<QLabel>("explain.picture");
        QTRY_VERIFY(text->isVisible());
        QCOMPARE(QApplication::topLevelWidgets().contains(&window()), true);
        QCOMPARE(QApplication::activeModalWidget(), nullptr);
        QCOMPARE(window().volumeView().geometry(), picture);
        QCOMPARE(text->text(), window().explanation());
        QVERIFY(child<QLabel>("explain.keys")->text().contains("computes the OTF for this view"));
        QTest::keyClick(&window(), Qt::Key_4);
        QTRY_VERIFY(text->text().contains("A parabolic OTF"));
        waitUntilIdle();
    }

private:
    [[nodiscard]] const QTabBar* tabBar() {
        for (const QTabBar* tabs : window().findChildren<QTabBar*>())
            if (tabs->isVisible() && tabs->parentWidget() == &window()) return tabs;
        return nullptr;
    }

    static void whetherSpacingIsKnown() {
        QTest::addColumn<bool>("known");
        QTest::newRow("spacing known") << true;
        QTest::newRow("spacing unknown") << false;  // lengths say that they are a guess, which takes more room
    }
    void openAsSaid() {
        QFETCH(bool, known);
        if (!known) open(m_unknown);
        QCOMPARE(window().openStudy().volume()->geometry().spacingKnown, known);
    }

    QString m_file, m_unknown;
};

ECHOLUCENT_TEST_CLASS(TestMainWindowLayout)

#include "test_main_window_layout.moc"
