// Which curve is rendered, and which are drawn.
#pragma once

#include <QCheckBox>
#include <QRadioButton>
#include <QWidget>
#include <array>

#include "widgets/otf_editor/otf_editor_model.h"

namespace echolucent {

/// A column per curve: a radio button renders it, a check box beside a piece of its line draws it. While a designer's
/// OTF is rendered, a row below has its name. Choosing one of the five leaves it.
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
    QRadioButton* m_designActive = nullptr;  ///< seen only while a designer's OTF is rendered; it is checked then
    QCheckBox* m_designVisible = nullptr;
};

}  // namespace echolucent
