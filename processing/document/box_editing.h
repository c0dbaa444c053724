// What a document becomes when a person sets its render box, and the curved front of that.
#pragma once

#include "processing/document/document.h"
#include "processing/viewpoint/box_section.h"

namespace echolucent {

/// The face of an unturned box's side.
[[nodiscard]] BoxFace faceOf(BoxSide side);

/// A person's box with another place, size or turn. Axes that the hand did not turn keep their bits.
[[nodiscard]] Box movedBox(const Box& box, const OrientedBox& moved, BeamAxis beam);

/// The document with the box. Where it is switched on or turned, or has another side, the adaptive OTF looks in
/// through its side from now on; where it is switched off, along the beam, unless it looked another way before.
[[nodiscard]] Document withBox(Document document, const Box& box);
/// The same, with a side from which the pose looks in; the box is switched on. It is one around all data where it was
/// never set.
[[nodiscard]] Document withSide(Document document, BoxSide side, const DataBox& data);
/// The document with another beam: boxes keep their place in the volume, planes are as on opening along it.
[[nodiscard]] Document withBeam(Document document, const Beam& beam);
/// Switches the box on, around all data where it was never set, or off.
[[nodiscard]] Document withBoxSwitched(Document document, bool on, const DataBox& data);
/// A box of a thickness (mm, above 0) around plane A, B or C as it lies now, as wide as all data, seen as the plane is.
[[nodiscard]] Document withSlab(Document document, PlaneName plane, double thicknessMm, const DataBox& data);

/// The surface that a view's picture begins at, as one that can be bowed: its cut's own; else a flat one across
/// the way that the adaptive OTF looks in, at its near cut or the front of its box, whichever is deeper.
[[nodiscard]] CutSurface startSurface(const Document& document, const Volume& volume);
/// A surface bowed by so many mm along its forward in the middle of its nodes, less towards their border: by
/// (1 - u^2)(1 - v^2), with u and v from -1 to 1 over the nodes.
[[nodiscard]] CutSurface bowed(CutSurface surface, double mm);
/// The share of a bow that reaches a place of the grid.
[[nodiscard]] double bowAt(const CutSurface& surface, const Vec3& gridMm);

}  // namespace echolucent
