// The window at 1280 x 720: one column of tabs, nothing clipped, messages over the picture.
#include <QAbstractScrollArea>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QTableWidget>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <vector>

#include "app/window/theme.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/controls/message_bar.h"

using namespace echolucent;

namespace {

/// Screens of small and usual machines.
constexpr QSize screenSizes[] = {{1024, 768}, {1280, 720}, {1366, 768}};

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
        seeSides();
        teach();
        wearTheme(Theme::dark);
        const auto still = smallPhantom(PhantomScene::shapes, 5);
        m_file = file("still.mha", {still});
        m_moving = file("moving.mha", {still, still, still});
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

    void everyScreenShowsAllNamesAndBarsInBothFaces() {
        for (const QSize& size : screenSizes) {
            window().resize(size);
            for (const char* face : {"face.teach", "face.review"}) {
                click(face);
                QCoreApplication::processEvents();
                namesAreWhole();
                QStringList names;
                for (const QAbstractButton* tab : namesInFront()) names << tab->text();
                const QStringList all{"Picture", "Curve", "Measure", "Method",  "Tube cores", "Designers",
                                      "Compare", "Study", "Motion",  "Explain", "Theory",     "Lessons"};
                QCOMPARE(names, face == QByteArray("face.teach") ? all : QStringList({"Picture", "Measure", "Study"}));
                toolBarIsWhole();
                QVERIFY2(rowsOfMotionBar() <= 2, qPrintable(QString("%1 rows").arg(rowsOfMotionBar())));
            }
        }
    }

    void theMotionBarFoldsRatherThanGrow() {
        open(m_moving);
        window().resize(1024, 768);
        auto* scenario = child<QComboBox>("motion.scenario");
        auto* modes = child("motion.mode.mean");
        for (int i = 0; i < scenario->count(); ++i) {
            scenario->setCurrentIndex(i);
            QCoreApplication::processEvents();
            QVERIFY2(rowsOfMotionBar() <= 2, qPrintable(scenario->currentText()));
            QVERIFY(modes->isVisible() || child("motion.otf")->isVisible());
        }
        QVERIFY(!modes->isVisible());
        click("motion.otf");
        QTRY_VERIFY(modes->isVisible());
        QVERIFY(window().geometry().contains(child("motion.otf.popup")->geometry()));
        QTest::mouseClick(modes, Qt::LeftButton);
        QCOMPARE(window().document().document().motion.otf, MotionOtf::mean);
        QTest::keyClick(child("motion.otf.popup"), Qt::Key_Escape);
        QTRY_VERIFY(!modes->isVisible());
        window().resize(1600, 768);
        QTRY_VERIFY(modes->isVisible());
        QVERIFY(!child("motion.otf")->isVisible());
        waitUntilIdle();
    }

    void aClickOnANameBringsItsPanelToTheFront() {
        for (const char* name : {"dock.method", "dock.explain", "dock.view"}) {
            auto* dock = child<QDockWidget>(name);
            for (QAbstractButton* tab : namesInFront())
                if (tab->text() == dock->windowTitle()) QTest::mouseClick(tab, Qt::LeftButton);
            QTRY_VERIFY(!dock->visibleRegion().isEmpty());
            for (const QAbstractButton* tab : namesInFront())
                QCOMPARE(tab->isChecked(), tab->text() == dock->windowTitle());
        }
        click("dock.view.close");
        QVERIFY(child<QDockWidget>("dock.view")->isHidden());
        QTRY_COMPARE(namesInFront().size(), 11);
    }

    void everyPanelScrollsInsideItselfAndShowsAllOfItsWidth_data() { whetherSpacingIsKnown(); }
    void everyPanelScrollsInsideItselfAndShowsAllOfItsWidth() {
        openAsSaid();
        window().resize(1024, 768);  // the column is as wide as on every screen
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
            saysWhy(*dock);
        }
        saysWhy(*child("motion"));
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
            facts->scrollToItem(facts->item(row, 1));
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

