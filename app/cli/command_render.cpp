#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

#include "app/cli/command.h"
#include "app/cli/options/designer_options.h"
#include "app/cli/options/document_study.h"
#include "app/cli/options/look_options.h"
#include "app/cli/options/method_options.h"
#include "app/cli/options/option_text.h"
#include "app/cli/options/view_options.h"
#include "app/cli/options/volume_options.h"
#include "app/cli/output_names.h"
#include "app/cli/report/opening_report.h"
#include "app/cli/report/picture_words.h"
#include "io/study/import_report.h"
#include "io/study/value_window.h"
#include "io/writers/picture_file.h"
#include "processing/pane_picture/pane_picture.h"
#include "processing/picture/empty_picture.h"

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
    std::string quality = "converged";
    bool words = false;
    std::string output;
};

constexpr int largestPictureEdge = 16384;

Result<std::array<int, 2>> sizeFrom(const std::string& text) {
    return parseWholePair(text, 1, largestPictureEdge, "--size", "512x512");
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

/// If no pixel of the picture shows anything and the classification is the reason, says so on stderr, and that black is
/// kept at 0 if the study has that note.
void explainEmptiness(const Picture& picture, const Classification& classification, const Volume& volume,
                      const Study& study) {
    constexpr float leastSeen = 1.0f / 255.0f;
    for (std::size_t alpha = 3; alpha < picture.rgba.size(); alpha += 4)
        if (picture.rgba[alpha] >= leastSeen) return;
    const std::string why = whyNothingShows(upperCurveOf(classification), intensityHistogram(volume));
    if (why.empty()) return;
    std::fprintf(stderr, "%s\n", why.c_str());
    if (std::ranges::count(study.warnings, blackKeptAtZero) > 0) sayNote(std::string(blackKeptAtZero));
}

/// The study of VOLUME, opened, and its document as the options edit it.
Result<DocumentStudy> opened(const RenderOptions& options, double aspect) {
    if (auto checked = checkOutputs({options.output}, {options.otf, options.method.initial}); !checked)
        return tl::unexpected<Failure>(checked.error());
    const auto config = options.method.get();
    if (!config) return tl::unexpected<Failure>(config.error());
    const auto named = namedCurve(options.otf, options.method.opacityScale);
    if (!named) return tl::unexpected<Failure>(named.error());
    const auto look = options.look.get();
    if (!look) return tl::unexpected<Failure>(look.error());
    const auto designer = options.designer.get();
    if (!designer) return tl::unexpected<Failure>(designer.error());
    auto study = openStudy(options.volume, options.view, *look, {options.output}, aspect);
    if (!study) return study;
    sayNote(findsText(*study));
    Document& document = study->document;
    document = withMethod(std::move(document), *config);
    if (*named) document = withCurve(std::move(document), **named);
    if (*designer) document = withDesigner(std::move(document), firstPane, **designer);
    return study;
}

/// Writes the picture of a pane of a document. The picture has no labels, except for the sentences of --words.
Result<void> render(const RenderOptions& options, const CLI::App& command) {
    if (auto checked = checkPictureName(options.output, "-o"); !checked) return checked;
    if (auto checked = checkOutputs({options.output}); !checked) return checked;
    const auto size = sizeFrom(options.size);
    if (!size) return tl::unexpected<Failure>(size.error());
    const auto [width, height] = *size;
    const auto background = backgroundFrom(options.background);
    if (!background) return tl::unexpected<Failure>(background.error());
    const std::string& document = options.document.path;
    if (auto checked = options.document.check(command, {"--size", "--background", "--output", "--quality", "--words"});
        !checked)
        return checked;
    const auto made = document.empty()
                          ? opened(options, static_cast<double>(width) / height)
                          : readDocumentStudy(document, options.volume, {options.output}, options.document.view);
    if (!made) return tl::unexpected<Failure>(made.error());
    sayNote(burnedInTextNote(made->study));
    const VolumeGeometry& geometry = made->study.phases.front()->geometry();
    sayNote(pictureNotesOf(geometry, "picture"));
    const auto quality = options.quality == "quick" ? PictureQuality::quick : PictureQuality::converged;
    const auto shown = panePicture(made->document, made->pane, made->study.phases, width, height, {}, quality);
    sayNote(shown->message);
    if (shown->cast.mode == RenderMode::direct)
        explainEmptiness(shown->picture, shown->classification, *shown->voxels, made->study);
    std::vector<std::uint8_t> rgb = overBackground(shown->picture, *background);
    if (options.words) writeWords(rgb, width, height, pictureWordsOf(geometry));
    return writePng(options.output, width, height, rgb);
}

}  // namespace

void addRenderCommand(CLI::App& program, Action& action) {
    auto options = std::make_shared<RenderOptions>();
    CLI::App& command = *program.add_subcommand("render", "Renders a picture of a volume");
    options->volume.addTo(command);
    options->document.addTo(command, "renders a pane of it as it is at rest");
    command
        .add_option("--otf", options->otf,
                    "linear (eq. 1), parabolic, quartic, manual:FILE or adaptive (for the given view)")
        ->type_name("NAME")
        ->capture_default_str();
    options->designer.addTo(command);
    command.get_option("--designer")->excludes("--otf");
    options->view.addTo(command, ViewOf::openedStudy);
    options->method.addTo(command);
    options->look.addTo(command);
    command.add_option("--size", options->size, "Pixels")->type_name("WxH")->capture_default_str();
    command.add_option("--background", options->background, "Levels from 0 to 255")
        ->type_name("R,G,B")
        ->capture_default_str();
    command
        .add_option("--quality", options->quality,
                    "converged, or quick: samples four times as far apart, as far as --step says")
        ->check(CLI::IsMember({"converged", "quick"}))
        ->capture_default_str();
    command.add_flag("--words", options->words,
                     "Writes into the picture that the spacing is unknown or that the volume was reduced");
    command.add_option("-o,--output", options->output, "Where the picture goes")->type_name("OUT.png")->required();
    command.footer("Example: echolucent-cli render chest.mha -o chest.png");
    command.callback(
        [options, &command, &action] { action = [options, &command] { return render(*options, command); }; });
}

}  // namespace echolucent::cli
