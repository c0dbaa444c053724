#include "app/measuring/measures/phantom_conditions.h"

namespace echolucent {

namespace {

/// The base condition, with scene, size, spacing, seed, bits and phase of another config.
PhantomConfig baseCondition(const PhantomConfig& given) {
    PhantomConfig base;
    base.scene = given.scene;
    base.size = given.size;
    base.spacing = given.spacing;
    base.seed = given.seed;
    base.bits = given.bits;
    base.phase = given.phase;
    return base;
}

}  // namespace

std::vector<NamedPhantom> ordinaryConditions(const PhantomConfig& given) {
    const PhantomConfig base = baseCondition(given);
    PhantomConfig ramp2 = base, littleSpeckle = base, attenuationShadow = base, specular = base;
    ramp2.ramp = 2;
    littleSpeckle.speckle = 0.2;
    littleSpeckle.speckleSize = 0;
    attenuationShadow.attenuation = 0.003;
    attenuationShadow.shadow = 0.02;
    specular.specular = 0.5;
    return {{"base", base},
            {"ramp2", ramp2},
            {"little_speckle", littleSpeckle},
            {"attenuation_shadow", attenuationShadow},
            {"specular", specular}};
}

std::vector<NamedPhantom> hardConditions(const PhantomConfig& given) {
    const PhantomConfig base = baseCondition(given);
    PhantomConfig full = base, uncorrelated = base, ramp8 = base, lowContrast = base, logCompressed = base;
    full.speckle = 1;
    uncorrelated.speckle = 1;
    uncorrelated.speckleSize = 0;
    ramp8.ramp = 8;
    lowContrast.fluid = 30;
    lowContrast.tissue = 80;
    lowContrast.object = 120;
    logCompressed.speckle = 1;
    logCompressed.logCompressDecibel = 50;
    return {{"hard_full_speckle", full},
            {"hard_uncorrelated", uncorrelated},
            {"hard_ramp8", ramp8},
            {"hard_low_contrast", lowContrast},
            {"hard_log_compressed", logCompressed}};
}

std::vector<NamedPhantom> frontWallConditions(const PhantomConfig& given) {
    PhantomConfig wall = baseCondition(given);
    wall.frontWall = true;
    return {{"front_wall", wall}};
}

std::vector<NamedPhantom> emptyConditions(const PhantomConfig& given) {
    PhantomConfig empty = baseCondition(given);
    empty.scene = PhantomScene::empty;
    return {{"empty", empty}};
}

}  // namespace echolucent
