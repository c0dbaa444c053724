// Asks what a case report shall hold.
#pragma once

#include <QDialog>
#include <QString>
#include <array>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPlainTextEdit;

namespace echolucent {

/// Whose study it is, as the fields of the dialog hold it.
struct ReportPatient {
    QString name{}, id{}, birthDate{}, sex{}, examDate{}, gestationalAge{};
    friend bool operator==(const ReportPatient&, const ReportPatient&) = default;
};

/// What a person wants in a report.
struct ReportChoice {
    QString comment{}, impression{};
    bool withPatient = false;
    ReportPatient patient{};     ///< what stands in the fields
    bool restFromFiles = false;  ///< what is empty there is as the study's files say
    bool withAppendix = false;
};

/// Objects: report (this), report.impression, report.comment, report.appendix (off each time), report.patient
/// (off each time), report.patientName, report.patientId, report.patientBirthDate, report.patientSex,
/// report.patientExamDate, report.patientGestationalAge (enabled while the patient is wanted), report.patientLine,
/// report.note (if there is one), report.save, report.cancel.
class ReportDialog : public QDialog {
    Q_OBJECT

public:
    struct Facts {
        bool filesNamePatient = false;  ///< it is a DICOM study, whose files may name the patient
        bool patientIsShown = true;     ///< if false, the fields do not show what the files say
        QString note{};                 ///< a sentence to read before saving; empty if there is none
        QString comment{}, impression{};
    };
    explicit ReportDialog(const Facts& facts, QWidget* parent = nullptr);

    [[nodiscard]] ReportChoice choice() const;
    /// Whether the person wants the patient in the report.
    [[nodiscard]] bool withPatient() const;
    /// What the files say, after patientAsked(). Fields in which a person has typed stay as they are.
    /// The files' gestational age is left out beside another exam date than theirs.
    void showPatient(const ReportPatient& patient);
    /// Says why the files' patient cannot be shown. A person may still type one.
    void showPatientProblem(const QString& sentence);

signals:
    /// The person wants the patient, and the fields shall show what the files say: emitted once.
    void patientAsked();

private:
    void createFields();
    void takeSwitch(bool on);

    Facts m_facts;
    QPlainTextEdit *m_impression, *m_comment;
    QCheckBox *m_appendix, *m_patient;
    std::array<QLineEdit*, 6> m_fields{};  ///< name, ID, date of birth, sex, exam date, gestational age
    QLabel* m_patientLine;
    bool m_asked = false;    ///< patientAsked() was emitted
    bool m_shown = false;    ///< the fields show what the files say
    bool m_problem = false;  ///< the files do not say whose study it is
};

}  // namespace echolucent
