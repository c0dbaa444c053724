// A case report: what a person has set of a study, what it shows and what was measured, as one page of HTML.
#pragma once

#include <QImage>
#include <QString>
#include <QStringList>
#include <optional>
#include <string>
#include <vector>

#include "io/dicom/patient.h"
#include "io/study/study.h"
#include "processing/document/document.h"
#include "processing/intensity/histogram.h"

namespace echolucent {

/// A pane as it stands on the screen.
struct ReportPane {
    QString caption;
    QImage image;
};

/// How long something took, milliseconds.
struct ReportTime {
    QString what;
    double milliseconds = 0.0;
};

/// All that a report tells, as values: it is made in another thread than the window. Names of files in it are as they
/// may be shown.
struct CaseReport {
    QString study;    ///< its name or its number
    QString made;     ///< date and time
    QString version;  ///< of the program
    std::vector<ReportPane> panes;
    QStringList explanation;  ///< sentences: what the 3D view shows and why
    Document document;
    SampledCurve adaptive;   ///< as it is shown; empty where there is none
    std::string designer{};  ///< its name, where the 3D view is rendered with the OTF of one; else empty
    std::optional<DesignerConfig> designedWith{};  ///< how that OTF was made, where it is there
    std::optional<OpacityCurve> designed{};        ///< that OTF's upper curve (upperCurveOf()), where it is there
    IntensityHistogram histogram;                  ///< of the raw voxels
    VolumeGeometry geometry;                       ///< of the volume that was measured in
    std::vector<ImportFact> facts;                 ///< the import report
    std::vector<std::string> warnings;             ///< of reading
    std::vector<ReportTime> times;
    std::optional<Patient> patient;  ///< only where a person asked for it
};

/// The page: it needs nothing beside it, and its pictures stay as they are.
[[nodiscard]] std::string caseReportPage(const CaseReport& report);

}  // namespace echolucent
