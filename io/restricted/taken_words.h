// Makes the words of a reader process harmless before anybody sees them.
#pragma once

#include "io/dicom/patient.h"
#include "io/study/series_list.h"
#include "io/study/study.h"

namespace echolucent::restricted {

/// The longest list of sentences or facts of a reader.
constexpr std::size_t mostTakenLines = 200;
/// The longest text of a reader, in bytes.
constexpr std::size_t longestTakenLine = 2000;

/// Makes each text one line (oneLine()) of at most longestTakenLine bytes, and cuts facts and warnings to
/// mostTakenLines. The last of cut warnings says how many more there are. Paths stay, since they name files.
void makeHarmless(Failure& failure);
void makeHarmless(Study& study);
void makeHarmless(SeriesList& list);
void makeHarmless(Patient& patient);
/// These hold no words.
inline void makeHarmless(SmallPicture&) {}
inline void makeHarmless(bool&) {}

}  // namespace echolucent::restricted
