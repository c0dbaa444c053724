// What a step looks at comes into sight, and stays there while texts and plots around it are still being computed.
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <QVBoxLayout>
#include <memory>

#include "tests/qt_program/test_classes.h"
#include "widgets/lesson/kept_in_sight.h"

using namespace echolucent;

namespace {

QString lines(int count) { return QStringList(count, QStringLiteral("line")).join('\n'); }

}  // namespace

class TestKeptInSight : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_window = std::make_unique<QWidget>();
        m_area = new QScrollArea;
        auto* rows = new QVBoxLayout(m_window.get());
        rows->addWidget(m_area);
        rows->addWidget(m_outside = new QLineEdit);
        auto* panel = new QWidget;
        auto* column = new QVBoxLayout(panel);
        for (QLabel** each : {&m_above, &m_target, &m_below}) column->addWidget(*each = new QLabel);
        column->addWidget(m_control = new QLineEdit);
        column->addStretch(1);
        m_area->setWidgetResizable(true);
        m_area->setWidget(panel);
        m_above->setText(lines(40));
        m_target->setText(lines(4));
        m_below->setText(lines(40));
        m_window->resize(300, 300);
        m_window->show();
        QApplication::setActiveWindow(m_window.get());
        m_outside->setFocus();
    }

    void cleanup() { m_window.reset(); }

    void allOfItIsSeenAlsoOnceMoreComes() {
        KeptInSight sight;
        sight.keep(m_target);
        QTRY_VERIFY(isWhole());
        m_target->setText(lines(8));
        QTRY_VERIFY(m_target->sizeHint().height() == m_target->height() && isWhole());
        m_above->setText(lines(80));
        QTRY_VERIFY(m_above->sizeHint().height() == m_above->height() && isWhole());
        m_above->setText(lines(1));
        QTRY_VERIFY(m_above->sizeHint().height() == m_above->height() && isWhole());
    }

    void itIsBroughtIntoSightOnceItIsShown() {
        KeptInSight sight;
        m_target->hide();
        sight.keep(m_target);
        QCoreApplication::processEvents();
        QCOMPARE(m_area->verticalScrollBar()->value(), 0);
        m_target->show();
        QTRY_VERIFY(isWhole());
    }

    void ofWhatIsTooHighTheTopIsSeen() {
        KeptInSight sight;
        sight.keep(m_target);
        QTRY_VERIFY(isWhole());
        m_target->setText(lines(60));
        QTRY_VERIFY(m_target->height() > m_area->viewport()->height() && top() >= 0 && top() < 20);
    }

    void whatJustFitsIsSeenWhole() {
        KeptInSight sight;
        m_target->setFixedHeight(m_area->viewport()->height() - 4);
        sight.keep(m_target);
        QTRY_VERIFY(isWhole());
    }

    void aPersonWhoScrollsIsLeftAlone() {
        KeptInSight sight;
        sight.keep(m_target);
        QTRY_VERIFY(isWhole());
        m_area->verticalScrollBar()->triggerAction(QScrollBar::SliderToMinimum);
        m_above->setText(lines(60));
        QTRY_COMPARE(m_above->height(), m_above->sizeHint().height());
        QCoreApplication::processEvents();
        QCOMPARE(m_area->verticalScrollBar()->value(), 0);
    }

    void aPersonWhoTakesAControlIsLeftAlone() {
        KeptInSight sight;
        sight.keep(m_target);
        QTRY_VERIFY(isWhole());
        m_control->setFocus();
        const int seen = m_area->verticalScrollBar()->value();
        m_above->setText(lines(60));
        QTRY_COMPARE(m_above->height(), m_above->sizeHint().height());
        QCoreApplication::processEvents();
        QCOMPARE(m_area->verticalScrollBar()->value(), seen);
    }

private:
    [[nodiscard]] int top() const { return m_target->mapTo(m_area->viewport(), QPoint(0, 0)).y(); }
    [[nodiscard]] bool isWhole() const {
        return top() >= 0 && top() + m_target->height() <= m_area->viewport()->height();
    }

    std::unique_ptr<QWidget> m_window;
    QScrollArea* m_area = nullptr;
    QLabel *m_above = nullptr, *m_target = nullptr, *m_below = nullptr;
    QLineEdit *m_control = nullptr, *m_outside = nullptr;
};

ECHOLUCENT_TEST_CLASS(TestKeptInSight)
#include "test_kept_in_sight.moc"
