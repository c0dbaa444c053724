// What a lesson's step can look at: the controls of the window by name, and one that a person points at.
#pragma once

#include <QList>
#include <QObject>
#include <QPointer>
#include <QString>

class QWidget;

namespace echolucent {

struct LessonTarget {
    QString name;   ///< object name
    QString words;  ///< "Strength (Method)"
};
/// The controls of a window that have a name for people, but for those of the lessons, by their words.
[[nodiscard]] QList<LessonTarget> lessonTargets(const QWidget& window);

/// While it is active, the next click in the window does nothing but name a control. Tabs and scroll bars work as ever,
/// so that a control on another panel can be reached. Escape, and a click elsewhere, ends it without one.
///
///              begin()                 click on a control: chosen(), ended()
///   [passive] ----------> [active] -----------------------------------------> [passive]
class TargetPointing : public QObject {
    Q_OBJECT

public:
    /// The window outlives this object.
    explicit TargetPointing(QObject* parent = nullptr) : QObject(parent) {}
    ~TargetPointing() override;

    void begin(QWidget& window);
    void end();
    [[nodiscard]] bool active() const { return m_window != nullptr; }

    bool eventFilter(QObject* watched, QEvent* event) override;

signals:
    /// The pointer is on the control of this name; empty: on none.
    void pointed(const QString& name);
    void chosen(const QString& name);
    void ended();

private:
    [[nodiscard]] QString nameOf(const QWidget* widget) const;

    QPointer<QWidget> m_window;
    QString m_pressed;  ///< the control under the press, until the release
    bool m_isPressed = false;
};

}  // namespace echolucent
