// VTK's CPU mapper with a clock between its stages.
#pragma once

#include <vtkFixedPointVolumeRayCastMapper.h>

#include <vector>

#include "tests/benchmarks/measured_cost.h"

namespace echolucent::bench {

/// Renders as its base class does, by the same public stages in the same order, and times each.
class StagedFixedPointMapper : public vtkFixedPointVolumeRayCastMapper {
public:
    static StagedFixedPointMapper* New();
    vtkTypeMacro(StagedFixedPointMapper, vtkFixedPointVolumeRayCastMapper)

        void Render(vtkRenderer* renderer, vtkVolume* volume) override;

    [[nodiscard]] const Cost& setUp() const { return m_setUp; }
    [[nodiscard]] const Cost& rays() const { return m_rays; }
    /// The mapper's picture in a viewport of size x size pixels: red, green, blue (premultiplied: over black), rows
    /// from the top.
    [[nodiscard]] std::vector<float> rgb(int size);

protected:
    StagedFixedPointMapper() = default;
    ~StagedFixedPointMapper() override = default;

private:
    Cost m_setUp, m_rays;
};

}  // namespace echolucent::bench
