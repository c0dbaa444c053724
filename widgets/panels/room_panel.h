// Planes, render box and scalpel as names and numbers.
#pragma once

#include <QWidget>
#include <array>
#include <optional>

#include "widgets/document/document_model.h"

class QAbstractButton;
class QCheckBox;
class QDoubleSpinBox;
class QGroupBox;
class QListWidget;
class QPushButton;
class QVBoxLayout;

namespace echolucent {

/// How the scalpel cuts, with any of its tools.
struct ScalpelSettings {
    ScalpelSide side = ScalpelSide::inside;
    double eraserMm = 4.0;            ///< diameter of the eraser, above 0
    std::optional<double> depthMm{};  ///< behind what is seen; no value: through everything
    friend bool operator==(const ScalpelSettings&, const ScalpelSettings&) = default;
};

/// Objects: room.quiet, room.linesIn3d, room.turnsView, room.window (+ .value), room.level (+ .value),
/// room.resetPlanes; room.box, room.width, room.depth, room.height, room.wholeBox,
/// room.slab.thickness, room.slab.a, .b, .c; room.scalpel.freehand … .eraser, room.scalpel.inside, .outside,
/// room.scalpel.size, .limited, .limit, room.scalpel.strokes, .takeBack, .takeAllBack. The panel shows the document. It
/// changes the planes itself, but for their reset, and asks for all other changes. No setter emits a signal.
class RoomPanel : public QWidget {
    Q_OBJECT

public:
    /// The document outlives the panel.
    explicit RoomPanel(DocumentModel& document, QWidget* parent = nullptr);

    /// The unit of a volume in mm, and whether lengths in mm are known.
    void setUnit(double unitMm, bool known);
    void setTool(std::optional<ScalpelTool> tool);
    [[nodiscard]] ScalpelSettings scalpel() const;

signals:
    void planesResetRequested();
    void boxSwitched(bool on);
    /// Axis 0 goes from left to right, 1 from far to near, 2 from top to bottom. In mm.
    void boxSizeChanged(int axis, double mm);
    void wholeBoxRequested();
    void slabRequested(echolucent::PlaneName plane, double thicknessMm);
    void toolChosen(std::optional<echolucent::ScalpelTool> tool);
    void strokeTakenBack(int stroke);  ///< its place in the list
    void allStrokesTakenBack();

private:
    QGroupBox* createPlanes();
    QGroupBox* createBox();
    QGroupBox* createScalpel();
    void addSizes(QVBoxLayout& column);
    void addSlab(QVBoxLayout& column);
    void addTools(QVBoxLayout& column);
    void addStrokes(QVBoxLayout& column);
    void showBox();
    void showStrokes();
    void updateEnabled();

    DocumentModel& m_document;
    QCheckBox* m_box = nullptr;
    std::array<QDoubleSpinBox*, 3> m_sizes{};
    QDoubleSpinBox* m_slab = nullptr;
    std::array<QAbstractButton*, 4> m_tools{};
    QAbstractButton* m_outside = nullptr;
    QDoubleSpinBox* m_eraser = nullptr;
    QCheckBox* m_limited = nullptr;
    QDoubleSpinBox* m_limit = nullptr;
    QListWidget* m_strokes = nullptr;
    QPushButton* m_takeBack = nullptr;
    QPushButton* m_takeAllBack = nullptr;
};

}  // namespace echolucent
