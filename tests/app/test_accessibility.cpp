// What a screen reader finds in the real window, and what it can do there.
#include <QAbstractItemView>
#include <QAccessible>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QLineEdit>
#include <limits>

#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/accessibility/spoken_widget.h"
#include "widgets/document/document_steps.h"
#include "widgets/names/named_controls.h"
#include "widgets/otf_editor/curve_canvas.h"
#include "widgets/panels/emphasis_canvas.h"

using namespace echolucent;

class TestAccessibility : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        lookAtNoPicture();
        teach();
        show();
        window().resize(1280, 720);
        open(file("shapes.mha", {smallPhantom(PhantomScene::shapes, 5)}));
    }
    void init() { QTest::keyClick(&window(), Qt::Key_F3); }
    void cleanupTestCase() { close(); }

    void everyControlOfTheWindowHasAWord() {
        QStringList silent;
        int found = 0;
        for (const NamedControl& control : namedControls(window())) {
            auto* widget = qobject_cast<QWidget*>(control.object.data());
            if (widget == nullptr || !isControl(*widget)) continue;
            ++found;
            const QAccessibleInterface* access = accessOf(widget);
            if (access == nullptr || access->text(QAccessible::Name).isEmpty()) silent << control.name;
        }
        QVERIFY2(silent.isEmpty(), qPrintable(silent.join(", ")));
        QVERIFY(found > 600);
    }

    void aComboBoxIsCalledByItsLabelAndHasAList() {
        auto* box = child<QComboBox>("view.colourMap");
        QAccessibleInterface* access = accessOf(box);
        QCOMPARE(access->role(), QAccessible::ComboBox);
        QCOMPARE(access->text(QAccessible::Name), "Colour map: " + box->currentText());
        QCOMPARE(access->text(QAccessible::Value), box->currentText());
        QCOMPARE(access->childCount(), 1);
        QAccessibleInterface* list = access->child(0);
        QCOMPARE(list->text(QAccessible::Name), "Colour map");
        QCOMPARE(list->childCount(), box->count());
        QCOMPARE(list->child(1)->text(QAccessible::Name), box->itemText(1));
        QVERIFY(access->state().collapsed);
        child<QDockWidget>("dock.view")->raise();
        click("view.more");
        access->actionInterface()->doAction(QAccessibleActionInterface::showMenuAction());
        QTRY_VERIFY(box->view()->isVisible());
        QVERIFY(access->state().expanded);
        access->actionInterface()->doAction(QAccessibleActionInterface::showMenuAction());
        QTRY_VERIFY(!box->view()->isVisible());
        click("view.more");
    }

    void toToggleAButtonIsToClickIt() {
        QAccessibleInterface* review = accessOf(child("face.review"));
        QCOMPARE(review->role(), QAccessible::RadioButton);
        QVERIFY(!review->state().checked);
        review->actionInterface()->doAction(QAccessibleActionInterface::toggleAction());
        QTRY_VERIFY(review->state().checked);
        QVERIFY(child("dock.method")->isHidden());  // the window has followed
        accessOf(child("face.teach"))->actionInterface()->doAction(QAccessibleActionInterface::pressAction());
        QTRY_VERIFY(!review->state().checked && !child("dock.method")->isHidden());
    }

    void aTextIsSaidBehindItsName() {
        auto* label = child<QLabel>("adaptive.summary");
        const QString said = accessOf(label)->text(QAccessible::Name);
        QVERIFY(!label->text().isEmpty());
        QVERIFY2(said.startsWith("What was found: ") && said.size() > 20 && !said.contains('<'), qPrintable(said));
    }

    void anEditableComboBoxHasItsFieldToo() {
        auto* box = child<QComboBox>("measurements.name");
        if (!box->isEditable()) box = child<QComboBox>("lessons.editor.step.target");
        QAccessibleInterface* access = accessOf(box);
        QCOMPARE(access->childCount(), 2);
        QCOMPARE(access->child(1)->object(), box->lineEdit());
        QCOMPARE(access->child(1)->text(QAccessible::Name), box->accessibleName());
        QCOMPARE(access->indexOfChild(access->child(1)), 1);
        QVERIFY(access->child(2) == nullptr);
    }

    void theNodesOfTheCurveAreChildrenWithValuesAndActions() {
        window().otfEditor().model().replaceManual({{{0.2, 0.0}, {0.5, 0.4}, {0.9, 0.8}}}, "three nodes");
        auto* canvas = child<CurveCanvas>("otfEditor.canvas");
        QAccessibleInterface* access = accessOf(canvas);
        QCOMPARE(access->childCount(), 3);
        QAccessibleInterface* node = access->child(1);
        QCOMPARE(node->role(), QAccessible::Slider);
        QCOMPARE(node->text(QAccessible::Name), "Node 2 of 3, intensity 0.500");
        QCOMPARE(node->valueInterface()->currentValue().toDouble(), 0.4);
        QCOMPARE(access->indexOfChild(node), 1);
        QVERIFY(node->parent()->object() == canvas);
        QVERIFY(QRect(canvas->mapToGlobal(QPoint()), canvas->size()).contains(node->rect().center()));
        QVERIFY(access->childAt(node->rect().center().x(), node->rect().center().y()) == node);

        const int before = steps();
        node->valueInterface()->setCurrentValue(0.75);
        QCOMPARE(window().document().document().curves.manual.nodes[1].opacity, 0.75);
        QCOMPARE(steps(), before + 1);
        node->actionInterface()->doAction(QAccessibleActionInterface::increaseAction());
        QCOMPARE(node->valueInterface()->currentValue().toDouble(), 0.75 + spokenOpacityStep);
        node->valueInterface()->setCurrentValue(7.0);
        QCOMPARE(node->valueInterface()->currentValue().toDouble(), 1.0);

        node->actionInterface()->doAction(QAccessibleActionInterface::setFocusAction());
        QCOMPARE(window().otfEditor().model().selectedNode(), 1);
        QVERIFY(node->state().selected && !access->child(0)->state().selected);
        child<QDockWidget>("dock.otfEditor")->raise();
        QApplication::setActiveWindow(&window());  // the list of a combo box was active
        canvas->setFocus();
        QTRY_VERIFY(canvas->hasFocus());
        node->actionInterface()->doAction(QAccessibleActionInterface::setFocusAction());
        QVERIFY(access->focusChild() == node);

        QAccessibleInterface* last = access->child(2);
        window().otfEditor().model().removeNode(2);
        QCOMPARE(access->childCount(), 2);
        QVERIFY(!last->isValid() && last->text(QAccessible::Name).isEmpty());
        last->actionInterface()->doAction(QAccessibleActionInterface::increaseAction());  // nothing is there to move
        last->valueInterface()->setCurrentValue(0.5);
        node->valueInterface()->setCurrentValue(std::numeric_limits<double>::quiet_NaN());
        node->valueInterface()->setCurrentValue("much");
        QCOMPARE(node->valueInterface()->currentValue().toDouble(), 1.0);
        QCOMPARE(window().document().document().curves.manual.nodes.size(), std::size_t{2});
    }

    void theNodesOfTheEmphasisAreChildrenToo() {
        EmphasisCanvas canvas;
        QAccessibleInterface* access = accessOf(&canvas);
        QCOMPARE(access->childCount(), 3);
        QAccessibleInterface* node = access->child(1);
        QCOMPARE(node->text(QAccessible::Name), "Node 2 of 3, position in boundary 0.00");
        QSignalSpy edited(&canvas, &EmphasisCanvas::edited);
        node->actionInterface()->doAction(QAccessibleActionInterface::decreaseAction());
        QCOMPARE(edited.size(), 1);
        QCOMPARE(node->valueInterface()->currentValue().toDouble(), 1.0 - spokenOpacityStep);
        canvas.setEnabled(false);
        node->valueInterface()->setCurrentValue(0.5);
        QCOMPARE(edited.size(), 1);
    }

    void aSliderSaysItsToolTip() {
        const QString said = accessOf(child("view.brightness"))->text(QAccessible::Description);
        QVERIFY2(said.startsWith("How bright the picture is"), qPrintable(said));
    }

    void aPlaneSaysWhereItLiesAndStepsByAction() {
        QAccessibleInterface* access = accessOf(child("planes.b"));
        QCOMPARE(access->role(), QAccessible::Graphic);
        QCOMPARE(access->text(QAccessible::Name), "Plane B");
        QVERIFY2(access->text(QAccessible::Description).contains(" mm"),
                 qPrintable(access->text(QAccessible::Description)));
        const Planes planes = window().document().document().scene.planes;
        const QString state = access->text(QAccessible::Value);
        for (const char* action : {"Step to the next plane", "Zoom in", "Turn to the right"}) {
            QVERIFY(access->actionInterface()->actionNames().contains(action));
            QVERIFY(!access->actionInterface()->keyBindingsForAction(action).isEmpty());
            const int before = steps();
            access->actionInterface()->doAction(action);
            QCOMPARE(steps(), before + 1);
        }
        QVERIFY(window().document().document().scene.planes != planes);
        QVERIFY(access->text(QAccessible::Value) != state);
    }

    void the3dViewTurnsByAction() {
        QAccessibleInterface* access = accessOf(child("view3d"));
        const Pose pose = window().document().document().scene.pose;
        QVERIFY(access->text(QAccessible::Description).startsWith("azimuth"));
        access->actionInterface()->doAction("Turn to the left");
        const Pose turned = window().document().document().scene.pose;
        QVERIFY(turned.direction != pose.direction);
        access->actionInterface()->doAction("Zoom in");
        QVERIFY(window().document().document().scene.pose.magnification > turned.magnification);
    }

    void theFocusGoesDownThroughAPanel() {
        for (const char* name : {"dock.view", "dock.otfEditor", "dock.room", "dock.method"}) {
            auto* dock = child<QDockWidget>(name);
            dock->raise();
            QCoreApplication::processEvents();
            const QList<QWidget*> order = focusOrder(*dock->widget());
            QVERIFY2(order.size() > 3, name);
            QStringList backwards;
            for (qsizetype i = 1; i < order.size(); ++i)
                if (topOf(*order[i], *dock) + order[i]->height() <= topOf(*order[i - 1], *dock))
                    backwards << order[i - 1]->objectName() + " before " + order[i]->objectName();
            QVERIFY2(backwards.isEmpty(), qPrintable(backwards.join(", ")));
        }
    }

private:
    static QAccessibleInterface* accessOf(QWidget* widget) { return QAccessible::queryAccessibleInterface(widget); }
    int steps() { return window().document().steps().count(); }
    static int topOf(const QWidget& widget, const QWidget& dock) { return widget.mapTo(&dock, QPoint(0, 0)).y(); }
    /// What Tab reaches in a panel, in its order.
    static QList<QWidget*> focusOrder(QWidget& panel) {
        QList<QWidget*> order;
        for (QWidget* each = panel.nextInFocusChain(); each != &panel; each = each->nextInFocusChain()) {
            const bool isReached = panel.isAncestorOf(each) && each->isVisibleTo(&panel) && isControl(*each) &&
                                   (each->focusPolicy() & Qt::TabFocus) != 0;
            if (isReached) order << each;
        }
        return order;
    }
};

ECHOLUCENT_TEST_CLASS(TestAccessibility)

#include "test_accessibility.moc"
