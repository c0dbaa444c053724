#include "app/cli/options/look_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>

#include "app/cli/options/option_text.h"

namespace echolucent::cli {

namespace {

/// The names that people know a flag by, beside that of its row.
std::string namesOf(const Parameter<Look>& parameter) {
    const std::string option = optionOf(parameter.name);
    if (parameter.name == "depth_colouring") return "--depth-colour," + option;
    return option;
}

/// The row's option says nothing that the row does not allow.
Result<void> checked(const Parameter<Look>& parameter, const Look& look) {
    const std::optional<ParameterValue> value = parameter.get(look);
    const std::optional<double> number = value ? numberOf(*value) : std::nullopt;
    if (!number || inRange(*number, parameter.range)) return {};
    return wrongUsage(optionOf(parameter.name), fmt::format("must be {} to {} {}", textOf(parameter.range.least),
                                                            textOf(parameter.range.largest), parameter.unit));
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

ParameterValue LookOptions::Given::value() const {
    const ParameterValue standard = *parameter->get(lookAtStart());
    if (std::holds_alternative<bool>(standard)) return flag;
    if (std::holds_alternative<std::string>(standard)) return choice;
    return number;
}

void LookOptions::addRow(CLI::App& command, const Parameter<Look>& parameter) {
    Given& given = m_given.emplace_back();
    given.parameter = &parameter;
    const ParameterValue standard = *parameter.get(lookAtStart());
    if (std::holds_alternative<bool>(standard)) {
        given.option = command.add_flag(namesOf(parameter), given.flag, std::string(parameter.meaning));
    } else if (const auto* name = std::get_if<std::string>(&standard)) {
        given.choice = *name;
        given.option = command
                           .add_option(namesOf(parameter), given.choice,
                                       fmt::format("{}: {}", parameter.meaning, listed(parameter.choices)))
                           ->type_name("NAME")
                           ->capture_default_str();
    } else {
        given.number = *numberOf(standard);
        const std::string unit = parameter.unit.empty() ? "" : fmt::format(", {}", parameter.unit);
        given.option = command.add_option(namesOf(parameter), given.number, std::string(parameter.meaning) + unit)
                           ->type_name("NUMBER")
                           ->default_str(textOf(given.number));
    }
}

void LookOptions::addTo(CLI::App& command, const std::vector<std::string_view>& names) {
    const auto wanted = [&](std::string_view name) {
        return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const Parameter<Look>& parameter : lookParameters())
        if (wanted(parameter.name)) addRow(command, parameter);
    if (!names.empty()) return;
    command.add_flag("--perspective", m_perspective, "Short for --projection perspective")->excludes("--projection");
    command.add_flag("--shade", m_shade, "Short for --lighting surface")->excludes("--lighting");
    command.add_option("--light", m_light, "Short for --light-azimuth AZ and --light-elevation EL")
        ->type_name("AZ,EL")
        ->excludes("--light-azimuth")
        ->excludes("--light-elevation");
}

/// An option of the light that was given although it plays no part is a mistake; its default is none.
Result<void> LookOptions::checkParts(const Look& look) const {
    if (look.mode != RenderMode::direct && (m_shade || !m_light.empty()))
        return wrongUsage("--shade and --light", "need direct volume rendering",
                          "Leave them out, or use --mode direct.");
    if (look.lighting == Lighting::flat && !m_light.empty())
        return wrongUsage("--light", "needs a light", "Leave it out, or use --lighting surface or depth.");
    for (const Given& given : m_given)
        if (given.option->count() > 0 && !playsAPart(given.parameter->name, look))
            return wrongUsage(optionOf(given.parameter->name), "plays no part in this mode and light",
                              "Leave it out, or use --mode direct and --lighting depth.");
    return {};
}

Result<Look> LookOptions::get() const {
    Look look = lookAtStart();
    for (const Given& given : m_given)
        if (!given.parameter->set(look, given.value()))
            return wrongUsage(optionOf(given.parameter->name), "is \"" + given.choice + "\"",
                              "Use " + listed(given.parameter->choices) + ".");
    if (m_perspective) look.projection = Projection::perspective;
    if (m_shade) look.lighting = Lighting::surface;
    if (!m_light.empty())
        if (const auto taken = takeLight(m_light, look); !taken) return tl::unexpected<Failure>(taken.error());
    for (const Parameter<Look>& parameter : lookParameters())
        if (const auto fits = checked(parameter, look); !fits) return tl::unexpected<Failure>(fits.error());
    if (const auto sensible = checkParts(look); !sensible) return tl::unexpected<Failure>(sensible.error());
    return look;
}

}  // namespace echolucent::cli
