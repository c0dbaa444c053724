#include "widgets/otf_editor/node_table_model.h"

#include <QLocale>
#include <algorithm>
#include <optional>
#include <string>

#include "processing/parameters/typed_number.h"
#include "processing/volume/value_digits.h"
#include "widgets/controls/number_box.h"

namespace echolucent {

namespace {

QString exactText(double value) { return QString::number(value, 'g', QLocale::FloatingPointShortest); }

}  // namespace

NodeTableModel::NodeTableModel(OtfEditorModel& model, QObject* parent)
    : QAbstractTableModel(parent), m_model(model), m_nodes(model.state().manual.nodes) {
    connect(&m_model, &OtfEditorModel::manualEdited, this, &NodeTableModel::takeNodes);
}

void NodeTableModel::setValueWindow(const ValueWindow& window) {
    m_values = window;
    if (!m_nodes.empty()) emit dataChanged(index(0, valueColumn), index(rowCount() - 1, valueColumn));
}

void NodeTableModel::takeNodes() {
    const std::vector<CurveNode>& nodes = m_model.state().manual.nodes;
    if (nodes.size() != m_nodes.size()) {
        beginResetModel();
        m_nodes = nodes;
        endResetModel();
        return;
    }
    m_nodes = nodes;
    if (!m_nodes.empty()) emit dataChanged(index(0, 0), index(rowCount() - 1, valueColumn));
}

int NodeTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_nodes.size());
}

int NodeTableModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : 3; }

double NodeTableModel::valueAt(const QModelIndex& index) const {
    const CurveNode& node = m_nodes[static_cast<std::size_t>(index.row())];
    if (index.column() == opacityColumn) return node.opacity;
    return index.column() == valueColumn ? m_values.valueAt(node.intensity) : node.intensity;
}

NodeTableModel::Range NodeTableModel::rangeAt(const QModelIndex& index) const {
    if (index.column() == opacityColumn) return {0.0, 1.0};
    const ValueWindow values = index.column() == valueColumn ? m_values : ValueWindow{};
    const auto row = static_cast<std::size_t>(index.row());
    return {values.valueAt(row > 0 ? m_nodes[row - 1].intensity : 0.0),
            values.valueAt(row + 1 < m_nodes.size() ? m_nodes[row + 1].intensity : 1.0)};
}

QString NodeTableModel::rangeText(const QModelIndex& index) const {
    const Range range = rangeAt(index);
    const int digits = index.column() == valueColumn ? digitsToTell(m_values, 4) : 4;
    return tr("%1 of node %2 lies between %3 and %4")
        .arg(headerData(index.column(), Qt::Horizontal, Qt::DisplayRole).toString())
        .arg(index.row() + 1)
        .arg(QString::number(range.lower, 'g', digits), QString::number(range.upper, 'g', digits));
}

/// Four decimals; for the file's values six digits or more, without trailing zeros.
QString NodeTableModel::roundedText(double value, const QModelIndex& index) const {
    if (index.column() != valueColumn) return QString::number(value, 'f', 4);
    return QString::number(value, 'g', digitsToTell(m_values, 6));
}

QVariant NodeTableModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || index.row() >= rowCount()) return {};
    switch (role) {
        case Qt::DisplayRole: return roundedText(valueAt(index), index);
        case Qt::EditRole: return exactText(valueAt(index));
        case Qt::ToolTipRole: return rangeText(index);
        case Qt::TextAlignmentRole: return QVariant::fromValue(Qt::Alignment(Qt::AlignRight | Qt::AlignVCenter));
        default: return {};
    }
}

bool NodeTableModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid()) return false;
    const QString text = value.toString().trimmed();
    if (text == exactText(valueAt(index))) return false;  // the person looked at it and changed nothing
    const std::string typed = plainNumberText(text);
    const Range range = rangeAt(index);
    const ParameterRange allowed{range.lower, range.upper};
    const std::optional<double> number = numberTyped(typed, allowed);
    if (!number) {
        emit refused(isDoubtful(typed, allowed)
                         ? tr("\"%1\" has two meanings. %2").arg(text, QString::fromStdString(remedyOfDoubt(typed)))
                         : rangeText(index));
        return false;
    }
    CurveNode node = m_nodes[static_cast<std::size_t>(index.row())];
    switch (index.column()) {
        case intensityColumn: node.intensity = *number; break;
        case opacityColumn: node.opacity = *number; break;
        default: node.intensity = std::clamp(m_values.intensityOf(*number), 0.0, 1.0);
    }
    m_model.moveNode(index.row(), node);
    return true;
}

QVariant NodeTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role == Qt::TextAlignmentRole && orientation == Qt::Horizontal)
        return QVariant::fromValue(Qt::Alignment(Qt::AlignRight | Qt::AlignVCenter));
    if (role != Qt::DisplayRole) return {};
    if (orientation == Qt::Vertical) return section + 1;
    switch (section) {
        case intensityColumn: return tr("Intensity");
        case opacityColumn: return tr("Opacity");
        default: return tr("Value");
    }
}

Qt::ItemFlags NodeTableModel::flags(const QModelIndex& index) const {
    return QAbstractTableModel::flags(index) | Qt::ItemIsEditable;
}

}  // namespace echolucent
