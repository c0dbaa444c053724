#include "widgets/accessibility/spoken_widget.h"

#include <QAbstractButton>
#include <QAccessibleWidget>
#include <QComboBox>
#include <QCoreApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QWidget>
#include <algorithm>
#include <cmath>

#include "widgets/accessibility/button_access.h"
#include "widgets/accessibility/combo_box_access.h"
#include "widgets/accessibility/label_access.h"

namespace echolucent {

namespace {

/// A node of a SpokenWidget.
class NodeAccess : public QAccessibleInterface, public QAccessibleValueInterface, public QAccessibleActionInterface {
public:
    NodeAccess(QWidget& widget, SpokenWidget& spoken, int place) : m_widget(widget), m_spoken(spoken), m_place(place) {}

    bool isValid() const override { return node().has_value(); }
    QObject* object() const override { return nullptr; }
    QAccessibleInterface* parent() const override { return QAccessible::queryAccessibleInterface(&m_widget); }
    QAccessibleInterface* child(int) const override { return nullptr; }
    QAccessibleInterface* childAt(int, int) const override { return nullptr; }
    int childCount() const override { return 0; }
    int indexOfChild(const QAccessibleInterface*) const override { return -1; }
    QWindow* window() const override { return m_widget.window()->windowHandle(); }
    QAccessible::Role role() const override { return QAccessible::Slider; }
    QString text(QAccessible::Text kind) const override {
        const auto now = node();
        if (!now) return {};
        if (kind == QAccessible::Name) return now->name;
        if (kind == QAccessible::Value) return QString::number(now->opacity, 'f', 3);
        return {};
    }
    void setText(QAccessible::Text, const QString&) override {}
    QRect rect() const override {
        const auto now = node();
        return now ? now->place.translated(m_widget.mapToGlobal(QPoint(0, 0))) : QRect();
    }
    QAccessible::State state() const override {
        QAccessible::State state;
        const auto now = node();
        state.focusable = state.selectable = true;
        state.invalid = !now;
        state.invisible = !m_widget.isVisible();
        state.disabled = !m_widget.isEnabled();
        state.selected = now && now->isChosen;
        state.focused = state.selected && m_widget.hasFocus();
        return state;
    }
    void* interface_cast(QAccessible::InterfaceType type) override {
        if (type == QAccessible::ValueInterface) return static_cast<QAccessibleValueInterface*>(this);
        if (type == QAccessible::ActionInterface) return static_cast<QAccessibleActionInterface*>(this);
        return nullptr;
    }

    QVariant currentValue() const override { return node().value_or(SpokenNode{}).opacity; }
    void setCurrentValue(const QVariant& value) override {
        bool isNumber = false;
        const double opacity = value.toDouble(&isNumber);
        if (isNumber && std::isfinite(opacity) && canBeUsed()) m_spoken.setSpokenOpacity(m_place, opacity);
    }
    QVariant maximumValue() const override { return 1.0; }
    QVariant minimumValue() const override { return 0.0; }
    QVariant minimumStepSize() const override { return spokenOpacityStep; }

    QStringList actionNames() const override { return {setFocusAction(), increaseAction(), decreaseAction()}; }
    void doAction(const QString& action) override {
        if (!canBeUsed()) return;
        const auto now = node();
        if (action == setFocusAction()) m_spoken.chooseSpokenNode(m_place);
        if (action == increaseAction()) m_spoken.setSpokenOpacity(m_place, now->opacity + spokenOpacityStep);
        if (action == decreaseAction()) m_spoken.setSpokenOpacity(m_place, now->opacity - spokenOpacityStep);
    }
    QStringList keyBindingsForAction(const QString&) const override { return {}; }

private:
    /// The node may be gone, and a disabled widget takes no changes.
    bool canBeUsed() const { return m_widget.isEnabled() && node().has_value(); }
    std::optional<SpokenNode> node() const {
        const std::vector<SpokenNode> nodes = m_spoken.spokenNodes();
        if (m_place >= static_cast<int>(nodes.size())) return std::nullopt;
        return nodes[static_cast<std::size_t>(m_place)];
    }

    QWidget& m_widget;
    SpokenWidget& m_spoken;
    int m_place;
};

/// A SpokenWidget. Its children are its nodes, then its widgets.
class SpokenAccess : public QAccessibleWidget {
public:
    SpokenAccess(QWidget& widget, SpokenWidget& spoken)
        : QAccessibleWidget(&widget, spoken.spokenRole()), m_spoken(spoken) {}
    ~SpokenAccess() override {
        for (const QAccessible::Id id : m_nodes) QAccessible::deleteAccessibleInterface(id);
    }

