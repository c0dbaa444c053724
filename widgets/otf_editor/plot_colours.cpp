#include "widgets/otf_editor/plot_colours.h"

namespace echolucent {

PlotColours plotColours(Theme theme) {
    const QColor ground = coloursOf(theme).plot, text = coloursOf(theme).text;
    return {ground,
            text,
            mixed(ground, text, 0.72),
            mixed(ground, text, 0.09),
            mixed(ground, text, 0.28),
            mixed(ground, text, 0.13),
            mixed(ground, text, 0.24)};
}

}  // namespace echolucent
