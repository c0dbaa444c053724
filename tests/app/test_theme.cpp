// The light theme in the real window: chosen in the menu, worn at once by everything, kept for the next start. Pictures
// stay on black.
#include <QCheckBox>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QStatusBar>
#include <QTableWidget>
#include <QToolButton>
#include <set>

#include "app/settings/settings.h"
#include "app/window/theme.h"
#include "processing/plots/series_style.h"
#include "tests/app/window_fixture.h"
#include "tests/qt_program/test_classes.h"
#include "tests/widgets/contrast.h"
#include "widgets/controls/message_bar.h"
#include "widgets/motion/otf_map_canvas.h"
#include "widgets/otf_editor/curve_canvas.h"
#include "widgets/otf_editor/curve_style.h"
#include "widgets/otf_editor/plot_colours.h"
#include "widgets/planes/pane_grid.h"

using namespace echolucent;

namespace {

QImage pixelsOf(QWidget& widget) { return widget.grab().toImage().convertToFormat(QImage::Format_RGB32); }

std::set<QRgb> coloursIn(const QImage& image) {
    std::set<QRgb> colours;
    for (int y = 0; y < image.height(); ++y) {
        const auto* line = reinterpret_cast<const QRgb*>(image.constScanLine(y));
        colours.insert(line, line + image.width());
    }
    return colours;
}

double shareOf(const QImage& image, const QColor& colour) {
    qint64 count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) count += image.pixel(x, y) == colour.rgb() ? 1 : 0;
    return static_cast<double>(count) / (static_cast<double>(image.width()) * image.height());
}

/// Whether a square of 4 x 4 pixels has the colour: smoothed letters have pixels of any colour, but no such squares.
bool hasPatchOf(const QImage& image, const QColor& colour) {
    for (int y = 0; y + 4 <= image.height(); ++y)
        for (int x = 0; x + 4 <= image.width(); ++x) {
            bool whole = true;
            for (int i = 0; whole && i < 16; ++i) whole = image.pixel(x + i % 4, y + i / 4) == colour.rgb();
            if (whole) return true;
        }
    return false;
}

/// The grounds of a theme that none of the other theme's colours is alike.
std::vector<QColor> groundsOf(Theme theme) {
    const ThemeColours& c = coloursOf(theme);
    return {c.background, c.panel,          c.head,        c.menu,      c.plot,
            c.raised,     c.raisedDisabled, c.accentQuiet, c.selection, c.progress};
}

}  // namespace

