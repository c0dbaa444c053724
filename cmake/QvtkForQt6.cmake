# echolucent_qvtk: VTK's own Qt widgets against Qt 6. Where VTK was built with Qt 6 its module is used; Debian's VTK is
# built with Qt 5, so there VTK's GUISupport/Qt of the same version (fetched by scripts/setup) is compiled here.
find_package(VTK QUIET OPTIONAL_COMPONENTS GUISupportQt)
if(TARGET VTK::GUISupportQt AND "${VTK_QT_VERSION}" EQUAL 6)
    add_library(echolucent_qvtk INTERFACE)
    target_link_libraries(echolucent_qvtk INTERFACE VTK::GUISupportQt)
    return()
endif()

set(qvtk_sources ${PROJECT_SOURCE_DIR}/build/qvtk)
if(NOT EXISTS ${qvtk_sources}/QVTKOpenGLWindow.cxx)
    message(FATAL_ERROR "The Qt widget sources of VTK are not in ${qvtk_sources}; run scripts/setup once.")
endif()
file(WRITE ${PROJECT_BINARY_DIR}/qvtk/vtkGUISupportQtModule.h
    "#pragma once\n#define VTKGUISUPPORTQT_EXPORT\n#define VTKGUISUPPORTQT_NO_EXPORT\n")
file(GLOB qvtk_files ${qvtk_sources}/*.cxx ${qvtk_sources}/*.h)
# Only the headers become visible to others: the folder also holds a file named "version", which would be taken for
# C++'s <version>.
file(GLOB qvtk_headers ${qvtk_sources}/*.h)
file(COPY ${qvtk_headers} DESTINATION ${PROJECT_BINARY_DIR}/qvtk)
add_library(echolucent_qvtk STATIC ${qvtk_files})
set_target_properties(echolucent_qvtk PROPERTIES AUTOMOC ON UNITY_BUILD OFF)
target_include_directories(echolucent_qvtk SYSTEM PUBLIC ${PROJECT_BINARY_DIR}/qvtk)
target_compile_options(echolucent_qvtk PRIVATE -w)
target_link_libraries(echolucent_qvtk PUBLIC Qt6::Widgets Qt6::OpenGL Qt6::OpenGLWidgets
    VTK::InteractionWidgets VTK::RenderingOpenGL2 VTK::RenderingVolumeOpenGL2 VTK::InteractionStyle
    VTK::FiltersExtraction VTK::RenderingUI)
