// The sliders that move the rendered curve, with the document behind them.
#pragma once

#include <QObject>

#include "widgets/document/document_model.h"
#include "widgets/hand_gesture.h"
#include "widgets/otf_editor/otf_editor.h"
#include "widgets/panels/curve_sliders.h"

namespace echolucent {

class CurveControls : public QObject {
    Q_OBJECT

public:
    /// All of them must outlive this.
    CurveControls(DocumentModel& model, HandGesture& hand, CurveSliders& sliders, OtfEditor& editor,
                  QObject* parent = nullptr);
};

}  // namespace echolucent
