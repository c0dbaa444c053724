#include "processing/sides/side.h"

#include <algorithm>
#include <charconv>
#include <tuple>

namespace echolucent {

namespace {

struct SideWords {
    std::string_view name, word, label, meaning;
};
using WordsOfSides = std::array<SideWords, std::tuple_size_v<Sides>>;

constexpr SideWords fromProbeWords{"From the probe", "probe", "1 From probe", "As the probe looked into the body."},
    fromBehindWords{"From behind", "behind", "2 From behind", "Towards the probe, from the far end of the scan."};
constexpr std::string_view ofNumber = "One of six sides. The file does not surely say where the probe was.";
constexpr WordsOfSides byPlanes{fromProbeWords,
                                fromBehindWords,
                                SideWords{"Onto the scan plane", "onto", "3 Onto scan plane",
                                          "Onto the planes that the probe scanned, the probe at the top."},
                                SideWords{"Onto the back of the scan plane", "onto-back", "4 Onto its back",
                                          "As side 3, from the other side of the planes."},
                                SideWords{"Along the scan plane, from the left", "along-left", "5 From left",
                                          "At a right angle to side 3, from the left of its picture."},
                                SideWords{"Along the scan plane, from the right", "along-right", "6 From right",
                                          "At a right angle to side 3, from the right of its picture."}};
constexpr WordsOfSides acrossBeam{fromProbeWords,
                                  fromBehindWords,
                                  SideWords{"From the lower edge of side 1", "across-1", "3 Below side 1",
                                            "Up through what side 1 shows. The probe is at the top."},
                                  SideWords{"From the upper edge of side 1", "across-2", "4 Above side 1",
                                            "Down through what side 1 shows. The probe is at the top."},
                                  SideWords{"From the left edge of side 1", "across-3", "5 Left of side 1",
                                            "To the right through what side 1 shows. The probe is at the top."},
                                  SideWords{"From the right edge of side 1", "across-4", "6 Right of side 1",
                                            "To the left through what side 1 shows. The probe is at the top."}};
constexpr WordsOfSides numbered{
    SideWords{"Side 1", "side-1", "Side 1", ofNumber}, SideWords{"Side 2", "side-2", "Side 2", ofNumber},
    SideWords{"Side 3", "side-3", "Side 3", ofNumber}, SideWords{"Side 4", "side-4", "Side 4", ofNumber},
    SideWords{"Side 5", "side-5", "Side 5", ofNumber}, SideWords{"Side 6", "side-6", "Side 6", ofNumber}};

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
        sides[i] = {static_cast<int>(i) + 1, words[i].name, words[i].word, words[i].label, words[i].meaning, views[i]};
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
