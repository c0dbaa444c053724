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
/// A view as a pane. With neither `id` nor view 1, it is the first view. A flat cut becomes a front that lies across
/// the view. Of several views, only those compared with this one become panes. Problems are told to the problems of
/// `root`. Empty if no view has the id.
[[nodiscard]] std::optional<DocumentPane> paneInVersion1(JsonFields root, const ViewOfVersion1& which);

}  // namespace echolucent