class TestTheme : public QObject, private WindowFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_file = file("visit.mha", {smallPhantom(PhantomScene::shapes, 5)});
        show();
        window().resize(1280, 720);
        useLook(Look{});
        open(m_file);
        for (auto* dock : window().findChildren<QDockWidget*>()) dock->show();
        child<QDockWidget>("dock.view")->raise();
    }
    void init() {
        if (inMenu("view.lightTheme")->isChecked()) chooseInMenu("view.lightTheme");
    }
    void cleanupTestCase() { close(); }

    void theWindowStartsDark() {
        QVERIFY(!inMenu("view.lightTheme")->isChecked());
        QVERIFY(inMenu("view.lightTheme")->isCheckable());
        QCOMPARE(inMenu("view.lightTheme")->text().remove('&'), "Light theme");
        QCOMPARE(qApp->styleSheet(), styleSheetOf(Theme::dark));
        QCOMPARE(window().palette().color(QPalette::WindowText), coloursOf(Theme::dark).text);
    }

    void aStyleSheetHasAColourForEveryName() {
        for (const Theme theme : {Theme::dark, Theme::light}) {
            const QString sheet = styleSheetOf(theme);
            QVERIFY(!sheet.contains('@'));
            QVERIFY(sheet.contains(coloursOf(theme).panel.name()));
        }
        QVERIFY(!styleSheetOf(Theme::light).contains(coloursOf(Theme::dark).panel.name()));
        QTest::failOnWarning(
            QRegularExpression("stylesheet|property|pseudo|parse", QRegularExpression::CaseInsensitiveOption));
        chooseInMenu("view.lightTheme");
    }

    void aClickInTheMenuChangesPaletteAndStyleSheetAtOnce() {
        chooseInMenu("view.lightTheme");
        QVERIFY(inMenu("view.lightTheme")->isChecked());
        const ThemeColours& light = coloursOf(Theme::light);
        QCOMPARE(qApp->styleSheet(), styleSheetOf(Theme::light));
        QCOMPARE(QApplication::palette().color(QPalette::Window), light.panel);
        for (const char* name : {"otfEditor", "motion", "study", "adaptive", "view", "explain"})
            QCOMPARE(child(name)->palette().color(QPalette::Window), light.panel);
        for (const QWidget* widget : window().findChildren<QWidget*>()) {
            if (widget->property("overPicture").toBool()) continue;
            QVERIFY2(themeOf(widget->palette()) == Theme::light, qPrintable(widget->objectName()));
        }
        chooseInMenu("view.lightTheme");
        for (const QWidget* widget : window().findChildren<QWidget*>())
            QVERIFY2(themeOf(widget->palette()) == Theme::dark, qPrintable(widget->objectName()));
    }

    void nothingOfTheOtherThemeIsLeft_data() { everyPart(); }
    void nothingOfTheOtherThemeIsLeft() {
        QFETCH(QString, part);
        QWidget& widget = shownPart(part);
        const QImage inDark = pixelsOf(widget);
        chooseInMenu("view.lightTheme");
        const QImage inLight = pixelsOf(widget);
        for (const QColor& ground : groundsOf(Theme::dark))
            QVERIFY2(!hasPatchOf(inLight, ground), qPrintable(ground.name()));
        for (const QColor& ground : groundsOf(Theme::light))
            QVERIFY2(!hasPatchOf(inDark, ground), qPrintable(ground.name()));
        QVERIFY(hasPatchOf(inLight, coloursOf(Theme::light).panel));
        QVERIFY(hasPatchOf(inDark, coloursOf(Theme::dark).panel));
    }

    void thereAndBackTheWindowLooksAsBefore_data() { everyPart(); }
    void thereAndBackTheWindowLooksAsBefore() {
        QFETCH(QString, part);
        QWidget& widget = shownPart(part);
        const QImage before = pixelsOf(widget);
        chooseInMenu("view.lightTheme");
        const QImage light = pixelsOf(widget);
        QCOMPARE(light.size(), before.size());  // colours change, and nothing moves
        QVERIFY(light != before);
        chooseInMenu("view.lightTheme");
        QCOMPARE(pixelsOf(widget), before);
    }

    void plotsLieOnWhiteAndCurvesAreDarkEnough() {
        child<QDockWidget>("dock.otfEditor")->raise();
        auto& canvas = window().otfEditor().canvas();
        QTRY_VERIFY(canvas.isVisible());
        window().otfEditor().setActive(CurveKind::manual);
        QVERIFY(coloursIn(pixelsOf(canvas)).contains(curveColor(CurveKind::manual, Theme::dark).rgb()));
        chooseInMenu("view.lightTheme");
        const QImage plot = pixelsOf(canvas);
        QVERIFY2(shareOf(plot, Qt::white) > 0.1, qPrintable(QString::number(shareOf(plot, Qt::white))));
        QVERIFY(!hasPatchOf(plot, plotColours(Theme::dark).background));
        QVERIFY(coloursIn(plot).contains(curveColor(CurveKind::manual, Theme::light).rgb()));
        QVERIFY(!coloursIn(plot).contains(curveColor(CurveKind::manual, Theme::dark).rgb()));
        // The samples of the legend show the same colours.
        for (const CurveKind kind : allCurveKinds) {
            auto* sample = child<QCheckBox>("otfEditor.legend." + curveKey(kind) + ".visible");
            const QImage icon = sample->icon().pixmap(curveSampleSize).toImage();
            QVERIFY2(
                coloursIn(icon.convertToFormat(QImage::Format_ARGB32)).contains(curveColor(kind, Theme::light).rgb()),
                qPrintable(curveName(kind)));
        }
        window().otfEditor().setActive(CurveKind::adaptive);
        waitUntilIdle();
    }

    void reportsDrawCurvesInTheSameColours() {
        for (const CurveKind kind : allCurveKinds) {
            const SeriesColour* series = nullptr;
            for (const SeriesColour& each : seriesColours)
                if (each.curve == nameOf(kind)) series = &each;
            QVERIFY(series != nullptr);
            const auto colour = [](std::string_view text) {
                return QColor(QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size())));
            };
            QCOMPARE(curveColor(kind, Theme::dark), colour(series->onDark));
            QCOMPARE(curveColor(kind, Theme::light), colour(series->onLight));
        }
    }

    void whatTheFileSaysStandsBackInBothThemes() {
        child<QDockWidget>("dock.study")->raise();
        auto* facts = child<QTableWidget>("study.facts");
        QTRY_VERIFY(facts->isVisible());
        const auto secondaryIn = [&](Theme theme) {
            return coloursIn(pixelsOf(*facts->viewport())).contains(coloursOf(theme).secondary.rgb());
        };
        QVERIFY(secondaryIn(Theme::dark) && !secondaryIn(Theme::light));
        chooseInMenu("view.lightTheme");
        QVERIFY(secondaryIn(Theme::light) && !secondaryIn(Theme::dark));
    }

    void messagesAreInTheThemesColours() {
        auto* bar = child<MessageBar>("message");
        const auto stripe = [&] { return QColor(pixelsOf(*bar).pixel(1, bar->height() / 2)); };
        const std::pair<MessageKind, QColor ThemeColours::*> kinds[] = {{MessageKind::info, &ThemeColours::accent},
                                                                        {MessageKind::warning, &ThemeColours::warning},
                                                                        {MessageKind::error, &ThemeColours::warning}};
        for (const auto& [kind, colour] : kinds) {
            bar->showMessage(kind, "A sentence.", MessageEnd::withStudy("a topic"));
            QCOMPARE(stripe(), coloursOf(Theme::dark).*colour);
            chooseInMenu("view.lightTheme");
            QCOMPARE(stripe(), coloursOf(Theme::light).*colour);
            QVERIFY(shareOf(pixelsOf(*bar), coloursOf(Theme::light).panel) > 0.5);
            chooseInMenu("view.lightTheme");
        }
        bar->dismiss();
    }

    void picturesStayOnBlackAndWhatLiesOverThemStays() {
        child<QAction>("room.quad")->trigger();
        waitUntilIdle();
        auto* plane = child("planes.b");
        QTRY_VERIFY(plane->isVisible());
        const QImage picture = window().volumeView().screenImage();
        child("motion.play")->setFocus();
        const QImage pane = pixelsOf(*plane);
        QVERIFY(shareOf(pane, Qt::black) > 0.05);
        chooseInMenu("view.lightTheme");
        waitUntilIdle();
        child("motion.play")->setFocus();
        // The pane with its buttons, letters, lines and frame.
        QCOMPARE(pixelsOf(*plane), pane);
        QCOMPARE(window().volumeView().screenImage(), picture);
        child<QAction>("room.only3d")->trigger();
        waitUntilIdle();
    }

    void aDialogThatIsOpenFollows() {
        child<QAction>("help.about")->trigger();
        auto* box = child<QMessageBox>("about");
        QVERIFY(QTest::qWaitForWindowExposed(box));
        QVERIFY(shareOf(pixelsOf(*box), coloursOf(Theme::dark).panel) > 0.5);
        chooseInMenu("view.lightTheme");
        QVERIFY(shareOf(pixelsOf(*box), coloursOf(Theme::light).panel) > 0.5);
        box->close();
    }

    void theThemeIsKeptForTheNextStart() {
        chooseInMenu("view.lightTheme");
        close();
        QCOMPARE(Settings(settingsFile()).theme(), Theme::light);
        wearTheme(Theme::dark);  // as a program that has just begun
        showAgain();
        QVERIFY(inMenu("view.lightTheme")->isChecked());
        QCOMPARE(qApp->styleSheet(), styleSheetOf(Theme::light));
        QCOMPARE(child("otfEditor")->palette().color(QPalette::Window), coloursOf(Theme::light).panel);
        chooseInMenu("view.lightTheme");
        close();
        showAgain();
        QVERIFY(!inMenu("view.lightTheme")->isChecked());
        QCOMPARE(qApp->styleSheet(), styleSheetOf(Theme::dark));
    }

