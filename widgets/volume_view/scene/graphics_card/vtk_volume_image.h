// A volume as VTK sees it, for pickers and bounds, on the volume's own memory.
#pragma once

#include <vtkSmartPointer.h>
#include <vtkType.h>

#include <cstdint>
#include <type_traits>

#include "processing/opacity_curve.h"
#include "processing/picture/colour_map.h"
#include "processing/volume/volume.h"

class vtkImageData;
class vtkVolumeProperty;

namespace echolucent {

/// An image on the volume's own memory in grid mm: voxel (0,0,0) at the origin, without the patient frame. VTK must not
/// write to it, and the volume must outlive it.
[[nodiscard]] vtkSmartPointer<vtkImageData> imageOn(const Volume& volume);

/// VTK's number for a voxel type.
template <typename Stored>
[[nodiscard]] constexpr int vtkTypeOf() {
    if constexpr (std::is_same_v<Stored, std::uint8_t>) return VTK_UNSIGNED_CHAR;
    if constexpr (std::is_same_v<Stored, std::uint16_t>) return VTK_UNSIGNED_SHORT;
    if constexpr (std::is_same_v<Stored, float>) return VTK_FLOAT;
}

/// Sets a property's curve and colour map, on stored values. VTK's pickers read them.
void setTransfer(vtkVolumeProperty& property, const Volume& volume, const OpacityCurve& curve, ColourMap colourMap);

}  // namespace echolucent
