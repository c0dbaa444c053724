// A volume as VTK sees it: the same voxels, not a copy, for pickers and for bounds.
#pragma once

#include <vtkSmartPointer.h>

#include "processing/opacity_curve.h"
#include "processing/ray_caster.h"

class vtkImageData;
class vtkVolumeProperty;

namespace echolucent {

/// An image on the volume's own memory in grid mm (voxel (0,0,0) at the origin, the patient frame left out). VTK must
/// not write to it, and the volume must outlive it.
[[nodiscard]] vtkSmartPointer<vtkImageData> imageOn(const Volume& volume);

/// Puts a curve and a colour map on a property, on stored values: what VTK's pickers read.
void setTransfer(vtkVolumeProperty& property, const Volume& volume, const OpacityCurve& curve, ColourMap colourMap);

}  // namespace echolucent