    void f1OpensOnePanelThatFollowsThePicture() {
        const QRect picture = window().volumeView().geometry();
        QTest::keyClick(&window(), Qt::Key_F1);
        QTest::keyClick(&window(), Qt::Key_F1);
        auto* text = child<QLabel>("explain.picture");
        QTRY_VERIFY(text->isVisible());
        QCOMPARE(QApplication::topLevelWidgets().contains(&window()), true);
        QCOMPARE(QApplication::activeModalWidget(), nullptr);
        QCOMPARE(window().volumeView().geometry(), picture);
        QTRY_COMPARE(text->text(), window().explanation());  // the picture may still become finer
        QVERIFY(child<QLabel>("explain.keys")->text().contains("computes the OTF for this view"));
        QTest::keyClick(&window(), Qt::Key_4);
        QTRY_VERIFY(text->text().contains("A parabolic OTF"));
        waitUntilIdle();
    }

private:
    /// Whether a control, its action or what it stands in was greyed with a reason (enableOrSayWhy()).
    static bool hasReason(const QWidget* control) {
        constexpr const char* kept = "toolTipIfEnabled";
        const auto* button = qobject_cast<const QToolButton*>(control);
        if (button != nullptr && button->defaultAction() != nullptr &&
            button->defaultAction()->property(kept).isValid())
            return true;
        for (const QWidget* each = control; each != nullptr; each = each->parentWidget())
            if (each->property(kept).isValid()) return true;
        return false;
    }
    /// Every greyed control has a reason, which ends its tool tip.
    void saysWhy(const QWidget& part) {
        for (const QWidget* control : part.findChildren<QWidget*>()) {
            const bool isControl =
                qobject_cast<const QAbstractButton*>(control) || qobject_cast<const QAbstractSlider*>(control) ||
                qobject_cast<const QAbstractSpinBox*>(control) || qobject_cast<const QComboBox*>(control);
            if (!isControl || !control->isVisible() || control->isEnabled()) continue;
            QString tip;
            for (const QWidget* each = control; tip.isEmpty() && each != &part; each = each->parentWidget())
                tip = each->toolTip();
            QVERIFY2(tip.endsWith('.'), qPrintable(control->objectName() + ": " + tip));
            QVERIFY2(hasReason(control), qPrintable(control->objectName()));
        }
    }

    /// As many rows as the names need.
    void namesAreWhole() {
        const QList<QAbstractButton*> names = namesInFront();
        for (const QAbstractButton* name : names) {
            QVERIFY2(name->width() >= name->sizeHint().width(), qPrintable(name->text()));
            QVERIFY2(window().rect().contains(QRect(name->mapTo(&window(), QPoint(0, 0)), name->size())),
                     qPrintable(name->text()));
            QVERIFY(name->parentWidget()->rect().contains(name->geometry()));
            for (const QAbstractButton* other : names)
                QVERIFY(other == name || !other->geometry().intersects(name->geometry()));
        }
    }
    void toolBarIsWhole() {
        const auto* bar = child<QToolBar>("toolBar");
        for (QAction* action : bar->actions()) {
            const auto* button = qobject_cast<QToolButton*>(bar->widgetForAction(action));
            if (button == nullptr) continue;
            QVERIFY2(button->isVisible() && bar->rect().contains(button->geometry()), qPrintable(button->objectName()));
            QVERIFY2(button->width() >= button->sizeHint().width(), qPrintable(button->objectName()));
        }
    }
    /// Lines of controls that lie one below the other.
    int rowsOfMotionBar() {
        QWidget* bar = child("motion");
        std::vector<QRect> controls;
        for (const QWidget* control : bar->findChildren<QWidget*>())
            if (control->isVisible() && control->objectName().startsWith("motion."))
                controls.emplace_back(control->mapTo(bar, QPoint(0, 0)), control->size());
        std::ranges::sort(controls, {}, &QRect::top);
        int rows = 0, bottom = -1;
        for (const QRect& control : controls) {
            if (control.center().y() > bottom) ++rows;
            bottom = std::max(bottom, control.bottom());
        }
        return rows;
    }
    /// The names in the head of the dock that is in front.
    [[nodiscard]] QList<QAbstractButton*> namesInFront() {
        QList<QAbstractButton*> names;
        for (const QDockWidget* dock : window().findChildren<QDockWidget*>())
            if (dock->isVisible() && !dock->visibleRegion().isEmpty())
                for (auto* button : dock->titleBarWidget()->findChildren<QAbstractButton*>())
                    if (button->isVisible() && button->objectName().contains(".tab.")) names << button;
        return names;
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

    QString m_file, m_moving, m_unknown;
};

ECHOLUCENT_TEST_CLASS(TestMainWindowLayout)

#include "test_main_window_layout.moc"
