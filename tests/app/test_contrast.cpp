// Whether the texts of panels, menus, tabs, messages and status line can be read: the contrast between their colour and
// what they stand on, measured in what the window draws in both themes, is at least 4.5 : 1 (WCAG 2.1, 1.4.3). Controls
// that cannot be used now need none; texts over pictures have a dark rim of their own.
#include <QComboBox>
#include <QDockWidget>
#include <QImage>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QStatusBar>
#include <QTableWidget>
#include <QToolBar>
#include <algorithm>
#include <map>

#include "app/window/theme.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "tests/widgets/contrast.h"
#include "widgets/controls/message_bar.h"

using namespace echolucent;

namespace {

/// Between the commonest colour of a place and that which differs from it most: what a text stands on, and the text.
double contrastWithin(const QImage& image, const QRect& place) {
    std::map<QRgb, int> counts;
    for (int y = place.top(); y <= place.bottom(); ++y)
        for (int x = place.left(); x <= place.right(); ++x) ++counts[image.pixel(x, y)];
    const auto commonest = std::max_element(counts.begin(), counts.end(),
                                            [](const auto& a, const auto& b) { return a.second < b.second; });
    double largest = 1.0;
    for (const auto& [colour, count] : counts) largest = std::max(largest, contrast(colour, commonest->first));
    return largest;
}

}  // namespace

class TestContrast : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    /// Every function runs in each theme.
    void initTestCase_data() {
        QTest::addColumn<Theme>("theme");
        QTest::newRow("dark") << Theme::dark;
        QTest::newRow("light") << Theme::light;
    }
    void initTestCase() {
        seeSides();
        show();
        window().resize(1280, 720);
        useLook(Look{});
        open(file("visit.mha", {smallPhantom(PhantomScene::shapes, 5)}));
        click("presets.open");
        QTRY_VERIFY_WITH_TIMEOUT(window().idle(), 30000);
    }
    void cleanupTestCase() {
        qInfo("the least contrast of %d texts is %.2f : 1 (%s)", m_texts, m_least, qPrintable(m_of));
        close();
    }

    void init() {
        QFETCH_GLOBAL(Theme, theme);
        wearTheme(theme);
    }

    void theMeasureIsWcags() {
        QCOMPARE(contrast(qRgb(255, 255, 255), qRgb(0, 0, 0)), 21.0);
        QVERIFY(std::abs(contrast(qRgb(0x77, 0x77, 0x77), qRgb(255, 255, 255)) - 4.48) < 0.005);
        QImage image(20, 10, QImage::Format_RGB32);
        image.fill(qRgb(0x1e, 0x22, 0x26));
        image.setPixel(3, 3, qRgb(0x6b, 0x74, 0x7d));
        QVERIFY(contrastWithin(image, image.rect()) < 4.5);
    }

    void textsOfPanels_data() {
        QTest::addColumn<QString>("dock");
        for (const QDockWidget* dock : window().findChildren<QDockWidget*>())
            QTest::newRow(qPrintable(dock->objectName())) << dock->objectName();
    }
    void textsOfPanels() {
        QFETCH(QString, dock);
        auto* panel = child<QDockWidget>(dock);
        panel->show();
        panel->raise();
        QTRY_VERIFY(panel->widget()->isVisible());
        const int before = m_texts;
        measureIn(*panel);
        QVERIFY2(m_texts > before, qPrintable(dock + " holds no text"));
    }

    void textsAroundThePicture() {
        child<QWidget>("dock.view")->raise();
        child<MessageBar>("message")->showMessage(MessageKind::info, "A message of some words.",
                                                  MessageEnd::withStudy("a topic"), {{"Do it", {}}});
        measureIn(*child<MessageBar>("message"));
        child<MessageBar>("message")->showMessage(MessageKind::error, "Trouble of some words.",
                                                  MessageEnd::withStudy("a topic"));
        measureIn(*child<MessageBar>("message"));
        measureIn(*window().statusBar());
        measureIn(*child("motion"));
        measureIn(*child<QToolBar>("toolBar"));
        for (QMenu* menu : window().menuBar()->findChildren<QMenu*>()) {
            if (menu->actions().isEmpty()) continue;
            menu->ensurePolished();
            menu->adjustSize();
            const QImage image = menu->grab().toImage();
            for (const QAction* action : menu->actions())
                if (action->isEnabled() && !action->isSeparator() && !action->text().isEmpty())
                    measure(image, menu->actionGeometry(const_cast<QAction*>(action)), action->text());
        }
    }