private:
    QAction* inMenu(const char* name) { return child<QAction>(name); }

    /// By the mouse, as a person does: the menu in the bar, then its entry.
    void chooseInMenu(const char* name) {
        QMenuBar* bar = window().menuBar();
        for (QAction* title : bar->actions()) {
            QMenu* menu = title->menu();
            QAction* entry = inMenu(name);
            if (menu == nullptr || !menu->actions().contains(entry)) continue;
            QTest::mouseClick(bar, Qt::LeftButton, {}, bar->actionGeometry(title).center());
            QTRY_VERIFY(menu->isVisible());
            QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(entry).center());
            QTRY_VERIFY(!menu->isVisible());
            return;
        }
        QFAIL(name);
    }

    void everyPart() {
        QTest::addColumn<QString>("part");
        QStringList parts;
        for (const QDockWidget* dock : window().findChildren<QDockWidget*>()) parts << dock->objectName();
        parts << "motion"
              << "menu bar"
              << "status bar";
        const qsizetype step = isLongRun() ? 1 : 4;
        for (qsizetype i = 0; i < parts.size(); i += step) QTest::newRow(qPrintable(parts[i])) << parts[i];
    }
    QWidget& shownPart(const QString& part) {
        if (part == "menu bar") return *window().menuBar();
        if (part == "status bar") return *window().statusBar();
        if (auto* dock = window().findChild<QDockWidget*>(part)) {
            dock->raise();
            QCoreApplication::processEvents();
        }
        child("motion.play")->setFocus();
        return *child(part);
    }

    QString m_file;
};

ECHOLUCENT_TEST_CLASS(TestTheme, "nothingOfTheOtherThemeIsLeft", "thereAndBackTheWindowLooksAsBefore")

#include "test_theme.moc"
