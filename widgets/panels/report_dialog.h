// Asks what a case report is to hold.
#pragma once

#include <QDialog>

class QCheckBox;

namespace echolucent {

/// Objects: report (this), report.patient (off each time), report.note (where there is one), report.save,
/// report.cancel.
class ReportDialog : public QDialog {
    Q_OBJECT

public:
    /// `patientKnown`: the study is one of DICOM, so that its files may say whose it is. `note`: a sentence to be read
    /// before the report is saved; empty where there is none.
    ReportDialog(bool patientKnown, const QString& note, QWidget* parent = nullptr);

    /// Whether the person wants the patient in the report.
    [[nodiscard]] bool withPatient() const;

private:
    QCheckBox* m_patient;
};

}  // namespace echolucent