private:
    void measureIn(QWidget& part) {
        const QImage image = part.grab().toImage();
        for (QWidget* widget : part.findChildren<QWidget*>()) {
            if (!widget->isVisible() || !widget->isEnabled()) continue;
            if (const auto* table = qobject_cast<QTableWidget*>(widget)) measureTable(part, image, *table);
            QRect place = widget->rect();
            QString text;
            if (const auto* label = qobject_cast<QLabel*>(widget)) text = label->text();
            if (const auto* box = qobject_cast<QComboBox*>(widget)) {
                text = box->currentText();
                place.adjust(0, 0, -24, 0);  // its arrow is no text
            }
            if (const auto* field = qobject_cast<QLineEdit*>(widget)) text = field->text();
            if (const auto* list = qobject_cast<QListWidget*>(widget)) measureList(part, image, *list);
            if (const auto* button = qobject_cast<QAbstractButton*>(widget)) {
                text = button->text();
                if (button->isCheckable() && widget->inherits("QAbstractButton") && !widget->inherits("QPushButton") &&
                    !widget->inherits("QToolButton"))
                    place.adjust(22, 0, 0, 0);  // the indicator is no text
            }
            if (text.trimmed().isEmpty()) continue;
            const QRect seen = QRect(widget->mapTo(&part, place.topLeft()), place.size()).intersected(part.rect());
            // What a scroll area cuts off is measured where it is whole.
            if (seen.height() < place.height() || widget->visibleRegion().boundingRect().height() < widget->height())
                continue;
            measure(image, seen, text);
        }
    }
    /// The names below the pictures.
    void measureList(const QWidget& part, const QImage& image, const QListWidget& list) {
        const QPoint corner = list.viewport()->mapTo(&part, QPoint(0, 0));
        for (int row = 0; row < list.count(); ++row) {
            const QRect place = list.visualItemRect(list.item(row)).adjusted(0, list.iconSize().height(), 0, 0);
            if (QRegion(list.viewport()->rect()).contains(place) && part.rect().contains(place.translated(corner)))
                measure(image, place.translated(corner), list.item(row)->text());
        }
    }
    void measureTable(const QWidget& part, const QImage& image, const QTableWidget& table) {
        const QPoint corner = table.viewport()->mapTo(&part, QPoint(0, 0));
        for (int row = 0; row < table.rowCount(); ++row)
            for (int column = 0; column < table.columnCount(); ++column) {
                const QRect place = table.visualItemRect(table.item(row, column));
                // What a scroll area cuts off has no pixels.
                const bool whole = (QRegion(place) - table.viewport()->visibleRegion()).isEmpty();
                if (table.item(row, column)->text().isEmpty() || !whole) continue;
                measure(image, place.translated(corner), table.item(row, column)->text());
            }
    }
    void measure(const QImage& image, const QRect& place, const QString& text) {
        const double found = contrastWithin(image, place.intersected(image.rect()));
        ++m_texts;
        if (found < m_least) {
            m_least = found;
            m_of = text;
        }
        QVERIFY2(found >= 4.5, qPrintable(QStringLiteral("%1: %2 : 1").arg(text).arg(found, 0, 'f', 2)));
    }

    int m_texts = 0;
    double m_least = 21.0;
    QString m_of;
};

ECHOLUCENT_TEST_CLASS(TestContrast)

#include "test_contrast.moc"
