// Which curve is rendered, and which are drawn.
#pragma once

#include <QCheckBox>
#include <QRadioButton>
#include <QWidget>
#include <array>

#include "widgets/otf_editor/otf_editor_model.h"

namespace echolucent {

/// The five curves, two in a row. Each has a radio button that renders the curve, and a check box that shows the curve
/// in the plot, with a piece of the curve's line. If a designer's OTF is rendered, one more row has the designer's
/// name; a click on any of the five curves then leaves the designer.
class CurveLegend : public QWidget {
    Q_OBJECT

public:
    explicit CurveLegend(OtfEditorModel& model, QWidget* parent = nullptr);

protected:
    void changeEvent(QEvent* event) override;

private:
    void showState();
    void showSamples();

    OtfEditorModel& m_model;
    std::array<QRadioButton*, 5> m_active{};
    std::array<QCheckBox*, 5> m_visible{};
    QRadioButton* m_designActive = nullptr;  ///< seen only while a designer's OTF is rendered, and checked then
    QCheckBox* m_designVisible = nullptr;
};

}  // namespace echolucent
