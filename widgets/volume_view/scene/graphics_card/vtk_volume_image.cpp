#include "widgets/volume_view/scene/graphics_card/vtk_volume_image.h"

#include <vtkColorTransferFunction.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>
#include <vtkVolumeProperty.h>

#include <vector>

namespace echolucent {

namespace {

constexpr int transferSamples = 1021;  // the 256 values of 8 bits, and three between each two

template <typename Stored>
using ArrayOf =
    std::conditional_t<std::is_same_v<Stored, std::uint8_t>, vtkUnsignedCharArray,
                       std::conditional_t<std::is_same_v<Stored, std::uint16_t>, vtkUnsignedShortArray, vtkFloatArray>>;

template <typename Stored>
vtkSmartPointer<ArrayOf<Stored>> arrayOn(const VoxelArray<Stored>& voxels) {
    auto array = vtkSmartPointer<ArrayOf<Stored>>::New();
    constexpr int keepMemory = 1;  // VTK does not free it
    array->SetArray(const_cast<Stored*>(voxels.data()), static_cast<vtkIdType>(voxels.size()), keepMemory);
    return array;
}

}  // namespace

vtkSmartPointer<vtkImageData> imageOn(const Volume& volume) {
    const VolumeGeometry& geometry = volume.geometry();
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(static_cast<int>(geometry.size[0]), static_cast<int>(geometry.size[1]),
                         static_cast<int>(geometry.size[2]));
    image->SetSpacing(geometry.spacing[0], geometry.spacing[1], geometry.spacing[2]);
    std::visit([&](const auto& voxels) { image->GetPointData()->SetScalars(arrayOn(voxels)); }, volume.voxels());
    return image;
}

void setTransfer(vtkVolumeProperty& property, const Volume& volume, const OpacityCurve& curve, ColourMap colourMap) {
    std::vector<double> opacities = sampledOpacities(curve, transferSamples);
    std::vector<double> colours;
    for (int i = 0; i < transferSamples; ++i) {
        const Vec3 colour = colourOf(colourMap, i / (transferSamples - 1.0));
        colours.insert(colours.end(), colour.val, colour.val + 3);
    }
    vtkNew<vtkPiecewiseFunction> opacity;
    opacity->BuildFunctionFromTable(0.0, volume.whiteLevel(), transferSamples, opacities.data());
    vtkNew<vtkColorTransferFunction> colour;
    colour->BuildFunctionFromTable(0.0, volume.whiteLevel(), transferSamples, colours.data());
    property.SetScalarOpacity(opacity);
    property.SetColor(colour);
    property.SetScalarOpacityUnitDistance(volume.geometry().unit());
    property.SetInterpolationTypeToLinear();
}

}  // namespace echolucent
