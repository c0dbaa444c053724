#include "widgets/key_table.h"

#include <QCoreApplication>

namespace echolucent {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("keys", text); }

std::vector<KeyRow> pictureRows() {
    constexpr KeyPlace place = KeyPlace::picture;
    return {
        {place, tr("left drag"),
         tr("turns the picture: sideways about the screen's vertical, up and down about its "
            "horizontal")},
        {place, tr("middle drag, Shift + left drag"), tr("moves the picture")},
        {place, tr("wheel, right drag"), tr("zooms, the wheel about the point under the cursor")},
        {place, tr("Ctrl + left drag"), tr("moves the light, if the picture is lit")},
        {place, tr("Ctrl + ← → ↑ ↓; with Shift"), tr("turns the picture by 1°; by 10°")},
        {place, tr("Shift + ← → ↑ ↓"), tr("moves the picture")},
        {place, tr("+, −"), tr("zooms in, zooms out")},
        {place, tr("left drag with the scalpel; double click, Enter"), tr("draws a stroke; closes a polygon")},
        {place, tr("left drag of a mark of the box"), tr("moves a face, an edge, a corner or the whole box")},
        {place, tr("left drag of the front's handle, if the panel shows it"),
         tr("moves the front along its own direction")},
        {place, tr("left click with the tool that measures distances"), tr("marks a place of what the picture shows")},
        {place, tr("left click on a tube core, if they are shown"), tr("explains it in the panel Tube cores")},
        {place, tr("double click"), tr("gives the picture the whole room, or gives it back")},
        {place, tr("left drag of the line of a wipe; ←, →"), tr("moves the line between two pictures compared")},
        {place, tr("Escape during a drag"), tr("ends the drag without change")},
        {place, tr("a file or folder dropped"), tr("opens it")},
    };
}

std::vector<KeyRow> planeRows() {
    constexpr KeyPlace place = KeyPlace::planes;
    return {
        {place, tr("left click, left drag"), tr("moves the reference point, where the planes meet")},
        {place, tr("left drag at the rim"),
         tr("turns the three planes about the reference point, and the 3D view along if the panel says so")},
        {place, tr("left drag of a mark or line of the box"),
         tr("moves a face, a corner or the whole box, or turns it")},
        {place, tr("left drag of the front's line; of its diamond"),
         tr("moves the front along its own direction; bows it")},
        {place, tr("wheel over the front's line"), tr("moves the front by one voxel")},
        {place, tr("left click, left drag with a tool that measures"), tr("marks a place; marks two")},
        {place, tr("left drag of a mark of a measurement"), tr("moves that place")},
        {place, tr("left click on a tube core, if they are shown"), tr("explains it in the panel Tube cores")},
        {place, tr("wheel; with Ctrl"), tr("steps through parallel planes; zooms about the cursor")},
        {place, tr("middle drag, Shift + left drag"), tr("moves the plane's picture")},
        {place, tr("right drag to the left or right; up or down"), tr("sets the window; sets the level")},
        {place, tr("double click"), tr("gives the plane the whole room, or gives it back")},
        {place, tr("←, →; with Shift"), tr("turn by 1°; by 10°")},
        {place, tr("↑, ↓; Page Up, Page Down"), tr("step by one plane; by ten")},
        {place, tr("+, −; Home"), tr("zoom in, zoom out; resets the plane")},
        {place, tr("Escape during a drag"), tr("ends the drag without change")},
    };
}

