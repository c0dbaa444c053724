// What every control is called and says of itself, in both faces: its label, its tool tip, and where the tip lies.
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QHelpEvent>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QScrollBar>
#include <QTableView>
#include <QTableWidget>
#include <QToolBar>
#include <QToolButton>
#include <QToolTip>
#include <array>
#include <set>
#include <tuple>
#include <utility>

#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "widgets/controls/tool_tips.h"

using namespace echolucent;

class TestToolTips : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        lookAtNoPicture();
        seeSides();
        const auto still = smallPhantom(PhantomScene::shapes, 5);
        show();
        window().resize(1280, 720);
        open(file("moving.mha", {still, still, still}));
    }
    void cleanupTestCase() { close(); }

    void everyControlHasANarrowTipThatDoesNotCoverIt_data() { faces(); }
    void everyControlHasANarrowTipThatDoesNotCoverIt() {
        takeFace();
        int seen = 0;
        QStringList wrong;
        for (QWidget* part : parts()) {
            for (QWidget* control : controlsOf(*part)) {
                wrong << whatIsWrongWithTip(*control);
                ++seen;
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join('\n')));
        QVERIFY2(seen > 50, qPrintable(QString::number(seen)));
    }

    void noTwoControlsOfAPanelHaveOneLabel_data() { faces(); }
    void noTwoControlsOfAPanelHaveOneLabel() {
        takeFace();
        auto* scenario = child<QComboBox>("motion.scenario");
        for (int i = 0; i < scenario->count(); ++i) {
            scenario->setCurrentIndex(i);
            QCoreApplication::processEvents();
            QCOMPARE(labelTwice(*child("motion")), QString());
        }
        for (QWidget* part : parts()) QCOMPARE(labelTwice(*part), QString());
    }

    void aTipIsInNarrowLinesWhateverItsText() {
        const QFont font = QToolTip::font();
        const QString words = QString("word ").repeated(60).trimmed();
        const QStringList lines = linesOfToolTip(words + "\nIt ends.", font).split('\n');
        for (const QString& line : lines)
            QVERIFY2(QFontMetrics(font).horizontalAdvance(line) <= widestToolTip, qPrintable(line));
        QVERIFY(lines.size() > 3);
        QCOMPARE(lines.last(), "It ends.");
        QCOMPARE(lines.mid(0, lines.size() - 1).join(' '), words);  // nothing is lost
        QCOMPARE(linesOfToolTip("<span>a &lt;b&gt; c</span>", font), "<p style='white-space:pre'>a &lt;b&gt; c</p>");
    }

    void theTipOfAnItemLiesBesideItsTableAndRepeatsNothing() {
        QTableWidget table(3, 1);
        table.setWordWrap(false);
        const QString whole = "short", cut = QString("much longer than its cell ").repeated(4);
        for (const auto& [row, text, tip] : {std::tuple{0, whole, whole}, {1, cut, cut}, {2, whole, QString("why")}}) {
            auto* item = new QTableWidgetItem(text);
            item->setToolTip(tip);
            table.setItem(row, 0, item);
        }
        table.setGeometry(300, 200, 220, 160);
        table.show();
        QVERIFY(QTest::qWaitForWindowExposed(&table));
        const auto tipOfRow = [&table](int row) {
            return placeOfTip(*table.viewport(), table.visualItemRect(table.item(row, 0)).center());
        };
        QVERIFY(tipOfRow(0).isNull());
        for (int row = 1; row < 3; ++row) {
            const QRect tip = tipOfRow(row);
            QVERIFY(!tip.isNull());
            const QRect view(table.viewport()->mapToGlobal(QPoint(0, 0)), table.viewport()->size());
            QVERIFY(!tip.intersects(view));
        }
    }

    void theTipOfAHeadingIsNarrowAndLiesBelowIt() {
        QTableWidget table(1, 2);
        auto* heading = new QTableWidgetItem("Right");
        heading->setToolTip(QString("the share of rays ").repeated(12));
        table.setHorizontalHeaderItem(1, heading);
        table.setGeometry(300, 200, 320, 160);
        table.show();
        QVERIFY(QTest::qWaitForWindowExposed(&table));
        const QHeaderView& header = *table.horizontalHeader();
        const int middle = header.height() / 2;
        QVERIFY(placeOfTip(*header.viewport(), QPoint(header.sectionViewportPosition(0) + 5, middle)).isNull());
        const QRect tip = placeOfTip(*header.viewport(), QPoint(header.sectionViewportPosition(1) + 5, middle));
        QVERIFY(!tip.isNull());
        QVERIFY(tip.width() < widestToolTip + 40);
        QVERIFY(!tip.intersects(QRect(header.mapToGlobal(QPoint(0, 0)), header.size())));
    }

    void anEntryOfAMenuHasATipOnlyIfItSaysMore() {
        QMenu menu;
        menu.setToolTipsVisible(true);
        QAction* plain = menu.addAction("Cut && &paste...");
        QAction* explained = menu.addAction("&Front");
        explained->setToolTip("Cuts away what lies before it");
        menu.popup(QPoint(200, 200));
        QVERIFY(QTest::qWaitForWindowExposed(&menu));
        QVERIFY(placeOfTip(menu, menu.actionGeometry(plain).center()).isNull());
        const QRect tip = placeOfTip(menu, menu.actionGeometry(explained).center());
        QVERIFY(!tip.isNull());
        QVERIFY(!tip.intersects(QRect(menu.mapToGlobal(QPoint(0, 0)), menu.size())));
        for (const char* name : {"menu.room", "menu.layout", "menu.compare"})
            QVERIFY2(child<QMenu>(name)->toolTipsVisible(), name);
    }

    void anActionHasOneNameWhereverItStands() {
        std::set<QString> names;
        for (const QAction* menu : window().menuBar()->actions())
            QVERIFY2(names.insert(menu->text().remove('&')).second, qPrintable(menu->text()));
        const std::array<std::pair<const char*, const char*>, 3> fronts{{{"view.findFront", "view.nearCut.suggest"},
                                                                         {"view.frontFromHere", "view.front.fromHere"},
                                                                         {"view.noFront", "view.front.none"}}};
        const QList<QAction*> ofTool = child<QMenu>("toolBar.front.menu")->actions();
        for (std::size_t i = 0; i < fronts.size(); ++i) {
            const QString name = child<QAbstractButton>(fronts[i].second)->text();
            QCOMPARE(child<QAction>(fronts[i].first)->text().remove('&'), name);
            QCOMPARE(ofTool.at(static_cast<int>(i))->text().remove('&'), name);
        }
        QCOMPARE(child<QAction>("otfEditor.action.reset")->text(), child<QAbstractButton>("view.resetCurve")->text());
        QCOMPARE(child<QAction>("room.takeAllStrokesBack")->text().remove('&'),
                 child<QAbstractButton>("room.scalpel.takeAllBack")->text());
    }

