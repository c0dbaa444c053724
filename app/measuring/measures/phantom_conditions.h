// The conditions of docs/experiments.md by name. Tests and studies share them.
#pragma once

#include <string>
#include <vector>

#include "processing/phantom/phantom_config.h"

namespace echolucent {

/// One of the conditions of the studies behind the method, by name.
struct NamedPhantom {
    std::string name;
    PhantomConfig config;
};

/// Each condition takes scene, size, spacing, seed, bits and phase from `base`. All else is the condition's own or the
/// default of PhantomConfig. The names: "base", "ramp2", "little_speckle", "attenuation_shadow", "specular".
[[nodiscard]] std::vector<NamedPhantom> ordinaryConditions(
    const PhantomConfig& base = defaultPhantom(PhantomScene::shapes));
/// "hard_full_speckle", "hard_uncorrelated", "hard_ramp8", "hard_low_contrast", "hard_log_compressed".
[[nodiscard]] std::vector<NamedPhantom> hardConditions(
    const PhantomConfig& base = defaultPhantom(PhantomScene::shapes));
/// "front_wall".
[[nodiscard]] std::vector<NamedPhantom> frontWallConditions(
    const PhantomConfig& base = defaultPhantom(PhantomScene::shapes));
/// "empty", with the scene PhantomScene::empty.
[[nodiscard]] std::vector<NamedPhantom> emptyConditions(
    const PhantomConfig& base = defaultPhantom(PhantomScene::shapes));

}  // namespace echolucent