std::vector<KeyRow> curveEditorRows() {
    constexpr KeyPlace place = KeyPlace::curveEditor;
    return {
        {place, tr("left drag of a node; with Shift"), tr("moves the node; moves it along one axis only")},
        {place, tr("double click on the plot, on an axis, in the corner"),
         tr("adds a node; shows that axis whole; shows both whole")},
        {place, tr("wheel; with Ctrl or on the opacity axis"), tr("zooms the intensities; zooms the opacities")},
        {place, tr("middle drag"), tr("moves the plot")},
        {place, tr("Tab, Page Down; Shift+Tab, Page Up"), tr("select the next node; the one before")},
        {place, tr("← → ↑ ↓; with Shift"), tr("move the selected node by 1/256; by ten times as much")},
        {place, tr("Delete"), tr("deletes the selected node (also in the table of nodes)")},
        {place, tr("Enter, F2 or a double click in the table of nodes"), tr("lets a number be typed")},
        {place, tr("drag, double click, Tab, Shift+Tab, Page Up, Page Down, arrows, Delete in the boundary emphasis"),
         tr("edit its nodes as those of the curve")},
        {place, tr("click, or ← → and Enter, on a maximum of the contour spectrum"),
         tr("puts the designer's ramp there")},
        {place, tr("Escape during a drag"), tr("ends the drag without change")},
    };
}

std::vector<KeyRow> windowRows() {
    constexpr KeyPlace place = KeyPlace::window;
    return {
        {place, "Ctrl+O, Ctrl+Q", tr("open a volume, quit"), {{"file.open", "Ctrl+O"}, {"file.quit", "Ctrl+Q"}}},
        {place,
         "Ctrl+S, Ctrl+Shift+S, Ctrl+H",
         tr("save the session; save it under another name; show the history of steps and snapshots"),
         {{"file.saveSession", "Ctrl+S"}, {"file.saveSessionAs", "Ctrl+Shift+S"}, {"edit.history", "Ctrl+H"}}},
        {place, "A", tr("computes the OTF for this view"), {{"otf.computeForThisView", "A"}}},
        {place,
         "1 2 3 4 5",
         tr("render the adaptive, manual, piecewise linear, parabolic or quartic curve"),
         {{"otfEditor.action.active.adaptive", "1"},
          {"otfEditor.action.active.manual", "2"},
          {"otfEditor.action.active.linear", "3"},
          {"otfEditor.action.active.parabolic", "4"},
          {"otfEditor.action.active.quartic", "5"}}},
        {place,
         "Ctrl+Z, Ctrl+Shift+Z",
         tr("undo and redo of whatever was changed: curves, view, beam, front, look, planes, box, strokes, "
            "measurements, method, motion"),
         {{"otfEditor.action.undo", "Ctrl+Z"}, {"otfEditor.action.redo", "Ctrl+Shift+Z"}}},
        {place, "C", tr("resets the active curve"), {{"otfEditor.action.reset", "C"}}},
        {place,
         "R, Shift+R",
         tr("reset the view; beam, look, front, view, curves, planes, box and strokes back to what opening gave"),
         {{"view.resetView", "R"}, {"view.resetAll", "Shift+R"}}},
        {place,
         "F2, F3, F4",
         tr("show the 3D view alone; planes A, B, C beside it; the 3D view large and the planes small"),
         {{"room.only3d", "F2"}, {"room.quad", "F3"}, {"room.large3d", "F4"}}},
        {place, "F5", tr("compares OTFs under one camera, and leaves the comparison"), {{"room.compare", "F5"}}},
        {place,
         "Ctrl+1 to Ctrl+6",
         tr("look into the scan from one of its six sides, behind that side's front; the strip and the menu View name "
            "the "
            "sides"),
         {{"room.lookInFrom1", "Ctrl+1"},
          {"room.lookInFrom2", "Ctrl+2"},
          {"room.lookInFrom3", "Ctrl+3"},
          {"room.lookInFrom4", "Ctrl+4"},
          {"room.lookInFrom5", "Ctrl+5"},
          {"room.lookInFrom6", "Ctrl+6"}}},
        {place, "B", tr("shows only what lies in the box"), {{"room.switchBox", "B"}}},
        {place,
         "S, Shift+S",
         tr("takes the scalpel or puts it away; shows all again that it has cut"),
         {{"room.scalpel", "S"}, {"room.takeAllStrokesBack", "Shift+S"}}},
        {place,
         "M, Shift+M",
         tr("takes the tool that measures distances, or angles in planes; or puts it away"),
         {{"room.measureDistance", "M"}, {"room.measureAngle", "Shift+M"}}},
        {place, "T", tr("shows tube cores in the pictures, or hides them"), {{"room.tubeCores", "T"}}},
        {place, tr("Delete, F2, a letter in the list of measurements"),
         tr("removes the selected measurement; goes to the field of its name; begins its name")},
        {place, tr("Enter in the name of a measurement; Escape in its fields or in the list"),
         tr("gives the keys back to the picture")},
        {place,
         "F, K",
         tr("shows the picture alone on the full screen, and leaves it; a large pointer for the last row of a class"),
         {{"view.fullScreen", "F"}, {"view.largePointer", "K"}}},
        {place,
         "N, Shift+N",
         tr("front from here: lays it across this view, or finds one; no front"),
         {{"view.frontFromHere", "N"}, {"view.noFront", "Shift+N"}}},
        {place,
         "Q, Shift+Q; L",
         tr("more or less smoothing; the next light"),
         {{"view.moreReduction", "Q"}, {"view.lessReduction", "Shift+Q"}, {"view.nextLighting", "L"}}},
        {place,
         "Space, ←, →",
         tr("play or pause, one degree back, one degree on"),
         {{"motion.playOrPause", "Space"}, {"motion.back", "Left"}, {"motion.on", "Right"}}},
        {place,
         tr(", and ."),
         tr("pause in the volume before or after, of a 4D study"),
         {{"motion.phaseBack", ","}, {"motion.phaseOn", "."}}},
        {place,
         "P, Shift+P, Ctrl+C",
         tr("save the picture, save a movie of the motion, copy the picture to the clipboard"),
         {{"file.savePicture", "P"}, {"file.saveMovie", "Shift+P"}, {"edit.copyPicture", "Ctrl+C"}}},
        {place, "F1", tr("explains what the picture shows"), {{"help.explain", "F1"}}},
        {place, "Escape",
         tr("ends a drag, then a stroke of the scalpel or places that were marked, the tool in the hand, a pane that "
            "has the whole room, the full screen")},
    };
}

