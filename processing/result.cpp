#include "processing/result.h"

#include <utility>

#include "processing/one_line.h"

namespace echolucent {

std::string Failure::sentence() const {
    std::string text;
    if (!file.empty()) text += file + ": ";
    if (!element.empty()) text += element + " ";
    text += problem;
    if (!text.empty() && text.back() != '.') text += '.';
    if (!remedy.empty()) text += ' ' + remedy;
    return oneLine(text);
}

tl::unexpected<Failure> fail(FailureKind kind, std::string file, std::string element, std::string problem,
                             std::string remedy) {
    Failure failure;
    failure.kind = kind;
    failure.file = std::move(file);
    failure.element = std::move(element);
    failure.problem = std::move(problem);
    failure.remedy = std::move(remedy);
    return tl::unexpected<Failure>(std::move(failure));
}

}  // namespace echolucent
