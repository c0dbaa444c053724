// A volume as VTK sees it: the same voxels, not a copy, for pickers and for bounds.
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

/// An image on the volume's own memory in grid mm (voxel (0,0,0) at the origin, the patient frame left out). VTK must
/// not write to it, and the volume must outlive it.
[[nodiscard]] vtkSmartPointer<vtkImageData> imageOn(const Volume& volume);

/// The same grid with the voxels as cells: it reaches half a voxel beyond the outermost voxel centres, as the volume's
/// box does. On the volume's own memory where it has no data mask. Where it has one the voxels are a copy, in which
/// those without data next to data have the mean of the data around them, so that interpolation between the two sees
/// data only; the mask is 1 on data.
struct CellImages {
    vtkSmartPointer<vtkImageData> voxels;
    vtkSmartPointer<vtkImageData> mask;  ///< null where all are data
};
[[nodiscard]] CellImages cellImagesOf(const Volume& volume);

/// VTK's number for a voxel type of Volume.
template <typename Stored>
[[nodiscard]] constexpr int vtkTypeOf() {
    if constexpr (std::is_same_v<Stored, std::uint8_t>) return VTK_UNSIGNED_CHAR;
    if constexpr (std::is_same_v<Stored, std::uint16_t>) return VTK_UNSIGNED_SHORT;
    if constexpr (std::is_same_v<Stored, float>) return VTK_FLOAT;
}

/// Puts a curve and a colour map on a property, on stored values: what VTK's pickers read.
void setTransfer(vtkVolumeProperty& property, const Volume& volume, const OpacityCurve& curve, ColourMap colourMap);

}  // namespace echolucent