std::vector<KeyRow> allRows() {
    std::vector<KeyRow> rows = pictureRows();
    for (const std::vector<KeyRow>& more : {planeRows(), curveEditorRows(), windowRows()})
        rows.insert(rows.end(), more.begin(), more.end());
    return rows;
}

}  // namespace

const std::vector<KeyRow>& keyTable() {
    static const std::vector<KeyRow> table = allRows();
    return table;
}

QString titleOf(KeyPlace place) {
    switch (place) {
        case KeyPlace::picture: return tr("In the picture");
        case KeyPlace::planes: return tr("In a plane");
        case KeyPlace::curveEditor: return tr("In the curve editor");
        case KeyPlace::window: return tr("Anywhere in the window");
    }
    return {};
}

QKeySequence keyOf(const QString& action) {
    for (const KeyRow& row : keyTable())
        for (const KeyOfAction& key : row.actions)
            if (key.action == action) return QKeySequence::fromString(key.key, QKeySequence::PortableText);
    return {};
}

QString keysPage() {
    QString page = QStringLiteral(
        "# Mouse and keys\n\n"
        "The control that has the focus is asked first, then the window. A field keeps its digits, a slider its "
        "arrows, a check box\n"
        "that Tab has reached its Space. A button that is clicked takes no focus: Space plays after it. The panel "
        "*Explain*, which F1\n"
        "opens, holds the same tables.\n\n"
        "<!-- The program writes this page from widgets/key_table.cpp, and TestKeyTable says how. Nobody edits it by "
        "hand. -->\n");
    for (const KeyPlace place : allKeyPlaces) {
        page += QStringLiteral("\n## %1\n| mouse, key | does |\n|---|---|\n").arg(titleOf(place));
        for (const KeyRow& row : keyTable())
            if (row.place == place) page += QStringLiteral("| %1 | %2 |\n").arg(row.keys, row.meaning);
    }
    return page;
}

}  // namespace echolucent
