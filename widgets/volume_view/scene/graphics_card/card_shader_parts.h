// The parts of the card's shader in GLSL, in the order in which they follow each other. cardShader() chooses among
// them.
#pragma once

namespace echolucent::card_shader {

extern const char* const samplesPart;    ///< voxels, the presence of data and colours at a place
extern const char* const raysPart;       ///< the pixel's ray, as RayGeometry aims it
extern const char* const frontPart;      ///< what a bowed front leaves of the ray, as CutSurface::firstLeft() says
extern const char* const stepsPart;      ///< the ray's whole and cut steps
extern const char* const opacitiesPart;  ///< a step's opacity, by a curve or a two-dimensional OTF
extern const char* const lightPart;      ///< Shading and DepthColouring
extern const char* const directPart;     ///< Petersch 2005, eqs. 2 and 3
extern const char* const extremesPart;   ///< maximum, minimum and mean
extern const char* const pixelPart;      ///< the pixel

}  // namespace echolucent::card_shader
