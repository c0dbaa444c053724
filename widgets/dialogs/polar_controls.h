// The fields that state the geometry of voxels along beams.
#pragma once

#include <QWidget>
#include <array>
#include <cstdint>
#include <optional>

#include "processing/scan_conversion/polar_geometry.h"

class QDoubleSpinBox;
class QLabel;

namespace echolucent {

/// Objects: rawLayout.polar (this), rawLayout.rangeStart, .rangeStep, .linesFirst, .linesLast, .linesRadius,
/// .planesFirst, .planesLast, .planesRadius. If the kind of probe turns lines or planes, they are in degrees and have a
/// radius. Otherwise they are in mm.
class PolarControls : public QWidget {
    Q_OBJECT

public:
    explicit PolarControls(QWidget* parent = nullptr);

    void setKind(PolarKind kind);
    /// Unevenly spaced lines (or planes) are kept until their first, last, number or kind changes.
    void setGeometry(const PolarGeometry& geometry);
    /// The geometry for a number of samples, lines and planes.
    [[nodiscard]] PolarGeometry geometry(const std::array<std::int64_t, 3>& size) const;
    /// A space and a sentence: geometry() replaces the uneven lines or planes that were set by even ones. Empty if it
    /// replaces none.
    [[nodiscard]] QString replacedSentence(const std::array<std::int64_t, 3>& size) const;

signals:
    void changed();

private:
    QDoubleSpinBox* createField(const QString& name, const QString& accessibleName, double value);
    [[nodiscard]] EvenPolar even() const;
    [[nodiscard]] bool keepsLines(std::int64_t count) const;
    [[nodiscard]] bool keepsPlanes(std::int64_t count) const;

    PolarKind m_kind = PolarKind::wobbler;
    /// The geometry that was set, and how the fields show it.
    std::optional<PolarGeometry> m_given;
    EvenPolar m_shownOfGiven;
    QDoubleSpinBox *m_rangeStart, *m_rangeStep;
    std::array<QDoubleSpinBox*, 2> m_lines{}, m_planes{};
    QDoubleSpinBox *m_linesRadius, *m_planesRadius;
    QLabel *m_linesLabel = nullptr, *m_planesLabel = nullptr;
};

}  // namespace echolucent
