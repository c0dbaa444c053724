// What successive documents share, and the bytes that each of them needs.
#pragma once

#include <cstddef>

#include "processing/document/document.h"

namespace echolucent {

/// The document, sharing those lists of `other` that equal its own.
[[nodiscard]] Document sharing(Document document, const Document& other);

/// The bytes of a document beside `other`: the document itself, and all it does not share with `other`. Null stands for
/// no other document. What a designer holds beside its numbers (64 nodes at most) is not counted.
[[nodiscard]] std::size_t bytesBeside(const Document& document, const Document* other);

}  // namespace echolucent
