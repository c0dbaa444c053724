// The document's curves and the curve of the first pane, as the OTF editor edits them.
#pragma once

#include "widgets/document/document_model.h"
#include "widgets/otf_editor/curve_owner.h"

namespace echolucent {

class DocumentCurves : public CurveOwner {
    Q_OBJECT

public:
    DocumentCurves(DocumentModel& model, QObject* parent = nullptr);

    [[nodiscard]] EditedCurves edited() const override;
    [[nodiscard]] DocumentSteps& steps() override { return m_model.steps(); }
    void edit(const EditedCurves& next, const QString& what, int gesture) override;
    void preview(const EditedCurves& next, const QString& what) override;
    void commitPreview() override { m_model.commitPreview(); }
    void cancelPreview() override { m_model.cancelPreview(); }
    [[nodiscard]] bool previewing() const override { return m_model.previewing(); }

private:
    [[nodiscard]] Document with(const EditedCurves& edited) const;

    DocumentModel& m_model;
};

}  // namespace echolucent
