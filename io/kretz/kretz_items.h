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

/// The beginning of every Kretz volume.
constexpr std::string_view kretzSignature = "KRETZFILE 1.0   ";

/// The bytes of a Kretz volume: a file of its own, or an element of a DICOM file.
struct KretzSource {
    std::string path;     ///< the file that holds them, for messages
    std::string element;  ///< tag of the DICOM element that holds them; empty for a Kretz file
    std::uint64_t size = 0;
    /// Fills `bytes` from byte `offset` on. Fails if they cannot be read.
    std::function<Result<void>(std::uint64_t offset, std::span<std::uint8_t> bytes)> read;
};
[[nodiscard]] KretzSource kretzSource(const InputFile& file);

/// One item; its value lies in the source.
struct KretzItem {
    KretzTag tag;
    std::uint64_t offset = 0;  ///< offset of the value's first byte
    std::uint64_t length = 0;  ///< bytes of the value
};

/// The most items of a volume: more than any scanner writes.
constexpr std::size_t mostKretzItems = 100000;

class KretzItems {
public:
    /// Lists the items without reading their values. Fails (unreadable) if the source does not begin with the
    /// signature, if an item is longer than the rest, or if there are too many; (cancelled) if the person ended it.
    [[nodiscard]] static Result<KretzItems> walk(KretzSource source, const Progress& progress);

    [[nodiscard]] const KretzSource& source() const { return m_source; }
    [[nodiscard]] const std::vector<KretzItem>& all() const { return m_items; }
    /// Whether the list has its end item. If the file was cut between two items, it has none.
    [[nodiscard]] bool ended() const { return m_ended; }
    /// The items of a tag, in the order of the file.
    [[nodiscard]] std::vector<KretzItem> allOf(KretzTag tag) const;
    [[nodiscard]] bool has(KretzTag tag) const { return !allOf(tag).empty(); }

    // These fail (unreadable) if the item appears twice, or if its value has another length or cannot be read. A
    // missing item gives no value.
    /// A whole number of two bytes, from 0 to 65535.
    [[nodiscard]] Result<std::optional<std::int64_t>> wholeNumber(KretzTag tag) const;
    /// A number of eight bytes, which may be infinite or NaN.
    [[nodiscard]] Result<std::optional<double>> number(KretzTag tag) const;
    /// Exactly `count` numbers of eight bytes. `what` names them in messages.
    [[nodiscard]] Result<std::optional<std::vector<double>>> numbers(KretzTag tag, std::int64_t count,
                                                                     const std::string& what) const;
    /// A failure of this source: "PATH: TAG problem."
    [[nodiscard]] tl::unexpected<Failure> refused(KretzTag tag, const std::string& problem,
                                                  const std::string& remedy = copyAgain) const;

private:
    explicit KretzItems(KretzSource source) : m_source(std::move(source)) {}
    /// The value of the only item of a tag. It must hold `length` bytes.
    [[nodiscard]] Result<std::optional<std::vector<std::uint8_t>>> value(KretzTag tag, std::uint64_t length,
                                                                         const std::string& what) const;

    KretzSource m_source;
    std::vector<KretzItem> m_items;
    bool m_ended = false;
};

}  // namespace echolucent
