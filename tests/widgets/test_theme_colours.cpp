// The colours of both themes: texts stand off what they are written on, curves off their plots, and no colour of the
// dark theme has changed.
#include <QByteArray>
#include <QColor>
#include <QObject>
#include <QPalette>
#include <QPen>
#include <QString>
#include <QTest>
#include <set>

#include "tests/qt_program/test_classes.h"
#include "tests/widgets/contrast.h"
#include "widgets/motion/course_drawing.h"
#include "widgets/otf_editor/curve_style.h"
#include "widgets/otf_editor/plot_colours.h"
#include "widgets/picture_labels/measurement_drawing.h"
#include "widgets/planes/plane_colours.h"
#include "widgets/surface_colours.h"
#include "widgets/theme_colours.h"

using namespace echolucent;

namespace {

constexpr double forTexts = 4.5, forLines = 3.0;  // WCAG 2.1, 1.4.3 and 1.4.11
constexpr std::array themes{Theme::dark, Theme::light};

using Member = QColor ThemeColours::*;

QByteArray said(Theme theme, const QString& what, double ratio) {
    return QStringLiteral("%1 theme, %2: %3 : 1")
        .arg(QString::fromUtf8(nameOf(theme).data()), what)
        .arg(ratio, 0, 'f', 2)
        .toUtf8();
}

QString nameOf(Member member) {
    for (const ThemeColourRow& row : themeColourRows())
        if (row.member == member) return QString::fromUtf8(row.name.data(), static_cast<qsizetype>(row.name.size()));
    return {};
}

}  // namespace

class TestThemeColours : public QObject {
    Q_OBJECT

private slots:
    void everyColourStandsOnceInTheTableUnderItsOwnName() {
        QCOMPARE(themeColourRows().size() * sizeof(QColor), sizeof(ThemeColours));
        std::set<std::string_view> names;
        for (const ThemeColourRow& row : themeColourRows()) {
            names.insert(row.name);
            QCOMPARE((coloursOf(Theme::dark).*row.member).rgb(), QColor(row.dark).rgb());
            QCOMPARE((coloursOf(Theme::light).*row.member).rgb(), QColor(row.light).rgb());
        }
        QCOMPARE(names.size(), themeColourRows().size());
    }

    void theDarkThemeIsAsItWas() {
        const ThemeColours& dark = coloursOf(Theme::dark);
        QCOMPARE(dark.background, QColor("#14171a"));
        QCOMPARE(dark.panel, QColor("#1e2226"));
        QCOMPARE(dark.text, QColor("#d8dde2"));
        QCOMPARE(dark.secondary, QColor("#8b949e"));
        QCOMPARE(dark.accent, QColor("#4fb3bf"));
        const char* curves[] = {"#4fb3bf", "#e8b04b", "#9aa5b1", "#b48ead", "#8fbc8f"};
        for (const CurveKind kind : allCurveKinds)
            QCOMPARE(curveColor(kind, Theme::dark), QColor(curves[indexOf(kind)]));
        // The ground that was derived from the panel's colour.
        QCOMPARE(plotColours(Theme::dark).background.rgb(), dark.panel.darker(140).rgb());
    }

    void textsStandOffWhatTheyAreWrittenOn() {
        using C = ThemeColours;
        const std::vector<std::pair<Member, std::vector<Member>>> written{
            {&C::text,
             {&C::background, &C::panel, &C::head, &C::menu, &C::field, &C::rowAlternate, &C::raised, &C::pointedAt,
              &C::pressed, &C::accentQuiet, &C::progress}},
            {&C::textBehind, {&C::panel, &C::head}},
            {&C::secondary, {&C::panel, &C::field, &C::rowAlternate}},
            {&C::textSelected, {&C::accentQuiet, &C::selection, &C::pointedAt}},
            {&C::onSign, {&C::accent, &C::warning, &C::error}}};
        for (const Theme theme : themes)
            for (const auto& [text, grounds] : written)
                for (const Member ground : grounds) {
                    const double ratio = contrast(coloursOf(theme).*text, coloursOf(theme).*ground);
                    QVERIFY2(ratio >= forTexts, said(theme, nameOf(text) + " on " + nameOf(ground), ratio).constData());
                }
    }

    void marksAndSignsStandOffTheirPanel() {
        using C = ThemeColours;
        for (const Theme theme : themes)
            for (const Member mark : {&C::accent, &C::secondary, &C::mark, &C::knob, &C::warning, &C::error})
                for (const Member ground : {&C::panel, &C::field, &C::raised}) {
                    const double ratio = contrast(coloursOf(theme).*mark, coloursOf(theme).*ground);
                    QVERIFY2(ratio >= forLines, said(theme, nameOf(mark) + " on " + nameOf(ground), ratio).constData());
                }
    }

