// Documents of version 1, as 0.1 wrote them: their views refer by id to lists of poses, cuts, looks and more.
#pragma once

#include <optional>

#include "io/document/document_file.h"
#include "io/json/json_fields.h"

namespace echolucent {

/// The view to read of a document of version 1.
struct ViewOfVersion1 {
    std::optional<int> id{};
    bool windows = false;  ///< without an id, the view that the window showed: view 1, if there is one
};
/// The document with one of its views as a pane: the view with `id`; without an id view 1 if `windows` is set and there
/// is one, else the first view. If that view is compared with others, each of them becomes a pane. A flat cut becomes a
/// front across the view shown, and is fixed there. What is wrong in the file is told to the problems of `root`. No
/// value if no view has the id.
[[nodiscard]] std::optional<DocumentPane> paneInVersion1(JsonFields root, const ViewOfVersion1& which);

}  // namespace echolucent
