#include "widgets/panels/light_amount.h"

#include <algorithm>

namespace echolucent {

double lightAmount(const Look& look) {
    switch (look.lighting) {
        case Lighting::flat: return 0.0;
        case Lighting::surface: return leastLight;
        case Lighting::depth: break;
    }
    return std::max(leastLight, 0.5 * (look.reaching.shadow + look.reaching.occlusion));
}

Look withLightAmount(Look look, double amount) {
    look.lighting = amount > 0.0 ? Lighting::depth : Lighting::flat;
    if (amount > 0.0) look.reaching.shadow = look.reaching.occlusion = std::max(leastLight, amount);
    return look;
}

}  // namespace echolucent
