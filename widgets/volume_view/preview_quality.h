// How coarse the picture is while the hand moves.
#pragma once

#include <cstddef>

#include "processing/ray_caster.h"

namespace echolucent {

/// Learns what a ray's sample costs on this machine and this scene, and chooses the finest picture within a budget.
class PreviewQuality {
public:
    /// budgetMilliseconds: what a picture may take while the hand moves.
    explicit PreviewQuality(double budgetMilliseconds = 40.0) : m_budget(budgetMilliseconds) {}

    /// Tells what a picture took.
    void measured(const RayCastSettings& settings, double milliseconds);
    /// The settings of the coarse picture that goes before the fine one; equal in size and step to the fine one where
    /// that is quick enough by itself. Does not waver between two levels on small changes of cost.
    [[nodiscard]] RayCastSettings coarse(const RayCastSettings& fine);

private:
    double m_budget;
    double m_costPerSample = 0.0;  // ms per ray and sample per unit of depth; 0: nothing measured yet
    std::size_t m_level = 4;  // before any measure: a third of the width and height
};

}  // namespace echolucent
