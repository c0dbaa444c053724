// Changes a document's render box as a person sets it, and bows the front.
#pragma once

#include "processing/document/document.h"

namespace echolucent {

/// The box with the place, size and axes of `moved`. If the axes are those of `box`, the box's direction keeps its
/// bits.
[[nodiscard]] Box movedBox(const Box& box, const OrientedBox& moved, BeamAxis beam);

/// The document with another beam. Box and front keep their places in the volume. The planes look along the new beam,
/// without crops.
[[nodiscard]] Document withBeam(Document document, const Beam& beam);
/// Switches the box on or off. If it was never set, it goes around all data.
[[nodiscard]] Document withBoxSwitched(Document document, bool on, const DataBox& data);
/// Sets a box of a thickness (mm, above 0) around plane A, B or C. The box is as wide as all data and seen as the plane
/// is. The pose looks in the same way, the front is taken away, and the motion's angle becomes 0.
[[nodiscard]] Document withSlab(Document document, PlaneName plane, double thicknessMm, const DataBox& data);

/// The document's front as a surface, ready to be bowed. If the front is bowed, its own. A flat front becomes a surface
/// over the box, or over the box around all data if that is off. The front must cut.
[[nodiscard]] CutSurface surfaceOfFront(const Document& document, const Volume& volume);
/// Bows a surface by `mm` along its forward in the middle of its nodes. Towards their border the bow falls as
/// (1 - u^2)(1 - v^2), with u and v from -1 to 1 over the nodes.
[[nodiscard]] CutSurface bowed(CutSurface surface, double mm);
/// The share of a bow at a place of the grid: 1 in the middle of the nodes, 0 at their border and beyond.
[[nodiscard]] double bowAt(const CutSurface& surface, const Vec3& gridMm);

}  // namespace echolucent
