// The options of the method, and curves by name.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "app/cli/options/parameter_options.h"
#include "processing/adaptive/adaptive_otf_config.h"
#include "processing/opacity_curve.h"
#include "processing/result.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace echolucent::cli {

/// The method's options: --reading, --initial, --tube-grid, --without-tube, and one for each row of methodParameters().
/// The reading sets everything; an option that is given overrides it.
struct MethodOptions {
    std::string reading = "default";
    std::string initial = "parabolic";
    std::string tubeGrid;
    std::vector<std::int64_t> withoutTubes;  ///< in any order; an index may come twice
    std::optional<double> opacityScale;
    /// Adds the options to a command. This object must not move until get() is called.
    void addTo(CLI::App& command);
    /// The config that the options make; the default reading if addTo() was never called. Fails (wrong usage) if a
    /// value is out of range, or if an option belongs to a choice that is not made. Fails as curveFromName() does.
    [[nodiscard]] Result<AdaptiveOtfConfig> get() const;

private:
    GivenParameters m_given;
    const CLI::Option* m_initialOption = nullptr;
};

/// "NxM" as columns and rows, within the ranges of the table; fails (wrong usage) if the text is something else.
[[nodiscard]] Result<TubeGrid> tubeGridFrom(const std::string& text, TubeGrid grid);

/// The grid in which tube cores of these indices are never placed; fails (wrong usage) if it has no such tube core.
[[nodiscard]] Result<TubeGrid> gridWithout(const std::vector<std::int64_t>& tubes, TubeGrid grid);

/// The FILE of the curve name manual:FILE; empty for every other name.
[[nodiscard]] std::string curveFileOf(const std::string& name);

/// The curve called linear, parabolic, quartic or manual:FILE. `opacityScale` is the scale of a power curve, the slope
/// of the linear one and a factor on the opacities of a manual one. If it has no value, a power curve has
/// defaultOpacityScale, the linear one its default slope, and a manual one stays as it is. Fails (wrong usage) if the
/// scale is out of range or the name is none of these, and as readCurve() does.
[[nodiscard]] Result<OpacityCurve> curveFromName(const std::string& name, std::optional<double> opacityScale);
/// The curve of --otf: as curveFromName(), and no curve for "adaptive", which is computed for the rendered view.
[[nodiscard]] Result<std::optional<OpacityCurve>> namedCurve(const std::string& name,
                                                             std::optional<double> opacityScale);

}  // namespace echolucent::cli