    QString text(QAccessible::Text kind) const override {
        const QString words = QAccessibleWidget::text(kind), now = m_spoken.spokenState();
        if (kind == QAccessible::Value) return now;
        if (kind != QAccessible::Description || now.isEmpty()) return words;
        return words.isEmpty() ? now : words + QStringLiteral(". ") + now;
    }
    int childCount() const override { return nodeCount() + QAccessibleWidget::childCount(); }
    QAccessibleInterface* child(int place) const override {
        const int nodes = nodeCount();
        return place >= 0 && place < nodes ? node(place) : QAccessibleWidget::child(place - nodes);
    }
    int indexOfChild(const QAccessibleInterface* child) const override {
        for (int place = 0; place < nodeCount(); ++place)
            if (node(place) == child) return place;
        const int place = QAccessibleWidget::indexOfChild(child);
        return place < 0 ? place : place + nodeCount();
    }
    QAccessibleInterface* childAt(int x, int y) const override {
        for (int place = 0; place < nodeCount(); ++place)
            if (node(place)->rect().contains(x, y)) return node(place);
        return QAccessibleWidget::childAt(x, y);
    }
    QAccessibleInterface* focusChild() const override {
        const std::vector<SpokenNode> nodes = m_spoken.spokenNodes();
        for (std::size_t place = 0; place < nodes.size(); ++place)
            if (nodes[place].isChosen && widget()->hasFocus()) return node(static_cast<int>(place));
        return QAccessibleWidget::focusChild();
    }

    QStringList actionNames() const override {
        QStringList names = QAccessibleWidget::actionNames();
        for (const SpokenAction& action : m_spoken.spokenActions()) names << action.name;
        return names;
    }
    QString localizedActionName(const QString& name) const override {
        return isSpoken(name) ? name : QAccessibleWidget::localizedActionName(name);
    }
    void doAction(const QString& name) override {
        for (const SpokenAction& action : m_spoken.spokenActions()) {
            if (action.name != name) continue;
            const QKeyCombination key = action.key[0];
            for (const QEvent::Type type : {QEvent::KeyPress, QEvent::KeyRelease}) {
                QKeyEvent event(type, key.key(), key.keyboardModifiers());
                QCoreApplication::sendEvent(widget(), &event);
            }
            return;
        }
        QAccessibleWidget::doAction(name);
    }
    QStringList keyBindingsForAction(const QString& name) const override {
        for (const SpokenAction& action : m_spoken.spokenActions())
            if (action.name == name) return {action.key.toString(QKeySequence::NativeText)};
        return QAccessibleWidget::keyBindingsForAction(name);
    }

private:
    int nodeCount() const { return static_cast<int>(m_spoken.spokenNodes().size()); }
    bool isSpoken(const QString& name) const {
        return std::ranges::any_of(m_spoken.spokenActions(),
                                   [&name](const SpokenAction& action) { return action.name == name; });
    }
    QAccessibleInterface* node(int place) const {
        while (static_cast<int>(m_nodes.size()) <= place)
            m_nodes.push_back(QAccessible::registerAccessibleInterface(
                new NodeAccess(*widget(), m_spoken, static_cast<int>(m_nodes.size()))));
        return QAccessible::accessibleInterface(m_nodes[static_cast<std::size_t>(place)]);
    }

    SpokenWidget& m_spoken;
    mutable std::vector<QAccessible::Id> m_nodes;  ///< made once asked for
};

QAccessibleInterface* makeAccess(const QString& className, QObject* object) {
    if (auto* spoken = dynamic_cast<SpokenWidget*>(object))
        return new SpokenAccess(*static_cast<QWidget*>(object), *spoken);
    if (auto* button = qobject_cast<QAbstractButton*>(object)) return new ButtonAccess(*button);
    if (className == QLatin1String("QComboBox"))
        if (auto* box = qobject_cast<QComboBox*>(object)) return new ComboBoxAccess(*box);
    if (className == QLatin1String("QLabel"))
        if (auto* label = qobject_cast<QLabel*>(object)) return new LabelAccess(*label);
    return nullptr;
}

QAccessibleInterface* nodeOf(QWidget& widget, int node) {
    if (!QAccessible::isActive()) return nullptr;
    const auto* spoken = dynamic_cast<SpokenWidget*>(&widget);
    if (spoken == nullptr || node < 0 || node >= static_cast<int>(spoken->spokenNodes().size())) return nullptr;
    QAccessibleInterface* access = QAccessible::queryAccessibleInterface(&widget);
    return access != nullptr ? access->child(node) : nullptr;
}

}  // namespace

QString spokenNameOf(int place, std::size_t nodes, const QString& where) {
    return QCoreApplication::translate("accessibility", "Node %1 of %2, %3").arg(place + 1).arg(nodes).arg(where);
}

QRect placeOfNode(QPointF centre, double reach) {
    return QRectF(centre.x() - reach, centre.y() - reach, 2 * reach, 2 * reach).toRect();
}

void watchSpokenWidgets() {
    QAccessible::removeFactory(makeAccess);
    QAccessible::installFactory(makeAccess);
}

void tellNodeChosen(QWidget& widget, int node) {
    QAccessibleInterface* access = nodeOf(widget, node);
    if (access == nullptr || !widget.hasFocus()) return;
    QAccessibleEvent chosen(access, QAccessible::Focus);
    QAccessible::updateAccessibility(&chosen);
}

void tellNodeChanged(QWidget& widget, int node) {
    QAccessibleInterface* access = nodeOf(widget, node);
    if (access == nullptr) return;
    // The name says where the node lies.
    QAccessibleEvent moved(access, QAccessible::NameChanged);
    QAccessible::updateAccessibility(&moved);
    QAccessibleValueChangeEvent changed(access, access->valueInterface()->currentValue());
    QAccessible::updateAccessibility(&changed);
}

}  // namespace echolucent