private:
    static void faces() {
        QTest::addColumn<QString>("face");
        QTest::newRow("Review") << "face.review";
        QTest::newRow("Teach") << "face.teach";
    }
    void takeFace() {
        QFETCH(QString, face);
        click(face);
        for (const char* more : {"presets.open", "view.more"})
            if (!child<QToolButton>(more)->isChecked()) child<QToolButton>(more)->click();
        QCoreApplication::processEvents();
    }
    /// Tool bar, strip, bar below and each panel; the panel that a loop reaches is in front.
    QList<QWidget*> parts() {
        QList<QWidget*> parts{child("toolBar"), child("sides"), child("motion")};
        for (QDockWidget* dock : window().findChildren<QDockWidget*>())
            if (!dock->isHidden()) parts << dock;
        return parts;
    }
    static void bringToFront(QWidget& part) {
        if (auto* dock = qobject_cast<QDockWidget*>(&part)) {
            dock->raise();
            QCoreApplication::processEvents();
        }
    }
    static bool isControl(const QWidget* each) {
        return (qobject_cast<const QAbstractButton*>(each) || qobject_cast<const QAbstractSlider*>(each) ||
                qobject_cast<const QAbstractSpinBox*>(each) || qobject_cast<const QComboBox*>(each)) &&
               !qobject_cast<const QScrollBar*>(each) && !each->objectName().isEmpty() &&
               !each->objectName().startsWith("qt_");
    }
    static QList<QWidget*> controlsOf(QWidget& part) {
        bringToFront(part);
        QList<QWidget*> controls;
        for (QWidget* each : part.findChildren<QWidget*>())
            if (each->isVisible() && isControl(each)) controls << each;
        return controls;
    }
    static QString tipOf(const QWidget& control) {
        for (const QWidget* each = &control; each != nullptr && !each->isWindow(); each = each->parentWidget())
            if (!each->toolTip().isEmpty()) return each->toolTip();
        return {};
    }
    /// Where the tip lies that a pointer resting there asks for; null if there is none.
    static QRect placeOfTip(QWidget& widget, const QPoint& at) {
        QToolTip::hideText();
        [] { QTRY_VERIFY(!QToolTip::isVisible()); }();
        QHelpEvent rest(QEvent::ToolTip, at, widget.mapToGlobal(at));
        QCoreApplication::sendEvent(&widget, &rest);
        for (const QWidget* tip : QApplication::topLevelWidgets())
            if (tip->inherits("QTipLabel") && tip->isVisible()) return tip->geometry();
        return {};
    }
    /// Asks for the tip as a resting pointer does.
    static QStringList whatIsWrongWithTip(QWidget& control) {
        const QString tipText = tipOf(control), name = control.objectName();
        if (tipText.isEmpty()) return {name + " has no tip"};
        const QPoint middle = control.rect().center();
        QHelpEvent rest(QEvent::ToolTip, middle, control.mapToGlobal(middle));
        QCoreApplication::sendEvent(&control, &rest);
        const QRect place(control.mapToGlobal(QPoint(0, 0)), control.size());
        bool shown = false;
        QStringList wrong;
        for (const QWidget* tip : QApplication::topLevelWidgets()) {
            if (!tip->inherits("QTipLabel") || !tip->isVisible()) continue;
            shown = true;
            constexpr int margins = 28;
            if (tip->width() > widestToolTip + margins)
                wrong << QString("%1 has a tip of %2").arg(name).arg(tip->width());
            if (place.height() <= highestWithTipBeside && tip->geometry().intersects(place))
                wrong << name + " is covered by its tip";
        }
        QToolTip::hideText();
        if (!shown) wrong << name + " shows no tip";
        return wrong;
    }
    /// The words that stand at two controls, or at a control and over a group. A reset, a field beside a slider and
    /// what only reads out have none of their own.
    static QString labelTwice(QWidget& part) {
        bringToFront(part);
        std::set<QString> labels;
        for (const QWidget* each : part.findChildren<QWidget*>()) {
            if (!each->isVisible() || each->objectName().contains(".tab.")) continue;
            QString words;
            if (const auto* label = qobject_cast<const QLabel*>(each);
                label != nullptr && label->objectName().isEmpty())
                words = label->text();
            if (const auto* button = qobject_cast<const QAbstractButton*>(each)) words = button->text();
            if (words.isEmpty() || !words.front().isLetter() || words.size() < 2) continue;
            if (!labels.insert(words).second) return words;
        }
        return {};
    }
};

ECHOLUCENT_TEST_CLASS(TestToolTips)

#include "test_tool_tips.moc"
