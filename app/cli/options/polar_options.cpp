#include "app/cli/options/polar_options.h"

#include <CLI/CLI.hpp>

#include "app/cli/options/option_text.h"

namespace echolucent::cli {

namespace {

constexpr const char* kinds = "linear, convex, linear-wobbler or wobbler";

/// The numbers of a required option.
Result<std::vector<double>> neededNumbers(const std::string& text, std::size_t count, const std::string& option,
                                          const std::string& example) {
    if (!text.empty()) return parseNumbers(text, count, option, example);
    return wrongUsage(option, "is missing beside --raw-polar", "Give it as " + example + ".");
}

Result<void> setRadii(const std::string& text, EvenPolar& even) {
    const bool lines = turnsLines(even.kind), planes = turnsPlanes(even.kind);
    const std::size_t count = (lines ? 1 : 0) + (planes ? 1 : 0);
    if (count == 0 && text.empty()) return {};
    if (count == 0)
        return wrongUsage("--raw-radius", "has no meaning where lines and planes are parallel", "Leave it out.");
    const auto radii = neededNumbers(text, count, "--raw-radius", count == 2 ? "40,25" : "40");
    if (!radii) return tl::unexpected(radii.error());
    if (lines) even.lineRadiusMm = radii->front();
    if (planes) even.planeRadiusMm = radii->back();
    return {};
}

const char* rawOptionOf(PolarPart part) {
    switch (part) {
        case PolarPart::range: return "--raw-range";
        case PolarPart::lines: return "--raw-lines";
        case PolarPart::planes: break;
    }
    return "--raw-planes";
}

}  // namespace

void PolarOptions::addTo(CLI::App& command) {
    command
        .add_option("--raw-polar", kind, std::string("Voxels of a raw file lie along beams of this probe: ") + kinds)
        ->type_name("KIND");
    command.add_option("--raw-range", range, "mm from the probe's face to the first sample, and from sample to sample")
        ->type_name("START,STEP");
    command.add_option("--raw-lines", lines, "First and last line of a plane: degrees, or mm where lines are parallel")
        ->type_name("FIRST,LAST");
    command.add_option("--raw-planes", planes, "First and last plane: degrees, or mm where planes are parallel")
        ->type_name("FIRST,LAST");
    command
        .add_option("--raw-radius", radius,
                    "mm from the axis about which lines turn to the probe's face, and the same of the planes")
        ->type_name("LINES,PLANES");
}

bool PolarOptions::any() const {
    return !kind.empty() || !range.empty() || !lines.empty() || !planes.empty() || !radius.empty();
}

Result<PolarKind> polarKindOf(const std::string& name, const std::string& option) {
    if (const auto kind = polarKindFromName(name)) return *kind;
    return wrongUsage(option, "is \"" + name + "\"", std::string("Use ") + kinds + ".");
}

Result<std::optional<PolarGeometry>> PolarOptions::get(const std::array<std::int64_t, 3>& size) const {
    if (!any()) return std::optional<PolarGeometry>();
    if (kind.empty())
        return wrongUsage("--raw-polar", "is missing beside other options of polar voxels",
                          std::string("Use ") + kinds + ".");
    EvenPolar even;
    const auto named = polarKindOf(kind, "--raw-polar");
    if (!named) return tl::unexpected(named.error());
    even.kind = *named;
    const auto ranges = neededNumbers(range, 2, "--raw-range", "0,0.5");
    if (!ranges) return tl::unexpected(ranges.error());
    const auto firstAndLastLine = neededNumbers(lines, 2, "--raw-lines", "-35,35");
    if (!firstAndLastLine) return tl::unexpected(firstAndLastLine.error());
    const auto firstAndLastPlane = neededNumbers(planes, 2, "--raw-planes", "-30,30");
    if (!firstAndLastPlane) return tl::unexpected(firstAndLastPlane.error());
    if (auto set = setRadii(radius, even); !set) return tl::unexpected(set.error());
    even.rangeStartMm = ranges->front();
    even.rangeStepMm = ranges->back();
    even.lines = {firstAndLastLine->front(), firstAndLastLine->back()};
    even.planes = {firstAndLastPlane->front(), firstAndLastPlane->back()};
    if (size[1] > mostPolarLines || size[2] > mostPolarLines)
        return wrongUsage("--raw-size", "has more lines or planes than any scanner",
                          "Give it as SAMPLESxLINESxPLANES.");
    const PolarGeometry polar = polarGeometry(even, size);
    if (const auto problem = problemOf(polar))
        return wrongUsage(rawOptionOf(problem->part), problem->words, "Correct the geometry of the beams.");
    return std::optional(polar);
}

}  // namespace echolucent::cli
