#include "processing/sides/side.h"

#include <algorithm>
#include <charconv>
#include <tuple>

namespace echolucent {

namespace {

struct SideWords {
    std::string_view name, word;
};
using WordsOfSides = std::array<SideWords, std::tuple_size_v<Sides>>;

constexpr SideWords fromProbeWords{"From the probe", "probe"}, fromBehindWords{"From behind", "behind"};
constexpr WordsOfSides byPlanes{fromProbeWords,
                                fromBehindWords,
                                SideWords{"Onto the scan plane", "onto"},
                                SideWords{"Onto the back of the scan plane", "onto-back"},
                                SideWords{"Along the scan plane, from the left", "along-left"},
                                SideWords{"Along the scan plane, from the right", "along-right"}};
constexpr WordsOfSides acrossBeam{fromProbeWords,
                                  fromBehindWords,
                                  SideWords{"Across the beam, 1", "across-1"},
                                  SideWords{"Across the beam, 2", "across-2"},
                                  SideWords{"Across the beam, 3", "across-3"},
                                  SideWords{"Across the beam, 4", "across-4"}};
constexpr WordsOfSides numbered{SideWords{"Side 1", "side-1"}, SideWords{"Side 2", "side-2"},
                                SideWords{"Side 3", "side-3"}, SideWords{"Side 4", "side-4"},
                                SideWords{"Side 5", "side-5"}, SideWords{"Side 6", "side-6"}};

}  // namespace

Sides sidesOf(const Viewpoint& fromProbe, bool beamSure, const ScanPlanes& planes) {
    const ViewFrame frame = frameOf(fromProbe);
    const Vec3 elevation = planes.lateral.cross(frame.forward);
    const auto along = [&](const Vec3& forward, const Vec3& down) {
        return withoutRounding(viewAlong(forward, down, fromProbe.beamAxis));
    };
    Viewpoint probe{.beamAxis = fromProbe.beamAxis,
                    .azimuthDegrees = fromProbe.azimuthDegrees,
                    .elevationDegrees = fromProbe.elevationDegrees,
                    .rollDegrees = fromProbe.rollDegrees};
    const std::array views{probe,
                           along(frame.forward * -1.0, frame.down),
                           along(elevation, frame.forward),
                           along(elevation * -1.0, frame.forward),
                           along(planes.lateral, frame.forward),
                           along(planes.lateral * -1.0, frame.forward)};
    const WordsOfSides& words = !beamSure ? numbered : planes.sure ? byPlanes : acrossBeam;
    Sides sides;
    for (std::size_t i = 0; i < sides.size(); ++i)
        sides[i] = {static_cast<int>(i) + 1, words[i].name, words[i].word, views[i]};
    return sides;
}

std::optional<std::size_t> sideNamed(const Sides& sides, std::string_view wordOrNumber) {
    const auto named = std::ranges::find(sides, wordOrNumber, &Side::word);
    if (named != sides.end()) return static_cast<std::size_t>(named - sides.begin());
    int number = 0;
    const char* end = wordOrNumber.data() + wordOrNumber.size();
    const auto read = std::from_chars(wordOrNumber.data(), end, number);
    if (read.ec != std::errc{} || read.ptr != end || number < 1 || number > static_cast<int>(sides.size()))
        return std::nullopt;
    return static_cast<std::size_t>(number - 1);
}

}  // namespace echolucent
