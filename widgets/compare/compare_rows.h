// The table of a comparison: one row a pane, as numbers, as words and as text to copy.
#pragma once

#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

namespace echolucent {

/// The measures of a pane. An unknown one has no value.
struct CompareRow {
    QString name;
    std::optional<double> contrast{};             ///< CNR_S by the tube cores' surfaces
    std::optional<double> nearSurfaces{};         ///< mean share of a ray's light near these surfaces, [0,1]
    std::optional<double> flicker{};              ///< RMS of pictures in [0,1]
    std::optional<double> designMilliseconds{};   ///< of the designer; a curve needs none
    std::optional<double> pictureMilliseconds{};  ///< of the picture that is shown
    friend bool operator==(const CompareRow&, const CompareRow&) = default;
};

/// The headings, the name first.
[[nodiscard]] QStringList compareColumns();
/// The cells of a row under the headings of compareColumns(). An unknown value is "–".
[[nodiscard]] QStringList cellsOf(const CompareRow& row);
/// "CNR_S 2.31 · 45 % near surfaces · picture 12 ms": the line under a picture. Unknown values are left out.
[[nodiscard]] QString numbersOf(const CompareRow& row);
/// Columns aligned by spaces.
[[nodiscard]] QString compareText(const std::vector<CompareRow>& rows);
/// Comma-separated, with all digits. Names stand in quotation marks, unknown values are empty.
[[nodiscard]] QString compareCsv(const std::vector<CompareRow>& rows);

}  // namespace echolucent
