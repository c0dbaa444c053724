// The list of measurements and its fields: what the hand does there, and what it asks for.
#include <QAbstractItemDelegate>
#include <QApplication>
#include <QComboBox>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QStyleOptionViewItem>
#include <QTest>

#include "tests/qt_program/test_classes.h"
#include "widgets/panels/measurements_panel.h"

using namespace echolucent;

class TestPanelsMeasurements : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_panel = std::make_unique<MeasurementsPanel>();
        m_list = m_panel->findChild<QListWidget*>("measurements.list");
        m_name = m_panel->findChild<QComboBox*>("measurements.name");
        m_comment = m_panel->findChild<QPlainTextEdit*>("measurements.comment");
        QVERIFY(m_list && m_name && m_comment);
        m_panel->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_panel.get()));
        QApplication::setActiveWindow(m_panel.get());
    }
    void cleanup() { m_panel.reset(); }

    void theFieldsShowTheSelectedMeasurement() {
        QSignalSpy names(m_panel.get(), &MeasurementsPanel::nameTyped);
        QSignalSpy comments(m_panel.get(), &MeasurementsPanel::commentTyped);
        QVERIFY(!m_name->isVisible());
        m_panel->setRows(rows());
        QVERIFY(m_name->isVisible() && m_comment->isVisible());
        QCOMPARE(m_list->currentRow(), 2);  // the newest
        QCOMPARE(m_name->currentText(), "FL");
        m_list->setCurrentRow(0);
        QCOMPARE(m_name->currentText(), "BPD");
        QCOMPARE(m_comment->toPlainText(), "outer to inner");
        m_list->setCurrentRow(1);
        QCOMPARE(m_name->currentText(), "");
        QCOMPARE(m_comment->toPlainText(), "");
        QCOMPARE(names.count() + comments.count(), 0);
    }

    void lettersAreToldOfTheSelectedMeasurement() {
        m_panel->setRows(rows());
        m_list->setCurrentRow(1);
        QSignalSpy names(m_panel.get(), &MeasurementsPanel::nameTyped);
        QSignalSpy comments(m_panel.get(), &MeasurementsPanel::commentTyped);
        QSignalSpy ended(m_panel.get(), &MeasurementsPanel::typingEnded);
        QSignalSpy done(m_panel.get(), &MeasurementsPanel::done);
        QTest::keyClicks(m_name->lineEdit(), "A");
        QCOMPARE(names.last(), (QVariantList{5, "A"}));  // nothing is completed
        QTest::keyClicks(m_name->lineEdit(), "o");
        QCOMPARE(names.last(), (QVariantList{5, "Ao"}));
        QCOMPARE(ended.count(), 0);
        QTest::keyClick(m_name->lineEdit(), Qt::Key_Return);
        QVERIFY(ended.count() > 0);
        QVERIFY(done.count() > 0);
        QTest::keyClicks(m_comment, "x");
        QCOMPARE(comments.last(), (QVariantList{5, "x"}));
        // A measurement named in the list of usual names.
        ended.clear();
        done.clear();
        m_name->setFocus();
        emit m_name->textActivated("NT");
        QCOMPARE(names.last(), (QVariantList{5, "NT"}));
        QVERIFY(ended.count() >= 2);
        QCOMPARE(done.count(), 1);  // so that a key of the window is no letter more
        for (QWidget* each : {static_cast<QWidget*>(m_name), static_cast<QWidget*>(m_comment)})
            QTest::keyClick(each, Qt::Key_Escape);
        QCOMPARE(done.count(), 3);
        QCOMPARE(m_name->currentText(), "Ao");  // what was typed stays
    }

    void usualNamesAreGroupedAndStandWithTheirWords() {
        QCOMPARE(m_name->lineEdit()->placeholderText(), "choose or type");
        for (const char* name : {"BPD", "NT", "LV", "RV", "LA", "RA", "IVS", "Ao", "PA", "MV", "TV"}) {
            const int row = m_name->findText(name);
            QVERIFY2(row >= 0, name);
            QVERIFY(m_name->model()->flags(m_name->model()->index(row, 0)).testFlag(Qt::ItemIsSelectable));
        }
        const int heart = m_name->findText("Heart");
        QVERIFY(m_name->findText("Fetal biometry") == 0 && m_name->findText("NT") < heart);
        QVERIFY(m_name->findText("LV") > heart);
        QVERIFY(!m_name->model()->flags(m_name->model()->index(heart, 0)).testFlag(Qt::ItemIsSelectable));
        QVERIFY(m_name->maxVisibleItems() >= m_name->count());
        // The words make a row wider, and are no part of the name.
        QStyleOptionViewItem option;
        const QSize row = m_name->itemDelegate()->sizeHint(option, m_name->model()->index(heart + 1, 0));
        QVERIFY(row.width() > option.fontMetrics.horizontalAdvance("LV – left"));
        QCOMPARE(m_name->itemText(heart + 1), "LV");
    }

    void tabGoesFromFieldToFieldAndToRemoveAtLast() {
        m_panel->setRows(rows());
        m_name->setFocus();
        const QStringList order{"measurements.comment", "measurements.list", "measurements.remove",
                                "measurements.removeAll"};
        for (const QString& next : order) {
            QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
            QCOMPARE(QApplication::focusWidget()->objectName(), next);
        }
    }

    void aLetterInTheListBeginsTheName() {
        m_panel->setRows(rows());
        m_list->setCurrentRow(0);
        m_list->setFocus();
        QSignalSpy names(m_panel.get(), &MeasurementsPanel::nameTyped);
        QKeyEvent asked(QEvent::ShortcutOverride, Qt::Key_M, Qt::NoModifier, "M");
        asked.ignore();
        QCoreApplication::sendEvent(m_list, &asked);
        QVERIFY(asked.isAccepted());  // no key of the window
        QTest::keyClicks(m_list, "M");
        QVERIFY(m_name->hasFocus());
        QTest::keyClicks(QApplication::focusWidget(), "V");
        QCOMPARE(names.last(), (QVariantList{4, "MV"}));
        QKeyEvent other(QEvent::ShortcutOverride, Qt::Key_S, Qt::ControlModifier, "\x13");
        other.ignore();
        QCoreApplication::sendEvent(m_list, &other);
        QVERIFY(!other.isAccepted());
    }

    void aCommentEndsAtItsLongest() {
        m_panel->setRows(rows());
        QSignalSpy comments(m_panel.get(), &MeasurementsPanel::commentTyped);
        const QString longest(500, 'c');
        m_comment->setFocus();
        m_comment->insertPlainText(longest + "ddd");
        QCOMPARE(m_comment->toPlainText(), longest);
        QCOMPARE(comments.count(), 1);
        QCOMPARE(comments.last(), (QVariantList{7, longest}));
        QTest::keyClick(m_comment, Qt::Key_E);
        QCOMPARE(m_comment->toPlainText(), longest);
        QCOMPARE(m_name->lineEdit()->maxLength(), 80);
    }

    void keysOfTheList() {
        m_panel->setRows(rows());
        m_list->setCurrentRow(1);
        m_list->setFocus();
        QTest::keyClick(m_list, Qt::Key_F2);
        QVERIFY(m_name->hasFocus() || m_name->lineEdit()->hasFocus());
        QSignalSpy removed(m_panel.get(), &MeasurementsPanel::removed);
        QTest::keyClick(m_name->lineEdit(), Qt::Key_Delete);
        QCOMPARE(removed.count(), 0);  // there it deletes a letter
        QTest::keyClick(m_list, Qt::Key_Delete);
        QCOMPARE(removed.last(), QVariantList{5});
        auto fewer = rows();
        fewer.erase(fewer.begin() + 1);
        m_panel->setRows(fewer);
        QCOMPARE(m_list->currentRow(), 1);  // the one in its place
        QTest::mouseClick(m_panel->findChild<QPushButton*>("measurements.remove"), Qt::LeftButton);
        QCOMPARE(removed.last(), QVariantList{7});
        fewer.pop_back();
        m_panel->setRows(fewer);
        QCOMPARE(m_list->currentRow(), 0);
        m_panel->setRows({});
        QVERIFY(!m_list->isVisible() && !m_name->isVisible());
    }

private:
    static std::vector<MeasurementRow> rows() {
        return {{4, "4. BPD 47.1 mm", "BPD", "outer to inner"}, {5, "5. 12.0 mm"}, {7, "7. FL 30.2 mm", "FL"}};
    }

    std::unique_ptr<MeasurementsPanel> m_panel;
    QListWidget* m_list = nullptr;
    QComboBox* m_name = nullptr;
    QPlainTextEdit* m_comment = nullptr;
};

ECHOLUCENT_TEST_CLASS(TestPanelsMeasurements)
#include "test_panels_measurements.moc"
