// What the workstation asks its reader process to read.
#pragma once

#include "io/restricted/descriptions.h"

namespace echolucent::restricted {

/// The functions of the readers that can be asked for.
enum class Task { readStudy, listSeries, holdsSeries, readSeries, middlePicture, readPatient };

/// A function with its arguments; those that the task does not take stay as they are.
struct Request {
    Task task = Task::readStudy;
    std::string path;                  ///< readStudy, listSeries, holdsSeries
    ReadOptions options{};             ///< readStudy, readSeries
    SeriesList list{};                 ///< readSeries and middlePicture, whose entry is the only one of its series
    int longestEdge = 1;               ///< middlePicture
    std::vector<std::string> files{};  ///< readPatient
    std::string series{};              ///< readPatient
    bool mayBeDicom = true;            ///< whether what DICOM needs has to be loaded
    bool wantsCoarse = false;          ///< readStudy, readSeries: whether a coarse volume is wanted before the study
    int threads = 1;                   ///< that the reader may use at once; at least 1
};

template <typename Archive, Described<Request> Value>
void describe(Archive& archive, Value& request) {
    archive.choice(request.task, Task::readPatient);
    archive(request.path, request.options, request.list, request.longestEdge, request.files, request.series,
            request.mayBeDicom, request.wantsCoarse, request.threads);
}

}  // namespace echolucent::restricted
