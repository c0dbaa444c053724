#include "widgets/dialogs/report_dialog.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "widgets/controls/panel_controls.h"

namespace echolucent {

namespace {

constexpr int linesOfText = 3;
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
      m_appendix(named(new QCheckBox(tr("With an &appendix: curves, parameters, import report, times")),
                       "report.appendix", tr("With an appendix: curves, parameters, import report, times"))),
      m_patient(named(new QCheckBox(tr("With the &patient's name and data")), "report.patient",
                      tr("With the patient's name and data"))),
      m_patientLine(named(secondaryLabel(), "report.patientLine", tr("About the patient's data"))) {
    setObjectName("report");
    setAccessibleName(tr("Case report"));
    setWindowTitle(tr("Case report"));
    auto* what = new QLabel(
        tr("The report has the pictures on the screen, the measurements, and what you type here. It is one page, and a "
           "second one for long texts. "
           "Give its file a name that ends with .html for a web page, or with .pdf for a PDF."));
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
    form->addRow(m_appendix);
    form->addRow(m_patient);
    const std::array labels{tr("Name"), tr("Patient ID"), tr("Date of birth"),
                            tr("Sex"),  tr("Exam date"),  tr("Gestational age")};
    // Two in a row, so that the dialog fits a low screen.
    for (std::size_t i = 0; i < m_fields.size(); i += 2) {
        auto* row = new QHBoxLayout;
        row->addWidget(m_fields[i]);
        row->addWidget(labelFor(m_fields[i + 1], labels[i + 1]));
        row->addWidget(m_fields[i + 1]);
        form->addRow(labelFor(m_fields[i], labels[i]), row);
    }
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
    const std::array names{"report.patientName", "report.patientId",       "report.patientBirthDate",
                           "report.patientSex",  "report.patientExamDate", "report.patientGestationalAge"};
    const std::array words{tr("Name of the patient"), tr("ID of the patient"), tr("Date of birth of the patient"),
                           tr("Sex of the patient"),  tr("Date of the exam"),  tr("Gestational age, weeks+days")};
    for (std::size_t i = 0; i < m_fields.size(); ++i) {
        m_fields[i] = named(new QLineEdit, QString::fromLatin1(names[i]), words[i]);
        m_fields[i]->setMaxLength(longestField);
    }
}

void ReportDialog::takeSwitch(bool on) {
    for (QLineEdit* field : m_fields) {
        enableOrSayWhy(*field, on, tr("Tick the box above first."));
        const bool comesFromFiles = on && m_facts.filesNamePatient && !m_shown && !m_problem;
        field->setPlaceholderText(comesFromFiles                   ? tr("as the files say")
                                  : on && field == m_fields.back() ? tr("weeks+days (22+4)")
                                                                   : QString());
    }
    if (m_problem) return;
    m_patientLine->setText(m_facts.filesNamePatient
                               ? tr("The files say whose study it is. You may correct what they say. It stands in this "
                                    "report and nowhere else.")
                               : tr("These files do not say whose study it is. What you type stands in this report and "
                                    "nowhere else."));
    if (!on || !m_facts.filesNamePatient || !m_facts.patientIsShown || m_asked) return;
    m_asked = true;
    emit patientAsked();
}

void ReportDialog::showPatient(const ReportPatient& patient) {
    m_shown = true;
    const std::array texts{patient.name, patient.id,       patient.birthDate,
                           patient.sex,  patient.examDate, patient.gestationalAge};
    constexpr std::size_t examDate = 4, gestationalAge = 5;
    for (std::size_t i = 0; i < m_fields.size(); ++i)
        if (m_fields[i]->text().isEmpty() && (i != gestationalAge || m_fields[examDate]->text() == patient.examDate))
            m_fields[i]->setText(texts[i]);
    // The files' age is that of their own date.
    connect(m_fields[examDate], &QLineEdit::textEdited, this, [this, patient](const QString& date) {
        if (date != patient.examDate && m_fields[gestationalAge]->text() == patient.gestationalAge)
            m_fields[gestationalAge]->clear();
    });
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
    choice.withAppendix = m_appendix->isChecked();
    if (!withPatient()) return choice;
    choice.withPatient = true;
    choice.patient = {m_fields[0]->text(), m_fields[1]->text(), m_fields[2]->text(),
                      m_fields[3]->text(), m_fields[4]->text(), m_fields[5]->text()};
    const bool isTyped = choice.patient != ReportPatient{};
    choice.restFromFiles = m_facts.filesNamePatient && !m_shown && !(m_problem && isTyped);
    return choice;
}

}  // namespace echolucent
