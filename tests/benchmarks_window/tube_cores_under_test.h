// How soon the real window explains a tube core that a person points at, and how fast the curve grows.
#pragma once

#include <QList>

#include "tests/benchmarks_window/measures.h"
#include "tests/benchmarks_window/open_window.h"

namespace echolucent::bench {

class TubeCoresUnderTest : private OpenWindow {
public:
    /// Opens the volume in Teach, at 1280 x 720, with tube cores in planes and 3D, and shows the panel *Tube cores*.
    explicit TubeCoresUnderTest(const QString& volume);

    /// Clicks so many seeded cells of the map. Each lasts from the click to the later of two things on the screen: the
    /// panel painted with the tube core's explanation, and the 3D view with its mark. "explain".
    [[nodiscard]] Row explain(int clicks);
    /// Moves the slider of the growing curve step by step, as the keys do, each once the one before is painted. "grow".
    [[nodiscard]] Row grow(const Amount& amount);

private:
    void bringIntoView(const QString& name) const;
    [[nodiscard]] Row rowOf(const QString& action, const std::vector<double>& milliseconds) const;
};

}  // namespace echolucent::bench
