// Which line of a plane a place lies on, by a table instead of an arc tangent.
#pragma once

#include <vector>

#include "processing/progress.h"
#include "processing/scan_conversion/polar_geometry.h"

namespace echolucent {

/// The index of a line, from the first (0) to the last, by a *key*: the tangent of half the angle where lines stand at
/// angles, else the position in mm. The table is linear between its entries, sixteen or more a line.
class LineLookup {
public:
    /// Where `progress` was cancelled the table is not complete, and nothing may be looked up in it.
    explicit LineLookup(const PolarAxis& lines, const Progress& progress = {});

    // An index is found so: place = (key - firstKey) entriesPerKey, held within [0, lastPlace], and linear between the
    // entries of `indices` on both sides, of which there is one more than places.
    [[nodiscard]] float firstKey() const { return m_firstKey; }
    [[nodiscard]] float entriesPerKey() const { return m_entriesPerKey; }
    [[nodiscard]] float lastPlace() const { return m_lastPlace; }
    [[nodiscard]] const float* indices() const { return m_indices.data(); }

private:
    float m_firstKey = 0, m_entriesPerKey = 0, m_lastPlace = 0;
    std::vector<float> m_indices;
};

}  // namespace echolucent
