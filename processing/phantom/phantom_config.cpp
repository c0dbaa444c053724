#include "processing/phantom/phantom_config.h"

namespace echolucent {

PhantomConfig defaultPhantom(PhantomScene scene) {
    PhantomConfig config;
    config.scene = scene;
    if (scene == PhantomScene::fetus) {
        config.speckle = 0.3;
        config.attenuation = 0.002;
        config.shadow = 0.02;
        config.specular = 0.25;
    }
    return config;
}

}  // namespace echolucent