    void curvesStandOffPlotsAndPanels() {
        for (const Theme theme : themes) {
            for (const CurveKind kind : allCurveKinds)
                for (const QColor& ground : {plotColours(theme).background, coloursOf(theme).panel}) {
                    const double ratio = contrast(curveColor(kind, theme), ground);
                    QVERIFY2(ratio >= forLines, said(theme, curveName(kind), ratio).constData());
                }
            for (const std::size_t place : {0, 1, 2}) {
                const double ratio = contrast(fixedRowColour(place, theme), plotColours(theme).background);
                QVERIFY2(ratio >= forLines, said(theme, "row " + QString::number(place), ratio).constData());
            }
            const PlotColours plot = plotColours(theme);
            QVERIFY(contrast(earlyLightColour(theme), plot.background) >= forLines);
            for (const QColor& text : {plot.text, plot.secondary}) {
                QVERIFY(contrast(text, plot.background) >= forTexts);
                QVERIFY(contrast(text, plot.histogram) >= forTexts);
                QVERIFY(contrast(text, coloursOf(theme).panel) >= forTexts);
            }
        }
    }

    void noTwoCurvesDifferByColourAlone() {
        for (const Theme theme : themes)
            for (const CurveKind one : allCurveKinds)
                for (const CurveKind other : allCurveKinds) {
                    if (one == other) continue;
                    const QPen a = curvePen(one, false, theme), b = curvePen(other, false, theme);
                    QVERIFY(a.dashPattern() != b.dashPattern() || a.widthF() != b.widthF());
                    QVERIFY(a.color() != b.color());
                }
    }

    void curvesDifferBetweenThemesByColourOnly() {
        for (const CurveKind kind : allCurveKinds) {
            const QPen dark = curvePen(kind, true, Theme::dark), light = curvePen(kind, true, Theme::light);
            QCOMPARE(light.dashPattern(), dark.dashPattern());
            QCOMPARE(light.widthF(), dark.widthF());
            // It is the same colour to the eye: the hue stays, where there is one.
            if (dark.color().hslSaturation() < 60) continue;
            const int apart = std::abs(dark.color().hslHue() - light.color().hslHue());
            QVERIFY2(std::min(apart, 360 - apart) <= 10, qPrintable(curveName(kind)));
        }
    }

    void whatLiesOverPicturesStandsOffBlack() {
        for (const PlaneName plane : allPlaneNames) QVERIFY(contrast(colourOf(plane), Qt::black) >= forTexts);
        for (const QColor& colour : {boxColour(), frontColour(), boxBehindColour(), measurementColour})
            QVERIFY(contrast(colour, Qt::black) >= forLines);
        QVERIFY(contrast(coloursOverPictures().text, Qt::black) >= forTexts);
    }

    void aWidgetKnowsItsThemeByItsPalette() {
        for (const Theme theme : themes) {
            QPalette palette = paletteOf(theme);
            QCOMPARE(themeOf(palette), theme);
            QCOMPARE(coloursOf(palette).panel, coloursOf(theme).panel);
            QCOMPARE(palette.color(QPalette::Window), coloursOf(theme).panel);
            palette.setCurrentColorGroup(QPalette::Disabled);
            QCOMPARE(themeOf(palette), theme);
            palette.setColor(QPalette::Window, Qt::transparent);  // as a label over something
            QCOMPARE(themeOf(palette), theme);
            palette.setColor(QPalette::WindowText, coloursOf(theme).secondary);
            QCOMPARE(themeOf(palette), theme);
        }
        QCOMPARE(themeOf(QPalette(Qt::white)), Theme::light);
    }

    void themesHaveNames() {
        for (const Theme theme : themes) QCOMPARE(themeFromName(echolucent::nameOf(theme)), std::optional(theme));
        QCOMPARE(themeFromName("mauve"), std::nullopt);
    }

    void mixedColoursLieBetween() {
        QCOMPARE(mixed(Qt::black, Qt::white, 0), QColor(0, 0, 0));
        QCOMPARE(mixed(Qt::black, Qt::white, 1), QColor(255, 255, 255));
        QCOMPARE(mixed({10, 200, 30}, {20, 100, 30}, 0.5), QColor(15, 150, 30));
    }
};

ECHOLUCENT_TEST_CLASS(TestThemeColours)
#include "test_theme_colours.moc"
