// The panel of the comparison, with the document behind it.
#pragma once

#include <QObject>

#include "app/study/open_study.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/document/document_model.h"

namespace echolucent {

/// The panel shows what is compared. Choices in the panel become steps.
class CompareControls : public QObject {
    Q_OBJECT

public:
    /// What the parameters refer to must outlive this object.
    CompareControls(DocumentModel& model, OpenStudy& openStudy, ComparePanel& panel, QObject* parent = nullptr);

    /// If nothing is compared yet, compares mostPanes panes. That is one step.
    void begin();

private:
    void show();

    DocumentModel& m_model;
    OpenStudy& m_openStudy;
    ComparePanel& m_panel;
};

}  // namespace echolucent
