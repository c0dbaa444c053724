#include "app/cli/phantom_output.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "app/cli/options/option_text.h"
#include "io/writers/enhanced_us_writer.h"
#include "io/writers/meta_image_writer.h"
#include "io/writers/nifti_writer.h"
#include "processing/ascii_letters.h"

namespace echolucent::cli {

namespace {

using Phases = std::vector<std::shared_ptr<const Volume>>;

Result<void> writeAsMetaImage(const std::string& path, const Phases& phases) { return writeMetaImage(path, phases); }

Result<void> writeAsNifti(const std::string& path, const Phases& phases) { return writeNifti(path, phases); }

/// The transducer lies on the middle of the face that a +z beam enters. The simulated beams are parallel, so the apex
/// is nominal: as far before the face as the volume is deep.
Result<void> writeAsEnhancedUs(const std::string& path, const Phases& phases) {
    const VolumeGeometry& geometry = phases.front()->geometry();
    const Vec3 centre = geometry.centreMm();
    EnhancedUsDetails details;
    details.transducer.faceMm = Vec3(centre[0], centre[1], geometry.boxMinMm()[2]);
    details.apexMm = details.transducer.faceMm - Vec3(0, 0, geometry.boxMaxMm()[2] - geometry.boxMinMm()[2]);
    return writeEnhancedUs(path, phases, details);
}

struct PhantomFormat {
    std::string_view ending;
    Result<void> (*write)(const std::string& path, const Phases& phases);
};

constexpr std::array formats{PhantomFormat{".mha", writeAsMetaImage}, PhantomFormat{".mhd", writeAsMetaImage},
                             PhantomFormat{".nii", writeAsNifti}, PhantomFormat{".nii.gz", writeAsNifti},
                             PhantomFormat{".dcm", writeAsEnhancedUs}};

/// The format for a name; null if none has its ending. Names without an ending (devices, the standard output) are
/// MetaImages.
const PhantomFormat* formatOf(const std::string& path) {
    const std::string name = lowerCase(path.substr(path.find_last_of('/') + 1));
    if (name.find('.') == std::string::npos) return &formats.front();
    const auto found =
        std::ranges::find_if(formats, [&](const PhantomFormat& format) { return name.ends_with(format.ending); });
    return found != formats.end() ? &*found : nullptr;
}

}  // namespace

std::string phantomEndings() {
    std::vector<std::string_view> endings;
    endings.reserve(formats.size());
    for (const PhantomFormat& format : formats) endings.push_back(format.ending);
    return listed(endings);
}

Result<void> checkPhantomName(const std::string& path) {
    if (formatOf(path) != nullptr) return {};
    return wrongUsage("OUT", "is " + path + ", which has an ending that no phantom is written with",
                      "Use " + phantomEndings() + ".");
}

Result<void> writePhantom(const std::string& path, const Phases& phases) {
    const PhantomFormat* format = formatOf(path);
    return format != nullptr ? format->write(path, phases) : checkPhantomName(path);
}

}  // namespace echolucent::cli
