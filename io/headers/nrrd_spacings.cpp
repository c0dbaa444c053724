#include "io/headers/nrrd_spacings.h"

#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "io/files/header_text.h"
#include "io/files/input_problems.h"
#include "processing/ascii_letters.h"

namespace echolucent {

namespace {

const std::string* fieldOf(const NrrdFields& fields, const std::string& name) {
    const auto found = fields.fields.find(name);
    return found == fields.fields.end() ? nullptr : &found->second;
}

/// A field of one number for each of `count` axes; empty if the header lacks it.
Result<std::vector<double>> numbersOfAxes(const std::string& path, const NrrdFields& fields, const std::string& name,
                                          std::size_t count, std::vector<std::string>& warnings) {
    const std::string* text = fieldOf(fields, name);
    if (text == nullptr) return std::vector<double>{};
    auto numbers = realNumbers(*text);
    if (const auto points = numbers ? std::nullopt : withDecimalPoints(*text)) {
        numbers = realNumbers(*points);
        if (numbers && numbers->size() == count) warnings.push_back(decimalCommasNote(name, *text));
    }
    if (!numbers || numbers->size() != count)
        return fail(FailureKind::unreadable, path, name,
                    fmt::format("must be {} numbers, not {}", count, quotedText(*text)), remedyOfNumbers(*text));
    return *numbers;
}

/// The words for the units of all axes. Three words beside four axes belong to the axes of space.
std::vector<std::string> unitWords(const NrrdFields& fields, const NrrdAxes& axes) {
    const std::string* text = fieldOf(fields, "units");
    std::vector<std::string> words = text != nullptr ? nrrdWords(*text) : std::vector<std::string>{};
    if (words.size() == 3 && axes.sizes.size() == 4) {
        std::vector<std::string> spread(4);
        std::size_t next = 0;
        for (std::size_t axis = 0; axis < 4; ++axis)
            if (axes.roles[axis] == NrrdAxisRole::space) spread[axis] = words[next++];
        return spread;
    }
    words.resize(axes.sizes.size());
    return words;
}

}  // namespace

Result<NrrdSpacings> nrrdSpacings(const std::string& path, const NrrdFields& fields, const NrrdAxes& axes) {
    const std::size_t count = axes.sizes.size();
    NrrdSpacings result;
    auto spacings = numbersOfAxes(path, fields, "spacings", count, result.warnings);
    if (!spacings) return tl::unexpected(spacings.error());
    if (!spacings->empty()) {
        result.values = std::move(*spacings);
        result.source = "spacings";
        return result;
    }
    const auto mins = numbersOfAxes(path, fields, "axis mins", count, result.warnings);
    if (!mins) return tl::unexpected(mins.error());
    const auto maxs = numbersOfAxes(path, fields, "axis maxs", count, result.warnings);
    if (!maxs) return tl::unexpected(maxs.error());
    if (mins->empty() || maxs->empty()) return result;
    const std::string* text = fieldOf(fields, "centerings");
    const auto centerings = text != nullptr ? wordsOf(lowerCase(*text)) : std::vector<std::string>{};
    for (std::size_t axis = 0; axis < count; ++axis) {
        const bool cells = centerings.size() == count && centerings[axis] == "cell";
        const bool nodes = centerings.size() == count && centerings[axis] == "node";
        const double parts = static_cast<double>(axes.sizes[axis] - (nodes ? 1 : 0));
        const double step = cells || (nodes && parts > 0) ? ((*maxs)[axis] - (*mins)[axis]) / parts
                                                          : std::numeric_limits<double>::quiet_NaN();
        result.values.push_back(step);
    }
    result.source = "axis mins, axis maxs, centerings";
    for (std::size_t axis = 0; axis < count; ++axis)
        if (axes.roles[axis] == NrrdAxisRole::space && !std::isfinite(result.values[axis])) {
            result.warnings.emplace_back(
                "axis mins and axis maxs give no spacing: centerings does not call each axis cell or node.");
            result.values.clear();
            break;
        }
    return result;
}

LengthUnits unitsOfSpaceAxes(const NrrdFields& fields, const NrrdAxes& axes) {
    const std::vector<std::string> all = unitWords(fields, axes);
    std::vector<std::string> words;
    for (std::size_t axis = 0; axis < axes.sizes.size(); ++axis)
        if (axes.roles[axis] == NrrdAxisRole::space) words.push_back(axes.mayBeNoSpace(axis) ? "mm" : all[axis]);
    return lengthUnits("units", std::move(words));
}

LengthUnits unitsOfCoordinates(const NrrdFields& fields) {
    const std::string* text = fieldOf(fields, "space units");
    std::vector<std::string> words = text != nullptr ? nrrdWords(*text) : std::vector<std::string>{};
    words.resize(3);
    return lengthUnits("space units", std::move(words));
}

std::string unitOfAxis(const NrrdFields& fields, const NrrdAxes& axes, std::size_t axis) {
    return unitWords(fields, axes)[axis];
}

}  // namespace echolucent
