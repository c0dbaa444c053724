# Fails where a file includes what its part must not know. SOURCE_DIR: the project's folder.
set(breaches "")

# forbid_files(REASON EXPRESSION FILES...): the files may not include what the regular expression names.
function(forbid_files reason expression)
    foreach(file IN LISTS ARGN)
        file(STRINGS ${file} lines REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"]${expression}")
        foreach(line IN LISTS lines)
            string(APPEND breaches "${file}: ${line}   (${reason})\n")
        endforeach()
    endforeach()
    set(breaches "${breaches}" PARENT_SCOPE)
endfunction()

# forbid(REASON EXPRESSION FOLDERS...): the same for all files in and below the folders.
function(forbid reason expression)
    foreach(folder IN LISTS ARGN)
        file(GLOB_RECURSE files ${SOURCE_DIR}/${folder}/*.h ${SOURCE_DIR}/${folder}/*.cpp)
        forbid_files("${reason}" "${expression}" ${files})
    endforeach()
    set(breaches "${breaches}" PARENT_SCOPE)
endfunction()

set(qt "Q[A-Za-z]+[>/]")
set(vtk "(vtk|QVTK)")
set(dcmtk "dcmtk/")
forbid("processing knows no Qt" "${qt}" processing)
forbid("processing knows no VTK" "${vtk}" processing)
forbid("processing knows no DCMTK" "${dcmtk}" processing)
forbid("processing knows no JSON" "nlohmann/" processing)
forbid("processing knows no other part" "(io|widgets|app)/" processing)
forbid("io knows no Qt" "${qt}" io)
forbid("io knows no VTK" "${vtk}" io)
forbid("io knows neither widgets nor app" "(widgets|app)/" io)
forbid("widgets do not know io or app" "(io|app)/" widgets)
forbid("widgets know no DCMTK" "${dcmtk}" widgets)
forbid("VTK stays in widgets/volume_view" "${vtk}" widgets/otf_editor widgets/panels widgets/motion widgets/picture_labels app)
file(GLOB shared_widgets ${SOURCE_DIR}/widgets/*.h ${SOURCE_DIR}/widgets/*.cpp)
forbid_files("VTK stays in widgets/volume_view" "${vtk}" ${shared_widgets})
forbid("widgets do not know the 3D view" "widgets/volume_view/" widgets/otf_editor widgets/panels widgets/motion
    widgets/picture_labels)
forbid_files("widgets do not know the 3D view" "widgets/volume_view/" ${shared_widgets})
# Of Qt its target has the core alone on its path.
forbid("the document knows no other widgets and Qt Core only" "(widgets/([^d]|d[^o])|Qt(Gui|Widgets)/)" widgets/document)
forbid("the scene knows no other widgets" "widgets/([^v]|volume_view/[^s])" widgets/volume_view/scene)
forbid("the scene knows no Qt" "${qt}" widgets/volume_view/scene)
forbid("the scene knows no QVTK" "QVTK" widgets/volume_view/scene)
forbid("the application reads DICOM through io only" "${dcmtk}" app)
forbid("the command line knows no Qt" "${qt}" app/cli app/measuring)
forbid("the command line knows no widgets" "widgets/" app/cli app/measuring)
forbid("what measures stays out of the rooms that data flows through" "app/measuring/" processing io widgets app/cli)
forbid("the window knows neither the command line nor what measures" "app/(cli|measuring)/"
    app/document app/motion app/otf app/picture app/planes app/report app/sessions app/study app/window)
forbid("pages know no Qt" "${qt}" app/pages)
forbid("pages know neither window nor commands" "(widgets|app/[^p]|app/pi|app/pl)" app/pages)
forbid("commands know no page" "app/pages/" app/cli)
forbid("measures know the numeric core only" "(io|widgets|app/cli)/" app/measuring/measures)

# DCMTK and JSON stay in the .cpp files of io: no header carries their types but those that serve these files alone.
file(GLOB_RECURSE headers ${SOURCE_DIR}/io/*.h)
forbid_files("io's headers carry no type of DCMTK" "${dcmtk}" ${headers})
list(FILTER headers EXCLUDE REGEX "/io/(json/[a-z_]+|document/document_(parts|version_1))\\.h$")
forbid_files("io's headers carry no type of JSON" "(nlohmann/|io/json/)" ${headers})

# The rooms of io, each of which knows none behind it; ROOT stands for io itself.
set(rooms files output json voxels study stored headers nifti kretz dicom/elements dicom/frames dicom/pixels dicom/volumes
    dicom/series dicom document writers ROOT restricted)
while(rooms)
    list(POP_FRONT rooms room)
    if(room STREQUAL "ROOT")
        set(room .)
    endif()
    file(GLOB files ${SOURCE_DIR}/io/${room}/*.h ${SOURCE_DIR}/io/${room}/*.cpp)
    foreach(behind IN LISTS rooms)
        string(REGEX REPLACE "^ROOT/" "" behind "${behind}/")
        forbid_files("io/${room} stands before what it knows" "io/${behind}[a-z0-9_]+\\.h" ${files})
    endforeach()
endwhile()

# What parses strangers' files runs in a process of its own (docs/hostile-files.md): the application calls no reader itself.
file(GLOB_RECURSE callers ${SOURCE_DIR}/app/*.h ${SOURCE_DIR}/app/*.cpp)
foreach(file IN LISTS callers)
    file(STRINGS ${file} lines
        REGEX "(^|[^a-zA-Z_:])(echolucent::)?(readStudy|listSeries|holdsSeries|readSeries|middlePicture|readPatient)\\(")
    foreach(line IN LISTS lines)
        string(APPEND breaches "${file}: ${line}   (the application calls readers of restricted:: only)\n")
    endforeach()
endforeach()

if(breaches)
    message(FATAL_ERROR "Includes across a boundary:\n${breaches}")
endif()
