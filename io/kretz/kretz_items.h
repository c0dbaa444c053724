// The items of a GE Voluson (Kretz) volume: a flat list of group, element, length and value.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/files/input_file.h"
#include "io/files/input_problems.h"
#include "io/kretz/kretz_tags.h"
#include "processing/progress.h"
#include "processing/result.h"

namespace echolucent {

/// What every Kretz volume begins with.
constexpr std::string_view kretzSignature = "KRETZFILE 1.0   ";

/// The bytes of a Kretz volume: a file of its own, or an element of a DICOM file.
struct KretzSource {
    std::string path;     ///< file that holds them, for sentences
    std::string element;  ///< tag of the DICOM element that holds them; empty where the file is theirs
    std::uint64_t size = 0;
    /// Fills `bytes` with what stands from byte `offset` on; fails where that cannot be read.
    std::function<Result<void>(std::uint64_t offset, std::span<std::uint8_t> bytes)> read;
};
[[nodiscard]] KretzSource kretzSource(const InputFile& file);

/// One item; its value lies in the source.
struct KretzItem {
    KretzTag tag;
    std::uint64_t offset = 0;  ///< of the value's first byte
    std::uint64_t length = 0;  ///< bytes of the value
};

/// No scanner writes more items.
constexpr std::size_t mostKretzItems = 100000;

/// The items of a source, and their values.
class KretzItems {
public:
    /// Walks over the items without reading their values. Fails (unreadable) where the source does not begin with the
    /// signature, where an item is longer than what follows, or where there are too many; (cancelled) where the person
    /// ended it.
    [[nodiscard]] static Result<KretzItems> walk(KretzSource source, const Progress& progress);

    [[nodiscard]] const KretzSource& source() const { return m_source; }
    [[nodiscard]] const std::vector<KretzItem>& all() const { return m_items; }
    /// Whether the list of items has the end that it must have; what was cut off between two items has none.
    [[nodiscard]] bool ended() const { return m_ended; }
    /// The items of a tag, in the order of the file.
    [[nodiscard]] std::vector<KretzItem> allOf(KretzTag tag) const;
    [[nodiscard]] bool has(KretzTag tag) const { return !allOf(tag).empty(); }

    // Each of these fails (unreadable) where the item stands twice or its value has another length; there is no value
    // where the item is missing.
    /// A whole number of two bytes.
    [[nodiscard]] Result<std::optional<std::int64_t>> wholeNumber(KretzTag tag) const;
    /// A number of eight bytes; it may be anything but finite.
    [[nodiscard]] Result<std::optional<double>> number(KretzTag tag) const;
    /// Exactly `count` numbers of eight bytes; `what` they are stands in the sentence.
    [[nodiscard]] Result<std::optional<std::vector<double>>> numbers(KretzTag tag, std::int64_t count,
                                                                     const std::string& what) const;
    /// A failure of this source: "PATH: TAG problem."
    [[nodiscard]] tl::unexpected<Failure> refused(KretzTag tag, const std::string& problem,
                                                  const std::string& remedy = copyAgain) const;

private:
    explicit KretzItems(KretzSource source) : m_source(std::move(source)) {}
    /// The bytes of the only item of a tag, of which there must be `length`.
    [[nodiscard]] Result<std::optional<std::vector<std::uint8_t>>> value(KretzTag tag, std::uint64_t length,
                                                                         const std::string& what) const;

    KretzSource m_source;
    std::vector<KretzItem> m_items;
    bool m_ended = false;
};

}  // namespace echolucent
