#include "widgets/dialogs/report_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/controls/panel_controls.h"

namespace echolucent {

ReportDialog::ReportDialog(bool patientKnown, const QString& note, QWidget* parent)
    : QDialog(parent),
      m_patient(named(new QCheckBox(tr("With the &patient's name and data")), "report.patient",
                      tr("With the patient's name and data"))) {
    setObjectName("report");
    setAccessibleName(tr("Case report"));
    setWindowTitle(tr("Case report"));
    auto* what = new QLabel(
        tr("One page that opens without a network: the panes as they are on the screen, measurements, curves, "
           "parameters, import report and timings."));
    what->setWordWrap(true);
    auto* patientLine = secondaryLabel(
        patientKnown ? tr("Name, identification, date of birth, sex and date of the study are read from the files "
                          "for this page alone.")
                     : tr("Only files of DICOM say whose study it is."));
    patientLine->setWordWrap(true);
    m_patient->setEnabled(patientKnown);
    auto* buttons = new QDialogButtonBox;
    auto* save = buttons->addButton(tr("&Save…"), QDialogButtonBox::AcceptRole);
    auto* cancel = buttons->addButton(QDialogButtonBox::Cancel);
    named(save, "report.save", tr("Save the case report"));
    named(cancel, "report.cancel", tr("Cancel"));
    for (QAbstractButton* button : buttons->buttons()) button->setIcon({});
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(what);
    layout->addSpacing(6);
    layout->addWidget(m_patient);
    layout->addWidget(patientLine);
    if (!note.isEmpty()) {
        layout->addSpacing(6);
        layout->addWidget(noteLabel(note, "report.note"));
    }
    layout->addSpacing(6);
    layout->addWidget(buttons);
    setMinimumWidth(460);
    save->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

bool ReportDialog::withPatient() const { return m_patient->isChecked(); }

}  // namespace echolucent
