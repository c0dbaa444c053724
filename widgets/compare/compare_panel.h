// The panes of a comparison, its layout, and the table of its measures.
#pragma once

#include <QStringList>
#include <QWidget>
#include <array>
#include <vector>

#include "processing/document/panes.h"
#include "widgets/compare/compare_table.h"
#include "widgets/compare/pane_words.h"

class QAction;
class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QGroupBox;
class QLabel;
class QSpinBox;
class QToolButton;

namespace echolucent {

class DesignerParameters;
class ReadingParameters;

/// Objects: compare (this), compare.switch, compare.count, compare.otf1 … 4, compare.tube1 … 4, compare.phase2 … 4,
/// compare.motion2 … 4, compare.method2 … 4, compare.parameters1 … 4 (a switch), compare.pane1.NAME … (a control for
/// each parameter of the pane's designer), compare.method2.NAME … (sliders of the adaptive method, for this pane
/// alone), compare.layout, compare.first, compare.second, compare.amplification, compare.colours, compare.insets, and
/// those of CompareTable. No setter emits a signal.
class ComparePanel : public QWidget {
    Q_OBJECT

public:
    explicit ComparePanel(QWidget* parent = nullptr);

    /// The button on top begins and ends the comparison, as this action does, which outlives the panel.
    void setSwitch(QAction& compares);
    /// The panes compared, and their names. Without a pane, a person can set nothing but the number of panes.
    void setPanes(const std::vector<Pane>& panes, const QStringList& names);
    void setComparison(const Comparison& comparison);
    /// Limits of the study and the method, for the choices that depend on them.
    void setLimits(int phases, const AdaptiveOtfConfig& method);
    void setRows(const std::vector<CompareRow>& rows) { m_table->setRows(rows); }
    [[nodiscard]] const std::vector<CompareRow>& rows() const { return m_table->rows(); }
    /// Whether the flicker is being measured.
    void setMeasuringFlicker(bool measuring);

signals:
    void countChosen(int count);
    void paneChosen(int place, const echolucent::Pane& choice);
    /// Layout, pair, amplification or colours.
    void comparisonChosen(const echolucent::Comparison& comparison, const QString& what);
    /// Whether each pane shows its OTF.
    void insetsSwitched(bool shown);
    void flickerRequested();
    void pageRequested();

private:
    struct PaneControls {
        QLabel* label = nullptr;
        QComboBox* otf = nullptr;
        QSpinBox* tube = nullptr;
        QComboBox* motion = nullptr;
        QSpinBox* phase = nullptr;
        QComboBox* method = nullptr;
        QToolButton* edits = nullptr;  ///< switches `parameters` or `reading`
        DesignerParameters* parameters = nullptr;
        ReadingParameters* reading = nullptr;  ///< of the adaptive method; null in the first pane, which has none
    };
    QGroupBox* createPanes();
    QGroupBox* createLayout();
    void choose(std::size_t place);
    void choosePhase(std::size_t place);
    void chooseMethod(std::size_t place);
    void takeMethod(std::size_t place, AdaptiveOtfConfig method);
    void showParameters(std::size_t place);
    void chooseComparison(const QString& what);
    void showAll();

    std::vector<Pane> m_panes;
    QStringList m_names;
    Comparison m_comparison;
    int m_phases = 1;
    AdaptiveOtfConfig m_method;  ///< the document's
    bool m_measuring = false;
    QToolButton* m_switch = nullptr;
    QSpinBox* m_count = nullptr;
    std::array<PaneControls, mostPanes> m_controls{};
    QComboBox* m_layout = nullptr;
    QComboBox* m_first = nullptr;
    QComboBox* m_second = nullptr;
    QDoubleSpinBox* m_amplification = nullptr;
    QCheckBox* m_colours = nullptr;
    QGroupBox* m_layoutGroup = nullptr;
    CompareTable* m_table = nullptr;
};

}  // namespace echolucent
