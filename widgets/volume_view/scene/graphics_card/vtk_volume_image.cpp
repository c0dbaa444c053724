#include "widgets/volume_view/scene/graphics_card/vtk_volume_image.h"

#include <vtkCellData.h>
#include <vtkColorTransferFunction.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnsignedShortArray.h>
#include <vtkVolumeProperty.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace echolucent {

namespace {

constexpr int transferSamples = 1021;  // the 256 values of 8 bits, and three between each two

template <typename Stored>
using ArrayOf =
    std::conditional_t<std::is_same_v<Stored, std::uint8_t>, vtkUnsignedCharArray,
                       std::conditional_t<std::is_same_v<Stored, std::uint16_t>, vtkUnsignedShortArray, vtkFloatArray>>;

/// Points at voxel centres, or cells around them.
vtkSmartPointer<vtkImageData> gridOf(const VolumeGeometry& geometry, bool cells) {
    const int more = cells ? 1 : 0;
    auto image = vtkSmartPointer<vtkImageData>::New();
    image->SetDimensions(static_cast<int>(geometry.size[0]) + more, static_cast<int>(geometry.size[1]) + more,
                         static_cast<int>(geometry.size[2]) + more);
    image->SetSpacing(geometry.spacing[0], geometry.spacing[1], geometry.spacing[2]);
    if (cells) image->SetOrigin(geometry.boxMinMm().val);
    return image;
}

template <typename Stored>
vtkSmartPointer<ArrayOf<Stored>> arrayOn(const VoxelArray<Stored>& voxels) {
    auto array = vtkSmartPointer<ArrayOf<Stored>>::New();
    constexpr int keepMemory = 1;  // VTK does not free it
    array->SetArray(const_cast<Stored*>(voxels.data()), static_cast<vtkIdType>(voxels.size()), keepMemory);
    return array;
}

/// The mean of the voxels with data among the 26 around one; 0 if there are none.
template <typename Stored>
Stored meanAround(const Volume& volume, const VoxelArray<Stored>& voxels, std::int64_t x, std::int64_t y,
                  std::int64_t z) {
    const VolumeGeometry& geometry = volume.geometry();
    const auto range = [&](std::int64_t at, std::size_t axis) {
        return std::pair{std::max<std::int64_t>(at - 1, 0), std::min(at + 1, geometry.size[axis] - 1)};
    };
    const auto [x0, x1] = range(x, 0);
    const auto [y0, y1] = range(y, 1);
    const auto [z0, z1] = range(z, 2);
    double sum = 0.0;
    int count = 0;
    for (std::int64_t k = z0; k <= z1; ++k)
        for (std::int64_t j = y0; j <= y1; ++j)
            for (std::int64_t i = x0; i <= x1; ++i) {
                const std::int64_t offset = geometry.offset(i, j, k);
                if (!volume.hasData(offset)) continue;
                sum += static_cast<double>(voxels[static_cast<std::size_t>(offset)]);
                ++count;
            }
    if (count == 0) return Stored{0};
    const double mean = sum / count;
    return static_cast<Stored>(std::is_integral_v<Stored> ? std::lround(mean) : mean);
}

template <typename Stored>
vtkSmartPointer<ArrayOf<Stored>> filledArray(const Volume& volume, const VoxelArray<Stored>& voxels) {
    const VolumeGeometry& geometry = volume.geometry();
    auto array = vtkSmartPointer<ArrayOf<Stored>>::New();
    array->SetNumberOfValues(static_cast<vtkIdType>(voxels.size()));
    Stored* filled = array->GetPointer(0);
    for (std::int64_t z = 0; z < geometry.size[2]; ++z)
        for (std::int64_t y = 0; y < geometry.size[1]; ++y)
            for (std::int64_t x = 0; x < geometry.size[0]; ++x) {
                const std::int64_t offset = geometry.offset(x, y, z);
                const auto at = static_cast<std::size_t>(offset);
                filled[at] = volume.hasData(offset) ? voxels[at] : meanAround(volume, voxels, x, y, z);
            }
    return array;
}

}  // namespace

vtkSmartPointer<vtkImageData> imageOn(const Volume& volume) {
    auto image = gridOf(volume.geometry(), false);
    std::visit([&](const auto& voxels) { image->GetPointData()->SetScalars(arrayOn(voxels)); }, volume.voxels());
    return image;
}

CellImages cellImagesOf(const Volume& volume) {
    CellImages images{gridOf(volume.geometry(), true), nullptr};
    const bool masked = !volume.dataMask().empty();
    std::visit(
        [&](const auto& voxels) {
            images.voxels->GetCellData()->SetScalars(masked ? filledArray(volume, voxels) : arrayOn(voxels));
        },
        volume.voxels());
    if (masked) {
        images.mask = gridOf(volume.geometry(), true);
        images.mask->GetCellData()->SetScalars(arrayOn(volume.dataMask()));
    }
    return images;
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
