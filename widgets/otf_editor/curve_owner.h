// Where the curves live that the OTF editor shows.
#pragma once

#include <QObject>
#include <QString>

#include "processing/document/curve_set.h"
#include "widgets/document/document_steps.h"

namespace echolucent {

/// What the editor edits: the curves and which of them is rendered.
struct EditedCurves {
    CurveSet curves;
    CurveKind active = CurveKind::adaptive;
    bool designed =
        false;  ///< the OTF of a designer is rendered in the active curve's place; leaving it makes it false
    friend bool operator==(const EditedCurves&, const EditedCurves&) = default;
};

/// Keeps the curves and the steps of their edits; in the program that is the document.
class CurveOwner : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    [[nodiscard]] virtual EditedCurves edited() const = 0;
    [[nodiscard]] virtual DocumentSteps& steps() = 0;
    /// One step named `what`; edits of one gesture (not 0) and name become one step.
    virtual void edit(const EditedCurves& next, const QString& what, int gesture) = 0;
    /// Shows `next` without a step, until it is committed as one or cancelled, or an undo ends it.
    virtual void preview(const EditedCurves& next, const QString& what) = 0;
    virtual void commitPreview() = 0;
    virtual void cancelPreview() = 0;
    [[nodiscard]] virtual bool previewing() const = 0;

signals:
    /// edited() may be another.
    void changed();
};

}  // namespace echolucent
