// The table of a comparison: one row a pane, as numbers, as words and as text to copy.
#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "processing/comparison/shown_depth.h"
#include "processing/pane_picture/pane_measures.h"

namespace echolucent {

/// The measures of a pane. An unknown one has no value.
struct CompareRow {
    QString name;
    /// The surfaces with which depth, contrast and nearSurfaces are measured.
    std::optional<SurfacesFrom> surfaces{};
    std::optional<ShownDepth> depth{};            ///< of at least one ray
    std::optional<double> contrast{};             ///< CNR_S
    std::optional<double> nearSurfaces{};         ///< mean share of a ray's light near the surface, [0,1]
    std::optional<double> flicker{};              ///< of the picture in a motion, RMS in [0,1]
    std::optional<double> designMilliseconds{};   ///< of the designer, median; a curve that needs no designer has none
    std::optional<double> pictureMilliseconds{};  ///< of the picture that is shown
    friend bool operator==(const CompareRow&, const CompareRow&) = default;
};

/// The place of the flicker among compareColumns().
inline constexpr int flickerColumn = 7;
/// The headings, the name first.
[[nodiscard]] QStringList compareColumns();
/// What each of compareColumns() asks, and whom it favours, a sentence or two each; empty for the name.
[[nodiscard]] QStringList compareTips();
/// Says with which OTFs the frames of the flicker are rendered.
[[nodiscard]] QString flickerSentences();
/// The core's surfacesSentence() of the rows. Empty if none is measured.
[[nodiscard]] QString surfacesSentence(const std::vector<CompareRow>& rows);
/// The cells of a row under the headings of compareColumns(). An unknown value is "–".
[[nodiscard]] QStringList cellsOf(const CompareRow& row);
/// "right 62 % · early 31 % · late 7 %": the line under a picture, which says where it stands. The share of right is
/// always there, each other one if it rounds to more than 0 %. Empty if no surface is known.
[[nodiscard]] QString numbersOf(const CompareRow& row);
/// Columns aligned by spaces.
[[nodiscard]] QString compareText(const std::vector<CompareRow>& rows);
/// Comma-separated, with all digits; percentages and levels as in the cells. Names stand in quotation marks, unknown
/// values are empty.
[[nodiscard]] QString compareCsv(const std::vector<CompareRow>& rows);

}  // namespace echolucent
