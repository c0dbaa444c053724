// The panel of OTF designers: which one makes the OTF, its parameters, and what it says of its OTF.
#pragma once

#include <QString>
#include <QWidget>
#include <optional>

#include "processing/designers/choice/designer_config.h"
#include "processing/designers/design.h"
#include "processing/volume/value_scale.h"
#include "widgets/document/document_model.h"

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;
class QToolButton;

namespace echolucent {

class DesignerParameters;
class DesignPlotCanvas;
class EmphasisCanvas;

/// Objects: designer.choice, designer.reset, the parameters (DesignerParameters), designer.emphasis.canvas,
/// designer.progress, designer.cancel, designer.compute, designer.message, designer.explanation, designer.facts,
/// designer.plot (which one) and designer.plot.canvas. The panel shows the designer of the document's first pane. What
/// a person chooses becomes a step of the document. The window tells the panel what was made.
class DesignerPanel : public QWidget {
    Q_OBJECT

public:
    /// The document outlives the panel.
    explicit DesignerPanel(DocumentModel& document, QWidget* parent = nullptr);

    /// Shows a finished OTF and the time it took. `design` is null if there is none yet.
    void setDesign(const Design* design, double milliseconds);
    /// `computing`: an OTF is being computed. `refused`: one was cancelled or has failed, for this view or for a pane
    /// beside it.
    void setComputing(bool computing, bool refused);
    /// Share done, in [0,1].
    void setProgress(double share);
    /// The file's values at intensities 0 and 1.
    void setValueWindow(const ValueWindow& window);

signals:
    /// A person cancels the designer.
    void cancelRequested();
    /// A person asks for the OTF that was cancelled or has failed.
    void computeRequested();

private:
    void makeChoice();
    void makeProgress();
    void makeWords();
    void makePlots();
    void makeEmphasis();
    void choose();
    void showConfig(const DesignerConfig* config);
    void take(const DesignerConfig& config, const QString& what, bool dragging = false);
    void showParts();
    void showPlot();
    void showFacts(const Design& design, double milliseconds);
    void resetParameters();
    void pick(double intensity);
    void changeEmphasis(const std::vector<EmphasisNode>& nodes, const QString& what, bool preview);
    [[nodiscard]] QString nameOfDesigner() const;

    DocumentModel& m_document;
    std::optional<DesignerConfig> m_config;  ///< of the designer shown; no value: a curve is rendered
    std::vector<DesignPlot> m_plots;
    QComboBox* m_choice = nullptr;
    QToolButton* m_reset = nullptr;
    DesignerParameters* m_parameters = nullptr;
    EmphasisCanvas* m_emphasis = nullptr;
    QWidget* m_computing = nullptr;
    QProgressBar* m_progress = nullptr;
    QToolButton* m_cancel = nullptr;
    QPushButton* m_compute = nullptr;
    QLabel* m_message = nullptr;
    QLabel* m_explanation = nullptr;
    QLabel* m_facts = nullptr;
    QComboBox* m_plot = nullptr;
    QLabel* m_plotHint = nullptr;
    DesignPlotCanvas* m_canvas = nullptr;
};

}  // namespace echolucent
