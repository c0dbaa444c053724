#include "widgets/volume_view/scene/annotation/shade.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>

#include <array>

#include "processing/picture/annotation_layout.h"

namespace echolucent {

Shade::Shade() {
    constexpr std::array<vtkIdType, 4> corners{0, 1, 2, 3};
    m_corners->SetNumberOfPoints(corners.size());
    layOut(1, 1);
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(corners.size(), corners.data());
    vtkNew<vtkPolyData> rectangle;
    rectangle->SetPoints(m_corners);
    rectangle->SetPolys(cells);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(rectangle);
    m_actor->SetMapper(mapper);
    m_actor->GetProperty()->SetColor(0.0, 0.0, 0.0);
    m_actor->GetProperty()->SetOpacity(oldPictureShade);
    setVisible(false);
}

Shade::~Shade() = default;

void Shade::addTo(vtkRenderer* renderer) { renderer->AddActor2D(m_actor); }

void Shade::layOut(int width, int height) {
    m_corners->SetPoint(0, 0, 0, 0);
    m_corners->SetPoint(1, width, 0, 0);
    m_corners->SetPoint(2, width, height, 0);
    m_corners->SetPoint(3, 0, height, 0);
    m_corners->Modified();
}

void Shade::setVisible(bool visible) { m_actor->SetVisibility(visible); }

}  // namespace echolucent
