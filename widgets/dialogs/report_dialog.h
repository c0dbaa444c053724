// Asks what a case report shall hold.
#pragma once

#include <QDialog>

class QCheckBox;

namespace echolucent {

/// Objects: report (this), report.patient (off each time), report.note (if there is one), report.save, report.cancel.
class ReportDialog : public QDialog {
    Q_OBJECT

public:
    /// `patientKnown`: it is a DICOM study, whose files may name the patient. `note`: a sentence to read before saving;
    /// empty if there is none.
    ReportDialog(bool patientKnown, const QString& note, QWidget* parent = nullptr);

    /// Whether the person wants the patient in the report.
    [[nodiscard]] bool withPatient() const;

private:
    QCheckBox* m_patient;
};

}  // namespace echolucent
