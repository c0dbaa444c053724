// Uses a control as a person would, and says which values of the document that has changed.
#pragma once

#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QFocusEvent>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMenu>
#include <QStringList>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include "app/window/main_window.h"
#include "io/document/document_file.h"
#include "widgets/accessibility/spoken_widget.h"
#include "widgets/names/named_controls.h"

namespace echolucent {

/// The paths at which two documents differ, as few as name them: of a list of numbers the list, of more than
/// `mostPaths` in one object that object.
class ChangedPaths {
public:
    static constexpr qsizetype mostPaths = 3;

    static QStringList between(const Document& from, const Document& to) {
        const auto object = [](const Document& document) {
            return QJsonDocument::fromJson(QByteArray::fromStdString(jsonOf(document))).object();
        };
        return ofObjects({}, object(from), object(to));
    }

private:
    static QString below(const QString& path, const QString& key) { return path.isEmpty() ? key : path + u'.' + key; }

    static QStringList ofValues(const QString& path, const QJsonValue& from, const QJsonValue& to) {
        if (from == to) return {};
        if (from.isObject() && to.isObject()) return ofObjects(path, from.toObject(), to.toObject());
        const QJsonArray a = from.toArray(), b = to.toArray();
        if (a.isEmpty() || a.size() != b.size() || !a[0].isObject()) return {path};
        QStringList paths;
        for (qsizetype i = 0; i < a.size(); ++i)
            paths += ofValues(QStringLiteral("%1[%2]").arg(path).arg(i), a[i], b[i]);
        return paths;
    }
    static QStringList ofObjects(const QString& path, const QJsonObject& from, const QJsonObject& to) {
        QStringList paths, keys = from.keys() + to.keys();
        keys.removeDuplicates();
        for (const QString& key : keys) paths += ofValues(below(path, key), from[key], to[key]);
        return paths.size() > mostPaths && !path.isEmpty() ? QStringList{path} : paths;
    }
};

class UsedControls {
public:
    explicit UsedControls(MainWindow& window) : m_window(window) {
        // What a control opens is closed again.
        QObject::connect(&m_closing, &QTimer::timeout, [] {
            if (QWidget* menu = QApplication::activePopupWidget()) menu->close();
            if (QWidget* dialog = QApplication::activeModalWidget()) dialog->close();
        });
        m_closing.start(20);
    }

    /// The paths of what a control sets; the document is as before afterwards. Empty if the control is disabled, or if
    /// it leads elsewhere: to a file, another study, a dialog, another face of the window.
    QStringList pathsSetBy(const NamedControl& control) {
        if (!control.object || leadsElsewhere(control)) return {};
        const Document before = m_window.document().document();
        if (!use(*control.object)) return {};
        QCoreApplication::processEvents();
        const QStringList paths = ChangedPaths::between(before, m_window.document().document());
        if (!paths.isEmpty()) m_window.document().edit(before, QStringLiteral("before the control was used"));
        QCoreApplication::processEvents();
        return paths;
    }

private:
    static bool leadsElsewhere(const NamedControl& control) {
        for (const char* elsewhere : {"dock.",
                                      "lessons",
                                      "file.",
                                      "menu",
                                      "compare.figure",
                                      "compare.motions",
                                      "help.",
                                      "view.fullScreen",
                                      "face.",
                                      "view.review",
                                      "view.teach",
                                      "history",
                                      "presets",
                                      "toolBar",
                                      "motion.play",
                                      "study.",
                                      "message",
                                      "theory",
                                      "edit.",
                                      "otfEditor.action.undo",
                                      "view.nearCut.suggest",
                                      "view.findFront",
                                      "otfEditor.action.redo",
                                      "otfEditor.undo",
                                      "otfEditor.redo"})
            if (control.name.startsWith(QLatin1String(elsewhere))) return true;
        const auto* button = qobject_cast<const QAbstractButton*>(control.object.data());
        return control.label.endsWith(u'…') || (button != nullptr && button->text().endsWith(u'…'));
    }
    static bool use(QObject& object) {
        if (auto* action = qobject_cast<QAction*>(&object)) {
            if (!action->isEnabled()) return false;
            action->trigger();
            return true;
        }
        auto* widget = qobject_cast<QWidget*>(&object);
        if (!widget->isEnabled()) return false;
        if (auto* button = qobject_cast<QAbstractButton*>(widget)) {
            const auto* tool = qobject_cast<QToolButton*>(button);
            if (tool != nullptr && tool->menu() != nullptr) return false;
            button->click();
        } else if (auto* slider = qobject_cast<QAbstractSlider*>(widget)) {
            slider->triggerAction(slider->value() < slider->maximum() ? QAbstractSlider::SliderSingleStepAdd
                                                                      : QAbstractSlider::SliderSingleStepSub);
        } else if (auto* number = qobject_cast<QAbstractSpinBox*>(widget)) {
            const QString text = number->text();
            number->stepUp();
            if (number->text() == text) number->stepDown();
            QFocusEvent left(QEvent::FocusOut, Qt::TabFocusReason);
            QCoreApplication::sendEvent(number, &left);
        } else if (auto* box = qobject_cast<QComboBox*>(widget); box != nullptr && !box->isEditable()) {
            const int next = box->currentIndex() + 1 < box->count() ? box->currentIndex() + 1 : 0;
            box->setCurrentIndex(next);
            emit box->activated(next);
        } else if (auto* spoken = dynamic_cast<SpokenWidget*>(widget)) {
            if (!spoken->spokenNodes().empty()) spoken->setSpokenOpacity(0, spoken->spokenNodes()[0].opacity + 0.25);
            if (!spoken->spokenActions().empty())
                QAccessible::queryAccessibleInterface(widget)->actionInterface()->doAction(
                    spoken->spokenActions().front().name);
        } else {
            return false;
        }
        return true;
    }

    MainWindow& m_window;
    QTimer m_closing;
};

}  // namespace echolucent
