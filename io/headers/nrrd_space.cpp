#include "io/headers/nrrd_space.h"

#include "processing/ascii_letters.h"

namespace echolucent {

std::optional<NrrdSpace> nrrdSpace(const std::string& text) {
    NrrdSpace space{.name = lowerCase(text)};
    const std::string& name = space.name;
    if (name.ends_with("-time")) space.name.resize(name.size() - 5);
    if (name == "rast" || name == "last" || name == "lpst") space.name.resize(3);
    const auto isOneOf = [&](const char* words, const char* letters) { return name == words || name == letters; };
    space.ofPatient = true;
    if (isOneOf("left-posterior-superior", "lps")) return space;
    if (isOneOf("right-anterior-superior", "ras")) {
        space.inLps = space.ownAxes = {-1, -1, 1};
        return space;
    }
    if (isOneOf("left-anterior-superior", "las")) {
        space.inLps = {1, -1, 1};
        return space;
    }
    space.ofPatient = false;
    // Nothing says which way the axes of such a frame run. Reversing one of them makes it right-handed.
    if (name == "3d-left-handed") space.inLps = {1, 1, -1};
    if (space.isLeftHanded() || isOneOf("scanner-xyz", "3d-right-handed")) return space;
    return std::nullopt;
}

}  // namespace echolucent
