#include "app/document/document_curves.h"

#include <utility>

namespace echolucent {

DocumentCurves::DocumentCurves(DocumentModel& model, int view, QObject* parent)
    : CurveOwner(parent), m_model(model), m_view(view) {
    connect(&m_model, &DocumentModel::curvesChanged, this, &CurveOwner::changed);
    connect(&m_model, &DocumentModel::viewsChanged, this, &CurveOwner::changed);
}

EditedCurves DocumentCurves::edited() const {
    const View& view = viewOf(m_model.document(), m_view);
    return {m_model.document().curves, view.curve, view.design != 0};
}

void DocumentCurves::edit(const EditedCurves& next, const QString& what, int gesture) {
    m_model.edit(with(next), what, gesture);
}

void DocumentCurves::preview(const EditedCurves& next, const QString& what) { m_model.preview(with(next), what); }

Document DocumentCurves::with(const EditedCurves& edited) const {
    Document document = m_model.document();
    document.curves = edited.curves;
    if (!edited.designed) return withCurve(std::move(document), m_view, edited.active);
    viewOf(document, m_view).curve = edited.active;
    return document;
}

}  // namespace echolucent
