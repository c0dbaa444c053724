// What the workstation asks of its reader process.
#pragma once

#include "io/restricted/descriptions.h"

namespace echolucent::restricted {

/// The functions of the readers that a request may name.
enum class Task { readStudy, listSeries, holdsSeries, readSeries, middlePicture, readPatient };

/// A function with its arguments. Arguments that the task does not take stay as they are.
struct Request {
    Task task = Task::readStudy;
    std::string path;                  ///< readStudy, listSeries, holdsSeries
    ReadOptions options{};             ///< readStudy, readSeries
    SeriesList list{};                 ///< readSeries, middlePicture: a list with the chosen series alone
    int longestEdge = 1;               ///< middlePicture
    std::vector<std::string> files{};  ///< readPatient
    std::string series{};              ///< readPatient
    bool mayBeDicom = true;            ///< whether DICOM's tables must be loaded
    bool wantsCoarse = false;          ///< readStudy, readSeries: whether a coarse volume is wanted before the study
    int threads = 1;                   ///< how many threads the reader may use at once; at least 1
};

template <typename Archive, Described<Request> Value>
void describe(Archive& archive, Value& request) {
    archive.choice(request.task, Task::readPatient);
    archive(request.path, request.options, request.list, request.longestEdge, request.files, request.series,
            request.mayBeDicom, request.wantsCoarse, request.threads);
}

}  // namespace echolucent::restricted
