// The panel of the comparison, with the document behind it.
#pragma once

#include <QObject>

#include "app/study/open_study.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/document/document_model.h"

namespace echolucent {

/// Shows what is compared, and makes steps of what is chosen.
class CompareControls : public QObject {
    Q_OBJECT

public:
    /// All of them must outlive this.
    CompareControls(DocumentModel& model, OpenStudy& openStudy, ComparePanel& panel, QObject* parent = nullptr);

    /// Where nothing is compared yet, makes the standard comparison a step.
    void begin();

private:
    void show();

    DocumentModel& m_model;
    OpenStudy& m_openStudy;
    ComparePanel& m_panel;
};

}  // namespace echolucent
