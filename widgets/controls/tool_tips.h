// How tool tips look: narrow, and beside what they explain.
#pragma once

#include <QObject>
#include <QString>

class QFont;

namespace echolucent {

/// No line of a tool tip is wider, logical pixels.
inline constexpr int widestToolTip = 276;

/// A tool tip's text in lines no wider than widestToolTip in the font. Rich text loses its tags. The result is plain
/// text, or what QToolTip shows as such.
[[nodiscard]] QString linesOfToolTip(const QString& text, const QFont& font);

/// Shows the application's tool tips in such lines: below a control, or above it if there is no room; at the right of a
/// menu; below the pointer over what is large. A tip never covers the control that it explains.
class ToolTips : public QObject {
    Q_OBJECT

public:
    /// Filters the events of the application from now on.
    explicit ToolTips(QObject* parent);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace echolucent
