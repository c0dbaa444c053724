// The parts of the simulated fetus. Local axes: the first points to its front, the second towards the crown, the third
// to its side nearer the probe. The unit of body parts is the crown-rump length. The head has its own unit.
#pragma once

#include <utility>

#include "processing/phantom/implicit_surface.h"

namespace echolucent {

/// A body under construction in local coordinates.
struct Sculpture {
    ImplicitBody& body;
    Placement placement;

    void join(const ImplicitPrimitive& primitive, double seam) {
        body.join(placed(placement, primitive), seam * placement.scale);
    }
    void carve(const ImplicitPrimitive& primitive, double seam) {
        body.carve(placed(placement, primitive), seam * placement.scale);
    }
    [[nodiscard]] Sculpture within(const Placement& inner) const { return {body, placement * inner}; }
};

/// Soft parts (skin and flesh), bright parts (bone) and dark parts (fluid) of the fetus.
struct FetusBodies {
    ImplicitBody flesh, bone, chambers;
};

/// `fetus` places crown-rump lengths into grid mm; `phase` (turns) moves one arm and the heart.
void addHead(FetusBodies& bodies, const Placement& fetus);
void addTrunk(FetusBodies& bodies, const Placement& fetus, double phase);
void addArms(FetusBodies& bodies, const Placement& fetus, double phase);
void addLegs(FetusBodies& bodies, const Placement& fetus);

}  // namespace echolucent
