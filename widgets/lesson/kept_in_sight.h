// Brings what a lesson's step looks at into sight, in the panel that scrolls it.
#pragma once

#include <QList>
#include <QObject>
#include <QPointer>
#include <QScrollArea>

namespace echolucent {

/// What stands around a widget, or in it, may get its size later: texts and plots come once they are computed. So the
/// widget is brought back into sight until a person scrolls the panel or takes a control of it.
class KeptInSight : public QObject {
    Q_OBJECT

public:
    explicit KeptInSight(QObject* parent = nullptr);

    /// All of the widget is shown, or its upper end if it is higher than what is seen of the panel. Null: none.
    void keep(QWidget* widget);

    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void leave();
    void scroll();
    void scrollSoon();

    QPointer<QWidget> m_widget;
    QPointer<QScrollArea> m_area;
    QList<QPointer<QWidget>> m_watched;  ///< the widget, and what it stands in
    bool m_soon = false;
};

}  // namespace echolucent
