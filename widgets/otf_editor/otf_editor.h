// The panel that shows and edits opacity transfer functions.
#pragma once

#include <QAction>
#include <QWidget>
#include <array>
#include <optional>

#include "processing/comparison/early_light.h"
#include "processing/intensity/histogram.h"
#include "processing/volume/value_scale.h"
#include "widgets/otf_editor/otf_editor_model.h"
#include "widgets/paced_words.h"

class QCheckBox;
class QLabel;
class QMenu;
class QStackedWidget;

namespace echolucent {

class CurveCanvas;
class NodeTable;

/// Holds the plot, the legend, the numbers of the active curve and the node table. The editor reads and writes no
/// files: whoever receives openCurveRequested and saveCurveRequested does.
///
/// The editor's actions have their shortcuts from the table of keys. The shortcuts work in the whole window: put the
/// actions into menus, and give their keys to nothing else.
class OtfEditor : public QWidget {
    Q_OBJECT

public:
    /// The document outlives the editor.
    explicit OtfEditor(DocumentModel& document, QWidget* parent = nullptr);
    ~OtfEditor() override;

    [[nodiscard]] const OtfEditorState& state() const { return m_model.state(); }

    /// The curve to render now. activeCurveChanged tells of each later one.
    [[nodiscard]] OpacityCurve activeCurve() const { return m_model.activeCurve(); }
    void setActive(CurveKind kind) { m_model.setActive(kind); }
    void setAdaptiveCurve(const SampledCurve& curve);
    /// As OtfEditorModel::setDesign().
    void setDesign(const QString& designer, const std::optional<OpacityCurve>& upper);
    /// While a motion plays, the table of the adaptive curve's numbers changes only as often as PacedWords says.
    void setPlaying(bool playing);
    void setHistogram(const IntensityHistogram& histogram);
    /// Whether a person wants to see at which intensities light is held back early. Off at first.
    [[nodiscard]] bool showsEarlyLight() const;
    void setShowsEarlyLight(bool shows);
    /// Shows it in the plot; no value shows none.
    void setEarlyLight(const std::optional<EarlyLight>& light);
    /// The file's values at intensities 0 and 1, which stand beside intensities. If they are 0 and 1, they do not.
    void setValueWindow(const ValueWindow& window);
    /// Marks the intensity under the cursor in the 3D view. No value removes the mark.
    void setCursorIntensity(std::optional<double> intensity);

    /// Takes a curve read from a file as the manual one and makes it active, in one undo step. The curve counts as
    /// saved.
    void openManualCurve(const ManualCurve& curve);
    [[nodiscard]] bool isManualModified() const { return m_model.isManualModified(); }
    /// Call this after the present manual curve has been written.
    void setManualSaved() { m_model.setManualSaved(); }

    [[nodiscard]] OtfEditorModel& model() { return m_model; }
    [[nodiscard]] DocumentSteps& steps() { return m_model.steps(); }
    [[nodiscard]] CurveCanvas& canvas() { return *m_canvas; }

    [[nodiscard]] QAction* undoAction() const { return m_undo; }
    [[nodiscard]] QAction* redoAction() const { return m_redo; }
    [[nodiscard]] QAction* resetAction() const { return m_reset; }
    [[nodiscard]] QAction* copyAdaptiveAction() const { return m_copyAdaptive; }
    [[nodiscard]] QAction* openCurveAction() const { return m_openCurve; }
    [[nodiscard]] QAction* saveCurveAction() const { return m_saveCurve; }
    [[nodiscard]] QMenu* presetsMenu() const { return m_presets; }
    /// Checkable. One of them is checked, but none while a designer's OTF is rendered. Keys 1 to 5.
    [[nodiscard]] QAction* activateAction(CurveKind kind) const { return m_activate[indexOf(kind)]; }

signals:
    /// As OtfEditorModel::activeCurveChanged.
    void activeCurveChanged(const echolucent::OpacityCurve& curve);
    /// showsEarlyLight() has changed.
    void earlyLightSwitched();
    void openCurveRequested();
    /// The person wants to save the curve that is shown.
    void saveCurveRequested();

protected:
    void changeEvent(QEvent* event) override;

private:
    void makeActions();
    void makePresets();
    void connectModel();
    [[nodiscard]] QLayout* makeToolRow();
    [[nodiscard]] QStackedWidget* makePages();
    [[nodiscard]] QWidget* makeAdaptivePage();
    [[nodiscard]] QWidget* makeManualPage();
    [[nodiscard]] QWidget* makeDesignPage();
    [[nodiscard]] QString renderedName() const;
    [[nodiscard]] QLayout* makeFileRow();
    void fitLetters();
    void paintIcons();
    void showState();
    void showAdaptiveFacts();
    [[nodiscard]] QString adaptiveFacts() const;
    [[nodiscard]] QString intensityText(double intensity) const;
    void showHovered(std::optional<CurveNode> value, int node);
    void showReadout();

    OtfEditorModel m_model;
    CurveCanvas* m_canvas = nullptr;
    NodeTable* m_nodeTable = nullptr;
    QCheckBox* m_earlyLight = nullptr;
    QStackedWidget* m_pages = nullptr;
    QLabel* m_readout = nullptr;
    QLabel* m_adaptiveNote = nullptr;
    QLabel* m_designNote = nullptr;
    QMenu* m_presets = nullptr;
    QAction* m_undo = nullptr;
    QAction* m_redo = nullptr;
    QAction* m_reset = nullptr;
    QAction* m_copyAdaptive = nullptr;
    QAction* m_openCurve = nullptr;
    QAction* m_saveCurve = nullptr;
    QAction* m_addNode = nullptr;
    QAction* m_deleteNode = nullptr;
    std::array<QAction*, 5> m_activate{};
    std::optional<CurveNode> m_hovered;
    int m_hoveredNode = -1;
    bool m_playing = false;
    PacedWords m_adaptiveFacts{[this] { showAdaptiveFacts(); }};
    std::optional<double> m_cursorIntensity;
    ValueWindow m_values{0.0, 255.0};
};

}  // namespace echolucent
