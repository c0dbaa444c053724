#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/cli/command.h"
#include "app/cli/document_render.h"
#include "app/cli/options/designer_options.h"
#include "app/cli/options/look_options.h"
#include "app/cli/output_names.h"
#include "app/cli/report/picture_words.h"
#include "io/study/import_report.h"
#include "io/writers/picture_file.h"
#include "processing/designers/designer.h"
#include "processing/picture/empty_picture.h"
#include "processing/picture/view_limits.h"
#include "processing/ray_caster.h"

namespace echolucent::cli {

namespace {

struct RenderOptions {
    VolumeOptions volume;
    DocumentOptions document;
    ViewOptions view;
    MethodOptions method;
    LookOptions look;
    DesignerOptions designer;
    std::string otf = "adaptive";
    std::string size = "512x512";
    std::string background = "0,0,0";
    std::string output;
};

constexpr int largestPictureEdge = 16384;

Result<std::array<int, 2>> sizeFrom(const std::string& text) {
    return parseWholePair(text, 1, largestPictureEdge, "--size", "512x512");
}

/// Size and look; the camera follows once the volume is there.
Result<RayCastSettings> renderSettingsFrom(const RenderOptions& options, const Look& look) {
    RayCastSettings settings = rayCastSettings(look);
    const auto size = sizeFrom(options.size);
    if (!size) return tl::unexpected<Failure>(size.error());
    settings.width = (*size)[0];
    settings.height = (*size)[1];
    return settings;
}

Result<Vec3> backgroundFrom(const std::string& text) {
    const auto levels = parseNumbers(text, 3, "--background", "14,85,170");
    if (!levels) return tl::unexpected<Failure>(levels.error());
    Vec3 colour;
    for (int channel = 0; channel < 3; ++channel) {
        const double level = (*levels)[static_cast<std::size_t>(channel)];
        if (!(level >= 0 && level <= 255)) return wrongUsage("--background", "must be three levels from 0 to 255");
        colour[channel] = level / 255.0;
    }
    return colour;
}

/// What the picture is rendered with: the curve that was asked for, or what a designer makes for the rendered view,
/// near cut included.
Classification classificationFor(const std::optional<OpacityCurve>& named,
                                 const std::optional<DesignerConfig>& designer, const DesignerInput& input) {
    if (named && !designer) return *named;
    auto made = design(designer.value_or(AdaptiveConfig{}), input);
    if (!made->message.empty()) std::fprintf(stderr, "%s\n", made->message.c_str());
    return std::move(made->classification);
}

/// Says on stderr why nothing is seen, where the curve is the reason.
void explainEmptiness(const Picture& picture, const Classification& classification, const Volume& volume) {
    constexpr float leastSeen = 1.0f / 255.0f;
    for (std::size_t alpha = 3; alpha < picture.rgba.size(); alpha += 4)
        if (picture.rgba[alpha] >= leastSeen) return;
    const std::string why = whyNothingShows(upperCurveOf(classification), intensityHistogram(volume));
    if (!why.empty()) std::fprintf(stderr, "%s\n", why.c_str());
}

/// What a view of a document shows, without labels.
Result<void> renderViewOfDocument(const RenderOptions& options, const CLI::App& command) {
    if (auto checked = options.document.checkAlone(command); !checked) return checked;
    if (auto checked = checkPictureName(options.output, "-o"); !checked) return checked;
    if (auto checked = checkOutputs({options.output}); !checked) return checked;
    const auto size = sizeFrom(options.size);
    if (!size) return tl::unexpected<Failure>(size.error());
    const auto background = backgroundFrom(options.background);
    if (!background) return tl::unexpected<Failure>(background.error());
    const auto shown = renderDocument(options.document, options.volume, *size, options.output);
    if (!shown) return tl::unexpected<Failure>(shown.error());
    if (!shown->message.empty()) std::fprintf(stderr, "%s\n", shown->message.c_str());
    if (shown->cast.mode == RenderMode::direct) explainEmptiness(shown->picture, shown->classification, *shown->voxels);
    return writePng(options.output, shown->picture.width, shown->picture.height,
                    overBackground(shown->picture, *background));
}

Result<void> render(const RenderOptions& options) {
    if (options.volume.path.empty())
        return wrongUsage("VOLUME", "is required", "Name a volume, or a document with --document.");
    if (auto checked = checkPictureName(options.output, "-o"); !checked) return checked;
    if (auto checked = checkOutputs({options.output}, {options.otf, options.method.initial}); !checked) return checked;
    if (const auto checked = options.view.get(); !checked) return tl::unexpected<Failure>(checked.error());
    const auto config = options.method.get();
    if (!config) return tl::unexpected<Failure>(config.error());
    auto named = namedCurve(options.otf, options.method.opacityScale);
    if (!named) return tl::unexpected<Failure>(named.error());
    const auto look = options.look.get();
    if (!look) return tl::unexpected<Failure>(look.error());
    auto settings = renderSettingsFrom(options, *look);
    if (!settings) return tl::unexpected<Failure>(settings.error());
    auto designer = options.designer.get();
    if (!designer) return tl::unexpected<Failure>(designer.error());
    if (settings->mode != RenderMode::direct) {  // no OTF is computed that plays no part
        *named = PowerCurve{};
        designer->reset();
    }
    const auto background = backgroundFrom(options.background);
    if (!background) return tl::unexpected<Failure>(background.error());

    const auto study = options.volume.readAll({options.output});
    if (!study) return tl::unexpected<Failure>(study.error());
    sayNote(burnedInTextNote(*study));
    const std::shared_ptr<const Volume>& volume = study->phases[static_cast<std::size_t>(options.volume.phase)];
    const VolumeGeometry& geometry = volume->geometry();
    sayNote(pictureNotesOf(geometry, "picture"));
    const auto view = options.view.get(*volume);
    if (!view) return tl::unexpected<Failure>(view.error());
    const Projection projection = settings->camera.projection;
    settings->camera = defaultCamera(volume->dataBox(), *view, static_cast<double>(settings->width) / settings->height);
    settings->camera.projection = projection;
    *settings = limitedTo(*view, geometry, *settings);
    const Volume shown = *quietVolume(*volume, look->reduction);
    const Classification classification =
        classificationFor(*named, *designer, {*volume, shown, look->reduction, *view, *config});
    const auto picture = castRays(shown, classification, *settings);
    if (settings->mode == RenderMode::direct) explainEmptiness(*picture, classification, shown);
    std::vector<std::uint8_t> rgb = overBackground(*picture, *background);
    writeWords(rgb, picture->width, picture->height, pictureWordsOf(geometry));
    return writePng(options.output, picture->width, picture->height, rgb);
}

}  // namespace

void addRenderCommand(CLI::App& program, Action& action) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App& command = *program.add_subcommand("render", "Renders a picture of a volume");
    options->volume.addTo(command);
    command.get_option("VOLUME")->required(false);
    options->document.addTo(command);
    command
        .add_option("--otf", options->otf,
                    "linear, parabolic, quartic, manual:FILE or adaptive (for the rendered view)")
        ->type_name("NAME")
        ->capture_default_str();
    options->designer.addTo(command);
    command.get_option("--designer")->excludes("--otf");
    options->view.addTo(command);
    options->method.addTo(command);
    options->look.addTo(command);
    command.add_option("--size", options->size, "Pixels")->type_name("WxH")->capture_default_str();
    command.add_option("--background", options->background, "Levels from 0 to 255")
        ->type_name("R,G,B")
        ->capture_default_str();
    command.add_option("-o,--output", options->output, "Where the picture goes")->type_name("OUT.png")->required();
    command.footer("Example: echolucent-cli render chest.mha --beam-axis +y --near 18 --otf adaptive -o chest.png");
    command.callback([options, &command, &action] {
        action = [options, &command] {
            return options->document.path.empty() ? render(*options) : renderViewOfDocument(*options, command);
        };
    });
}

}  // namespace echolucent::cli
