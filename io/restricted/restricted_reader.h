// The readers of io/ for the workstation and the command line. Each runs in a process that can only read what it is
// given. Whatever happens in that process, the caller gets a result or a failure.
#pragma once

#include <string>
#include <vector>

#include "io/dicom/patient.h"
#include "io/study/series_list.h"
#include "io/study/study.h"

namespace echolucent::restricted {

/// How far ahead a reader process is started.
enum class Readiness {
    once,    ///< one process, for a program that reads once
    always,  ///< for a program that stays: as soon as one process is used, the next one starts and loads DICOM's tables
};
/// Starts a reader process before it is needed, so that nobody waits for it.
void prepareReader(Readiness readiness);
/// Ends the process that waits. None is started ahead until prepareReader() is called again.
void dismissReader();

// Each function takes, gives and fails as its namesake in io/. It also fails (unreadable) if the reader process cannot
// be started, ends before it answers, or answers nonsense. It fails too if the reader uses more memory or time than
// files of that size may. It fails (cancelled) within 100 ms after progress.cancel is raised. holdsSeries() gives false
// for every failure. Texts of the reader come through makeHarmless(). A study that an unconfined process read has a
// warning.
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
