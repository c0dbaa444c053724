// How tool tips look: narrow, and beside what they explain.
#pragma once

#include <QObject>
#include <QString>

class QFont;

namespace echolucent {

/// No line of a tool tip is wider, logical pixels.
inline constexpr int widestToolTip = 276;

/// A control that is higher has its tool tip at the pointer, logical pixels.
inline constexpr int highestWithTipBeside = 160;

/// A tool tip's text in lines no wider than widestToolTip in the font. Rich text loses its tags. The result is plain
/// text, or what QToolTip shows as such.
[[nodiscard]] QString linesOfToolTip(const QString& text, const QFont& font);

/// Shows the application's tool tips in such lines, on the pointer's screen: below a control or
/// a heading of columns, or above it if there is no room; beside a menu, and beside a list or table for one of its
/// items. A tip does not cover the control that it explains, unless the control is higher than highestWithTipBeside:
/// then it lies below the pointer. An item whose tip only repeats what it shows whole has none.
class ToolTips : public QObject {
    Q_OBJECT

public:
    /// Filters the events of the application from now on.
    explicit ToolTips(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace echolucent
