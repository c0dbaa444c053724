// Dates and times of day as DICOM writes them.
#pragma once

#include <optional>
#include <string>

namespace echolucent {

/// A day has so many seconds; leap seconds are not counted.
inline constexpr double secondsOfADay = 86400;

/// A time of day (DICOM's TM: "HHMMSS.FFFFFF", shorter ones, or "HH:MM:SS") in seconds; no value if it is none.
[[nodiscard]] std::optional<double> secondsOfDay(const std::string& text);
/// A date (DICOM's DA: "YYYYMMDD", or "YYYY.MM.DD") in days since 1 January 2000; no value if it is none.
[[nodiscard]] std::optional<double> daysOfDate(const std::string& text);
/// A date with a time (DICOM's DT: "YYYYMMDDHHMMSS.FFFFFF&ZZXX") in seconds since that day, in UTC if it states its
/// zone; no value if it is none.
[[nodiscard]] std::optional<double> secondsOfDateTime(const std::string& text);

}  // namespace echolucent
