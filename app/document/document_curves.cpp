#include "app/document/document_curves.h"

#include <utility>

namespace echolucent {

DocumentCurves::DocumentCurves(DocumentModel& model, QObject* parent) : CurveOwner(parent), m_model(model) {
    connect(&m_model, &DocumentModel::curvesChanged, this, &CurveOwner::changed);
    connect(&m_model, &DocumentModel::panesChanged, this, &CurveOwner::changed);
}

EditedCurves DocumentCurves::edited() const {
    const Pane& pane = m_model.document().panes.at(firstPane);
    return {m_model.document().curves, pane.curve, pane.designer.has_value()};
}

void DocumentCurves::edit(const EditedCurves& next, const QString& what, int gesture) {
    m_model.edit(with(next), what, gesture);
}

void DocumentCurves::preview(const EditedCurves& next, const QString& what) { m_model.preview(with(next), what); }

Document DocumentCurves::with(const EditedCurves& edited) const {
    Document document = m_model.document();
    document.curves = edited.curves;
    if (!edited.designed) return withCurve(std::move(document), firstPane, edited.active);
    document.panes.at(firstPane).curve = edited.active;
    return document;
}

}  // namespace echolucent
