// Changes a document's render box as a person sets it, and bows the front.
#pragma once

#include "processing/document/document.h"
#include "processing/viewpoint/box_section.h"

namespace echolucent {

[[nodiscard]] BoxFace faceOf(BoxSide side);

/// Gives a person's box another place, size or turn. Axes that the hand did not turn keep their bits.
[[nodiscard]] Box movedBox(const Box& box, const OrientedBox& moved, BeamAxis beam);

/// The document with the box. If the box is switched on or turned, or has another side, the adaptive OTF looks in
/// through its side from now on. If it is switched off, the OTF looks along the beam, unless it looked another way
/// before.
[[nodiscard]] Document withBox(Document document, const Box& box);
/// The same with another side, from which the pose looks in. The box is switched on. If it was never set, it goes
/// around all data.
[[nodiscard]] Document withSide(Document document, BoxSide side, const DataBox& data);
/// The document with another beam. Boxes keep their place in the volume; planes are as on opening along that beam.
[[nodiscard]] Document withBeam(Document document, const Beam& beam);
/// Switches the box on or off. If it was never set, it goes around all data.
[[nodiscard]] Document withBoxSwitched(Document document, bool on, const DataBox& data);
/// Sets a box of a thickness (mm, above 0) around plane A, B or C as it lies now. It is as wide as all data and seen as
/// the plane is.
[[nodiscard]] Document withSlab(Document document, PlaneName plane, double thicknessMm, const DataBox& data);

/// The surface at which a view's picture begins, ready to be bowed. If the front has a surface, that one. Else a flat
/// one across the way that the adaptive OTF looks in, at the near cut or the front of the box, whichever is deeper.
[[nodiscard]] CutSurface startSurface(const Document& document, const Volume& volume);
/// Bows a surface by `mm` along its forward in the middle of its nodes. Towards their border the bow falls as
/// (1 - u^2)(1 - v^2), with u and v from -1 to 1 over the nodes.
[[nodiscard]] CutSurface bowed(CutSurface surface, double mm);
/// The share of a bow at a place of the grid.
[[nodiscard]] double bowAt(const CutSurface& surface, const Vec3& gridMm);

}  // namespace echolucent
