// What a screen reader, or a script, learns of a widget that the program draws itself, and what it can do with it.
#pragma once

#include <QAccessible>
#include <QKeySequence>
#include <QRect>
#include <QString>
#include <optional>
#include <vector>

class QWidget;

namespace echolucent {

/// Something that can be done with a widget, by the key that does it: "Step on", Down.
struct SpokenAction {
    QString name;  ///< as it is spoken
    QKeySequence key;
};

/// A node of a curve: a part of a widget with a number of its own.
struct SpokenNode {
    QString name;  ///< "Node 2 of 5, intensity 0.471"
    double opacity = 0.0;
    QRect place;  ///< in the widget, logical pixels
    bool isChosen = false;
};

/// "Node 2 of 5, intensity 0.471". `place` is counted from 0, `where` says where the node lies.
[[nodiscard]] QString spokenNameOf(int place, std::size_t nodes, const QString& where);
/// The square about a node's centre that a press hits, `reach` pixels to each side.
[[nodiscard]] QRect placeOfNode(QPointF centre, double reach);

/// Base of widgets that paint what they show. Their class is a QWidget too. watchSpokenWidgets() must have been called.
class SpokenWidget {
public:
    virtual ~SpokenWidget() = default;

    [[nodiscard]] virtual QAccessible::Role spokenRole() const { return QAccessible::Graphic; }
    /// What is shown now, in words; it stands behind the widget's description.
    [[nodiscard]] virtual QString spokenState() const { return {}; }
    /// The keys that the widget itself takes.
    [[nodiscard]] virtual std::vector<SpokenAction> spokenActions() const { return {}; }

    [[nodiscard]] virtual std::vector<SpokenNode> spokenNodes() const { return {}; }
    /// Chooses a node and gives the widget the focus. The node is one of spokenNodes().
    virtual void chooseSpokenNode(int /*node*/) {}
    /// Moves a node up or down, in one step. The opacity is clamped to what the node may have.
    virtual void setSpokenOpacity(int /*node*/, double /*opacity*/) {}
};

/// How far a node moves when a screen reader asks for more or less of it.
inline constexpr double spokenOpacityStep = 1.0 / 256.0;

/// From now on a screen reader finds what this room says of widgets: of SpokenWidgets, of combo boxes, which are
/// called by their label (Qt calls them by their value), and of labels, whose text follows their name, and of
/// buttons that stay down, which are clicked. Call it once the application is there; more calls do nothing.
void watchSpokenWidgets();

/// Tells screen readers that a node of a widget was chosen, or has another value. The widget is a SpokenWidget.
void tellNodeChosen(QWidget& widget, int node);
void tellNodeChanged(QWidget& widget, int node);

}  // namespace echolucent
