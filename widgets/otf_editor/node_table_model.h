// The manual curve's nodes as rows of exact numbers.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "processing/volume/value_scale.h"
#include "widgets/otf_editor/otf_editor_model.h"

namespace echolucent {

/// One row per node. Edits go through OtfEditorModel and its undo stack.
class NodeTableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { intensityColumn, opacityColumn, valueColumn };  ///< value: the file's own of the intensity

    explicit NodeTableModel(OtfEditorModel& model, QObject* parent = nullptr);

    void setValueWindow(const ValueWindow& window);

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    /// DisplayRole rounds, EditRole is the shortest text that reads back as the same number.
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    /// Takes text with a point or a comma. If the text is no number or out of range, returns false, and `refused` says
    /// why. Unchanged text also gives false, without a word.
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

signals:
    /// Says why an input was refused.
    void refused(const QString& reason);

private:
    struct Range {
        double lower;
        double upper;
    };
    void takeNodes();
    [[nodiscard]] double valueAt(const QModelIndex& index) const;
    [[nodiscard]] Range rangeAt(const QModelIndex& index) const;
    [[nodiscard]] QString rangeText(const QModelIndex& index) const;
    [[nodiscard]] QString roundedText(double value, const QModelIndex& index) const;

    OtfEditorModel& m_model;
    std::vector<CurveNode> m_nodes;
    ValueWindow m_values{0.0, 255.0};
};

}  // namespace echolucent
