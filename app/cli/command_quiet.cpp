// `quiet`: writes the voxels for pictures to a file.
#include <CLI/CLI.hpp>

#include <memory>

#include "app/cli/command.h"
#include "app/cli/options/look_options.h"
#include "app/cli/options/volume_options.h"
#include "app/cli/output_names.h"
#include "io/writers/meta_image_writer.h"

namespace echolucent::cli {

namespace {

struct QuietOptions {
    VolumeOptions volume;
    LookOptions look;
    std::string output;
};

Result<void> writeQuiet(const QuietOptions& options) {
    const auto look = options.look.get();
    if (!look) return tl::unexpected<Failure>(look.error());
    if (auto checked = checkMetaImageName(options.output, "-o"); !checked) return checked;
    if (auto checked = checkOutputs({options.output}); !checked) return checked;
    const auto volume = options.volume.readPhase({options.output});
    if (!volume) return tl::unexpected<Failure>(volume.error());
    const auto quiet = std::make_shared<const Volume>(*quietVolume(**volume, look->reduction));
    return writeMetaImage(options.output, {quiet}, MetaImageVoxels::plain);
}

}  // namespace

void addQuietCommand(CLI::App& program, Action& action) {
    auto options = std::make_shared<QuietOptions>();
    CLI::App& command =
        *program.add_subcommand("quiet", "Writes a volume with less speckle: the voxels a picture is taken from");
    options->volume.addTo(command);
    options->look.addTo(command, {"reduction"});
    command.add_option("-o,--output", options->output, "MetaImage file to write (.mha), not compressed")
        ->type_name("OUT.mha")
        ->required();
    command.footer("Example: echolucent-cli quiet chest.mha --reduction strong -o quiet.mha");
    command.callback([options, &action] { action = [options] { return writeQuiet(*options); }; });
}

}  // namespace echolucent::cli
