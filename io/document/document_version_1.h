// Documents of version 1, as 0.1 wrote them: views that refer by id to lists of poses, cuts, looks and the rest.
#pragma once

#include <optional>

#include "io/document/document_file.h"
#include "io/json/json_fields.h"

namespace echolucent {

/// Which view of a document of version 1 is read.
struct ViewOfVersion1 {
    std::optional<int> id{};
    bool windows = false;  ///< without an id, the view that the window showed: view 1, where it is there
};
/// A view, or where there is neither `id` nor view 1 the first one, as a pane. A flat cut becomes a front that lies
/// across the view shown. Of several views, only those that are compared with this one become panes. What is wrong is
/// told to the problems of `root`. The result is empty if there is no view of the id.
[[nodiscard]] std::optional<DocumentPane> paneInVersion1(JsonFields root, const ViewOfVersion1& which);

}  // namespace echolucent
