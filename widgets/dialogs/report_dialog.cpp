#include "widgets/dialogs/report_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {

constexpr int linesOfText = 4;
constexpr int longestField = 100;  // letters

QPlainTextEdit* textField(const QString& objectName, const QString& words, const QString& text) {
    auto* field = named(new QPlainTextEdit(text), objectName, words);
    field->setTabChangesFocus(true);
    field->setFixedHeight(linesOfText * field->fontMetrics().lineSpacing() + 14);
    return field;
}

}  // namespace

ReportDialog::ReportDialog(const Facts& facts, QWidget* parent)
    : QDialog(parent),
      m_facts(facts),
      m_impression(textField("report.impression", tr("Impression"), facts.impression)),
      m_comment(textField("report.comment", tr("Comment"), facts.comment)),
      m_patient(named(new QCheckBox(tr("With the &patient's name and data")), "report.patient",
                      tr("With the patient's name and data"))),
      m_patientLine(named(secondaryLabel(), "report.patientLine", tr("About the patient's data"))) {
    setObjectName("report");
    setAccessibleName(tr("Case report"));
    setWindowTitle(tr("Case report"));
    auto* what = new QLabel(
        tr("One page: the panes as they are on the screen, measurements, impression and comment. Its appendix holds "
           "the rest. The file opens without a network."));
    what->setWordWrap(true);
    m_patientLine->setWordWrap(true);
    m_patientLine->setTextFormat(Qt::PlainText);
    createFields();
    auto* buttons = new QDialogButtonBox;
    auto* save = buttons->addButton(tr("&Save…"), QDialogButtonBox::AcceptRole);
    auto* cancel = buttons->addButton(QDialogButtonBox::Cancel);
    named(save, "report.save", tr("Save the case report"));
    named(cancel, "report.cancel", tr("Cancel"));
    for (QAbstractButton* button : buttons->buttons()) button->setIcon({});
    auto* form = new QFormLayout;
    form->addRow(labelFor(m_impression, tr("&Impression")), m_impression);
    form->addRow(labelFor(m_comment, tr("&Comment")), m_comment);
    form->addRow(m_patient);
    const std::array labels{tr("Name"), tr("Identification"), tr("Date of birth"), tr("Sex")};
    for (std::size_t i = 0; i < m_fields.size(); ++i) form->addRow(labelFor(m_fields[i], labels[i]), m_fields[i]);
    form->addRow(m_patientLine);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(what);
    layout->addLayout(form);
    if (!facts.note.isEmpty()) layout->addWidget(noteLabel(facts.note, "report.note"));
    layout->addWidget(buttons);
    setMinimumWidth(520);
    save->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(m_patient, &QCheckBox::toggled, this, &ReportDialog::takeSwitch);
    takeSwitch(false);
}

void ReportDialog::createFields() {
    const std::array names{"report.patientName", "report.patientId", "report.patientBirthDate", "report.patientSex"};
    const std::array words{tr("Name of the patient"), tr("Identification of the patient"),
                           tr("Date of birth of the patient"), tr("Sex of the patient")};
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        m_fields[i] = named(new QLineEdit, QString::fromLatin1(names[i]), words[i]);
        m_fields[i]->setMaxLength(longestField);
    }
}

void ReportDialog::takeSwitch(bool on) {
    for (QLineEdit* field : m_fields) {
        enableOrSayWhy(*field, on, tr("Tick the box above first."));
        field->setPlaceholderText(on && m_facts.filesNamePatient && !m_shown && !m_problem ? tr("as the files say")
                                                                                           : QString());
    }
    if (m_problem) return;
    m_patientLine->setText(m_facts.filesNamePatient
                               ? tr("Name, identification, date of birth, sex and date of the study are read from the "
                                    "files for this page alone. What you type takes their place.")
                               : tr("These files do not say whose study it is. What you type stands in this page "
                                    "alone."));
    if (!on || !m_facts.filesNamePatient || !m_facts.patientIsShown || m_asked) return;
    m_asked = true;
    emit patientAsked();
}

void ReportDialog::showPatient(const ReportPatient& patient) {
    m_shown = true;
    const std::array texts{patient.name, patient.id, patient.birthDate, patient.sex};
    for (std::size_t i = 0; i < m_fields.size(); ++i)
        if (m_fields[i]->text().isEmpty()) m_fields[i]->setText(texts[i]);
    takeSwitch(m_patient->isChecked());
}

void ReportDialog::showPatientProblem(const QString& sentence) {
    m_problem = true;
    m_patientLine->setText(sentence);
    takeSwitch(m_patient->isChecked());
}

bool ReportDialog::withPatient() const { return m_patient->isChecked(); }

ReportChoice ReportDialog::choice() const {
    ReportChoice choice{.comment = m_comment->toPlainText(), .impression = m_impression->toPlainText()};
    if (!withPatient()) return choice;
    choice.withPatient = true;
    choice.patient = {m_fields[0]->text(), m_fields[1]->text(), m_fields[2]->text(), m_fields[3]->text()};
    const bool isTyped = choice.patient != ReportPatient{};
    choice.restFromFiles = m_facts.filesNamePatient && !m_shown && !(m_problem && isTyped);
    return choice;
}

}  // namespace echolucent
