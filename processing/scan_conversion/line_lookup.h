// The line of a plane on which a place lies, by a table instead of an arc tangent.
#pragma once

#include <vector>

#include "processing/progress.h"
#include "processing/scan_conversion/polar_geometry.h"

namespace echolucent {

/// The index of a line, from the first (0) to the last, by a *key*. If lines stand at angles, the key is the tangent of
/// half the angle, else the position in mm. The table is linear between its entries, at least sixteen a line.
class LineLookup {
public:
    /// If `progress` is cancelled, the table is not complete and must not be used.
    explicit LineLookup(const PolarAxis& lines, const Progress& progress = {});

    // To find an index: place = (key - firstKey) entriesPerKey, held within [0, lastPlace]. Then interpolate linearly
    // between the entries of `indices` on both sides. There is one more entry than places.
    [[nodiscard]] float firstKey() const { return m_firstKey; }
    [[nodiscard]] float entriesPerKey() const { return m_entriesPerKey; }
    [[nodiscard]] float lastPlace() const { return m_lastPlace; }
    [[nodiscard]] const float* indices() const { return m_indices.data(); }

private:
    float m_firstKey = 0, m_entriesPerKey = 0, m_lastPlace = 0;
    std::vector<float> m_indices;
};

}  // namespace echolucent
