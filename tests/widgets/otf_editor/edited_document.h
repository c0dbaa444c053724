// The OTF editor and its model on their own document.
#pragma once

#include "widgets/otf_editor/otf_editor.h"

namespace echolucent {

inline const ManualCurve threeNodes{{{0.2, 0.1}, {0.5, 0.4}, {0.9, 0.8}}};

struct EditedDocument {
    DocumentModel document;

    /// Begins a document of these curves, without steps.
    void begin(const OtfEditorState& state) {
        Document next;
        next.curves = state;
        next.panes.at(firstPane).curve = state.active;
        document.begin(next);
    }
    static void showIn(OtfEditorModel& model, const OtfEditorState& state) {
        model.setAdaptiveCurve(state.adaptive);
        for (const CurveKind kind : allCurveKinds) model.setVisible(kind, state.visible[indexOf(kind)]);
        model.setManualSaved();
        model.selectNode(-1);
    }
};

class EditedModel : private EditedDocument, public OtfEditorModel {
public:
    EditedModel() : OtfEditorModel(document) {}
    /// Begins a document of these curves. Its steps are forgotten, and the manual curve counts as saved.
    void setState(const OtfEditorState& state) {
        begin(state);
        showIn(*this, state);
    }
};

class EditedEditor : private EditedDocument, public OtfEditor {
public:
    EditedEditor() : OtfEditor(document) {}
    void setState(const OtfEditorState& state) {
        begin(state);
        showIn(model(), state);
    }
};

}  // namespace echolucent
