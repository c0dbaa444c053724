// A scene that VTK draws off screen by itself, and things to put in it.
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSphereSource.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <memory>

#include "processing/picture/camera_pose.h"
#include "tests/volume_view/test_volumes.h"
#include "widgets/volume_view/scene/volume_scene.h"

namespace echolucent::testing {

/// A colour of red, green and blue, 0..255.
using Level = std::array<int, 3>;

struct DrawnScene {
    DrawnScene(int width, int height) {
        window->SetOffScreenRendering(1);
        window->SetMultiSamples(0);
        window->SetSize(width, height);
        window->AddRenderer(scene.renderer());
        scene.setAnnotationsVisible(false);
    }
    ~DrawnScene() { window->RemoveRenderer(scene.renderer()); }
    void draw() {
        window->Render();
        window->GetPixelData(0, 0, width() - 1, height() - 1, 0, pixels.Get(), 0);
    }
    int width() { return window->GetSize()[0]; }
    int height() { return window->GetSize()[1]; }
    /// Pixel in column x and row y from the top left.
    Level at(int x, int y) {
        const unsigned char* pixel = pixels->GetPointer(3 * (static_cast<vtkIdType>(height() - 1 - y) * width() + x));
        return {pixel[0], pixel[1], pixel[2]};
    }
    /// Depth of the window at that pixel, 0 to 1, as VTK's z-buffer pickers read it.
    double windowDepthAt(int x, int y) { return scene.renderer()->GetZ(x, height() - 1 - y); }

    VolumeScene scene;
    vtkNew<vtkRenderWindow> window;
    vtkNew<vtkUnsignedCharArray> pixels;
};

/// A picture with the same premultiplied pixel everywhere.
inline ScreenPicture plainPicture(int width, int height, const std::array<std::uint8_t, 4>& rgba) {
    ScreenPicture picture;
    picture.width = width;
    picture.height = height;
    for (int i = 0; i < width * height; ++i) picture.rgba.insert(picture.rgba.end(), rgba.begin(), rgba.end());
    return picture;
}

/// A sphere without light in one colour, with `resolution` facets around.
inline vtkNew<vtkActor> sphereAt(const Vec3& centre, double radius, const std::array<double, 3>& colour,
                                 int resolution = 32) {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(centre[0], centre[1], centre[2]);
    sphere->SetRadius(radius);
    sphere->SetThetaResolution(resolution);
    sphere->SetPhiResolution(resolution);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(sphere->GetOutputPort());
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    actor->GetProperty()->LightingOff();
    return actor;
}

/// The camera that shows the whole volume in a square picture.
inline Camera cameraOn(const Volume& volume, const Viewpoint& view, Projection projection = Projection::parallel) {
    return cameraFor(fittedPose(volume.geometry(), view, projection, 1.0));
}

}  // namespace echolucent::testing
