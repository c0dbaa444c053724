// The OTF editor's layout and accessibility under the dark theme, and the theme itself.
#include <QAbstractButton>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QRegularExpression>
#include <QTableView>
#include <QTest>
#include <cmath>
#include <memory>

#include "app/window/dark_theme.h"
#include "tests/widgets/otf_editor/edited_document.h"
#include "widgets/otf_editor/canvas/curve_canvas.h"
#include "widgets/otf_editor/canvas/curve_style.h"

using namespace echolucent;

namespace {

/// Contrast ratio of two colours, 1 to 21 (WCAG 2.1, relative luminance of sRGB).
double contrast(const QColor& one, const QColor& other) {
    const auto luminance = [](const QColor& color) {
        const auto linear = [](double value) {
            return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
        };
        return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
    };
    const double a = luminance(one);
    const double b = luminance(other);
    return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

}  // namespace

class TestOtfEditorLayout : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup() { m_editor.reset(); }
    void themeIsReadWithoutWarnings();
    void textAndCurvesStandOut();
    void plotDoesNotMoveWhenTheActiveCurveChanges();
    void fitsANarrowDock();
    void everyControlHasANameAndCanBeReached();

private:
    std::unique_ptr<EditedEditor> m_editor;
};

void TestOtfEditorLayout::initTestCase() { wearDarkTheme(); }

void TestOtfEditorLayout::init() {
    m_editor = std::make_unique<EditedEditor>();
    m_editor->resize(420, 520);
    m_editor->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_editor.get()));
}

void TestOtfEditorLayout::themeIsReadWithoutWarnings() {
    QTest::failOnWarning(QRegularExpression("stylesheet|property|pseudo", QRegularExpression::CaseInsensitiveOption));
    const QString theme = qApp->styleSheet();
    qApp->setStyleSheet({});
    qApp->setStyleSheet(theme);
    m_editor->grab();
    QCOMPARE(m_editor->palette().color(QPalette::Window), QColor(0x1e, 0x22, 0x26));
}

void TestOtfEditorLayout::textAndCurvesStandOut() {
    const QColor panel = m_editor->palette().color(QPalette::Window);
    for (const auto* label : m_editor->findChildren<QLabel*>()) {
        const double ratio = contrast(label->palette().color(QPalette::Active, QPalette::WindowText), panel);
        QVERIFY2(ratio >= 4.5, qPrintable(QString("%1: %2").arg(label->text()).arg(ratio)));
    }
    for (const CurveKind kind : allCurveKinds) QVERIFY(contrast(curveColor(kind), panel) >= 4.5);
}

void TestOtfEditorLayout::plotDoesNotMoveWhenTheActiveCurveChanges() {
    const QRect before = m_editor->canvas().geometry();
    for (const CurveKind kind : allCurveKinds) {
        m_editor->setActive(kind);
        QCoreApplication::sendPostedEvents();
        QCOMPARE(m_editor->canvas().geometry(), before);
    }
}

void TestOtfEditorLayout::fitsANarrowDock() {
    QVERIFY2(
        m_editor->minimumSizeHint().width() <= 329 && m_editor->minimumSizeHint().height() <= 520,
        qPrintable(
            QString("%1 x %2").arg(m_editor->minimumSizeHint().width()).arg(m_editor->minimumSizeHint().height())));
}

void TestOtfEditorLayout::everyControlHasANameAndCanBeReached() {
    int controls = 0;
    for (auto* widget : m_editor->findChildren<QWidget*>()) {
        const bool ours = widget->objectName().startsWith("otfEditor.");
        const bool control = qobject_cast<QAbstractButton*>(widget) || qobject_cast<QDoubleSpinBox*>(widget) ||
                             qobject_cast<QTableView*>(widget) || qobject_cast<CurveCanvas*>(widget);
        if (!ours || !control) continue;
        ++controls;
        auto* button = qobject_cast<QAbstractButton*>(widget);
        const bool named = !widget->accessibleName().isEmpty() || (button && !button->text().isEmpty());
        QVERIFY2(named, qPrintable(widget->objectName()));
        QVERIFY2(widget->focusPolicy() & Qt::TabFocus, qPrintable(widget->objectName()));
    }
    QVERIFY(controls >= 25);
}

QTEST_MAIN(TestOtfEditorLayout)
#include "test_otf_editor_layout.moc"
