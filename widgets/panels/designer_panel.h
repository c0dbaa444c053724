// The panel of OTF designers: which one makes the OTF, its parameters, and what it says of its OTF.
#pragma once

#include <QString>
#include <QWidget>
#include <optional>

#include "processing/designers/choice/designer_config.h"
#include "processing/designers/design.h"

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
/// designer.progress, designer.cancel, designer.compute, designer.message,
/// designer.explanation, designer.facts, designer.plot (which one) and designer.plot.canvas.
class DesignerPanel : public QWidget {
    Q_OBJECT

public:
    explicit DesignerPanel(QWidget* parent = nullptr);

    /// Shows a designer's config; without a value a curve is rendered. Emits nothing.
    void setConfig(const std::optional<DesignerConfig>& config);
    /// Shows a finished OTF and the time it took. `design` is null if there is none yet.
    void setDesign(const Design* design, double milliseconds);
    /// `computing`: an OTF is being computed. `refused`: one was cancelled or has failed, for this view or for a pane
    /// beside it.
    void setComputing(bool computing, bool refused);
    /// Share done, in [0,1].
    void setProgress(double share);

signals:
    /// A person chose a designer, or a curve (no value).
    void chosen(std::optional<echolucent::Designer> designer);
    /// A person changed something; `what` names the step.
    void configChanged(const echolucent::DesignerConfig& config, const QString& what);
    /// A drag changed something. More may follow, until dragEnded() or dragCancelled().
    void configPreviewed(const echolucent::DesignerConfig& config, const QString& what);
    void dragEnded();
    void dragCancelled();
    void cancelRequested();
    /// A person asks for the OTF that was cancelled.
    void computeRequested();

private:
    void makeChoice();
    void makeProgress();
    void makeWords();
    void makePlots();
    void makeEmphasis();
    void showParts();
    void showPlot();
    void showFacts(const Design& design, double milliseconds);
    void resetParameters();
    void pick(double intensity);
    void changeEmphasis(const std::vector<EmphasisNode>& nodes, const QString& what, bool preview);
    [[nodiscard]] QString nameOfDesigner() const;

    std::optional<DesignerConfig> m_config;
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
