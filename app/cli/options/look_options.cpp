#include "app/cli/options/look_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>

#include "app/cli/options/option_text.h"

namespace echolucent::cli {

namespace {

/// The names of a row's option: its own, and of one row a shorter one before it.
std::string namesOf(const AnyParameter& row) {
    return row.name == "depth_colouring" ? "--depth-colour,--depth-colouring" : optionOf(row.name);
}

/// "AZ,EL" in degrees.
Result<void> takeLight(const std::string& text, Look& look) {
    const auto angles = parseNumbers(text, 2, "--light", "40,-20");
    if (!angles) return tl::unexpected<Failure>(angles.error());
    const ParameterRange azimuth = parameterNamed(lookParameters(), "light_azimuth")->range;
    const ParameterRange elevation = parameterNamed(lookParameters(), "light_elevation")->range;
    if (!inRange((*angles)[0], azimuth) || !inRange((*angles)[1], elevation))
        return wrongUsage("--light",
                          fmt::format("must be an azimuth from {} to {} and an elevation from {} to {} degrees",
                                      textOf(azimuth.least), textOf(azimuth.largest), textOf(elevation.least),
                                      textOf(elevation.largest)));
    look.light = {(*angles)[0], (*angles)[1]};
    return {};
}

}  // namespace

void LookOptions::addTo(CLI::App& command, const std::vector<std::string_view>& names) {
    const auto wanted = [&](std::string_view name) {
        return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const auto& [row, standard] : defaultsOf(lookParameters()))
        if (wanted(row->name)) m_given.add(command, *row, standard, namesOf(*row));
    if (!names.empty()) return;
    command.add_flag("--perspective", m_perspective, "Short for --projection perspective")->excludes("--projection");
    command.add_flag("--shade", m_shade, "Short for --lighting surface")->excludes("--lighting");
    command.add_option("--light", m_light, "Short for --light-azimuth AZ and --light-elevation EL")
        ->type_name("AZ,EL")
        ->excludes("--light-azimuth")
        ->excludes("--light-elevation");
}

/// Fails (wrong usage) if an option that was given plays no part in `look`. Defaults are never a mistake.
Result<void> LookOptions::checkParts(const Look& look) const {
    if (look.mode != RenderMode::direct && (m_shade || !m_light.empty()))
        return wrongUsage("--shade and --light", "need direct volume rendering",
                          "Leave them out, or use --mode direct.");
    if (look.lighting == Lighting::flat && !m_light.empty())
        return wrongUsage("--light", "needs a light", "Leave it out, or use --lighting surface or depth.");
    for (const Parameter<Look>& row : lookParameters())
        if (m_given.has(row.name) && !playsAPart(row, look))
            return wrongUsage(optionOf(row.name), "plays a part only " + whenOf(row), "Leave it out.");
    return {};
}

Result<Look> LookOptions::get() const {
    Look look = lookAtStart();
    if (auto taken = m_given.override(lookParameters(), look); !taken) return tl::unexpected<Failure>(taken.error());
    if (m_perspective) look.projection = Projection::perspective;
    if (m_shade) look.lighting = Lighting::surface;
    if (!m_light.empty())
        if (const auto taken = takeLight(m_light, look); !taken) return tl::unexpected<Failure>(taken.error());
    if (const auto sensible = checkParts(look); !sensible) return tl::unexpected<Failure>(sensible.error());
    return look;
}

}  // namespace echolucent::cli
