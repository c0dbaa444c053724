// The readers of io/ as the workstation and the command line call them: each runs in a process that can do nothing but
// read what it is given, and whatever happens there ends in a sentence.
#pragma once

#include <string>
#include <vector>

#include "io/dicom/patient.h"
#include "io/study/series_list.h"
#include "io/study/study.h"

namespace echolucent::restricted {

/// How long ahead a reader process is started.
enum class Readiness {
    once,    ///< one, for a program that reads once
    always,  ///< the next as soon as one is used, with all that DICOM needs, for a program that stays
};
/// Starts a reader process before it is needed, so that nobody waits for it.
void prepareReader(Readiness readiness);
/// Ends the process that waits.
void dismissReader();

// Each takes, gives and fails as the function of its name in io/ does. Beyond that each fails (unreadable) where the
// reader process cannot be started, ends before it has answered, uses more memory or time than files of that size may,
// or answers what makes no sense; and (cancelled) within 100 ms where progress.cancel is raised.
[[nodiscard]] Result<Study> readStudy(const std::string& path, const ReadOptions& options = {},
                                      const Progress& progress = {});
[[nodiscard]] Result<SeriesList> listSeries(const std::string& path, const Progress& progress = {});
[[nodiscard]] bool holdsSeries(const std::string& path);
[[nodiscard]] Result<Study> readSeries(const SeriesList& list, const SeriesEntry& entry,
                                       const ReadOptions& options = {}, const Progress& progress = {});
[[nodiscard]] Result<SmallPicture> middlePicture(const SeriesEntry& entry, int longestEdge,
                                                 const Progress& progress = {});
[[nodiscard]] Result<Patient> readPatient(const std::vector<std::string>& files, const std::string& series = {},
                                          const Progress& progress = {});

}  // namespace echolucent::restricted
