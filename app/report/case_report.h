// A case report as one file of HTML or PDF: a page that says what was found, and an appendix that says how.
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
#include "processing/progress.h"

namespace echolucent {

/// A pane as the screen shows it.
struct ReportPane {
    QString caption;
    QImage image;
    bool is3d = false;
};

/// How long something took.
struct ReportTime {
    QString what;
    double milliseconds = 0.0;
};

/// The content of a report, as values: another thread makes the page. Names of files in it are as they may be shown.
struct CaseReport {
    QString study;    ///< its name or its number
    QString made;     ///< date and time
    QString version;  ///< of the program
    std::vector<ReportPane> panes;
    QStringList explanation;  ///< sentences: what the 3D view shows and why
    Document document;
    SampledCurve adaptive;   ///< the adaptive curve as the editor shows it; empty if there is none
    std::string designer{};  ///< the designer whose OTF the 3D view is rendered with; else empty
    std::optional<DesignerConfig> designedWith{};  ///< how that OTF was made, if it is there
    std::optional<OpacityCurve> designed{};        ///< that OTF's upper curve (upperCurveOf()), if it is there
    IntensityHistogram histogram;                  ///< of the raw voxels
    VolumeGeometry geometry;                       ///< of the measured volume
    std::size_t phases = 1;                        ///< of the study
    std::vector<ImportFact> facts;                 ///< the import report
    std::vector<std::string> warnings;             ///< of reading
    std::vector<ReportTime> times;
    std::optional<Patient> patient;  ///< only if a person asked for it
    bool withAppendix = false;
    std::string impression{}, comment{};  ///< UTF-8, as a person typed them
};

/// The file. It needs no other one. Its first page holds pictures, measurements, impression and comment, and fits one
/// sheet of A4 or Letter (HtmlPage::beginSheet()). What has no room there (textsOfFirstPage()) and all the rest stand
/// in the appendix. Without an appendix only what has no room on the first page follows it.
[[nodiscard]] std::string caseReportPage(const CaseReport& report);
/// The same as PDF, on A4. Works in any thread. The result is empty only if progress.cancel was raised.
[[nodiscard]] std::optional<std::string> caseReportPdf(const CaseReport& report, const Progress& progress = {});

}  // namespace echolucent
