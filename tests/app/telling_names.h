// Collects all text that a window shows, so that tests can search it for a name.
#pragma once

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QPlainTextEdit>
#include <QStringList>
#include <QTextEdit>
#include <QWidget>

namespace echolucent {

/// All words of all windows of the program: titles, texts, tool tips, screen readers' words, menus that were filled,
/// rows of tables and lists.
inline QStringList allWords() {
    QStringList words;
    for (QWidget* widget : QApplication::allWidgets()) {
        words << widget->windowTitle() << widget->windowFilePath() << widget->toolTip() << widget->statusTip()
              << widget->whatsThis() << widget->accessibleName() << widget->accessibleDescription()
              << widget->objectName();
        if (const auto* label = qobject_cast<QLabel*>(widget)) words << label->text();
        if (const auto* button = qobject_cast<QAbstractButton*>(widget)) words << button->text();
        if (const auto* line = qobject_cast<QLineEdit*>(widget)) words << line->text() << line->placeholderText();
        if (const auto* text = qobject_cast<QTextEdit*>(widget)) words << text->toPlainText();
        if (const auto* text = qobject_cast<QPlainTextEdit*>(widget)) words << text->toPlainText();
        if (const auto* group = qobject_cast<QGroupBox*>(widget)) words << group->title();
        if (const auto* choice = qobject_cast<QComboBox*>(widget))
            for (int i = 0; i < choice->count(); ++i) words << choice->itemText(i);
        for (const QAction* action : widget->actions())
            words << action->text() << action->toolTip() << action->iconText() << action->objectName();
        const auto* view = qobject_cast<QAbstractItemView*>(widget);
        if (view == nullptr || view->model() == nullptr) continue;
        const QAbstractItemModel& model = *view->model();
        for (int row = 0; row < model.rowCount(); ++row)
            for (int column = 0; column < model.columnCount(); ++column)
                for (const int role : {Qt::DisplayRole, Qt::ToolTipRole, Qt::AccessibleTextRole})
                    words << model.index(row, column).data(role).toString();
    }
    words.removeAll(QString());
    return words;
}

}  // namespace echolucent
