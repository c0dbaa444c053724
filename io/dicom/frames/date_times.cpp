#include "io/dicom/frames/date_times.h"

#include <algorithm>
#include <chrono>
#include <string_view>

#include "io/files/header_text.h"

namespace echolucent {

namespace {

/// Cuts a number of `digits` digits off the front of `rest`; no value if it is none or not from `least` to `most`.
std::optional<int> cutNumber(std::string_view& rest, std::size_t digits, int least, int most) {
    if (rest.size() < digits) return std::nullopt;
    int number = 0;
    for (const char digit : rest.substr(0, digits)) {
        if (digit < '0' || digit > '9') return std::nullopt;
        number = 10 * number + (digit - '0');
    }
    if (number < least || number > most) return std::nullopt;
    rest.remove_prefix(digits);
    return number;
}

std::string without(std::string text, char letter) {
    std::erase(text, letter);
    return text;
}

}  // namespace

std::optional<double> secondsOfDay(const std::string& text) {
    const std::string plain = without(text, ':');
    std::string_view rest = plain;
    const auto hours = cutNumber(rest, 2, 0, 24);
    if (!hours) return std::nullopt;
    double seconds = 3600.0 * *hours;
    if (rest.empty()) return seconds;
    const auto minutes = cutNumber(rest, 2, 0, 59);
    if (!minutes) return std::nullopt;
    seconds += 60.0 * *minutes;
    if (rest.empty()) return seconds;
    const auto whole = cutNumber(rest, 2, 0, 60);  // 60 in a leap second
    if (!whole) return std::nullopt;
    seconds += *whole;
    if (rest.empty() || rest == ".") return seconds;
    const bool isFraction = rest.front() == '.' && std::ranges::all_of(rest.substr(1), [](char digit) {
                                return digit >= '0' && digit <= '9';
                            });
    const auto fraction = isFraction ? realNumber("0" + std::string(rest)) : std::nullopt;
    if (!fraction) return std::nullopt;
    return seconds + *fraction;
}

std::optional<double> daysOfDate(const std::string& text) {
    const std::string plain = without(without(text, '.'), '-');
    std::string_view rest = plain;
    const auto year = cutNumber(rest, 4, 0, 9999);
    const auto month = year ? cutNumber(rest, 2, 1, 12) : std::nullopt;
    const auto day = month ? cutNumber(rest, 2, 1, 31) : std::nullopt;
    if (!day || !rest.empty()) return std::nullopt;
    const std::chrono::year_month_day date{std::chrono::year(*year), std::chrono::month(static_cast<unsigned>(*month)),
                                           std::chrono::day(static_cast<unsigned>(*day))};
    if (!date.ok()) return std::nullopt;
    constexpr std::chrono::year_month_day first{std::chrono::year(2000), std::chrono::month(1), std::chrono::day(1)};
    return static_cast<double>((std::chrono::sys_days(date) - std::chrono::sys_days(first)).count());
}

std::optional<double> secondsOfDateTime(const std::string& text) {
    const auto sign = text.find_first_of("+-", 8);
    std::string_view zone = sign == std::string::npos ? std::string_view() : std::string_view(text).substr(sign);
    const std::string local = text.substr(0, sign);
    if (local.size() < 10) return std::nullopt;
    const auto days = daysOfDate(local.substr(0, 8));
    const auto time = secondsOfDay(local.substr(8));
    if (!days || !time) return std::nullopt;
    double ahead = 0.0;
    if (!zone.empty()) {
        const double direction = zone.front() == '-' ? -1.0 : 1.0;
        zone.remove_prefix(1);
        const auto hours = cutNumber(zone, 2, 0, 14);
        const auto minutes = hours ? cutNumber(zone, 2, 0, 59) : std::nullopt;
        if (!minutes || !zone.empty()) return std::nullopt;
        ahead = direction * (3600.0 * *hours + 60.0 * *minutes);
    }
    return secondsOfADay * *days + *time - ahead;
}

}  // namespace echolucent
