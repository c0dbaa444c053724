// The OTF editor's layout and accessibility under both themes, and the themes themselves.
#include <QAbstractButton>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QRegularExpression>
#include <QTableView>
#include <QTest>
#include <memory>

#include "app/window/theme.h"
#include "tests/qt_program/test_classes.h"
#include "tests/widgets/contrast.h"
#include "tests/widgets/otf_editor/edited_document.h"
#include "widgets/otf_editor/curve_canvas.h"
#include "widgets/otf_editor/curve_style.h"

using namespace echolucent;

class TestOtfEditorLayout : public QObject {
    Q_OBJECT

private slots:
    /// Every function runs in each theme.
    void initTestCase_data();
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

void TestOtfEditorLayout::initTestCase_data() {
    QTest::addColumn<Theme>("theme");
    QTest::newRow("dark") << Theme::dark;
    QTest::newRow("light") << Theme::light;
}

void TestOtfEditorLayout::init() {
    QFETCH_GLOBAL(Theme, theme);
    wearTheme(theme);
    m_editor = std::make_unique<EditedEditor>();
    m_editor->resize(420, 520);
    m_editor->show();
    QVERIFY(QTest::qWaitForWindowExposed(m_editor.get()));
}

void TestOtfEditorLayout::themeIsReadWithoutWarnings() {
    QTest::failOnWarning(QRegularExpression("stylesheet|property|pseudo", QRegularExpression::CaseInsensitiveOption));
    const QString sheet = qApp->styleSheet();
    qApp->setStyleSheet({});
    qApp->setStyleSheet(sheet);
    m_editor->grab();
    QFETCH_GLOBAL(Theme, theme);
    QCOMPARE(m_editor->palette().color(QPalette::Window), coloursOf(theme).panel);
}

void TestOtfEditorLayout::textAndCurvesStandOut() {
    const QColor panel = m_editor->palette().color(QPalette::Window);
    for (const auto* label : m_editor->findChildren<QLabel*>()) {
        const double ratio = contrast(label->palette().color(QPalette::Active, QPalette::WindowText), panel);
        QVERIFY2(ratio >= 4.5, qPrintable(QString("%1: %2").arg(label->text()).arg(ratio)));
    }
    QFETCH_GLOBAL(Theme, theme);
    const double least = theme == Theme::dark ? 4.5 : 3.0;
    for (const CurveKind kind : allCurveKinds) QVERIFY(contrast(curveColor(kind, theme), panel) >= least);
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

ECHOLUCENT_TEST_CLASS(TestOtfEditorLayout)
#include "test_otf_editor_layout.moc"
