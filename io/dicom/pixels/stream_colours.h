// The colours that a codestream states by itself, whatever its data set says.
#pragma once

#include <string>

namespace echolucent {

/// What the markers of a codestream of three samples say.
struct StreamColours {
    enum class Kind {
        unsaid,     ///< nothing, or several things that contradict each other: the data set decides
        rgb,        ///< the samples are red, green and blue
        lumaFirst,  ///< the first sample is luma
    };
    Kind kind = Kind::unsaid;
    std::string source{};  ///< the marker that says so, for a note: "the JFIF marker"; empty if unsaid
};

}  // namespace echolucent
