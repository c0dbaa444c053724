// What a reader process says in words, made harmless before anybody sees it.
#pragma once

#include "io/dicom/patient.h"
#include "io/study/series_list.h"
#include "io/study/study.h"

namespace echolucent::restricted {

/// No list of sentences or facts that a reader sends is longer.
constexpr std::size_t mostTakenLines = 200;
/// No sentence or other text that a reader sends is longer, in bytes.
constexpr std::size_t longestTakenLine = 2000;

/// Makes each text one line (oneLine()) of at most longestTakenLine bytes, and each list as long as
/// mostTakenLines at most; the last of warnings says how many there were. Paths stay as they are: they name files.
void makeHarmless(Failure& failure);
void makeHarmless(Study& study);
void makeHarmless(SeriesList& list);
void makeHarmless(Patient& patient);
/// What holds no words.
inline void makeHarmless(SmallPicture&) {}
inline void makeHarmless(bool&) {}

}  // namespace echolucent::restricted
