// Section 4 of the paper in the window: two intensities, their pixels and their contrast under five curves.
#pragma once

#include <QWidget>
#include <functional>
#include <optional>

#include "processing/theory/contrast_course.h"
#include "widgets/theory/study_intensities.h"

class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace echolucent {

class FittedTable;
class PlotCanvas;
class ValueSlider;

/// Shows and edits a TheorySetting, which is the window's and no part of the document. All numbers are those of
/// processing/theory. Nothing is computed while nobody sees the panel. Objects: theory (this), theory.tissue,
/// theory.fluid, theory.fluidUnits, theory.tissueUnits, theory.scale (each + .value), theory.scaling, theory.contrast,
/// theory.axis, theory.fromStudy, theory.reset, theory.origin, theory.words, theory.table, theory.contrastPlot,
/// theory.pixelPlot, theory.curvePlot.
class TheoryPanel : public QWidget {
    Q_OBJECT

public:
    explicit TheoryPanel(QWidget* parent = nullptr);

    [[nodiscard]] const TheorySetting& setting() const { return m_setting; }
    [[nodiscard]] CourseAxis axis() const { return m_axis; }
    /// The setting is in range (problemOf()).
    void setSetting(const TheorySetting& setting);

    /// Sets who gives the shown study's values. It gives none if no adaptive OTF with a surface is there.
    void setStudy(std::function<std::optional<StudyIntensities>()> study);
    /// Call this if the study has or loses values.
    void followStudy();

protected:
    void showEvent(QShowEvent* event) override;

private:
    using Change = std::function<void(TheorySetting& setting, double value)>;
    ValueSlider* addSlider(QGridLayout& grid, const QString& label, ValueSlider* slider, const Change& change);
    void addSliders(QGridLayout& grid);
    void addChoices(QGridLayout& grid);
    QLayout* createButtons();
    FittedTable* createTable();
    void takeFromStudy();
    void showControls();
    void follow();
    void tell();
    void showTable();

    TheorySetting m_setting;
    CourseAxis m_axis = CourseAxis::depth;
    std::function<std::optional<StudyIntensities>()> m_study;
    bool m_stale = true;  ///< words, table and plots are not those of the setting
    ValueSlider *m_tissue = nullptr, *m_fluid = nullptr, *m_fluidUnits = nullptr, *m_tissueUnits = nullptr,
                *m_scale = nullptr;
    QComboBox *m_scaling = nullptr, *m_contrast = nullptr, *m_axisChoice = nullptr;
    QPushButton* m_fromStudy = nullptr;
    QLabel *m_origin = nullptr, *m_words = nullptr;
    FittedTable* m_table = nullptr;
    PlotCanvas *m_contrastPlot = nullptr, *m_pixelPlot = nullptr, *m_curvePlot = nullptr;
};

}  // namespace echolucent
