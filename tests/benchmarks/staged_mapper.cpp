#include "tests/benchmarks/staged_mapper.h"

#include <vtkFixedPointRayCastImage.h>
#include <vtkObjectFactory.h>

namespace echolucent::bench {

vtkStandardNewMacro(StagedFixedPointMapper);

void StagedFixedPointMapper::Render(vtkRenderer* renderer, vtkVolume* volume) {
    // This is one picture of one volume; the base class passes zeros as well, which it does not read.
    double origin[3]{}, spacing[3]{};
    int extent[6]{};
    const double wall = wallClockMs(), cpu = processCpuMs();
    PerImageInitialization(renderer, volume, 0, origin, spacing, extent);
    PerVolumeInitialization(renderer, volume);
    PerSubVolumeInitialization(renderer, volume, 0);
    const double wallReady = wallClockMs(), cpuReady = processCpuMs();
    RenderSubVolume();
    m_setUp = {wallReady - wall, cpuReady - cpu};
    m_rays = {wallClockMs() - wallReady, processCpuMs() - cpuReady};
    DisplayRenderedImage(renderer, volume);
}

std::vector<float> StagedFixedPointMapper::rgb(int size) {
    int inUse[2], memory[2], origin[2];
    RayCastImage->GetImageInUseSize(inUse);
    RayCastImage->GetImageMemorySize(memory);
    RayCastImage->GetImageOrigin(origin);
    const unsigned short* image = RayCastImage->GetImage();
    std::vector<float> rgb(static_cast<std::size_t>(size) * static_cast<std::size_t>(size) * 3, 0.0f);
    for (int y = 0; y < inUse[1]; ++y)
        for (int x = 0; x < inUse[0]; ++x) {
            const int row = size - 1 - (y + origin[1]), column = x + origin[0];  // VTK's rows begin at the bottom
            if (row < 0 || column >= size) continue;
            const unsigned short* from = image + 4 * (static_cast<std::ptrdiff_t>(y) * memory[0] + x);
            float* to = &rgb[(static_cast<std::size_t>(row) * static_cast<std::size_t>(size) +
                              static_cast<std::size_t>(column)) *
                             3];
            for (int channel = 0; channel < 3; ++channel) to[channel] = static_cast<float>(from[channel]) / 32767.0f;
        }
    return rgb;
}

}  // namespace echolucent::bench
