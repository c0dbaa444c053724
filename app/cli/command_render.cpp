#include <cmath>
#include <cstdio>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/picture_words.h"
#include "io/output/picture_file.h"
#include "processing/adaptive/adaptive_otf.h"
#include "processing/picture/light_direction.h"
#include "processing/ray_caster.h"

namespace echolucent::cli {

namespace {

struct RenderOptions {
    VolumeOptions volume;
    ViewOptions view;
    MethodOptions method;
    std::string otf = "adaptive";
    std::string size = "512x512";
    std::string mode = "direct";
    std::string colourMap = "sepia";
    std::string interpolation = "trilinear";
    std::string background = "0,0,0";
    std::string output;
    double step = 1.0;
    std::string light;
    bool shade = false;
    bool depthColour = false;
    bool perspective = false;
};

constexpr double largestPictureEdge = 16384;

/// "AZ,EL" in degrees.
Result<LightDirection> lightFrom(const std::string& text) {
    const auto angles = parseNumbers(text, 2, "--light");
    if (!angles) return tl::unexpected<Failure>(angles.error());
    const double azimuth = (*angles)[0], elevation = (*angles)[1];
    if (!(std::abs(azimuth) <= 180) || !(std::abs(elevation) <= 90))
        return fail(FailureKind::wrongUsage, "", "--light",
                    "must be an azimuth of -180 to 180 and an elevation of -90 "
                    "to 90 degrees",
                    "Write it as -33,33.");
    return LightDirection{azimuth, elevation};
}

/// Mode, light and depth colours.
Result<void> addAppearance(const RenderOptions& options, RayCastSettings& settings) {
    const auto mode = renderModeFromName(options.mode);
    if (!mode)
        return fail(FailureKind::wrongUsage, "", "--mode", "is \"" + options.mode + "\"",
                    "Use direct, maximum, minimum or mean.");
    settings.mode = *mode;
    const bool lit = options.shade || !options.light.empty();
    if (settings.mode != RenderMode::direct && (lit || options.depthColour))
        return fail(FailureKind::wrongUsage, "", "--shade, --light and --depth-colour", "need direct volume rendering",
                    "Leave them out, or use --mode direct.");
    if (lit) settings.shading = Shading{};
    if (!options.light.empty()) {
        const auto light = lightFrom(options.light);
        if (!light) return tl::unexpected<Failure>(light.error());
        settings.shading->towardsLight = towardsLight(*light);
    }
    if (options.depthColour) settings.depthColouring = DepthColouring{};
    return {};
}

/// Size, step, colours and projection; the camera follows once the volume is there.
Result<RayCastSettings> settingsFrom(const RenderOptions& options) {
    RayCastSettings settings;
    const auto size = parseNumbers(options.size, 2, "--size");
    if (!size) return tl::unexpected<Failure>(size.error());
    for (const double edge : *size)
        if (!(edge >= 1 && edge <= largestPictureEdge) || edge != static_cast<int>(edge))
            return fail(FailureKind::wrongUsage, "", "--size", "must be two whole numbers from 1 to 16384",
                        "Write it as 512x512.");
    settings.width = static_cast<int>((*size)[0]);
    settings.height = static_cast<int>((*size)[1]);
    if (!(options.step >= 1e-3 && options.step <= 100))
        return fail(FailureKind::wrongUsage, "", "--step", "must be 0.001 to 100 units");
    settings.step = options.step;
    const auto map = colourMapFromName(options.colourMap);
    if (!map)
        return fail(FailureKind::wrongUsage, "", "--colour-map", "is \"" + options.colourMap + "\"",
                    "Use sepia, grey or ice.");
    settings.colourMap = *map;
    if (options.interpolation != "trilinear" && options.interpolation != "nearest")
        return fail(FailureKind::wrongUsage, "", "--interpolation", "is \"" + options.interpolation + "\"",
                    "Use trilinear or nearest.");
    settings.interpolation = options.interpolation == "nearest" ? Interpolation::nearest : Interpolation::trilinear;
    if (const auto added = addAppearance(options, settings); !added) return tl::unexpected<Failure>(added.error());
    return settings;
}

Result<Vec3> backgroundFrom(const std::string& text) {
    const auto levels = parseNumbers(text, 3, "--background");
    if (!levels) return tl::unexpected<Failure>(levels.error());
    Vec3 colour;
    for (int channel = 0; channel < 3; ++channel) {
        const double level = (*levels)[static_cast<std::size_t>(channel)];
        if (!(level >= 0 && level <= 255))
            return fail(FailureKind::wrongUsage, "", "--background", "must be three levels from 0 to 255");
        colour[channel] = level / 255.0;
    }
    return colour;
}

/// The curve that was asked for; the adaptive one is computed for the rendered view, near cut included.
OpacityCurve curveFor(const Volume& volume, const Viewpoint& view, const std::optional<OpacityCurve>& named,
                      const AdaptiveOtfConfig& config) {
    if (named) return *named;
    const auto otf = adaptOpacity(volume, view, config);
    if (!otf->message.empty()) std::fprintf(stderr, "%s\n", otf->message.c_str());
    return otf->curve;
}

Result<void> render(const RenderOptions& options) {
    if (auto checked = checkOutputs({options.output}, {options.otf, options.method.initial}); !checked) return checked;
    if (const auto checked = options.view.get(); !checked) return tl::unexpected<Failure>(checked.error());
    const auto config = options.method.get();
    if (!config) return tl::unexpected<Failure>(config.error());
    std::optional<OpacityCurve> named;
    if (options.otf != "adaptive") {
        const auto curve = curveFromName(options.otf, options.method.opacityScale);
        if (!curve) {
            Failure failure = curve.error();
            if (failure.kind == FailureKind::wrongUsage)
                failure.remedy = "Use adaptive, linear, parabolic, quartic or manual:FILE.";
            return tl::unexpected<Failure>(std::move(failure));
        }
        named = *curve;
    }
    auto settings = settingsFrom(options);
    if (!settings) return tl::unexpected<Failure>(settings.error());
    if (settings->mode != RenderMode::direct) named = PowerCurve{};  // none is looked for that plays no part
    const auto background = backgroundFrom(options.background);
    if (!background) return tl::unexpected<Failure>(background.error());

    const auto volume = options.volume.readPhase({options.output});
    if (!volume) return tl::unexpected<Failure>(volume.error());
    const VolumeGeometry& geometry = (*volume)->geometry();
    if (!geometry.spacingKnown)
        std::fprintf(stderr, "The spacing of this volume is unknown: proportions in the picture may be wrong.\n");
    const auto view = options.view.get(**volume, *config);
    if (!view) return tl::unexpected<Failure>(view.error());
    settings->camera = defaultCamera(geometry, *view, static_cast<double>(settings->width) / settings->height);
    if (options.perspective) settings->camera.projection = Projection::perspective;
    settings->nearPlaneDepthMm = nearPlaneDepthMm(*view, geometry);
    const auto picture = castRays(**volume, curveFor(**volume, *view, named, *config), *settings);
    std::vector<std::uint8_t> rgb = overBackground(*picture, *background);
    if (!geometry.spacingKnown) writeWords(rgb, picture->width, picture->height, "spacing unknown");
    return writePng(options.output, picture->width, picture->height, rgb);
}

}  // namespace

void addRenderCommand(CLI::App& program, Action& action) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App& command = *program.add_subcommand("render", "Renders a picture of a volume");
    options->volume.addTo(command);
    command
        .add_option("--otf", options->otf,
                    "linear, parabolic, quartic, manual:FILE or adaptive (for the rendered view)")
        ->type_name("NAME")
        ->capture_default_str();
    options->view.addTo(command);
    options->method.addTo(command);
    command.add_option("--mode", options->mode, "direct, maximum, minimum or mean; the OTF counts in direct only")
        ->capture_default_str();
    command.add_flag("--shade", options->shade, "Gradient shading: light from the upper left in front");
    command
        .add_option("--light", options->light,
                    "Shades with a light so many degrees to the right of and above the viewer")
        ->type_name("AZ,EL");
    command.add_flag("--depth-colour", options->depthColour, "Tints what is near warm and what is far blue");
    command.add_flag("--perspective", options->perspective, "Perspective instead of parallel projection");
    command.add_option("--size", options->size, "Pixels")->type_name("WxH")->capture_default_str();
    command.add_option("--step", options->step, "Units (smallest spacing) between samples on a ray")
        ->capture_default_str();
    command.add_option("--interpolation", options->interpolation, "trilinear or nearest")->capture_default_str();
    command.add_option("--colour-map", options->colourMap, "sepia, grey or ice")->capture_default_str();
    command.add_option("--background", options->background, "Levels from 0 to 255")
        ->type_name("R,G,B")
        ->capture_default_str();
    command.add_option("-o,--output", options->output, "Where the picture goes")->type_name("OUT.png")->required();
    command.footer(
        "Example: echolucent-cli render chest.mha --beam-axis +y --near 18 --otf adaptive --shade -o chest.png");
    command.callback([options, &action] { action = [options] { return render(*options); }; });
}

}  // namespace echolucent::cli
