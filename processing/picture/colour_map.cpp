#include "processing/picture/colour_map.h"

#include <algorithm>
#include <array>

#include "processing/choice_names.h"

namespace echolucent {

namespace {

constexpr ChoiceNames<3> colourMapNames{"sepia", "grey", "ice"};

/// Colours at equidistant intensities from 0 to 1, linear between.
using ColourStops = std::array<Vec3, 5>;

const ColourStops& stopsOf(ColourMap map) {
    static const ColourStops sepia{Vec3{0.06, 0.03, 0.015}, Vec3{0.59, 0.36, 0.21}, Vec3{0.89, 0.67, 0.46},
                                   Vec3{0.98, 0.84, 0.67}, Vec3{1.0, 0.95, 0.87}};
    static const ColourStops grey{Vec3{0, 0, 0}, Vec3{0.25, 0.25, 0.25}, Vec3{0.5, 0.5, 0.5}, Vec3{0.75, 0.75, 0.75},
                                  Vec3{1, 1, 1}};
    static const ColourStops ice{Vec3{0.01, 0.04, 0.09}, Vec3{0.10, 0.33, 0.52}, Vec3{0.34, 0.65, 0.82},
                                 Vec3{0.68, 0.87, 0.95}, Vec3{0.95, 0.99, 1.0}};
    switch (map) {
        case ColourMap::sepia: return sepia;
        case ColourMap::grey: return grey;
        case ColourMap::ice: return ice;
    }
    return grey;
}

}  // namespace

std::string_view nameOf(ColourMap map) { return nameIn(colourMapNames, map); }

Vec3 colourOf(ColourMap map, double intensity) {
    const ColourStops& stops = stopsOf(map);
    const double position = (intensity > 0.0 ? std::min(intensity, 1.0) : 0.0) * static_cast<double>(stops.size() - 1);
    const auto left = std::min(static_cast<std::size_t>(position), stops.size() - 2);
    const double share = position - static_cast<double>(left);
    return stops[left] * (1.0 - share) + stops[left + 1] * share;
}

Vec3 shadowTintOf(ColourMap map) {
    switch (map) {
        case ColourMap::sepia: return {1.0, 0.82, 0.64};
        case ColourMap::grey: return {1.0, 1.0, 1.0};
        case ColourMap::ice: return {0.64, 0.86, 1.0};
    }
    return {1.0, 1.0, 1.0};
}

}  // namespace echolucent
