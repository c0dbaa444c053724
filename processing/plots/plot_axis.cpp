#include "processing/plots/plot_axis.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace echolucent {

namespace {

constexpr int wantedTicks = 6;
constexpr double roomBeside = 0.03;  // of the range, so that no marker sits on the frame

/// The smallest step of 1, 2 or 5 times a power of ten that is not below `raw`.
double niceStep(double raw) {
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    for (const double step : {1.0, 2.0, 5.0})
        if (raw <= step * power * 1.0001) return step * power;
    return 10.0 * power;
}

std::vector<PlotTick> linearTicks(double low, double high) {
    std::vector<PlotTick> ticks;
    const double step = niceStep((high - low) / wantedTicks);
    const double first = std::ceil(low / step - 1e-9), last = std::floor(high / step + 1e-9);
    for (double index = first; index <= last; ++index) {
        const double value = index == 0 ? 0.0 : index * step;
        ticks.push_back({value, shortNumber(value)});
    }
    return ticks;
}

/// The ticks are decades, with 2 and 5 between them if there is room for their labels. The ends are decimal logarithms.
std::vector<PlotTick> logarithmicTicks(double low, double high) {
    const double decades = high - low;
    const int every = std::max(1, static_cast<int>(std::ceil(decades / 10)));
    std::vector<PlotTick> ticks;
    for (int decade = static_cast<int>(std::floor(low)); decade <= static_cast<int>(std::floor(high)); ++decade) {
        if (decade % every != 0) continue;
        const double power = std::pow(10.0, decade);
        for (int multiple = 1; multiple <= 9; ++multiple) {
            const double place = decade + std::log10(multiple);
            if (place < low || place > high || (multiple > 1 && decades > 4)) continue;
            const bool labelled = multiple == 1 || (decades < 2.5 && (multiple == 2 || multiple == 5));
            ticks.push_back({multiple * power, labelled ? shortNumber(multiple * power) : std::string()});
        }
    }
    return ticks;
}

}  // namespace

std::string shortNumber(double value) {
    std::array<char, 32> digitsOf{};
    const auto written =
        std::to_chars(digitsOf.data(), digitsOf.data() + digitsOf.size(), value, std::chars_format::general, 6);
    std::string text(digitsOf.data(), written.ptr);
    const auto exponent = text.find('e');
    if (exponent == std::string::npos) return text;
    std::string digits = text.substr(exponent + 1);
    const bool negative = digits.front() == '-';
    digits.erase(0, digits.find_first_not_of("+-0"));
    return text.substr(0, exponent + 1) + (negative ? "-" : "") + digits;
}

PlotAxis::PlotAxis(const std::vector<double>& values, bool logarithmic, const std::optional<PlotRange>& range)
    : m_logarithmic(logarithmic) {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const double value : values) {
        if (!shows(value)) continue;
        least = std::min(least, value);
        most = std::max(most, value);
    }
    if (range && shows(range->from) && shows(range->to) && range->from < range->to) {
        least = range->from;
        most = range->to;
    }
    if (logarithmic)
        least > most ? spanLogarithmic(0.1, 1.0) : spanLogarithmic(least, most);
    else
        least > most ? spanLinear(0.0, 1.0) : spanLinear(least, most);
}

void PlotAxis::spanLinear(double least, double most) {
    // A range that is tiny beside its values would have no ticks.
    const double width = std::max(most - least, 1e-9 * std::max(std::abs(least), std::abs(most)));
    const double half = width > 0 ? 0.5 * width : 0.5, middle = least + 0.5 * (most - least);
    m_low = middle - half * (1 + 2 * roomBeside);
    m_high = middle + half * (1 + 2 * roomBeside);
    m_ticks = linearTicks(m_low, m_high);
}

void PlotAxis::spanLogarithmic(double least, double most) {
    const double low = std::log10(least), high = std::log10(most);
    const double room = std::max(roomBeside * (high - low), 0.02);
    m_low = low - room;
    m_high = high + room;
    m_ticks = logarithmicTicks(m_low, m_high);
    const auto labelled =
        std::count_if(m_ticks.begin(), m_ticks.end(), [](const PlotTick& tick) { return !tick.label.empty(); });
    if (labelled < 2) m_ticks = linearTicks(std::pow(10.0, m_low), std::pow(10.0, m_high));
}

bool PlotAxis::shows(double value) const { return std::isfinite(value) && (!m_logarithmic || value > 0); }

double PlotAxis::placeOf(double value) const {
    return ((m_logarithmic ? std::log10(value) : value) - m_low) / (m_high - m_low);
}

}  // namespace echolucent
